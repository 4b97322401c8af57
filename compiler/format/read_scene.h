// JSON tree -> SceneFile: reads every key, checks its words and numbers, finds the files that it names (and opens
// none), and says which of the scene's materials each object means.
#pragma once

#include <functional>

#include "compiler/format/read_fields.h"
#include "patina/scene.h"

namespace patina::graph {

// Where the files are found that a scene names. It is the room behind this one that knows (resolve/session.h).
struct SceneFiles {
    std::function<std::string(const std::string& name)> find;                   // its path; empty: there is none
    std::function<void(const std::string& name, Span where)> report_missing{};  // what find() did not find
};

// Returns a scene even after errors (what could be read). `name`: what it is called if it does not say so itself.
SceneFile read_scene(const Reading& reading, const Json& json, const std::string& path, std::string name,
                     const SceneFiles& files);

}  // namespace patina::graph
