// A primitive of a glTF mesh as triangles. Strips and fans are resolved, missing normals and tangents are made (flat
// normals, and tangents as in mesh/tangents.h), and morph targets and skins are applied.
//
//   Outcome<Mesh> mesh = primitive_mesh(file, "meshes[0].primitives[1]", primitive, weights, joints);
#pragma once

#include <tiny_gltf.h>

#include <string>
#include <vector>

#include "runtime/gltf/gltf_model.h"
#include "runtime/mesh/mesh.h"
#include "runtime/outcome.h"

namespace patina::runtime {

// True for triangles, strips and fans; points and lines have no surface.
bool has_triangles(const tinygltf::Primitive& primitive);

// `weights`: one for each morph target; missing ones are 0. `joints`: from the mesh's space to that of the joint's
// pose, for each joint of the skin; empty: no skin. `where` begins the errors: an index past the end, a joint that the
// skin lacks, a number that is not finite.
Outcome<Mesh> primitive_mesh(const tinygltf::Model& model, const std::string& where,
                             const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                             const std::vector<glm::mat4>& joints, MeshDetail detail = MeshDetail::Whole);

}  // namespace patina::runtime
