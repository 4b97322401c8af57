#include "compiler/interpret/texels.h"

#include <algorithm>
#include <cmath>

namespace patina::interpret {

const float* texel_at(const TextureLevel& level, std::size_t x, std::size_t y, std::size_t layer) {
    const auto width = static_cast<std::size_t>(level.width), height = static_cast<std::size_t>(level.height);
    return level.texels.data() + 4 * ((layer * height + y) * width + x);
}

namespace {

// The index of a texel for any coordinate, infinity and NaN included.
std::size_t wrapped(double index, int size, Wrap wrap) {
    if (!std::isfinite(index)) return 0;
    double inside = index;
    switch (wrap) {
        case Wrap::Repeat: inside = index - size * std::floor(index / size); break;
        case Wrap::Clamp: break;
        case Wrap::Mirror: {
            const double twice = index - 2.0 * size * std::floor(index / (2.0 * size));
            inside = twice < size ? twice : 2.0 * size - 1 - twice;
            break;
        }
    }
    return static_cast<std::size_t>(std::clamp(inside, 0.0, size - 1.0));
}

Texel nearest(const Reader& reader, const TextureLevel& level, double u, double v, std::size_t layer) {
    const float* texel = texel_at(level, wrapped(std::floor(u * level.width), level.width, reader.wrap),
                                  wrapped(std::floor(v * level.height), level.height, reader.wrap), layer);
    return {texel[0], texel[1], texel[2], texel[3]};
}

Texel bilinear(const Reader& reader, const TextureLevel& level, double u, double v, std::size_t layer) {
    // Texel centres are at halves.
    const double x = u * level.width - 0.5, y = v * level.height - 0.5;
    const double left = std::floor(x), top = std::floor(y);
    const double right_weight = std::isfinite(x) ? x - left : 0, bottom_weight = std::isfinite(y) ? y - top : 0;
    const std::array columns = {wrapped(left, level.width, reader.wrap), wrapped(left + 1, level.width, reader.wrap)};
    const std::array rows = {wrapped(top, level.height, reader.wrap), wrapped(top + 1, level.height, reader.wrap)};
    const std::array column_weights = {1 - right_weight, right_weight},
                     row_weights = {1 - bottom_weight, bottom_weight};
    Texel sum{};
    for (std::size_t j : {0u, 1u}) {
        for (std::size_t i : {0u, 1u}) {
            const float* texel = texel_at(level, columns[i], rows[j], layer);
            for (std::size_t c = 0; c < 4; ++c) sum[c] += column_weights[i] * row_weights[j] * texel[c];
        }
    }
    return sum;
}

// Between the two nearest layers of a 3D texture.
Texel trilinear(const Reader& reader, const TextureLevel& level, double u, double v, double w) {
    const double z = w * level.depth - 0.5, front = std::floor(z), weight = std::isfinite(z) ? z - front : 0;
    const Texel first = bilinear(reader, level, u, v, wrapped(front, level.depth, reader.wrap));
    const Texel second = bilinear(reader, level, u, v, wrapped(front + 1, level.depth, reader.wrap));
    Texel mixed{};
    for (std::size_t c = 0; c < 4; ++c) mixed[c] = first[c] + (second[c] - first[c]) * weight;
    return mixed;
}

// --- cubes

// Where a direction meets the cube: the face, and the place on it from 0 to 1 (Vulkan, "Cube Map Face Selection").
struct OnFace {
    std::size_t face = 0;
    double u = 0, v = 0;
};

// If two components are equally long, z wins over y, and y over x.
std::size_t face_of(const Direction& d) {
    const double x = std::abs(d[0]), y = std::abs(d[1]), z = std::abs(d[2]);
    if (z >= x && z >= y) return d[2] >= 0 ? 4 : 5;
    if (y >= x) return d[1] >= 0 ? 2 : 3;
    return d[0] >= 0 ? 0 : 1;
}

// A direction in the axes of a face: to the right, down, and out of the cube.
Direction in_face(std::size_t face, const Direction& d) {
    switch (face) {
        case 0: return {-d[2], -d[1], d[0]};
        case 1: return {d[2], -d[1], -d[0]};
        case 2: return {d[0], d[2], d[1]};
        case 3: return {d[0], -d[2], -d[1]};
        case 4: return {d[0], -d[1], d[2]};
        default: return {-d[0], -d[1], -d[2]};
    }
}

OnFace on_face(const Direction& d) {
    const std::size_t face = face_of(d);
    const Direction at = in_face(face, d);
    return {face, 0.5 * (at[0] / at[2] + 1), 0.5 * (at[1] / at[2] + 1)};
}

// The way back; u and v may lie a little outside.
Direction through(const OnFace& place) {
    const double s = 2 * place.u - 1, t = 2 * place.v - 1;
    switch (place.face) {
        case 0: return {1, -t, -s};
        case 1: return {-1, -t, s};
        case 2: return {s, 1, t};
        case 3: return {s, -1, -t};
        case 4: return {s, -t, 1};
        default: return {-s, -t, -1};
    }
}

// A texel of a face, or of the neighbouring face if it lies beyond one edge. Beyond two edges there is none.
const float* cube_texel(const TextureLevel& level, std::size_t face, double x, double y) {
    const double size = level.width;
    const auto inside = [&](double i) { return i >= 0 && i < size; };
    const auto index = [&](double i) { return static_cast<std::size_t>(std::clamp(i, 0.0, size - 1)); };
    if (inside(x) && inside(y)) return texel_at(level, index(x), index(y), face);
    if (!inside(x) && !inside(y)) return nullptr;
    // Just beyond the edge, where the position along the edge is still the same.
    const auto centre = [&](double i) { return i < 0 ? -1e-6 : i >= size ? 1 + 1e-6 : (i + 0.5) / size; };
    const OnFace beyond = on_face(through({.face = face, .u = centre(x), .v = centre(y)}));
    return texel_at(level, index(std::floor(beyond.u * size)), index(std::floor(beyond.v * size)), beyond.face);
}

// Filtered over the edges; at a corner, where three faces meet, the missing texel is the mean of the others.
Texel cube_bilinear(const TextureLevel& level, const OnFace& place) {
    const double x = place.u * level.width - 0.5, y = place.v * level.width - 0.5;
    const double left = std::floor(x), top = std::floor(y);
    const std::array column_weights = {1 - (x - left), x - left}, row_weights = {1 - (y - top), y - top};
    std::array<const float*, 4> texels{};
    for (std::size_t k = 0; k < 4; ++k) {
        texels[k] = cube_texel(level, place.face, left + static_cast<double>(k & 1), top + static_cast<double>(k >> 1));
    }
    Texel sum{};
    for (std::size_t k = 0; k < 4; ++k) {
        const double weight = column_weights[k & 1] * row_weights[k >> 1];
        for (std::size_t c = 0; c < 4; ++c) {
            double value = 0;
            if (texels[k]) {
                value = texels[k][c];
            } else {
                for (const float* other : texels) value += other ? other[c] / 3.0 : 0;
            }
            sum[c] += weight * value;
        }
    }
    return sum;
}

// --- levels

// `bilinear_at` and `nearest_at` read one level.
template <class Linear, class Nearest>
Texel mixed_levels(const Reader& reader, double lod, Linear bilinear_at, Nearest nearest_at) {
    // fmin and fmax let a level that is not a number be level 0.
    const double level = std::fmin(std::fmax(lod, 0.0), reader.last_level());
    const auto whole = [&](double l) -> const TextureLevel& {
        return reader.texture.levels[static_cast<std::size_t>(l)];
    };
    if (!reader.is_linear) {
        const double near_level = std::fmax(std::ceil(level + 0.5) - 1, 0.0);
        return nearest_at(whole(std::fmin(near_level, reader.last_level())));
    }
    const double finer = std::floor(level), weight = level - finer;
    Texel mixed = bilinear_at(whole(finer));
    if (weight == 0) return mixed;
    const Texel coarse = bilinear_at(whole(finer + 1));
    for (std::size_t c = 0; c < 4; ++c) mixed[c] += (coarse[c] - mixed[c]) * weight;
    return mixed;
}

}  // namespace

Texel in_layer(const Reader& reader, double u, double v, double lod, std::size_t layer) {
    return mixed_levels(
        reader, lod, [&](const TextureLevel& level) { return bilinear(reader, level, u, v, layer); },
        [&](const TextureLevel& level) { return nearest(reader, level, u, v, layer); });
}

Texel in_volume(const Reader& reader, const Direction& place, double lod) {
    const auto nearest_at = [&](const TextureLevel& level) {
        const std::size_t layer = wrapped(std::floor(place[2] * level.depth), level.depth, reader.wrap);
        return nearest(reader, level, place[0], place[1], layer);
    };
    return mixed_levels(
        reader, lod, [&](const TextureLevel& level) { return trilinear(reader, level, place[0], place[1], place[2]); },
        nearest_at);
}

Texel in_cube(const Reader& reader, const Direction& direction, double lod) {
    const OnFace place = on_face(direction);
    if (!std::isfinite(place.u) || !std::isfinite(place.v)) return {};
    const auto nearest_at = [&](const TextureLevel& level) -> Texel {
        const double last = level.width - 1;
        const auto index = [&](double at) {
            return static_cast<std::size_t>(std::clamp(std::floor(at * level.width), 0.0, last));
        };
        const float* texel = texel_at(level, index(place.u), index(place.v), place.face);
        return {texel[0], texel[1], texel[2], texel[3]};
    };
    return mixed_levels(
        reader, lod, [&](const TextureLevel& level) { return cube_bilinear(level, place); }, nearest_at);
}

// The level of detail of a footprint: log2 of the longer of its two sides, in texels of level 0.
double flat_level(const Reader& reader, std::array<double, 2> dx, std::array<double, 2> dy) {
    const TextureLevel& base = reader.texture.levels[0];
    const auto length = [&](std::array<double, 2> d) { return std::hypot(d[0] * base.width, d[1] * base.height); };
    return std::log2(std::fmax(length(dx), length(dy)));
}

// The footprint on the face that the pixel itself looks at: the derivatives of the place on it.
double cube_level(const Reader& reader, const Direction& direction, const Direction& dx, const Direction& dy) {
    const std::size_t face = face_of(direction);
    const Direction at = in_face(face, direction);
    const auto moved = [&](const Direction& by) -> std::array<double, 2> {
        const Direction way = in_face(face, by);
        const double scale = 0.5 / (at[2] * at[2]);
        return {(way[0] * at[2] - at[0] * way[2]) * scale, (way[1] * at[2] - at[1] * way[2]) * scale};
    };
    return flat_level(reader, moved(dx), moved(dy));
}

// The level of a footprint in a 3D texture.
double volume_level(const Reader& reader, const Direction& dx, const Direction& dy) {
    const TextureLevel& base = reader.texture.levels[0];
    const auto length = [&](const Direction& d) {
        return std::hypot(d[0] * base.width, d[1] * base.height, d[2] * base.depth);
    };
    return std::log2(std::fmax(length(dx), length(dy)));
}

}  // namespace patina::interpret
