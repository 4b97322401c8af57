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

Environment::Environment(const SphericalHarmonics& ambient, std::function<TextureData()> make_map,
                         MakePicture make_picture)
    : ambient_(ambient), make_map_(std::move(make_map)), make_picture_(std::move(make_picture)) {}

Environment::Environment(const Radiance& radiance, int face_size)
    : Environment(project(radiance), [radiance, face_size] { return prefiltered(Pyramid(radiance, face_size), {}); }) {}

Environment::Environment(const SphericalHarmonics& ambient)
    : Environment(ambient, [ambient] {
          return prefiltered(Pyramid([&](glm::vec3 d) { return evaluate(ambient, d); }, 256), {});
      }) {}

std::shared_ptr<const TextureData> Environment::map() const {
    std::call_once(made_, [this] { map_ = std::make_shared<const TextureData>(make_map_()); });
    return map_;
}

std::shared_ptr<const TextureData> Environment::picture(int size) const {
    if (!make_picture_) return map();
    const std::lock_guard lock(picture_mutex_);
    if (size != picture_size_) {
        TextureData made = make_picture_(size);
        picture_ = made.levels.empty() ? map() : std::make_shared<const TextureData>(std::move(made));
        picture_size_ = size;
    }
    return picture_;
}

TextureData map_with_levels(const Radiance& radiance, int face_size, std::span<const float> blurred_levels) {
    TextureData data{.levels = {}, .sampler = {.wrap = Wrap::Clamp}, .layers = 6};
    data.levels.push_back(blurred(Pyramid(radiance, face_size), 0, face_size));
    for (int level = 1; level < kEnvironmentLevels; level++)
        data.levels.push_back(unpacked(blurred_levels, std::max(face_size >> level, 1)));
    return data;
}

}  // namespace patina::runtime
