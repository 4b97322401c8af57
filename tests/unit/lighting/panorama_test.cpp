// Pictures of the surroundings: which direction each of their pixels shows, by the definitions in panorama.h written a
// second time; and environments from files, from the cache and from broken files.
#include "runtime/lighting/panorama.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>

#include "runtime/lighting/environment_file.h"
#include "runtime/lighting/map_cache.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;
constexpr double kPi = std::numbers::pi;

// A picture whose colours are the directions that it shows, from 0 to 1.
void set_direction(Image& image, int x, int y, glm::dvec3 direction) {
    const glm::dvec3 color = (glm::normalize(direction) + 1.0) / 2.0;
    for (int c = 0; c < 3; ++c) image.at(x, y)[std::size_t(c)] = float(color[c]);
}
glm::vec3 direction_in(const Radiance& radiance, glm::vec3 direction) {
    return glm::normalize(radiance(direction) * 2.0f - 1.0f);
}

void expect_directions(const Image& image, float tolerance) {
    const Outcome<Panorama> made = panorama_of(image, "picture");
    ASSERT_TRUE(made) << made.error;
    std::mt19937 random(7);
    std::normal_distribution<float> normal;
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 d = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
        EXPECT_LT(glm::length(direction_in(made.value.radiance, d) - d), tolerance) << d.x << " " << d.y << " " << d.z;
    }
}

Image sphere_of_directions(int width) {
    Image image = make_image(width, width / 2);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < width; ++x) {
            // To the right of the middle, and down from straight up.
            const double right = ((x + 0.5) / width - 0.5) * 2 * kPi, down = (y + 0.5) / image.height * kPi;
            set_direction(image, x, y,
                          {std::sin(down) * std::sin(right), std::cos(down), -std::sin(down) * std::cos(right)});
        }
    }
    return image;
}

// What each face shows at s to the right and t down, from -1 to 1, for somebody who turns to it from ahead.
enum Face { Right, Left, Up, Down, Ahead, Behind };
glm::dvec3 seen(Face face, double s, double t) {
    switch (face) {
        case Right: return {1, -t, s};
        case Left: return {-1, -t, -s};
        case Up: return {s, 1, -t};
        case Down: return {s, -1, t};
        case Ahead: return {s, -t, -1};
        case Behind: return {-s, -t, 1};
    }
    return {};
}

struct Placed {
    Face face;
    int column, row;
    bool is_turned = false;
};
Image cube_of_directions(int columns, int rows, const std::array<Placed, 6>& faces) {
    constexpr int kSize = 32;
    Image image = make_image(columns * kSize, rows * kSize);
    for (const Placed& placed : faces) {
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const double sign = placed.is_turned ? -1 : 1;
                const double s = sign * (2 * (x + 0.5) / kSize - 1), t = sign * (2 * (y + 0.5) / kSize - 1);
                set_direction(image, placed.column * kSize + x, placed.row * kSize + y, seen(placed.face, s, t));
            }
        }
    }
    return image;
}

TEST(Panorama, EveryShapeShowsTheSameDirections) {
    expect_directions(sphere_of_directions(256), 0.03f);
    expect_directions(
        cube_of_directions(4, 3,
                           {{{Up, 1, 0}, {Left, 0, 1}, {Ahead, 1, 1}, {Right, 2, 1}, {Behind, 3, 1}, {Down, 1, 2}}}),
        0.05f);
    expect_directions(
        cube_of_directions(
            3, 4, {{{Up, 1, 0}, {Left, 0, 1}, {Ahead, 1, 1}, {Right, 2, 1}, {Down, 1, 2}, {Behind, 1, 3, true}}}),
        0.05f);
    expect_directions(
        cube_of_directions(6, 1,
                           {{{Right, 0, 0}, {Left, 1, 0}, {Up, 2, 0}, {Down, 3, 0}, {Ahead, 4, 0}, {Behind, 5, 0}}}),
        0.05f);
    expect_directions(
        cube_of_directions(1, 6,
                           {{{Right, 0, 0}, {Left, 0, 1}, {Up, 0, 2}, {Down, 0, 3}, {Ahead, 0, 4}, {Behind, 0, 5}}}),
        0.05f);
}

