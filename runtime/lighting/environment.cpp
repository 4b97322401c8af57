#include "runtime/lighting/environment.h"

#include <algorithm>

#include "runtime/lighting/prefilter.h"

namespace patina::runtime {
namespace {

// Takes a level's texels, three numbers each, from the front.
TextureLevel unpacked(std::span<const float>& numbers, int size) {
    TextureLevel level{.width = size, .height = size, .texels = {}};
    const std::size_t count = std::size_t(18) * size * size;
    for (std::size_t i = 0; i < count; i += 3)
        level.texels.insert(level.texels.end(), {numbers[i], numbers[i + 1], numbers[i + 2], 1});
    numbers = numbers.subspan(count);
    return level;
}

}  // namespace

Environment::Environment(Radiance radiance, int face_size)
    : radiance_(std::move(radiance)), face_size_(face_size), ambient_(project(radiance_)) {}

Environment::Environment(Radiance radiance, int face_size, std::span<const float> blurred_levels)
    : Environment(std::move(radiance), face_size) {
    blurred_levels_ = blurred_levels;
}

Environment::Environment(const SphericalHarmonics& ambient)
    : radiance_([ambient](glm::vec3 direction) { return evaluate(ambient, direction); }),
      face_size_(256),
      ambient_(ambient) {}

std::shared_ptr<const TextureData> Environment::map() const {
    std::call_once(made_, [this] {
        TextureData data{.levels = {}, .sampler = {.wrap = Wrap::Clamp}, .faces = 6};
        const Pyramid pyramid(radiance_, face_size_);
        std::span<const float> known = blurred_levels_;
        for (int level = 0; level < kEnvironmentLevels; level++) {
            const int size = std::max(face_size_ >> level, 1);
            const bool is_known = level > 0 && !known.empty();
            data.levels.push_back(is_known ? unpacked(known, size) : blurred(pyramid, level, size));
        }
        map_ = std::make_shared<const TextureData>(std::move(data));
    });
    return map_;
}

}  // namespace patina::runtime
