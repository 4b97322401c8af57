// Makes a SceneFile from a JSON tree. Reads every key, checks its words and numbers, finds the files that the scene
// names without opening them, and resolves the material of each object.
#pragma once

#include <functional>

#include "compiler/format/read_fields.h"
#include "patina/scene.h"

namespace patina::format {

// Finds the files that a scene names. The caller provides it, because the search belongs to resolve/session.h.
struct SceneFiles {
    // The path of the file that is named at `where`; empty if there is none.
    std::function<std::string(const std::string& name, Span where)> find;
    // The same; reports at `where` that there is none.
    std::function<std::string(const std::string& name, Span where)> require;
    // The same for a graph: reports a file of the disk that is none.
    std::function<std::string(const std::string& name, Span where)> require_graph;
};

// Returns a scene even after errors (the parts that could be read). `name`: the scene's name if the file states none.
SceneFile read_scene(const Reading& reading, const json::Json& json, const std::string& path, std::string name,
                     const SceneFiles& files);

}  // namespace patina::format