// A quarter of a turn, counter-clockwise from above: what was ahead (-z) is at the left (-x).
TEST(Panorama, Turns) {
    const Outcome<Panorama> made = panorama_of(sphere_of_directions(256), "picture");
    const Radiance radiance = turned(made.value.radiance, 90);
    EXPECT_LT(glm::length(direction_in(radiance, {-1, 0, 0}) - glm::vec3(0, 0, -1)), 0.03f);
    EXPECT_LT(glm::length(direction_in(radiance, {0, 0, -1}) - glm::vec3(1, 0, 0)), 0.03f);
    EXPECT_LT(glm::length(direction_in(radiance, {0, 1, 0}) - glm::vec3(0, 1, 0)), 0.03f);
    EXPECT_LT(glm::length(direction_in(turned(made.value.radiance, -270), {-1, 0, 0}) - glm::vec3(0, 0, -1)), 0.03f);
}

TEST(Panorama, RefusesWhatIsNoEnvironment) {
    EXPECT_EQ(panorama_of(make_image(100, 90), "a.png").error,
              "'a.png' does not show all directions: it has 100 x 90 pixels, and these shapes are understood: 2:1 "
              "(equirectangular), 4:3 and 3:4 (crosses of a cube's faces), 6:1 and 1:6 (strips of them)");
    Image image = make_image(8, 4);
    image.at(5, 2)[1] = std::numeric_limits<float>::infinity();
    EXPECT_EQ(panorama_of(image, "a.exr").error, "'a.exr' is not light everywhere: the pixel 5,2 is not finite");
    image.at(5, 2)[1] = -4;
    const Outcome<Panorama> made = panorama_of(image, "a.exr");
    ASSERT_TRUE(made) << made.error;
    const double right = (5.5 / 8 - 0.5) * 2 * kPi, down = 2.5 / 4 * kPi;
    const glm::vec3 direction(std::sin(down) * std::sin(right), std::cos(down), -std::sin(down) * std::cos(right));
    EXPECT_GE(made.value.radiance(direction).g, 0);
}

// --- files

class EnvironmentOfFile : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() /
                  (std::string("patina_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string save(const std::string& name, const Image& image) const {
        EXPECT_EQ(save_image(path(name), image), "");
        return path(name);
    }
    std::vector<fs::path> kept() const {
        std::vector<fs::path> files;
        std::error_code none;
        for (const auto& entry : fs::directory_iterator(folder_ / "cache" / "patina", none))
            files.push_back(entry.path());
        return files;
    }
    // The last environment is kept in memory: after another one, a file is read again.
    std::shared_ptr<const Environment> load(const EnvironmentChoice& choice) const {
        (void)load_environment({.path = save("other.png", make_image(2, 1))});
        Outcome<std::shared_ptr<const Environment>> made = load_environment(choice);
        EXPECT_TRUE(made) << made.error;
        return made.value;
    }

private:
    fs::path folder_;
};

void expect_equal(const TextureData& a, const TextureData& b) {
    ASSERT_EQ(a.levels.size(), b.levels.size());
    for (std::size_t i = 0; i < a.levels.size(); ++i) {
        EXPECT_EQ(a.levels[i].width, b.levels[i].width);
        EXPECT_EQ(a.levels[i].texels, b.levels[i].texels) << i;
    }
}

// An even light of radiance L has the first coefficient L 2 sqrt(pi), and no others.
void expect_even(const Environment& environment, glm::vec3 light) {
    for (std::size_t i = 0; i < 9; ++i) {
        const glm::vec3 expected = i == 0 ? light * float(2 * std::sqrt(kPi)) : glm::vec3(0);
        EXPECT_LT(glm::length(environment.ambient().coefficients[i] - expected), 2e-3f) << i;
    }
    for (const TextureLevel& level : environment.map()->levels) {
        ASSERT_FALSE(level.texels.empty());
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(level.texels[std::size_t(c)], light[c], 1e-3f);
    }
}

// A file of 8 bits is decoded: #bc, 188 / 255, is 0.5029 by IEC 61966-2-1. One of floats is light already.
TEST_F(EnvironmentOfFile, DecodesEightBits) {
    const float stored = 188.0f / 255, linear = std::pow((stored + 0.055f) / 1.055f, 2.4f);
    Image grey = make_image(8, 4, linear, linear, linear);
    expect_even(*load({.path = save("grey.png", grey)}), glm::vec3(linear));
    expect_even(*load({.path = save("grey.exr", make_image(8, 4, 3, 2, 0.25f))}), {3, 2, 0.25f});
    expect_even(*load({.path = path("grey.exr"), .intensity = 0.5}), {1.5f, 1, 0.125f});
}

