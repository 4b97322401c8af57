// Pictures that are larger than allowed are refused before their pixels are decoded, and headers that state more than
// the file can hold before a library takes memory for it. The tests make all files.
#include "runtime/picture/picture_bounds.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "runtime/picture/formats/header_fault.h"
#include "runtime/picture/formats/stated_space.h"
#include "runtime/picture/image.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

class PictureBounds : public testing::Test {
protected:
    PictureBounds() {
        std::string name = (fs::temp_directory_path() / "patina_bounds_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~PictureBounds() override {
        limit_pixels(kMostPixels);
        fs::remove_all(folder);
    }
    std::string path(const std::string& name) const { return (folder / name).string(); }

    // A picture of one colour, row by row, which compresses well.
    void save(const std::string& name, int width, int height, int channels, const char* compression = nullptr,
              int tile = 0) const {
        const bool is_half = name.ends_with(".exr");
        OIIO::ImageSpec spec(width, height, channels, is_half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
        if (compression) spec.attribute("compression", compression);
        spec.tile_width = spec.tile_height = tile;
        auto output = OIIO::ImageOutput::create(name);
        ASSERT_TRUE(output && output->open(path(name), spec)) << name;
        if (tile > 0) {
            const std::vector<float> all(std::size_t(width) * std::size_t(height) * std::size_t(channels), 0.5f);
            ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, all.data()) && output->close()) << name;
            return;
        }
        const std::vector<float> row(std::size_t(width) * std::size_t(channels), 0.5f);
        for (int y = 0; y < height; ++y)
            ASSERT_TRUE(output->write_scanline(y, 0, OIIO::TypeDesc::FLOAT, row.data())) << name;
        ASSERT_TRUE(output->close()) << name;
    }
    std::string bytes_of(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }

    // What loading it says, and by how many megabytes the process grew meanwhile: in a process of its own.
    struct Loaded {
        std::string error{};
        long megabytes = 0;
    };
    Loaded load(const std::string& name) const {
        int ends[2] = {};
        EXPECT_EQ(pipe(ends), 0);
        const pid_t child = fork();
        if (child == 0) {
            rusage before{}, after{};
            getrusage(RUSAGE_SELF, &before);
            const std::string error = load_image(path(name)).error;
            stated_space(path(name));
            load_notes(path(name));
            getrusage(RUSAGE_SELF, &after);
            const std::string said = std::to_string((after.ru_maxrss - before.ru_maxrss) >> 10) + " " + error;
            const bool is_told = ::write(ends[1], said.data(), said.size()) == ssize_t(said.size());
            _exit(is_told ? 0 : 1);
        }
        close(ends[1]);
        std::string said;
        char piece[4096];
        for (ssize_t got = 0; (got = read(ends[0], piece, sizeof piece)) > 0;) said.append(piece, std::size_t(got));
        close(ends[0]);
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << name << ": the process ended by a signal";
        const std::size_t blank = std::min(said.find(' '), said.size());
        return {.error = said.substr(std::min(blank + 1, said.size())), .megabytes = std::atol(said.c_str())};
    }
    void expect_refused(const std::string& name, const std::string& reason) const {
        const Loaded loaded = load(name);
        EXPECT_NE(loaded.error.find(reason), std::string::npos) << name << ": " << loaded.error;
        EXPECT_LT(loaded.megabytes, 64) << name;
        const Outcome<Image> decoded = decode_image(path(name), bytes_of(name));
        EXPECT_NE(decoded.error.find(reason), std::string::npos) << name << ": " << decoded.error;
    }

    fs::path folder;
};

// Puts a number at an attribute of an EXR header: `at` bytes behind the beginning of its value.
std::string with_number(std::string bytes, const std::string& attribute, std::size_t at, std::int32_t number) {
    const std::size_t name = bytes.find(attribute);
    EXPECT_NE(name, std::string::npos) << attribute;
    const std::size_t type = name + attribute.size() + 1, value = bytes.find('\0', type) + 5;
    std::memcpy(bytes.data() + value + at, &number, sizeof number);
    return bytes;
}

TEST_F(PictureBounds, APictureOfManyPixelsIsRefusedBeforeItIsDecoded) {
    save("flat.exr", 16384, 16384, 3, "zip");
    EXPECT_LT(fs::file_size(path("flat.exr")), 4u << 20);
    expect_refused("flat.exr", "it is 16384 x 16384 pixels, and the limit is 67108864 in all: --max-pixels");
    for (const std::string name : {"flat.png", "flat.jpg", "flat.tif", "flat.bmp", "flat.webp"}) {
        save(name, 600, 400, 3);
        ASSERT_TRUE(load_image(path(name))) << name;
        limit_pixels(600 * 400 - 1);
        expect_refused(name, "it is 600 x 400 pixels, and the limit is 239999 in all: --max-pixels");
        limit_pixels(600 * 400);
        EXPECT_TRUE(load_image(path(name))) << name;
        limit_pixels(kMostPixels);
    }
}

