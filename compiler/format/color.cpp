#include "compiler/format/color.h"

#include <cmath>

namespace patina::format {
namespace {

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

}  // namespace

double srgb_to_linear(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::optional<LinearColor> parse_color(std::string_view text) {
    const bool is_short = text.size() == 4;
    if (!text.starts_with('#') || (!is_short && text.size() != 7 && text.size() != 9)) return std::nullopt;

    LinearColor color{.value = {0, 0, 0, 1}, .has_alpha = text.size() == 9};
    const std::size_t digits = is_short ? 1 : 2;
    for (std::size_t i = 1, component = 0; i < text.size(); i += digits, ++component) {
        const int high = hex_digit(text[i]);
        const int low = hex_digit(text[i + digits - 1]);
        if (high < 0 || low < 0) return std::nullopt;
        const double encoded = (high * 16 + low) / 255.0;
        color.value[component] = component < 3 ? srgb_to_linear(encoded) : encoded;
    }
    return color;
}

}  // namespace patina::format
