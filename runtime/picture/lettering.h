// Text on pictures, for labels: one line, drawn by FreeType through OpenImageIO in the font DejaVu Sans.
//
//   Outcome<Lettering> label = lettering("_Roughness = 0.5", 14);
//   if (label) put(image, label.value, 4, 20, {0.8f, 0.8f, 0.8f});
#pragma once

#include <array>
#include <string>
#include <vector>

#include "runtime/outcome.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

// A line of text as coverage, 0 to 1, row by row. Lines of one size have one height and one baseline.
struct Lettering {
    int width = 0, height = 0;
    std::vector<float> coverage{};
};

// `size`: pixels of an em. The error says that the font is not installed.
Outcome<Lettering> lettering(const std::string& text, int size);
// The same, made smaller and then cut ("_Rough...") until it is at most `width` pixels wide.
Outcome<Lettering> lettering_within(std::string text, int size, int width);

// Draws it with its upper left corner at `x`, `y`; parts outside the image are left out.
void put(Image& image, const Lettering& text, int x, int y, const std::array<float, 3>& linear_color);

}  // namespace patina::runtime
