// Texture reads, as Vulkan describes them ("Texel Input Operations"), on RGBA texels in linear floats.
//
// Left out: anisotropy (a footprint that is longer than wide is sampled as a square, so such places are blurrier than
// on a GPU), and cube maps: nothing in the public interface brings their texels, so a cube is opaque black.
#include <algorithm>
#include <cmath>

#include "compiler/interpret/kernels.h"
#include "compiler/interpret/rounding.h"

namespace patina::interpret {
namespace {

using ir::Op;

using Texel = std::array<double, 4>;
// What no texture is bound to reads white, so that a factor stays what it is.
constexpr Texel kUnbound = {1, 1, 1, 1};
constexpr Texel kNothing = {0, 0, 0, 0};

enum class Wrap { Repeat, Clamp, Mirror };

// A texture and how it is read.
struct Reader {
    const TextureData& texture;
    Wrap wrap = Wrap::Repeat;
    bool is_linear = true;

    double last_level() const { return static_cast<double>(texture.levels.size() - 1); }
};

// The index of a texel, from one that may be anywhere, infinity and NaN included.
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

const float* texel_at(const TextureLevel& level, std::size_t x, std::size_t y) {
    return level.texels.data() + 4 * (y * static_cast<std::size_t>(level.width) + x);
}

Texel nearest(const Reader& reader, const TextureLevel& level, double u, double v) {
    const float* texel = texel_at(level, wrapped(std::floor(u * level.width), level.width, reader.wrap),
                                  wrapped(std::floor(v * level.height), level.height, reader.wrap));
    return {texel[0], texel[1], texel[2], texel[3]};
}

Texel bilinear(const Reader& reader, const TextureLevel& level, double u, double v) {
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
            const float* texel = texel_at(level, columns[i], rows[j]);
            for (std::size_t c = 0; c < 4; ++c) sum[c] += column_weights[i] * row_weights[j] * texel[c];
        }
    }
    return sum;
}

Texel at_level(const Reader& reader, double u, double v, double lod) {
    // fmin and fmax let a level that is not a number be level 0.
    const double level = std::fmin(std::fmax(lod, 0.0), reader.last_level());
    const auto whole = [&](double l) -> const TextureLevel& {
        return reader.texture.levels[static_cast<std::size_t>(l)];
    };
    if (!reader.is_linear) {
        const double near_level = std::fmax(std::ceil(level + 0.5) - 1, 0.0);
        return nearest(reader, whole(std::fmin(near_level, reader.last_level())), u, v);
    }
    const double finer = std::floor(level), weight = level - finer;
    Texel mixed = bilinear(reader, whole(finer), u, v);
    if (weight == 0) return mixed;
    const Texel coarse = bilinear(reader, whole(finer + 1), u, v);
    for (std::size_t c = 0; c < 4; ++c) mixed[c] += (coarse[c] - mixed[c]) * weight;
    return mixed;
}

// The level of detail of a footprint: log2 of the longer of its two sides, in texels of level 0.
double level_of(const Reader& reader, std::array<double, 2> dx, std::array<double, 2> dy) {
    const TextureLevel& base = reader.texture.levels[0];
    const auto length = [&](std::array<double, 2> d) { return std::hypot(d[0] * base.width, d[1] * base.height); };
    return std::log2(std::fmax(length(dx), length(dy)));
}

// --- kernels

double operand(const Step& step, const Machine& machine, unsigned which, unsigned component, unsigned lane) {
    return machine.at(step.from[which] + component)[lane];
}
std::array<double, 2> pair(const Step& step, const Machine& machine, unsigned which, unsigned lane) {
    return {operand(step, machine, which, 0, lane), operand(step, machine, which, 1, lane)};
}

// The opaque operand holds the global's index.
const TextureData* bound(const Step& step, const Machine& machine, unsigned which, unsigned lane) {
    const auto global = static_cast<std::size_t>(operand(step, machine, which, 0, lane));
    return global < machine.textures.size() ? machine.textures[global].get() : nullptr;
}

