// The JSON of a glTF file, and the line of a mistake that the reader of the container found: it knows the part
// ("accessors[3].count") and not the line.
//
//   Outcome<tinygltf::Model> file = runtime::open_gltf(path);
//   if (!file) return {.error = located_mistake(path, file.error)};   // "a.gltf:7:12: accessors[3].count: ..."
#pragma once

#include <memory>
#include <string>

#include "compiler/json/json.h"

namespace patina::importers::gltf {

struct GltfText {
    SourceMap sources{};
    std::unique_ptr<json::Json> root{};  // null: it is not JSON
    bool is_binary = false;              // it lies in a .glb, where lines say nothing
    bool looks_like_json = false;  // it begins as the JSON of a .gltf does, so what stops its reader is of interest
    std::string error{};           // "a.gltf:3:9: ..."; why `root` is null
};
GltfText read_gltf_text(const std::string& path);

// The first part of the file that has another shape than the specification says, and that tinygltf passes over or
// reports without its place: lists that are none, types that do not exist, buffers that hold less than they claim.
// Begins with the path and the line; empty: nothing is wrong.
std::string shape_mistake(const GltfText& text, const std::string& path);

// The error of a file that could not be opened, or whose meshes are wrong, with the line and column of the part that it
// names, if the file is text.
std::string located_mistake(const std::string& path, const std::string& error);

}  // namespace patina::importers::gltf
