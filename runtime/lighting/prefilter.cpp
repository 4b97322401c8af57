#include "runtime/lighting/prefilter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/jobs/shares.h"

namespace patina::runtime {
namespace {

std::size_t at(int size, int face, int x, int y) {
    return (std::size_t(face) * size + std::size_t(y)) * size + std::size_t(x);
}

// Runs `work` for each texel of a cube, each face on a thread.
template <class Work>
void each_texel(int size, const Work& work) {
    on_threads(6, [&](int face) {
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

// A square is small if its radius is at most this share of the lobe's scale there: the distance over which the lobe
// changes. That is the lobe's own width in its middle, and the distance from the middle further away. The scale's
// square is at most kLargestScale2, because n.l changes everywhere.
constexpr float kSmall = 0.15f, kLargestScale2 = 0.5f;

// Squares that wait while a sum is made. A square that is not small adds four squares, and the next one to visit is one
// of them: so three wait for each level, and the six faces. That is enough for 2^19 texels along a face.
constexpr std::size_t kMostOpen = 64;

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
    levels_.push_back(texels(radiance, size, samples));
    for (int coarse = size / 2; coarse > 0; coarse /= 2) levels_.push_back(coarser(levels_.back(), coarse));
}

Pyramid::Level Pyramid::texels(const Radiance& radiance, int size, int samples) {
    Level made(std::size_t(6) * size * size);
    each_texel(size, [&](int face, int x, int y) {
        Square& texel = made[at(size, face, x, y)];
        texel.direction = cube_direction(face, x, y, size);
        texel.solid_angle = cube_solid_angle(x, y, size);
        texel.light = mean_in_texel(radiance, face, x, y, size, samples) * texel.solid_angle;
    });
    return made;
}

// `size`: squares along a face of the coarser level.
Pyramid::Level Pyramid::coarser(const Level& finer, int size) {
    Level made(std::size_t(6) * size * size);
    each_texel(size, [&](int face, int x, int y) {
        const auto quarter = [&](int i, int j) { return finer[at(2 * size, face, 2 * x + i, 2 * y + j)]; };
        Square& square = made[at(size, face, x, y)];
        square = joined({quarter(0, 0), quarter(1, 0), quarter(0, 1), quarter(1, 1)});
        const auto place = [&](int line) { return 2 * float(line) / float(size) - 1; };
        for (const int column : {x, x + 1}) {
            for (const int row : {y, y + 1}) {
                const glm::vec3 corner = cube_direction(face, place(column), place(row));
                square.radius = std::max(square.radius, glm::distance(corner, square.direction));
            }
        }
    });
    return made;
}

// The centre of the light is the mean of the quarters' directions by their light; without light, by their areas.
Pyramid::Square Pyramid::joined(const std::array<Square, 4>& quarters) {
    Square whole;
    glm::vec3 of_light(0), of_area(0);
    for (const Square& quarter : quarters) {
        whole.solid_angle += quarter.solid_angle;
        whole.light += quarter.light;
        of_light += quarter.direction * (quarter.light.r + quarter.light.g + quarter.light.b);
        of_area += quarter.direction * quarter.solid_angle;
    }
    const bool is_lit = glm::dot(of_light, of_light) > 0;
    whole.direction = glm::normalize(is_lit ? of_light : of_area);
    return whole;
}

glm::vec3 Pyramid::radiance(glm::vec3 direction) const {
    const CubePlace place = cube_place(direction);
    const auto inside = [&](float share) { return std::clamp(int(share * float(size_)), 0, size_ - 1); };
    const Square& texel = levels_.front()[at(size_, place.face, inside(place.u), inside(place.v))];
    return texel.light / texel.solid_angle;
}

glm::vec3 Pyramid::reflected(glm::vec3 normal, float roughness) const {
    const float a2 = std::pow(roughness, 4.0f);  // alpha squared
    struct SquareIndex {
        std::size_t level;
        int face, x, y;
    };
    std::array<SquareIndex, kMostOpen> open{};  // squares that are still to be added
    std::size_t count = 0;
    for (int face = 0; face < 6; face++) open[count++] = {levels_.size() - 1, face, 0, 0};
    glm::dvec3 sum(0);
    double weights = 0;
    while (count > 0) {
        const SquareIndex place = open[--count];
        const Square& square = levels_[place.level][at(size_ >> place.level, place.face, place.x, place.y)];
        const float cosine = glm::dot(normal, square.direction);
        if (cosine < -square.radius) continue;  // below the horizon
        const float chord2 = 2 - 2 * cosine;    // from the middle of the lobe, squared
        const float scale2 = std::min(chord2 + 2 * a2, kLargestScale2);
        if (place.level > 0 && square.radius * square.radius > kSmall * kSmall * scale2) {
            for (const int i : {0, 1})
                for (const int j : {0, 1})
                    open[count++] = {place.level - 1, place.face, 2 * place.x + i, 2 * place.y + j};
            continue;
        }
        if (cosine <= 0) continue;
        // D n.l, without the factor that all have; n.h is the cosine of half the angle between n and l.
        const float root = (1 + cosine) / 2 * (a2 - 1) + 1, weight = cosine / (root * root);
        sum += glm::dvec3(square.light * weight);
        weights += double(weight) * double(square.solid_angle);
    }
    return glm::vec3(sum / weights);
}

TextureLevel blurred(const Pyramid& pyramid, float roughness, int size, const PrefilterProgress& progress) {
    TextureLevel result{.width = size, .height = size, .texels = std::vector<float>(std::size_t(24) * size * size)};
    on_threads(6, [&](int face) {
        float* texel = result.texels.data() + std::size_t(4) * size * size * face;
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++, texel += 4) {
                const glm::vec3 normal = cube_direction(face, x, y, size);
                const glm::vec3 mean = roughness > 0 ? pyramid.reflected(normal, roughness) : pyramid.radiance(normal);
                texel[0] = mean.x, texel[1] = mean.y, texel[2] = mean.z, texel[3] = 1;
            }
            // The calling thread does the first face.
            if (face == 0 && progress) progress(double(y + 1) / size);
        }
    });
    return result;
}

TextureData prefiltered(const Pyramid& pyramid, const PrefilterProgress& progress) {
    const auto size_of = [&](int level) { return std::max(pyramid.size() >> level, 1); };
    // A texel of the first level is read, and not computed.
    const auto work_of = [&](int level) { return double(size_of(level)) * size_of(level) * (level > 0 ? 1.0 : 0.01); };
    double all = 0, done = 0;
    for (int level = 0; level < kEnvironmentLevels; level++) all += work_of(level);
    TextureData data{.levels = {}, .sampler = {.wrap = Wrap::Clamp}, .layers = 6};
    for (int level = 0; level < kEnvironmentLevels; level++) {
        const double work = work_of(level);
        const auto show = [&](double share) {
            if (progress) progress((done + work * share) / all);
        };
        data.levels.push_back(blurred(pyramid, roughness_of_level(level), size_of(level), show));
        done += work;
    }
    return data;
}

}  // namespace patina::runtime