TEST_F(PictureBounds, ManyChannelsCountAsPixels) {
    save("layers.exr", 100, 100, 40, "zip");
    EXPECT_TRUE(load_image(path("layers.exr")));
    limit_pixels(99'999);
    expect_refused("layers.exr", "it is 100 x 100 pixels with 40 channels, and the limit is 99999 pixels with four");
}

TEST_F(PictureBounds, ADamagedHeaderTakesNoMemory) {
    save("good.exr", 64, 64, 4, "zip");
    const std::string good = bytes_of("good.exr");
    ASSERT_TRUE(load_image(path("good.exr")));
    constexpr std::size_t kRight = 8, kBottom = 12;
    write("wide.exr", with_number(good, "dataWindow", kRight, (1 << 27) - 1));
    expect_refused("wide.exr", "it is 134217728 x 64 pixels");
    write("high.exr", with_number(good, "dataWindow", kBottom, (1 << 30) - 1));
    expect_refused("high.exr", "it is 64 x 1073741824 pixels");
    write("whole.exr", with_number(with_number(good, "dataWindow", 0, INT32_MIN), "dataWindow", kRight, INT32_MAX));
    expect_refused("whole.exr", "it is 4294967296 x 64 pixels");
    write("none.exr", with_number(good, "dataWindow", kRight, -5));
    expect_refused("none.exr", "its header has no size");
    // It could be so large, if the file had a place for each of its pieces.
    write("cut.exr", with_number(good, "dataWindow", kBottom, 16383));
    expect_refused("cut.exr", "it is cut off, or its header is damaged");

    save("tiles.exr", 128, 128, 4, "zip", 64);
    const std::string tiles = bytes_of("tiles.exr");
    ASSERT_TRUE(load_image(path("tiles.exr")));
    write("large.exr", with_number(with_number(tiles, "tiles", 0, 1 << 15), "tiles", 4, 1 << 15));
    expect_refused("large.exr", "its pieces have more than 64 MiB each");
    write("huge.exr", with_number(with_number(tiles, "tiles", 0, -1), "tiles", 4, -1));
    expect_refused("huge.exr", "its pieces have more than 64 MiB each");
    write("small.exr",
          with_number(with_number(with_number(tiles, "tiles", 0, 1), "tiles", 4, 1), "dataWindow", kRight, 8191));
    expect_refused("small.exr", "it is cut off, or its header is damaged");
}

TEST_F(PictureBounds, OfEveryFlippedByteOfAHeaderTakesNoMemory) {
    save("good.exr", 64, 64, 4, "zip");
    const std::string good = bytes_of("good.exr");
    for (std::size_t at = 8; at < std::min<std::size_t>(good.size(), 360); ++at) {
        std::string bytes = good;
        bytes[at] = static_cast<char>(bytes[at] ^ 0xff);
        EXPECT_LE(header_fault(bytes).size(), 200u);
        header_fault(std::string_view(bytes).substr(0, at));
    }
}

TEST_F(PictureBounds, HeadersOfOtherKindsThatAreDecodedAsTheyAreOpened) {
    using namespace std::string_literals;
    const std::string riff = "RIFF\x40\0\0\0WEBP"s;
    EXPECT_NE(header_fault(riff + "VP8X\x0a\0\0\0\x10\0\0\0\xff\xff\xff\xff\xff\xff"s).find("16777216 x 16777216"),
              std::string::npos);
    EXPECT_EQ(header_fault(riff + "VP8X\x0a\0\0\0\x10\0\0\0\x0f\0\0\x0f\0\0"s), "");
    limit_pixels(1 << 20);
    EXPECT_NE(header_fault(riff + "VP8L\x0a\0\0\0\x2f\xff\xff\xff\x0f"s).find("16384 x 16384"), std::string::npos);
    EXPECT_NE(header_fault(riff + "VP8 \x0a\0\0\0\0\0\0\x9d\x01\x2a\xff\x3f\xff\x3f"s).find("16383 x 16383"),
              std::string::npos);
    const std::string siz = "\xff\x4f\xff\x51\0\x2f\0\0"s;
    const std::string rest = "\0\0\0\0\0\0\0\0"s + std::string(16, '\0') + "\0\x03"s;
    EXPECT_NE(header_fault(siz + "\0\1\0\0\0\1\0\0"s + rest).find("65536 x 65536"), std::string::npos);
    EXPECT_EQ(header_fault(siz + "\0\0\1\0\0\0\1\0"s + rest), "");
    EXPECT_EQ(header_fault(siz + "\0\0"s), "its header has no size");
}

// The lengths and the numbers stand where "Graphics Interchange Format" and "Adobe Photoshop File Formats
// Specification" have them.
TEST_F(PictureBounds, HeadersOfGifAndPhotoshop) {
    using namespace std::string_literals;
    EXPECT_EQ(header_fault("GIF89a\x0c\0\x0c\0"s), "");
    EXPECT_NE(header_fault("GIF89a\xbd\xbd\xbd\xbd"s).find("48573 x 48573"), std::string::npos);
    const auto psd = [](char channels, char height, char mode, const std::string& palette, const std::string& rest) {
        return "8BPS\0\1\0\0\0\0\0\0\0"s + channels + "\0\0"s + height + "\0\0\0\0\4\0\x08\0"s + mode + palette + rest;
    };
    const std::string none = "\0\0\0\0"s, cut = "it is cut off, or its header is damaged";
    EXPECT_EQ(header_fault(psd(3, 0, 3, none, none + none)), "");
    EXPECT_EQ(header_fault(psd(1, 0, 1, none, none + none)), "");
    EXPECT_EQ(header_fault(psd(2, 0, 3, none, none + none)), "its header has fewer channels than its colours need");
    EXPECT_EQ(header_fault(psd(3, 0, 4, none, none + none)), "its header has fewer channels than its colours need");
    EXPECT_NE(header_fault(psd(3, 127, 3, none, none + none)).find("4 x 32512"), std::string::npos);
    EXPECT_TRUE(header_fault(psd(3, 0, 3, "\xff\x7f\0\0"s, none + none)).starts_with(cut));
    EXPECT_TRUE(header_fault(psd(3, 0, 3, none, none)).starts_with(cut));
    const std::string block = "8BIM\4\x0f\1a\0\0\0\3abc\0"s;  // a name of one letter, three bytes and one to be even
    EXPECT_EQ(header_fault(psd(3, 0, 3, none, "\0\0\0\x10"s + block + none)), "");
    EXPECT_TRUE(header_fault(psd(3, 0, 3, none, "\0\0\0\x0f"s + block + none)).starts_with(cut));
    EXPECT_TRUE(
        header_fault(psd(3, 0, 3, none, "\0\0\0\x10"s + "8BIM\4\x0f\1a\x7f\0\0\3abc\0"s + none)).starts_with(cut));
}

// A block: 0x1c, the record, a number, two bytes of length, data.
TEST_F(PictureBounds, HeadersWithDamagedIptcData) {
    using namespace std::string_literals;
    const std::string good = "\x1c\2\x78\0\3abc"s,
                      damaged = "its IPTC data are damaged: they claim more bytes than they have";
    const auto jpeg = [](const std::string& data, int stated) {
        const std::string inner = "Photoshop 3.0\0008BIM\4\4\0\0\0\0\0"s + char(stated) + data;
        return "\xff\xd8\xff\xed\0"s + char(inner.size() + 2) + inner + "\xff\xda";
    };
    EXPECT_EQ(header_fault(jpeg(good, 8)), "");
    EXPECT_EQ(header_fault(jpeg(good + good, 16)), "");
    EXPECT_EQ(header_fault(jpeg(good + '\0', 9)), "");
    EXPECT_EQ(header_fault(jpeg("", 0)), "");
    EXPECT_EQ(header_fault(jpeg(good, 9)), damaged);
    EXPECT_EQ(header_fault(jpeg("\x1c\2\x78\0\4abc"s, 8)), damaged);
    EXPECT_EQ(header_fault(jpeg(good + "\x1c\2\x78", 11)), damaged);
    const auto tiff = [](const std::string& data) {
        return "II*\0\x08\0\0\0\1\0\xbb\x83\4\0\2\0\0\0\x1a\0\0\0\0\0\0\0"s + data;  // an entry of two longs
    };
    EXPECT_EQ(header_fault(tiff(good)), "");
    EXPECT_EQ(header_fault(tiff("\x1c\2\x78\0\4abc"s)), damaged);
}

TEST_F(PictureBounds, OfAnAttributeThatIsLongerThanItsFile) {
    save("good.exr", 8, 8, 3, "zip");
    std::string bytes = bytes_of("good.exr");
    ASSERT_EQ(header_fault(bytes), "");
    const std::size_t type = bytes.find("\0chlist\0", 0, 8);
    ASSERT_NE(type, bytes.npos);
    bytes[type + 8 + 3] = '\x7f';  // the highest byte of its length
    EXPECT_EQ(header_fault(bytes), "it is cut off, or its header is damaged: it claims more bytes than it has");
}

TEST_F(PictureBounds, TheLargestPictureThatIsAllowedIsRead) {
    EXPECT_EQ(size_fault(8192, 8192, 4), "");
    EXPECT_NE(size_fault(8192, 8193, 4), "");
    EXPECT_NE(size_fault(16385, 1, 4), "");
    EXPECT_EQ(most_picture_bytes(), (std::uint64_t{1} << 30) + (std::uint64_t{64} << 20));
}

}  // namespace
}  // namespace patina::runtime