void store(const Step& step, Machine& machine, unsigned lane, const Texel& texel) {
    for (unsigned c = 0; c < 4; ++c) {
        const double value = texel[c];
        machine.at(step.to + c)[lane] = machine.precision == Precision::Float ? to_float(value) : value;
    }
}

// A sampler's state comes with the texture data that is bound to it, else with the texture's own.
Reader make_reader(const Step& step, const Machine& machine, const TextureData& texture, unsigned lane) {
    const TextureData* state = bound(step, machine, 1, lane);
    const Sampler& sampler = state ? state->sampler : texture.sampler;
    return {.texture = texture,
            .wrap = sampler.wrap == "clamp"    ? Wrap::Clamp
                    : sampler.wrap == "mirror" ? Wrap::Mirror
                                               : Wrap::Repeat,
            .is_linear = sampler.filter != "nearest"};
}

// One level for the whole quad, from the differences at its first pixel.
double implicit_level(const Step& step, const Machine& machine, const Reader& reader) {
    const auto corner = pair(step, machine, 2, 0), right = pair(step, machine, 2, 1), below = pair(step, machine, 2, 2);
    return level_of(reader, {right[0] - corner[0], right[1] - corner[1]}, {below[0] - corner[0], below[1] - corner[1]});
}

template <Op op>
double level(const Step& step, const Machine& machine, const Reader& reader, unsigned lane) {
    if constexpr (op == Op::SampleLevel) return operand(step, machine, 3, 0, lane);
    if constexpr (op == Op::SampleGrad) {
        return level_of(reader, pair(step, machine, 3, lane), pair(step, machine, 4, lane));
    }
    const double bias = op == Op::SampleBias ? operand(step, machine, 3, 0, lane) : 0;
    return implicit_level(step, machine, reader) + bias;
}

template <Op op>
void sample_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const TextureData* texture = bound(step, machine, 0, lane);
        if (!texture) {
            store(step, machine, lane, kUnbound);
            continue;
        }
        const Reader reader = make_reader(step, machine, *texture, lane);
        const auto [u, v] = pair(step, machine, 2, lane);
        store(step, machine, lane, at_level(reader, u, v, level<op>(step, machine, reader, lane)));
    }
}

// Null where there is no such level.
const TextureLevel* level_at(const TextureData* texture, double level) {
    static const TextureLevel unbound{.width = 1, .height = 1, .texels = {1, 1, 1, 1}};
    if (!texture) return level == 0 ? &unbound : nullptr;
    const bool exists = level >= 0 && level < static_cast<double>(texture->levels.size());
    return exists ? &texture->levels[static_cast<std::size_t>(level)] : nullptr;
}

// Outside the texture there is nothing: zero, as robust image access and Direct3D define it.
void load_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const TextureLevel* level = level_at(bound(step, machine, 0, lane), operand(step, machine, 2, 0, lane));
        const auto [x, y] = pair(step, machine, 1, lane);
        if (!level || x < 0 || y < 0 || x >= level->width || y >= level->height) {
            store(step, machine, lane, kNothing);
            continue;
        }
        const float* texel = texel_at(*level, static_cast<std::size_t>(x), static_cast<std::size_t>(y));
        store(step, machine, lane, {texel[0], texel[1], texel[2], texel[3]});
    }
}

void size_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const TextureLevel* level = level_at(bound(step, machine, 0, lane), operand(step, machine, 1, 0, lane));
        machine.at(step.to)[lane] = level ? level->width : 0;
        machine.at(step.to + 1)[lane] = level ? level->height : 0;
    }
}

void cube_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) store(step, machine, lane, {0, 0, 0, 1});
}

}  // namespace

Kernel sampling_kernel(Op op, ir::Kind texture) {
    if (op == Op::TextureSize) return size_kernel;
    if (texture == ir::Kind::TextureCube) return cube_kernel;
    if (op == Op::Sample) return sample_kernel<Op::Sample>;
    if (op == Op::SampleBias) return sample_kernel<Op::SampleBias>;
    if (op == Op::SampleLevel) return sample_kernel<Op::SampleLevel>;
    if (op == Op::SampleGrad) return sample_kernel<Op::SampleGrad>;
    return op == Op::TexelLoad ? load_kernel : nullptr;
}

}  // namespace patina::interpret
