#include "compiler/importers/mtlx/colors.h"

#include <algorithm>
#include <cmath>

namespace patina::importers::mtlx {
namespace {

// Academy S-2014-004 (ACEScg) to IEC 61966-2-1, adapted from D60 to D65 by Bradford's transform; Adobe RGB (1998) and
// Display P3 to the same.
constexpr double kAcescg[] = {1.7050509,  -0.6217921, -0.0832588, -0.1302564, 1.1408047,
                              -0.0105483, -0.0240033, -0.1289690, 1.1529724};
constexpr double kAdobe[] = {1.3983557, -0.3983557, 0, 0, 1, 0, 0, -0.0429290, 1.0429290};
constexpr double kP3[] = {1.2249401, -0.2249402, 0, -0.0420570, 1.0420571, 0, -0.0196376, -0.0786361, 1.0982736};

struct Row {
    std::string_view name;
    Colorspace space;
};
constexpr Row kSpaces[] = {
    {"", {}},
    {"none", {}},
    {"raw", {}},
    {"Raw", {}},
    {"data", {}},
    {"lin_rec709", {}},
    {"lin_rec709_scene", {}},
    {"lin_srgb", {}},
    {"linear", {}},
    {"srgb_texture", {.gamma = 0, .is_color = true}},
    {"srgb_rec709_scene", {.gamma = 0, .is_color = true}},
    {"sRGB", {.gamma = 0, .is_color = true}},
    {"rec709_display", {.gamma = 2.4, .is_color = true}},
    {"g18_rec709", {.gamma = 1.8, .is_color = true}},
    {"g22_rec709", {.gamma = 2.2, .is_color = true}},
    {"gamma18", {.gamma = 1.8, .is_color = true}},
    {"gamma22", {.gamma = 2.2, .is_color = true}},
    {"gamma24", {.gamma = 2.4, .is_color = true}},
    {"acescg", {.matrix = kAcescg}},
    {"lin_ap1", {.matrix = kAcescg}},
    {"lin_ap1_scene", {.matrix = kAcescg}},
    {"g22_ap1", {.gamma = 2.2, .matrix = kAcescg, .is_color = true}},
    {"lin_adobergb", {.matrix = kAdobe}},
    {"adobergb", {.gamma = 2.19921875, .matrix = kAdobe, .is_color = true}},
    {"lin_displayp3", {.matrix = kP3}},
    {"srgb_displayp3", {.gamma = 0, .matrix = kP3, .is_color = true}},
};

}  // namespace

Colorspace colorspace_of(std::string_view name) {
    for (const Row& row : kSpaces)
        if (row.name == name) return row.space;
    return {.is_known = false};
}

void to_linear(const Colorspace& space, std::vector<double>& color) {
    if (color.size() < 3) return;
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = color[i];
        if (space.gamma == 0)
            color[i] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
        else if (space.gamma != 1)
            color[i] = std::pow(std::max(value, 0.0), space.gamma);
    }
    if (!space.matrix) return;
    const double red = color[0], green = color[1], blue = color[2];
    for (std::size_t i = 0; i < 3; ++i)
        color[i] = space.matrix[i * 3] * red + space.matrix[i * 3 + 1] * green + space.matrix[i * 3 + 2] * blue;
}

}  // namespace patina::importers::mtlx
