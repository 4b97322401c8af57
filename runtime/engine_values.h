// What a scene says for each value that nodes/stage/ declares as the engine's, by its name there: camera, object,
// frame, lights and ambient light. Only numbers and names; material_values.h puts them where the reflection wants them.
//
//   engine_values(scene).at("light_color").numbers   // four for each light
#pragma once

#include <map>
#include <string>
#include <vector>

#include "runtime/scene.h"

namespace patina::runtime {

// Vectors of `per_vector` numbers one after the other: columns of a matrix, elements of an array, or a single one.
struct EngineValue {
    unsigned per_vector = 1;
    std::vector<double> numbers;
};

// world_to_clip, world_to_view, camera_position_ws, camera_forward_ws, view_is_orthographic; object_to_world,
// world_to_object; time, screen_size (pixels, samples included); light_count, light_position, light_color, light_axis,
// light_cone (directional lights first); ambient_sh.
std::map<std::string, EngineValue> engine_values(const Scene& scene);

}  // namespace patina::runtime
