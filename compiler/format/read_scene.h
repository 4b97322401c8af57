// JSON tree -> SceneFile: reads every key, checks its words and numbers, finds the files that it names (and opens
// none), and says which of the scene's materials each object means.
#pragma once

#include "compiler/json/json.h"
#include "compiler/resolve/session.h"
#include "patina/scene.h"

namespace patina::graph {

// Returns a scene even after errors (what could be read).
SceneFile read_scene(Session& session, const Json& json, const std::string& path);

}  // namespace patina::graph
