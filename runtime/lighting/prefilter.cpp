#include "runtime/lighting/prefilter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <thread>

namespace patina::runtime {
namespace {

constexpr double kPi = std::numbers::pi;

// Runs `work` for 0 to 5, each on a thread.
template <class Work>
void on_each_face(const Work& work) {
    std::vector<std::thread> threads;
    for (int face = 1; face < 6; face++) threads.emplace_back(work, face);
    work(0);
    for (std::thread& thread : threads) thread.join();
}

// Van der Corput's sequence in base 2.
double radical_inverse(std::uint32_t bits) {
    bits = (bits << 16) | (bits >> 16);
    bits = ((bits & 0x55555555u) << 1) | ((bits & 0xAAAAAAAAu) >> 1);
    bits = ((bits & 0x33333333u) << 2) | ((bits & 0xCCCCCCCCu) >> 2);
    bits = ((bits & 0x0F0F0F0Fu) << 4) | ((bits & 0xF0F0F0F0u) >> 4);
    bits = ((bits & 0x00FF00FFu) << 8) | ((bits & 0xFF00FF00u) >> 8);
    return bits * (1.0 / 4294967296.0);
}

std::size_t at(int size, int face, int x, int y) {
    return (std::size_t(face) * size + std::size_t(y)) * size + std::size_t(x);
}

// Runs `work` for each texel of a cube, each face on a thread.
template <class Work>
void each_texel(int size, const Work& work) {
    on_each_face([&](int face) {
        for (int y = 0; y < size; y++)
            for (int x = 0; x < size; x++) work(face, x, y);
    });
}

glm::vec3 mean_in_texel(const Radiance& radiance, int face, int x, int y, int size, int samples) {
    glm::vec3 sum(0);
    for (int j = 0; j < samples; j++)
        for (int i = 0; i < samples; i++)
            sum += radiance(cube_direction(face, x * samples + i, y * samples + j, size * samples));
    return sum / float(samples * samples);
}

// A direction around +z in which a surface reflects a view along its normal.
struct Mirrored {
    glm::vec3 direction;
    float weight;  // with n.l in it
    float level;   // of the pyramid, as wide as the sample
};

std::vector<Mirrored> mirrored_directions(float roughness, int count, int size) {
    double a2 = std::pow(double(roughness), 4), texel = 4 * kPi / (6.0 * size * size);
    std::vector<Mirrored> result;
    for (int i = 0; i < count; i++) {
        // More samples lie in the tail, each with less weight.
        double s = (i + 0.5) / count, u = 1 - (1 - s) * (1 - s), weight = 2 * (1 - s);
        double phi = kPi * radical_inverse(std::uint32_t(i));
        double cos2 = (1 - u) / (1 + (a2 - 1) * u), sin2 = std::max(1 - cos2, 0.0);
        // l = 2 (v.h) h - v with v = (0, 0, 1)
        double along = 2 * cos2 - 1, across = 2 * std::sqrt(cos2 * sin2);
        if (along <= 0) continue;
        // Its probability by solid angle: D (n.h) / (4 (v.h)), and here v is n.
        double root = cos2 * (a2 - 1) + 1, density = a2 / (kPi * root * root) / 4;
        double wide = weight / (2 * count * density);
        // Faces of fewer than 16 texels are too coarse for a lobe that is blurred less.
        float level = float(std::clamp(0.5 * std::log2(wide / texel) + 0.5, 0.0, std::log2(size) - 4.0));
        // Samples come in pairs, so that the lobe is symmetric; azimuths cover half a turn, or pairs would coincide.
        for (double side : {across, -across}) {
            result.push_back({{side * std::cos(phi), side * std::sin(phi), along}, float(along * weight), level});
        }
    }
    return result;
}

}  // namespace

float roughness_of_level(int level) {
    // The root of r (1.7 - 0.7 r) = level / (levels - 1).
    const double share = double(level) / double(kEnvironmentLevels - 1);
    return float((1.7 - std::sqrt(1.7 * 1.7 - 4 * 0.7 * share)) / 1.4);
}

TextureData sampled(const Radiance& radiance, int size, int samples) {
    TextureData data{.levels = {}, .sampler = {.wrap = Wrap::Clamp}, .layers = 6};
    TextureLevel& level = data.levels.emplace_back(TextureLevel{.width = size, .height = size, .texels = {}});
    level.texels.resize(std::size_t(24) * size * size);
    each_texel(size, [&](int face, int x, int y) {
        const glm::vec4 texel(mean_in_texel(radiance, face, x, y, size, samples), 1);
        for (int c = 0; c < 4; c++) level.texels[4 * at(size, face, x, y) + std::size_t(c)] = texel[c];
    });
    return data;
}

Pyramid::Pyramid(const Radiance& radiance, int size, int samples) : size_(size) {
    std::vector<glm::vec3>& base = levels_.emplace_back(std::size_t(6) * size * size);
    each_texel(size, [&](int face, int x, int y) {
        base[at(size, face, x, y)] = mean_in_texel(radiance, face, x, y, size, samples);
    });
    for (int half = size / 2; half > 0; half /= 2) {
        std::vector<glm::vec3> next(std::size_t(6) * half * half);
        const std::vector<glm::vec3>& before = levels_.back();
        for (int face = 0; face < 6; face++) {
            for (int y = 0; y < half; y++) {
                for (int x = 0; x < half; x++) {
                    next[at(half, face, x, y)] =
                        (before[at(2 * half, face, 2 * x, 2 * y)] + before[at(2 * half, face, 2 * x + 1, 2 * y)] +
                         before[at(2 * half, face, 2 * x, 2 * y + 1)] +
                         before[at(2 * half, face, 2 * x + 1, 2 * y + 1)]) /
                        4.0f;
                }
            }
        }
        levels_.push_back(std::move(next));
    }
}

glm::vec3 Pyramid::look(glm::vec3 direction, float level) const {
    const float highest = float(levels_.size() - 1), lod = std::clamp(level, 0.0f, highest);
    const CubePlace place = cube_place(direction);
    const int finer = int(lod);
    const glm::vec3 fine = bilinear(finer, place);
    return lod == float(finer) ? fine : glm::mix(fine, bilinear(finer + 1, place), lod - float(finer));
}

glm::vec3 Pyramid::bilinear(int level, const CubePlace& place) const {
    const int size = size_ >> level;
    const float x = place.u * float(size) - 0.5f, y = place.v * float(size) - 0.5f;
    const float left = std::floor(x), top = std::floor(y);
    const std::vector<glm::vec3>& texels = levels_[std::size_t(level)];
    const auto texel = [&](float column, float row) {
        if (column >= 0 && row >= 0 && column < float(size) && row < float(size))
            return texels[at(size, place.face, int(column), int(row))];
        // Beyond an edge: the neighbour's texel that lies there.
        const CubePlace beyond = cube_place(cube_direction(place.face, int(column), int(row), size));
        const auto inside = [&](float share) { return std::clamp(int(share * float(size)), 0, size - 1); };
        return texels[at(size, beyond.face, inside(beyond.u), inside(beyond.v))];
    };
    return glm::mix(glm::mix(texel(left, top), texel(left + 1, top), x - left),
                    glm::mix(texel(left, top + 1), texel(left + 1, top + 1), x - left), y - top);
}

TextureLevel blurred(const Pyramid& pyramid, float roughness, int size, int samples,
                     const PrefilterProgress& progress) {
    std::vector<Mirrored> around = {{{0, 0, 1}, 1, 0}};
    if (roughness > 0) around = mirrored_directions(roughness, samples, pyramid.size());
    TextureLevel result{.width = size, .height = size, .texels = std::vector<float>(std::size_t(24) * size * size)};
    on_each_face([&](int face) {
        float* texel = result.texels.data() + std::size_t(4) * size * size * face;
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++, texel += 4) {
                glm::vec3 normal = cube_direction(face, x, y, size);
                glm::vec3 helper = std::abs(normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
                glm::vec3 tangent = glm::normalize(glm::cross(helper, normal)), bitangent = glm::cross(normal, tangent);
                glm::dvec3 sum(0);
                double weights = 0;
                for (const Mirrored& l : around) {
                    glm::vec3 towards = tangent * l.direction.x + bitangent * l.direction.y + normal * l.direction.z;
                    sum += glm::dvec3(pyramid.look(towards, l.level) * l.weight);
                    weights += l.weight;
                }
                sum /= weights;
                texel[0] = float(sum.x), texel[1] = float(sum.y), texel[2] = float(sum.z), texel[3] = 1;
            }
            // The calling thread does the first face.
            if (face == 0 && progress) progress(double(y + 1) / size);
        }
    });
    return result;
}

TextureData prefiltered(const Pyramid& pyramid, const PrefilterProgress& progress) {
    // Coarser levels have fewer texels, and each covers more of the environment.
    constexpr int kSamples[kEnvironmentLevels] = {1, 16, 48, 96, 256, 1024};
    const auto size_of = [&](int level) { return std::max(pyramid.size() >> level, 1); };
    const auto work_of = [&](int level) { return double(kSamples[level]) * size_of(level) * size_of(level); };
    double all = 0, done = 0;
    for (int level = 0; level < kEnvironmentLevels; level++) all += work_of(level);
    TextureData data{.levels = {}, .sampler = {.wrap = Wrap::Clamp}, .layers = 6};
    for (int level = 0; level < kEnvironmentLevels; level++) {
        const double work = work_of(level);
        const auto show = [&](double share) {
            if (progress) progress((done + work * share) / all);
        };
        data.levels.push_back(blurred(pyramid, roughness_of_level(level), size_of(level), kSamples[level], show));
        done += work;
    }
    return data;
}

}  // namespace patina::runtime
