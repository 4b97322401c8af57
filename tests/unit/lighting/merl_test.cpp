// Files of measured BRDFs: how they are laid out, what is refused, and the angles that an entry stands for. What a
// shader makes of a table is tested in tests/witness.
#include "runtime/lighting/merl.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

constexpr double kPi = std::numbers::pi;

class Merl : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("patina_merl_test_" + std::to_string(::getpid()));
        fs::create_directories(folder);
        path = (folder / "table.binary").string();
    }
    void TearDown() override { fs::remove_all(folder); }

    // A file of these counts and numbers, whatever they are.
    void write(std::array<std::int32_t, 3> counts, const std::vector<double>& numbers, std::size_t cut = 0) const {
        std::string bytes(sizeof counts + numbers.size() * sizeof(double), '\0');
        std::memcpy(bytes.data(), counts.data(), sizeof counts);
        std::copy_n(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double),
                    bytes.begin() + sizeof counts);
        bytes.resize(bytes.size() - cut);
        std::ofstream(path, std::ios::binary) << bytes;
    }
    void expect_refused(const std::string& words) const {
        const Outcome<MerlTable> table = read_merl(path);
        EXPECT_FALSE(table);
        EXPECT_NE(table.error.find(words), std::string::npos) << table.error;
        EXPECT_NE(table.error.find("table.binary"), std::string::npos) << table.error;
    }

    fs::path folder;
    std::string path;
};

// By the description of the database: three counts, then red, green and blue each as a whole, phi_d running fastest;
// red is scaled by 1 / 1500, green by 1.15 / 1500, blue by 1.66 / 1500.
TEST_F(Merl, ReadsTheDatabasesLayout) {
    std::vector<double> numbers(3 * 2 * 2 * 4);
    numbers[0] = 1500;                         // red, (0, 0, 0)
    numbers[(1 * 2 + 0) * 4 + 3] = 750;        // red, (1, 0, 3)
    numbers[16 + (0 * 2 + 1) * 4 + 2] = 3000;  // green, (0, 1, 2)
    numbers[32 + 15] = -1500;                  // blue, the last
    write({2, 2, 4}, numbers);
    const Outcome<MerlTable> read = read_merl(path);
    ASSERT_TRUE(read) << read.error;
    const MerlTable& table = read.value;
    EXPECT_EQ(table.half, 2);
    EXPECT_EQ(table.difference, 2);
    EXPECT_EQ(table.azimuth, 4);
    EXPECT_EQ(table.entries(), 16u);
    EXPECT_DOUBLE_EQ(table.channels[0][0], 1);
    EXPECT_DOUBLE_EQ(table.channels[0][11], 0.5);
    EXPECT_DOUBLE_EQ(table.channels[1][6], 2.3);
    EXPECT_DOUBLE_EQ(table.channels[2][15], -1.66);

    // A row of texels for each line of phi_d, times pi; what is less than nothing is nothing.
    const Image image = as_texture(table);
    EXPECT_EQ(image.width, 4);
    EXPECT_EQ(image.height, 4);
    EXPECT_FLOAT_EQ(image.at(0, 0)[0], float(kPi));
    EXPECT_FLOAT_EQ(image.at(3, 2)[0], float(kPi / 2));
    EXPECT_FLOAT_EQ(image.at(2, 1)[1], float(kPi * 2.3));
    EXPECT_EQ(image.at(3, 3)[2], 0);
    EXPECT_EQ(image.at(1, 1)[0], 0);
}

TEST_F(Merl, ReadsWhatItHasWritten) {
    const auto brdf = [](const DirectionPair& pair) -> std::array<double, 3> {
        return {pair.light[0], pair.view[1] * 1e-3, pair.light[2] * pair.view[2] * 1e3};
    };
    const MerlTable table = sampled_table(brdf, 5, 5, 8);
    ASSERT_EQ(write_merl(path, table), "");
    EXPECT_EQ(fs::file_size(path), 12u + 3 * 200 * 8);
    const Outcome<MerlTable> read = read_merl(path);
    ASSERT_TRUE(read) << read.error;
    for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_EQ(read.value.channels[c].size(), 200u);
        for (std::size_t i = 0; i < 200; ++i) EXPECT_DOUBLE_EQ(read.value.channels[c][i], table.channels[c][i]);
    }
    EXPECT_NE(write_merl((folder / "table.binary" / "x.binary").string(), table), "");
}

