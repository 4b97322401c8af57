// Reads the colours of graph files: "#f5cfc0" -> linear light. Authors pick colours in sRGB; everything computes in
// linear light.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace patina::format {

struct LinearColor {
    std::array<double, 4> value{};
    bool has_alpha = false;  // false: value[3] is 1
};

// "#rgb", "#rrggbb" or "#rrggbbaa"; alpha is linear already. Nothing if the text is not a colour.
std::optional<LinearColor> parse_color(std::string_view text);

// Converts an sRGB component, 0 to 1, to linear light (IEC 61966-2-1).
double srgb_to_linear(double encoded);

}  // namespace patina::format
