// Reads parts of a scene from words, the same on the command line and in a snapshot file: a kind, then name=value.
//
//   parse_light("point position=1,2,0 color=#ff8800 intensity=3 range=5")
//   parse_light("spot position=0,3,0 direction=0,-1,0 inner=15 outer=25")
//   parse_light("directional direction=-1,1,1")
//   parse_ambient("0.2")
//   parse_ambient("sky=#9ab horizon=0.2 ground=0.05")
//   parse_environment("sunset.hdr rotation=90 intensity=2")
//   parse_background("#203040")
//   parse_camera("position=2,1,3 target=0,0,0 fov=35")
//
// Colours are #rgb or #rrggbb (sRGB, decoded), one number (a grey) or three (linear).
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string_view>

#include "runtime/lighting/environment_file.h"
#include "runtime/outcome.h"
#include "runtime/scene/scene.h"

namespace patina::runtime {

Outcome<Light> parse_light(std::string_view text);
Outcome<SphericalHarmonics> parse_ambient(std::string_view text);
// A file, or one of the words of a scene's "environment"; then settings. A file's name may contain spaces.
Outcome<EnvironmentChoice> parse_environment(std::string_view text);
// Such a text names a picture.
bool is_picture(std::string_view environment);
// Lights the scene by it: "studio", "none" (mirrors reflect the ambient light, which stays), or a file. Returns
// nothing, or what is wrong with the file.
std::string set_environment(Scene& scene, const EnvironmentChoice& choice, const EnvironmentProgress& progress);
// Words that are not given keep the values of `base`.
Outcome<Camera> parse_camera(std::string_view text, const Camera& base);

// Behind everything: a colour, "none", which is transparent, or a word of a scene's "background".
struct Background {
    SceneBackdrop backdrop = SceneBackdrop::Color;
    glm::vec4 color{0, 0, 0, 1};  // linear
};
Outcome<Background> parse_background(std::string_view text);

// --- what is said in part: a scene file follows the same rules
// A missing colour is the mean of the two others, or the only other one.
SphericalHarmonics ambient_of(std::optional<glm::vec3> sky, std::optional<glm::vec3> horizon,
                              std::optional<glm::vec3> ground);
// Degrees. One angle alone moves the other along, so that the cone is never inside out.
void set_cone(Light& light, std::optional<float> inner, std::optional<float> outer);

// "#f80", "#ff8800", "#ff8800cc", decoded to linear; without alpha it is 1.
Outcome<glm::vec4> parse_hex_color(std::string_view text);
// One to four numbers with commas; `count` says how many. No NaN, no infinity.
Outcome<glm::vec4> parse_numbers(std::string_view text, int& count);

}  // namespace patina::runtime