TEST_F(Merl, RefusesFilesThatAreNoTables) {
    const std::vector<double> numbers(3 * 2 * 2 * 4, 1);
    expect_refused("there is no file");
    write({2, 2, 4}, numbers, 1);
    expect_refused("cut off: a table of 2 x 2 x 4 angles has 396 bytes, and it has 395");
    write({2, 2, 4}, numbers, 3 * 16 * 8);
    expect_refused("cut off");
    std::vector<double> more = numbers;
    more.push_back(1);
    write({2, 2, 4}, more);
    expect_refused("too long: a table of 2 x 2 x 4 angles has 396 bytes, and it has 404");
    write({90, 90, 180}, numbers);
    expect_refused("cut off: a table of 90 x 90 x 180 angles has 34992012 bytes");
    write({2, 2, 4}, {}, 1);
    expect_refused("not a MERL table: it has 11 bytes");
    std::ofstream(path, std::ios::binary | std::ios::trunc).close();
    expect_refused("not a MERL table: it has 0 bytes");

    constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
    for (const std::array<std::int32_t, 3>& counts : {std::array{2, 3, 4}, std::array{0, 0, 4}, std::array{2, 2, 0},
                                                      std::array{-2, -2, 4}, std::array{kMost, kMost, kMost}}) {
        write(counts, numbers);
        expect_refused("not a MERL table: its counts of angles are " + std::to_string(counts[0]) + " x ");
    }
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
        for (const std::size_t place : {std::size_t(0), numbers.size() - 1}) {
            std::vector<double> spoilt = numbers;
            spoilt[place] = bad;
            write({2, 2, 4}, spoilt);
            expect_refused("a value that is not a reflectance");
        }
    }
    fs::remove(path);
    fs::create_directories(path);
    expect_refused("cannot read");
}

// The angles of an entry's directions, taken from them as Rusinkiewicz defines them: the light, turned so that the half
// vector becomes the normal.
TEST_F(Merl, AnEntrysDirectionsHaveItsAngles) {
    const MerlTable table{.half = 9, .difference = 9, .azimuth = 18};
    for (int h = 0; h < table.half; ++h) {
        for (int d = 0; d < table.difference; ++d) {
            for (int a = 0; a < table.azimuth; ++a) {
                const auto [light, view] = directions_of(table, h, d, a);
                const double length_l = std::hypot(light[0], light[1], light[2]);
                const double length_v = std::hypot(view[0], view[1], view[2]);
                EXPECT_NEAR(length_l, 1, 1e-12);
                EXPECT_NEAR(length_v, 1, 1e-12);
                const double x = light[0] + view[0], y = light[1] + view[1], z = light[2] + view[2];
                const double theta_half = std::atan2(std::hypot(x, y), z), phi_half = std::atan2(y, x);
                const double c = std::cos(phi_half), s = std::sin(phi_half);
                const double turned_x = light[0] * c + light[1] * s, turned_y = light[1] * c - light[0] * s;
                const double e = std::cos(theta_half), f = std::sin(theta_half);
                const double dx = turned_x * e - light[2] * f, dz = turned_x * f + light[2] * e;
                EXPECT_NEAR(theta_half, std::pow((h + 0.5) / 9, 2) * kPi / 2, 1e-9);
                EXPECT_NEAR(std::atan2(std::hypot(dx, turned_y), dz), (d + 0.5) / 9 * kPi / 2, 1e-9);
                EXPECT_NEAR(std::atan2(turned_y, dx), (a + 0.5) / 18 * kPi, 1e-9);
            }
        }
    }
}

}  // namespace
}  // namespace patina::runtime
