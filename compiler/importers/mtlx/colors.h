// The colour spaces that documents name, and their numbers as linear light with the primaries of sRGB.
#pragma once

#include <string_view>
#include <vector>

namespace patina::importers::mtlx {

struct Colorspace {
    double gamma = 1;                // 0: the curve of sRGB
    const double* matrix = nullptr;  // three rows, to the primaries of sRGB; null: they are these
    bool is_known = true;
    bool is_color = false;  // pictures in it are decoded as sRGB
};
Colorspace colorspace_of(std::string_view name);  // "srgb_texture", "acescg"
// The first three numbers.
void to_linear(const Colorspace& space, std::vector<double>& color);

}  // namespace patina::importers::mtlx
