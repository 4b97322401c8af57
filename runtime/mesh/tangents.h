// Makes missing tangents of a mesh, in the same way as the tools that bake normal maps.
// source: Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008 (MikkTSpace)
//
//   Mesh mesh = with_tangents(std::move(read));
#pragma once

#include "runtime/mesh/mesh.h"

namespace patina::runtime {

// Replaces the tangents, which follow growing u of uv0 (mesh.h). At a vertex, the tangents of some triangles are
// averaged by their angles there, across indices: of triangles with the same position, normal, uv0 and handedness. A
// vertex with several results is split. Triangles without area in uv0 take the tangent of a neighbour; a vertex without
// any has some tangent at a right angle to its normal. Triangles keep their order. Normals must be unit vectors.
Mesh with_tangents(const Mesh& mesh);

}  // namespace patina::runtime
