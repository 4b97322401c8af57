// "#f5cfc0" -> linear light. Graph files write colours as people pick them, in sRGB; everything computes in linear.
//
//   parse_color("#ff8000")->value   // {1, 0.2158605, 0, 1}
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace patina::graph {

struct LinearColor {
    std::array<double, 4> value{};
    bool has_alpha = false;  // else value[3] is 1
};

// "#rgb", "#rrggbb" or "#rrggbbaa"; alpha is linear as written. Nothing if it is none of these.
std::optional<LinearColor> parse_color(std::string_view text);

// IEC 61966-2-1: an sRGB component, 0 to 1, to linear light.
double srgb_to_linear(double encoded);

}  // namespace patina::graph