TEST_F(EnvironmentOfFile, KeepsThePrefilteredMap) {
    const std::string file = save("directions.exr", sphere_of_directions(64));
    const auto made = load({.path = file});
    const TextureData map = *made->map();
    ASSERT_EQ(kept().size(), 1u);
    const auto again = load({.path = file});
    EXPECT_NE(again, made);
    EXPECT_EQ(again->ambient().coefficients, made->ambient().coefficients);
    expect_equal(*again->map(), map);
    // Other bytes and another rotation are other environments; another intensity is the same map.
    (void)load({.path = file, .intensity = 2})->map();
    EXPECT_EQ(kept().size(), 1u);
    (void)load({.path = file, .rotation = 360})->map();
    EXPECT_EQ(kept().size(), 1u);
    (void)load({.path = file, .rotation = 90})->map();
    EXPECT_EQ(kept().size(), 2u);
}

TEST_F(EnvironmentOfFile, ABrokenCacheIsNotRead) {
    const std::string file = save("directions.exr", sphere_of_directions(64));
    const TextureData map = *load({.path = file})->map();
    ASSERT_EQ(kept().size(), 1u);
    const std::string name = kept().front().string();
    std::ifstream in(name, std::ios::binary);
    const std::string good((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    std::string changed = good, other_version = good, huge = good;
    changed[good.size() / 2] = char(changed[good.size() / 2] ^ 1);
    other_version[8] = char(other_version[8] + 1);
    huge[15] = 0x7f;  // the highest byte of its size
    for (const std::string& bad : {changed, other_version, huge, good.substr(0, 1000), good + "x", std::string()}) {
        std::ofstream(name, std::ios::binary) << bad;
        expect_equal(*load({.path = file})->map(), map);
        EXPECT_EQ(fs::file_size(name), good.size());  // it has been written again
    }
}

TEST_F(EnvironmentOfFile, WorksWithoutAFolderForTheCache) {
    const std::string file = save("grey.exr", make_image(8, 4, 1, 1, 1));
    std::ofstream(path("a_file")) << "";
    for (const std::string& folder : {path("a_file"), std::string("/proc/none")}) {
        setenv("XDG_CACHE_HOME", folder.c_str(), 1);
        expect_even(*load({.path = file}), glm::vec3(1));
    }
}

TEST_F(EnvironmentOfFile, TheOldestAreRemoved) {
    const std::string other = save("grey.exr", make_image(8, 4, 1, 1, 1));
    fs::create_directories(path("cache/patina"));
    for (std::size_t i = 0; i < MapCache::kMostKept; ++i) {
        const fs::path old = path("cache/patina/" + std::to_string(i) + ".environment");
        std::ofstream(old) << "old";
        fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(1 + i));
    }
    (void)load({.path = other})->map();
    EXPECT_EQ(kept().size(), MapCache::kMostKept);
    EXPECT_FALSE(fs::exists(path("cache/patina/" + std::to_string(MapCache::kMostKept - 1) + ".environment")));
    EXPECT_TRUE(fs::exists(path("cache/patina/0.environment")));
}

TEST_F(EnvironmentOfFile, BrokenFilesAreNamed) {
    const auto error_of = [&](const std::string& file) { return load_environment({.path = file}).error; };
    EXPECT_EQ(error_of(path("none.hdr")), "there is no file '" + path("none.hdr") + "'");
    std::ofstream(path("text.hdr")) << "this is no picture";
    EXPECT_EQ(error_of(path("text.hdr")).find("cannot read '" + path("text.hdr") + "' as an image: "), 0u);
    const std::string whole = save("whole.exr", sphere_of_directions(256));
    std::ifstream in(whole, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    std::ofstream(path("part.exr"), std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    EXPECT_EQ(error_of(path("part.exr")).find("cannot read '" + path("part.exr") + "' as an image: "), 0u);
    // A picture under the name of another format is read by its content, or refused.
    std::ofstream(path("really_exr.png"), std::ios::binary) << bytes;
    const std::string said = error_of(path("really_exr.png"));
    EXPECT_TRUE(said.empty() || said.find("really_exr.png") != std::string::npos) << said;
}

}  // namespace
}  // namespace patina::runtime
