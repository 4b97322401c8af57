// Tangents of a mesh that comes without them, as the tools that bake normal maps compute them.
// source: Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008 (MikkTSpace)
//
//   Mesh mesh = with_tangents(std::move(read));
#pragma once

#include "runtime/mesh/mesh.h"

namespace patina::runtime {

// Replaces the tangents, which follow growing u of uv0 (mesh.h). At a vertex, the tangents of the triangles that share
// its position, normal and uv0, and have the same handedness, are averaged by their angles there, across indices. A
// vertex with several results is split. Triangles without area in uv0 take the tangent of a neighbour; a vertex without
// any has some tangent at a right angle to its normal. Triangles keep their order. Normals must be unit vectors.
Mesh with_tangents(const Mesh& mesh);

}  // namespace patina::runtime
