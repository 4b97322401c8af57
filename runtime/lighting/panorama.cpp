#include "runtime/lighting/panorama.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "runtime/lighting/cube.h"

namespace patina::runtime {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

glm::vec3 pixel(const Image& image, int x, int y) {
    const std::span<const float> at = image.at(x, y);
    return {at[0], at[1], at[2]};
}

// Between the middles of four pixels, whose columns and rows `column` and `row` bring back into the picture.
template <class Column, class Row>
glm::vec3 between(const Image& image, float x, float y, const Column& column, const Row& row) {
    const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
    const auto at = [&](int i, int j) { return pixel(image, column(int(left) + i), row(int(top) + j)); };
    const float right_share = x - 0.5f - left, lower_share = y - 0.5f - top;
    return glm::mix(glm::mix(at(0, 0), at(1, 0), right_share), glm::mix(at(0, 1), at(1, 1), right_share), lower_share);
}

glm::vec3 on_sphere(const Image& image, glm::vec3 d) {
    const float u = 0.5f + std::atan2(d.x, -d.z) / (2 * kPi), v = std::acos(std::clamp(d.y, -1.0f, 1.0f)) / kPi;
    return between(
        image, u * float(image.width), v * float(image.height), [&](int x) { return (x + image.width) % image.width; },
        [&](int y) { return std::clamp(y, 0, image.height - 1); });
}

// Where the faces of a cube are, in the order of cube.h and in faces from the upper left corner.
struct Layout {
    int columns = 0, rows = 0;
    std::array<glm::ivec2, 6> places{};
    bool turns_last = false;  // the last face is upside down
};
constexpr Layout kLayouts[] = {
    {4, 3, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}}},
    {3, 4, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}}}, true},
    {6, 1, {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}}},
    {1, 6, {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}}},
};

glm::vec3 on_cube(const Image& image, const Layout& layout, glm::vec3 d) {
    // The faces of cube maps are seen from inside in a left-handed space.
    CubePlace place = cube_place({d.x, d.y, -d.z});
    if (layout.turns_last && place.face == 5) place.u = 1 - place.u, place.v = 1 - place.v;
    const int size = image.width / layout.columns;
    const glm::ivec2 corner = layout.places[std::size_t(place.face)] * size;
    return between(
        image, float(corner.x) + place.u * float(size), float(corner.y) + place.v * float(size),
        [&](int x) { return std::clamp(x, corner.x, corner.x + size - 1); },
        [&](int y) { return std::clamp(y, corner.y, corner.y + size - 1); });
}

const Layout* layout_of(const Image& image) {
    for (const Layout& layout : kLayouts) {
        const int size = image.width / layout.columns;
        if (size > 0 && image.width == size * layout.columns && image.height == size * layout.rows) return &layout;
    }
    return nullptr;
}

// Empty, or which numbers of the picture are no light. Those below 0 become 0.
std::string check_light(Image& image, const std::string& what) {
    for (int y = 0; y < image.height; y++) {
        for (int x = 0; x < image.width; x++) {
            for (float& value : image.at(x, y).first(3)) {
                if (!std::isfinite(value))
                    return what + " is not light everywhere: the pixel " + std::to_string(x) + "," + std::to_string(y) +
                           " is not finite";
                value = std::max(value, 0.0f);
            }
        }
    }
    return "";
}

}  // namespace

Outcome<Panorama> panorama_of(Image image, const std::string& name) {
    const std::string what = name.empty() ? "the picture" : "'" + name + "'";
    const bool is_sphere = image.width == 2 * image.height;
    const Layout* layout = layout_of(image);
    if (!is_sphere && !layout)
        return Failure{what + " does not show all directions: it has " + std::to_string(image.width) + " x " +
                       std::to_string(image.height) +
                       " pixels, and these shapes are understood: 2:1 (equirectangular), 4:3 and 3:4 (crosses of a "
                       "cube's faces), 6:1 and 1:6 (strips of them)"};
    if (std::string error = check_light(image, what); !error.empty()) return Failure{error};
    const auto kept = std::make_shared<const Image>(std::move(image));
    if (is_sphere)
        return Panorama{.radiance = [kept](glm::vec3 d) { return on_sphere(*kept, d); },
                        .quarter = std::max(kept->width / 4, 1)};
    return Panorama{.radiance = [kept, layout](glm::vec3 d) { return on_cube(*kept, *layout, d); },
                    .quarter = kept->width / layout->columns};
}

Radiance turned(Radiance radiance, double degrees) {
    if (std::remainder(degrees, 360.0) == 0) return radiance;
    const double angle = degrees * std::numbers::pi / 180;
    const float c = float(std::cos(angle)), s = float(std::sin(angle));
    // The direction in the picture: turned back.
    return [radiance = std::move(radiance), c, s](glm::vec3 d) {
        return radiance({c * d.x - s * d.z, d.y, s * d.x + c * d.z});
    };
}

Pyramid pyramid_of(const Panorama& around, int face_size) {
    const int wanted =
        face_size > 0 ? face_size : int(std::bit_ceil(unsigned(std::clamp(around.quarter, kSmallestMap, kLargestMap))));
    // At least two directions for each pixel along each axis, so that a small sun counts as much as it does there.
    const int samples = std::max(2, (2 * around.quarter + wanted - 1) / wanted);
    return {around.radiance, wanted, samples};
}

SphericalHarmonics ambient_of(const Pyramid& pyramid) {
    return without_negative_light(
        project([&](glm::vec3 direction) { return pyramid.radiance(direction); }, pyramid.size()));
}

}  // namespace patina::runtime
