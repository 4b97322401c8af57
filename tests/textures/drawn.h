// Draws a plane that fills a small picture with a graph given as text, and the textures that a test makes. The left
// half shows one value and the right half may show another.
//
//   const Drawing drawing("glsl");
//   Image seen = drawing.picture("name", R"("properties": [...], ...)", {{"_Map", file}});
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "runtime/render/render_request.h"

namespace patina::runtime {

inline constexpr int kSide = 8;  // of the picture

// An 8-bit PNG of these texels, row by row, as the numbers are; its path.
std::string png_of(const std::string& name, int width, int height, const std::vector<std::array<float, 4>>& texels);

// `graph`: the members of a material's graph after "patina" and "workflow"; the workflow is unlit. Empty after an
// error, which is a failure of the test.
Image drawn(const std::string& via, const std::string& name, const std::string& graph,
            const std::map<std::string, std::string>& files);

// The pixel at a quarter of the width (0) or at three quarters (1), and so for the height.
void expect_at(const Image& picture, int right, int down, std::array<double, 3> expected, const std::string& what);

}  // namespace patina::runtime
