// What `patina env FILE -o DIR` writes, read back as an engine reads it: six files for each level, which face each is,
// and which way its rows go. The directions follow the table of Vulkan's "Cube Map Face Selection", written here again.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <glm/glm.hpp>
#include <numbers>
#include <random>

#include "runtime/picture/image.h"
#include "tests/support/received.h"

namespace patina::testing {
namespace {

using runtime::Image;
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kFaces = {"px", "nx", "py", "ny", "pz", "nz"};

std::string name_of(int level, std::size_t face) {
    return "around.level" + std::to_string(level) + "." + std::string(kFaces[face]) + ".exr";
}

struct FacePoint {
    std::size_t face = 0;
    double u = 0, v = 0;  // from the face's first pixel, 0 to 1
};
// Major axis, then sc and tc over |ma|.
FacePoint place_of(glm::dvec3 d) {
    const glm::dvec3 a = glm::abs(d);
    const auto place = [](std::size_t face, double sc, double tc, double ma) {
        return FacePoint{face, (sc / ma + 1) / 2, (tc / ma + 1) / 2};
    };
    if (a.x >= a.y && a.x >= a.z) return d.x > 0 ? place(0, -d.z, -d.y, a.x) : place(1, d.z, -d.y, a.x);
    if (a.y >= a.z) return d.y > 0 ? place(2, d.x, d.z, a.y) : place(3, d.x, -d.z, a.y);
    return d.z > 0 ? place(4, d.x, -d.y, a.z) : place(5, -d.x, -d.y, a.z);
}

// Equirectangular, ahead (-z) in the middle; the colour of a direction is the direction, from 0 to 1.
Image directions() {
    constexpr int kWidth = 512;
    Image image = runtime::make_image(kWidth, kWidth / 2);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double right = ((x + 0.5) / kWidth - 0.5) * 2 * std::numbers::pi;
            const double down = (y + 0.5) / image.height * std::numbers::pi;
            const glm::dvec3 d(std::sin(down) * std::sin(right), std::cos(down), -std::sin(down) * std::cos(right));
            for (int c = 0; c < 3; ++c) image.at(x, y)[std::size_t(c)] = float((d[c] + 1) / 2);
        }
    }
    return image;
}

TEST(EnvFiles, AFaceHoldsWhatIsInItsDirections) {
    const fs::path folder = received_folder() / "env_test";
    fs::remove_all(folder);
    fs::create_directories(folder);
    ASSERT_EQ(runtime::save_exr((folder / "around.exr").string(), directions()), "");
    const Ran ran = run("XDG_CACHE_HOME=. patina env around.exr -o out", folder);
    ASSERT_EQ(ran.exit, 0) << ran.output;

    std::array<Image, 6> faces;
    for (std::size_t i = 0; i < 6; ++i) {
        const auto loaded = runtime::load_image((folder / "out" / name_of(0, i)).string());
        ASSERT_TRUE(loaded) << loaded.error;
        faces[i] = loaded.value;
        EXPECT_EQ(faces[i].width, 256);
        EXPECT_EQ(faces[i].height, 256);
    }
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 600; ++i) {
        const glm::dvec3 d = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        const FacePoint place = place_of(d);
        const auto texel = faces[place.face].at(int(place.u * 256), int(place.v * 256));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(texel[std::size_t(c)], (d[c] + 1) / 2, 0.008) << d.x << ", " << d.y << ", " << d.z;
    }
    // Every level has half the size of the one before, and the JSON lists its files in the order of a cube map.
    const std::string json = read_file(folder / "out" / "around.light.json");
    std::size_t at = 0;
    for (int level = 0; level < 6; ++level) {
        for (std::size_t i = 0; i < 6; ++i) {
            const auto loaded = runtime::load_image((folder / "out" / name_of(level, i)).string());
            ASSERT_TRUE(loaded) << loaded.error;
            EXPECT_EQ(loaded.value.width, 256 >> level);
            at = json.find("\"" + name_of(level, i) + "\"", at);
            EXPECT_NE(at, json.npos) << name_of(level, i);
        }
    }
}

}  // namespace
}  // namespace patina::testing
