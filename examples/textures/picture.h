// A square picture that tiles, and what is made from a height field: a normal map and cavity shading. Values are what
// the file stores, 0 to 1; colours are given as they are stored (sRGB).
//
//   Picture color(256);
//   color.fill([](float u, float v) { return Color{u, v, 0, 1}; });
//   save(color, 3, "out/gradient.png");
#pragma once

#include <array>
#include <string>
#include <vector>

namespace textures {

using Color = std::array<float, 4>;
Color mix(const Color& a, const Color& b, float t);
// Each of r, g and b multiplied, alpha kept.
Color scaled(const Color& color, float factor);

struct Picture {
    int size = 0;
    std::vector<Color> texels;  // rows from the top

    explicit Picture(int edge) : size(edge), texels(static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge)) {}

    // Wraps around at the edges.
    Color& at(int x, int y) {
        const int cx = (x % size + size) % size, cy = (y % size + size) % size;
        return texels[static_cast<std::size_t>(cy) * static_cast<std::size_t>(size) + static_cast<std::size_t>(cx)];
    }
    const Color& at(int x, int y) const { return const_cast<Picture*>(this)->at(x, y); }

    // paint(u, v) at every texel's centre; v grows downwards, as texture coordinates do.
    template <class Paint>
    void fill(Paint paint) {
        const float step = 1.0f / static_cast<float>(size);
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                at(x, y) = paint((static_cast<float>(x) + 0.5f) * step, (static_cast<float>(y) + 0.5f) * step);
            }
        }
    }
};

// Tangent-space normals (red: +u, green: up in the picture, as OpenGL has it) of the heights in one channel. `depth` is
// the height of value 1 in texels; alpha carries the height on.
Picture normals_of(const Picture& heights, int channel, float depth);

// 1 on open ground, less where the surroundings within `radius` texels are higher: ambient occlusion of a height field.
float cavity(const Picture& heights, int channel, int x, int y, int radius, float strength);

// Writes the first `channels` channels as an 8-bit PNG; an error message, or empty.
std::string save(const Picture& picture, int channels, const std::string& path);

}  // namespace textures
