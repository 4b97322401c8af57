// The installed library of this room: patina/lighting.h, in the terms of the other files.
#include "patina/lighting.h"

#include <cmath>
#include <cstdint>
#include <exception>
#include <new>

#include "runtime/lighting/panorama.h"
#include "runtime/lighting/split_sum.h"

namespace patina::lighting {
namespace {

constexpr int kLargestFace = 1024;
constexpr double kMostIntensity = 1e6;

// Empty, or what is wrong.
std::string check(const Picture& picture, const Options& options) {
    if (picture.width < 1 || picture.height < 1 || picture.width > runtime::kLargestImage ||
        picture.height > runtime::kLargestImage)
        return "a picture has 1 to " + std::to_string(runtime::kLargestImage) + " pixels on a side, not " +
               std::to_string(picture.width) + " x " + std::to_string(picture.height);
    if (picture.channels < 3)
        return "a pixel has 3 numbers or more (red, green, blue), not " + std::to_string(picture.channels);
    const std::uint64_t wanted = std::uint64_t(picture.width) * unsigned(picture.height) * unsigned(picture.channels);
    if (picture.numbers.size() != wanted)
        return "a picture of " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
               " pixels with " + std::to_string(picture.channels) + " channels has " + std::to_string(wanted) +
               " numbers, not " + std::to_string(picture.numbers.size());
    const int size = options.face_size;
    if (size != 0 && (size < runtime::kSmallestMap || size > kLargestFace || (size & (size - 1)) != 0))
        return "face_size is 0 or a power of two from " + std::to_string(runtime::kSmallestMap) + " to " +
               std::to_string(kLargestFace) + ", not " + std::to_string(size);
    if (!std::isfinite(options.rotation)) return "rotation is not a finite number";
    if (!(options.intensity >= 0 && options.intensity <= kMostIntensity)) return "intensity is not from 0 to 1e6";
    return {};
}

runtime::Image image_of(const Picture& picture) {
    runtime::Image image{.width = picture.width, .height = picture.height};
    const std::size_t count = std::size_t(picture.width) * std::size_t(picture.height);
    image.pixels.resize(4 * count, 1);
    for (std::size_t pixel = 0; pixel < count; ++pixel) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            image.pixels[4 * pixel + channel] = picture.numbers[pixel * std::size_t(picture.channels) + channel];
    }
    return image;
}

// The radiance that the options ask for, in the right-handed or left-handed world.
runtime::Radiance chosen(runtime::Radiance radiance, const Options& options) {
    const float intensity = float(options.intensity), z = options.is_left_handed ? -1.0f : 1.0f;
    if (intensity == 1 && z == 1) return radiance;
    return [radiance = std::move(radiance), intensity, z](glm::vec3 d) {
        return intensity * radiance({d.x, d.y, z * d.z});
    };
}

Environment environment_of(const Picture& picture, const Options& options) {
    if (std::string error = check(picture, options); !error.empty()) return {.error = std::move(error)};
    runtime::Outcome<runtime::Panorama> around = runtime::panorama_of(image_of(picture), "");
    if (!around) return {.error = std::move(around.error)};
    const double turn = std::remainder(options.rotation, 360.0);
    around.value.radiance = chosen(runtime::turned(std::move(around.value.radiance), turn), options);
    const runtime::Pyramid pyramid = runtime::pyramid_of(around.value, options.face_size);

    Environment made;
    const runtime::SphericalHarmonics ambient = runtime::ambient_of(pyramid);
    for (std::size_t i = 0; i < made.coefficients.size(); ++i) {
        const glm::vec3 c = ambient.coefficients[i];
        made.coefficients[i] = {c.r, c.g, c.b};
    }
    TextureData map = runtime::prefiltered(pyramid, options.progress);
    for (std::size_t i = 0; i < map.levels.size(); ++i)
        made.levels.push_back({.size = map.levels[i].width,
                               .roughness = runtime::roughness_of_level(int(i)),
                               .texels = std::move(map.levels[i].texels)});
    return made;
}

// Short enough to need no memory.
constexpr const char* kNoMemory = "out of memory";

// Of the exception that is being handled.
Environment failed() {
    Environment made;
    try {
        throw;
    } catch (const std::bad_alloc&) {
        made.error = kNoMemory;
    } catch (const std::exception& exception) {
        made.error = exception.what();
    } catch (...) {
        made.error = "a failure";
    }
    return made;
}

}  // namespace

Environment prefilter(const Picture& picture, const Options& options) {
    try {
        try {
            return environment_of(picture, options);
        } catch (...) {
            return failed();
        }
    } catch (...) {  // there was no memory for what the exception says
        Environment made;
        made.error = kNoMemory;
        return made;
    }
}

SplitSumTable split_sum_table() {
    const std::vector<float>& texels = runtime::split_sum_table()->levels.front().texels;
    SplitSumTable table{.size = runtime::kSplitSumSize};
    for (std::size_t i = 0; i < texels.size(); i += 4)
        table.texels.insert(table.texels.end(), {texels[i], texels[i + 1]});
    return table;
}

}  // namespace patina::lighting
