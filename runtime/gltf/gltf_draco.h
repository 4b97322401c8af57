// Meshes that KHR_draco_mesh_compression holds.
//
//   std::string text = without_draco_indices(json);   // before the file is read
//   std::string mistake = expand_draco(model);         // after it
#pragma once

#include <tiny_gltf.h>

#include <string>
#include <string_view>

namespace patina::runtime {

// tinygltf refuses indices without bytes of their own, and compressed indices have none: moves them into the extension.
// Text that is no JSON stays as it is. Throws nothing.
std::string without_draco_indices(std::string_view json);

// Decodes all compressed primitives into a buffer of their own, and restores their indices. Returns the first error
// with its location in the file; empty if there is none.
std::string expand_draco(tinygltf::Model& model);

}  // namespace patina::runtime
