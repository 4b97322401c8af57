// What the ops over textures compute: the texels of texels.h.
#include <algorithm>
#include <cmath>

#include "compiler/interpret/kernels.h"
#include "compiler/interpret/rounding.h"
#include "compiler/interpret/texels.h"

namespace patina::interpret {
namespace {

using ir::Kind;
using ir::Op;

// A global without a texture reads white, so that a factor changes nothing.
constexpr Texel kUnbound = {1, 1, 1, 1};
constexpr Texel kNothing = {0, 0, 0, 0};

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

// The sampler state is that of the texture data bound to the sampler. If none is bound, it is the state of the texture.
Reader make_reader(const Step& step, const Machine& machine, const TextureData& texture, unsigned lane) {
    const TextureData* state = bound(step, machine, 1, lane);
    const Sampler& sampler = state ? state->sampler : texture.sampler;
    return {.texture = texture, .wrap = sampler.wrap, .is_linear = sampler.filter == Filter::Linear};
}

Direction place_of(const Step& step, const Machine& machine, unsigned which, unsigned lane) {
    return {operand(step, machine, which, 0, lane), operand(step, machine, which, 1, lane),
            operand(step, machine, which, 2, lane)};
}

Direction difference(const Direction& a, const Direction& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// The level of a footprint whose derivatives have the operands `which`, or are the differences to the quad's first
// pixel.
template <Kind kind>
double level_of(const Reader& reader, const Direction& at, const Direction& dx, const Direction& dy) {
    if constexpr (kind == Kind::TextureCube) return cube_level(reader, at, dx, dy);
    if constexpr (kind == Kind::Texture3D) return volume_level(reader, dx, dy);
    return flat_level(reader, {dx[0], dx[1]}, {dy[0], dy[1]});
}

// The components of a coordinate, or of its derivative; components that the kind lacks are 0.
template <Kind kind>
Direction numbers(const Step& step, const Machine& machine, unsigned which, unsigned lane, bool is_derivative) {
    const bool has_two = kind == Kind::Texture2D || (kind == Kind::Texture2DArray && is_derivative);
    if (!has_two) return place_of(step, machine, which, lane);
    const auto [u, v] = pair(step, machine, which, lane);
    return {u, v, 0};
}

template <Kind kind, Op op>
double level(const Step& step, const Machine& machine, const Reader& reader, unsigned lane) {
    if constexpr (op == Op::SampleLevel) return operand(step, machine, 3, 0, lane);
    if constexpr (op == Op::SampleGrad) {
        return level_of<kind>(reader, numbers<kind>(step, machine, 2, lane, false),
                              numbers<kind>(step, machine, 3, lane, true), numbers<kind>(step, machine, 4, lane, true));
    }
    // One level for the whole quad, from the differences at its first pixel. Vertices read the finest.
    const double bias = op == Op::SampleBias ? operand(step, machine, 3, 0, lane) : 0;
    if (!machine.is_quad) return bias;
    const Direction corner = numbers<kind>(step, machine, 2, 0, false);
    return level_of<kind>(reader, corner, difference(numbers<kind>(step, machine, 2, 1, false), corner),
                          difference(numbers<kind>(step, machine, 2, 2, false), corner)) +
           bias;
}

// Layers are not filtered: the nearest one, halves to the even one. A layer that is not a number is layer 0.
std::size_t layer_of(const TextureData& texture, double layer) {
    return static_cast<std::size_t>(std::fmin(std::fmax(std::nearbyint(layer), 0.0), texture.layers - 1.0));
}

template <Kind kind, Op op>
void sample_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const TextureData* texture = bound(step, machine, 0, lane);
        if (!texture || (kind == Kind::TextureCube && texture->layers != 6)) {
            store(step, machine, lane, kUnbound);
            continue;
        }
        const Reader reader = make_reader(step, machine, *texture, lane);
        const Direction at = numbers<kind>(step, machine, 2, lane, false);
        const double lod = level<kind, op>(step, machine, reader, lane);
        if constexpr (kind == Kind::TextureCube) {
            store(step, machine, lane, in_cube(reader, at, lod));
        } else if constexpr (kind == Kind::Texture3D) {
            store(step, machine, lane, in_volume(reader, at, lod));
        } else {
            store(step, machine, lane, in_layer(reader, at[0], at[1], lod, layer_of(*texture, at[2])));
        }
    }
}

template <Kind kind>
Kernel kernel_of(Op op) {
    if (op == Op::Sample) return sample_kernel<kind, Op::Sample>;
    if (op == Op::SampleBias) return sample_kernel<kind, Op::SampleBias>;
    if (op == Op::SampleLevel) return sample_kernel<kind, Op::SampleLevel>;
    return op == Op::SampleGrad ? sample_kernel<kind, Op::SampleGrad> : nullptr;
}

// Null where there is no such level.
const TextureLevel* level_at(const TextureData* texture, double level) {
    static const TextureLevel unbound{.width = 1, .height = 1, .texels = {1, 1, 1, 1}};
    if (!texture) return level == 0 ? &unbound : nullptr;
    const bool exists = level >= 0 && level < static_cast<double>(texture->levels.size());
    return exists ? &texture->levels[static_cast<std::size_t>(level)] : nullptr;
}

// Zero outside of the texture, as robust image access and Direct3D define it.
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

}  // namespace

Kernel sampling_kernel(Op op, ir::Kind texture) {
    if (op == Op::TextureSize) return size_kernel;
    if (op == Op::TexelLoad) return load_kernel;
    if (texture == Kind::TextureCube) return kernel_of<Kind::TextureCube>(op);
    if (texture == Kind::Texture2DArray) return kernel_of<Kind::Texture2DArray>(op);
    return texture == Kind::Texture3D ? kernel_of<Kind::Texture3D>(op) : kernel_of<Kind::Texture2D>(op);
}

}  // namespace patina::interpret
