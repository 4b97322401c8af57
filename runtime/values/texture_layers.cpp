#include "runtime/values/texture_layers.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/lighting/cube.h"
#include "runtime/lighting/panorama.h"

namespace patina::runtime {

Outcome<std::vector<Image>> cube_faces(Image image, const std::string& name) {
    const int bits = image.bits;
    std::vector<Image> faces;
    if (image.width == 1 && image.height == 1) {  // a named default
        faces.assign(6, image);
        return faces;
    }
    const Outcome<Panorama> around = panorama_of(std::move(image), name);
    if (!around) return Failure{around.error};
    const int size = around.value.quarter;
    for (int face = 0; face < 6; face++) {
        Image& made = faces.emplace_back(make_image(size, size));
        made.bits = bits;
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                const glm::vec3 seen = around.value.radiance(cube_direction(face, x, y, size));
                const std::array texel = {seen.r, seen.g, seen.b, 1.0f};
                std::copy(texel.begin(), texel.end(), made.at(x, y).begin());
            }
        }
    }
    return faces;
}

Outcome<std::vector<Image>> grid_layers(const Image& image, std::array<int, 2> grid, const std::string& name) {
    const auto [columns, rows] = grid;
    if (image.width % columns != 0 || image.height % rows != 0)
        return Failure{fmt::format("'{}' has {} x {} pixels, which the grid [{}, {}] does not divide into equal layers",
                                   name, image.width, image.height, columns, rows)};
    if (columns * rows > kMostLayers)
        return Failure{fmt::format("the grid [{}, {}] of '{}' has {} layers; a texture may have {}", columns, rows,
                                   name, columns * rows, kMostLayers)};
    const int width = image.width / columns, height = image.height / rows;
    std::vector<Image> layers;
    for (int row = 0; row < rows; row++) {
        for (int column = 0; column < columns; column++) {
            Image& made = layers.emplace_back(make_image(width, height));
            made.bits = image.bits;
            for (int y = 0; y < height; y++) {
                const float* from = image.at(column * width, row * height + y).data();
                std::copy_n(from, std::size_t(4) * width, made.at(0, y).data());
            }
        }
    }
    return layers;
}

}  // namespace patina::runtime
