// The room `gltf`: reads glTF 2.0 files (.gltf, .glb) as meshes, cameras, lights and materials. It knows no graph and
// draws nothing.
//
// Opens a file with its buffers and checks all that others rely on: every index, every range of bytes, every count.
// What it returns can be read without further checks. Pictures are not decoded.
//
//   Outcome<tinygltf::Model> file = open_gltf("chair.glb");
#pragma once

#include <tiny_gltf.h>

#include <string>
#include <string_view>

#include "runtime/outcome.h"

namespace patina::runtime {

// Errors name the file and the place in it: "chair.glb: accessors[3]: ...".
Outcome<tinygltf::Model> open_gltf(const std::string& path);

// The bytes of a picture's own file, not decoded. Empty: it is a file that could not be read.
std::string_view picture_bytes(const tinygltf::Model& model, std::size_t index);

// gltf_check.cpp: the first error, with its location; empty if there is none. `is_used`: an extension that a file
// requires is refused if this room does not read it.
std::string mistake_in(const tinygltf::Model& model);

}  // namespace patina::runtime
