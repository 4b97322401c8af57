// The room `lighting`: light as numbers and tables, computed on the CPU. It knows no scene and no device; all but
// MERL files is a library of its own, which reads no pictures either.
//
// The environment of a scene, in the three forms that shaders read: nine coefficients for diffuse light, a cube map
// blurred level by level for specular light, and the table of the split sum. It is computed on the CPU from a function
// of the direction.
//
//   Environment sunset([](glm::vec3 d) { return glm::vec3(d.y > 0 ? 1 : 0.2f); }, 64);
//   scene.ambient = sunset.ambient();   texture = sunset.map();
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <span>

#include "patina/interpret.h"
#include "runtime/lighting/harmonics.h"

namespace patina::runtime {

class Environment {
public:
    // A map is a cube of kEnvironmentLevels levels (prefilter.h); it is made when first asked for, by one thread.
    // A picture behind everything is a cube of one level; it is made whenever another size is asked for.
    using MakePicture = std::function<TextureData(int)>;
    Environment(const SphericalHarmonics& ambient, std::function<TextureData()> make_map,
                MakePicture make_picture = {});
    // `face_size`: texels along a face of the cube, a power of two, 256 or more: the last level has 8 or more, fewer of
    // which would show as facets.
    Environment(const Radiance& radiance, int face_size);
    // What the coefficients describe, smooth as it is.
    explicit Environment(const SphericalHarmonics& ambient);

    const SphericalHarmonics& ambient() const { return ambient_; }
    std::shared_ptr<const TextureData> map() const;
    // The light itself, for a visible background: as fine as it is known, but with at most `size` texels along a face.
    // The map if there is nothing finer.
    std::shared_ptr<const TextureData> picture(int size) const;

private:
    SphericalHarmonics ambient_;
    std::function<TextureData()> make_map_;
    mutable std::once_flag made_;
    mutable std::shared_ptr<const TextureData> map_;
    MakePicture make_picture_;
    mutable std::mutex picture_mutex_;
    mutable std::shared_ptr<const TextureData> picture_;
    mutable int picture_size_ = 0;  // that was asked for
};

// A map whose levels from the second on are known, texel by texel, red, green and blue.
TextureData map_with_levels(const Radiance& radiance, int face_size, std::span<const float> blurred_levels);

// The studio of studio.h. The same object each time.
std::shared_ptr<const Environment> studio_environment();

}  // namespace patina::runtime
