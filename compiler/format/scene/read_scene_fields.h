// Functions that the readers of a scene's parts share: numbers within limits, vectors, colours and files. Private to
// compiler/format/scene/read_scene*.cpp.
//
//   read_number(reading, json, ObjectKind::Camera, "fov", camera.fov);   // keeps what is there if the key is not
#pragma once

#include "compiler/format/color.h"
#include "compiler/format/read_graph.h"
#include "compiler/format/scene/read_scene.h"

namespace patina::format {

struct SceneReading : Reading {
    const SceneFiles& files;
};

inline FileLocation place_of(const Reading& reading, Span span) {
    return place_of(reading.sources, span);
}

// True if the key is present and valid; `target` changes only then. The limits are those of the table of keys.
bool read_number(Reading& reading, const json::Json& object, ObjectKind kind, std::string_view key, double& target);
bool read_vector(Reading& reading, const json::Json& object, ObjectKind kind, std::string_view key,
                 SceneVector& target);
// Reads "#rrggbb", a grey, or three linear numbers; a fourth number where alpha has a meaning.
std::optional<std::array<double, 4>> read_scene_color(Reading& reading, const json::Json& json, std::string_view key,
                                                      bool with_alpha = false);
void read_color(Reading& reading, const json::Json& object, std::string_view key, SceneVector& target);
// Reports a file that does not exist.
SceneFileName read_file_name(SceneReading& reading, const json::Json& json, std::string_view what);
// The same for a graph.
SceneFileName read_graph_name(SceneReading& reading, const json::Json& json, std::string_view what);

void report_impossible(Reading& reading, const json::Json& object, std::string_view key, std::string_view wanted);

// --- read_scene_surroundings.cpp
void read_surroundings(SceneReading& reading, const json::Json& json, SceneFile& scene);

// --- read_scene_lights.cpp
std::vector<SceneLight> read_lights(SceneReading& reading, const json::Json& array);

}  // namespace patina::format
