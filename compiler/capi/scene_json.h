// A scene as JSON, as patina_scene_json() gives it.
//
//   std::string text = json_of(read.scene);   // {"name":"Beads","camera":{"position":[0,4.6,4.2],...},...}
#pragma once

#include <string>

#include "patina/scene.h"

namespace patina::capi {

std::string json_of(const SceneFile& scene);

}  // namespace patina::capi
