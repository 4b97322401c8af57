#include "runtime/lighting/environment_file.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numbers>

#include "runtime/files/files.h"
#include "runtime/lighting/map_cache.h"
#include "runtime/lighting/panorama.h"
#include "runtime/picture/image.h"
#include "runtime/picture/picture_bounds.h"

namespace patina::runtime {
namespace {

// The bytes of a file; nothing if it cannot be read, of which load_image() knows the reason.
std::string bytes_of(const std::string& path) {
    return read_file(path, most_picture_bytes()).value;
}

Outcome<Panorama> load_panorama(const std::string& path) {
    Outcome<Image> image = load_image(path);
    if (!image) return Failure{image.error};
    if (image.value.bits <= 8) decode_srgb(image.value);
    return panorama_of(std::move(image.value), path);
}

TextureData scaled(TextureData map, float factor) {
    if (factor == 1) return map;
    for (TextureLevel& level : map.levels)
        for (std::size_t i = 0; i < level.texels.size(); i++)
            if (i % 4 != 3) level.texels[i] *= factor;
    return map;
}

double rotation_of(const EnvironmentChoice& choice) {
    return std::remainder(choice.rotation, 360.0);
}

// Nothing is shown of what takes less than a second.
PrefilterProgress after_a_second(const EnvironmentProgress& progress, const std::string& what) {
    if (!progress) return {};
    using Clock = std::chrono::steady_clock;
    return [=, begin = Clock::now()](double share) {
        if (Clock::now() - begin >= std::chrono::seconds(1)) progress(share, what);
    };
}

// The picture as it is. Its texels are the smallest in the middle of a face, where a quarter of a turn has 4 / pi times
// as many as the face is wide. Nothing if it can no longer be read.
TextureData picture_of(const EnvironmentChoice& choice, int size) {
    const Outcome<Panorama> around = load_panorama(choice.path);
    if (!around) return {};
    const double own = around.value.quarter * 4 / std::numbers::pi;
    const int made = std::min(size, std::max(int(std::ceil(own)), 1));
    const int samples = std::max(int(std::lround(own / made)), 1);
    return scaled(sampled(turned(around.value.radiance, rotation_of(choice)), made, samples), float(choice.intensity));
}

using Made = Outcome<std::shared_ptr<const Environment>>;

Made make_environment(const EnvironmentChoice& choice, const std::string& name, EnvironmentProgress progress) {
    const float intensity = float(choice.intensity);
    const double rotation = rotation_of(choice);
    const auto picture = [choice](int size) { return picture_of(choice, size); };
    const MapCache cache;
    if (std::optional<KeptEnvironment> kept = cache.read(name)) {
        const auto map = std::make_shared<TextureData>(std::move(kept->map));
        return std::make_shared<const Environment>(
            scaled(kept->ambient, intensity), [=] { return scaled(std::move(*map), intensity); }, picture);
    }
    Outcome<Panorama> around = load_panorama(choice.path);
    if (!around) return Failure{around.error};
    around.value.radiance = turned(std::move(around.value.radiance), rotation);
    const auto pyramid = std::make_shared<const Pyramid>(pyramid_of(around.value));
    const SphericalHarmonics ambient = ambient_of(*pyramid);
    const auto make_map = [=, progress = std::move(progress)] {
        KeptEnvironment made{ambient, prefiltered(*pyramid, after_a_second(progress, choice.path))};
        cache.write(name, made);
        return scaled(std::move(made.map), intensity);
    };
    return std::make_shared<const Environment>(scaled(ambient, intensity), make_map, picture);
}

}  // namespace

// The last environment is cached for the other pictures of a sequence.
Made load_environment(const EnvironmentChoice& choice, EnvironmentProgress progress) {
    static std::mutex mutex;
    static std::string last_name;
    static std::shared_ptr<const Environment> last;
    const std::string name = MapCache::name_of(bytes_of(choice.path), rotation_of(choice));
    const std::string key = name + " " + std::to_string(choice.intensity);
    const std::lock_guard lock(mutex);
    if (last && key == last_name) return last;
    Made made = make_environment(choice, name, std::move(progress));
    if (made) last_name = key, last = made.value;
    return made;
}

}  // namespace patina::runtime
