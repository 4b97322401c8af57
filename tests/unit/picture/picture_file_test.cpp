// Files that are not what they claim to be: cut off, named as another kind, or with sizes that nobody can hold; and the
// colour spaces that files state. The tests make all files.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "runtime/lighting/environment_file.h"
#include "runtime/picture/formats/picture_kind.h"
#include "runtime/picture/formats/stated_space.h"
#include "runtime/picture/image.h"
#include "runtime/picture/openimageio.h"
#include "runtime/values/textures.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

class PictureFile : public testing::Test {
protected:
    PictureFile() {
        std::string name = (fs::temp_directory_path() / "patina_picture_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~PictureFile() override { fs::remove_all(folder); }
    std::string path(const std::string& name) const { return (folder / name).string(); }

    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }
    std::string bytes_of(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    // A picture of noise, which no format makes small. `attributes` are OpenImageIO's.
    void save(const std::string& name, const std::vector<std::pair<std::string, std::string>>& attributes = {},
              OIIO::TypeDesc type = OIIO::TypeDesc::UINT8) const {
        constexpr int kSide = 64;
        const bool is_float = name.ends_with(".exr") || name.ends_with(".hdr");
        OIIO::ImageSpec spec(kSide, kSide, 3, is_float ? OIIO::TypeDesc::FLOAT : type);
        spec.attribute("oiio:ColorSpace", "");
        for (const auto& [key, value] : attributes) spec.attribute(key, value);
        std::mt19937 random(3);
        std::vector<float> pixels(std::size_t(3) * kSide * kSide);
        for (float& each : pixels) each = float(random() % 256) / 255;
        auto output = OIIO::ImageOutput::create(name);
        ASSERT_TRUE(output && output->open(path(name), spec)) << name << ": " << OIIO::geterror();
        ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close()) << name;
    }

    // The file cannot be read, and the message names the file and the reason.
    void expect_fault(const std::string& name, const std::string& reason) const {
        const Outcome<Image> loaded = load_image(path(name));
        ASSERT_FALSE(loaded) << name;
        EXPECT_NE(loaded.error.find("'" + path(name) + "'"), std::string::npos) << loaded.error;
        EXPECT_NE(loaded.error.find(reason), std::string::npos) << loaded.error;
        const Outcome<Image> decoded = decode_image(path(name), bytes_of(name));
        ASSERT_FALSE(decoded) << name;
        EXPECT_NE(decoded.error.find(reason), std::string::npos) << decoded.error;
    }

    fs::path folder;
};

const char* const kFormats[] = {".png", ".jpg", ".exr", ".hdr", ".tif", ".tga", ".bmp", ".webp"};

TEST_F(PictureFile, OfEveryFormatIsRefusedIfItIsCutOff) {
    for (const std::string ending : kFormats) {
        save("whole" + ending);
        const Outcome<Image> whole = load_image(path("whole" + ending));
        ASSERT_TRUE(whole) << whole.error;
        const std::string bytes = bytes_of("whole" + ending);
        for (const std::size_t size : {std::size_t(1), std::size_t(7), std::size_t(40), bytes.size() / 4,
                                       bytes.size() / 2, bytes.size() * 9 / 10, bytes.size() - 60, bytes.size() - 1}) {
            const std::string name = "cut" + ending;
            write(name, bytes.substr(0, size));
            const Outcome<Image> loaded = load_image(path(name));
            // A format can end with something else than pixels.
            if (loaded) {
                EXPECT_EQ(loaded.value.pixels, whole.value.pixels) << size << " bytes of " << ending;
                continue;
            }
            EXPECT_NE(loaded.error.find("'" + path(name) + "'"), std::string::npos) << loaded.error;
            EXPECT_FALSE(loaded.error.ends_with("unknown reason")) << size << " bytes of " << ending;
        }
        write("cut" + ending, bytes.substr(0, bytes.size() / 2));
        EXPECT_FALSE(load_image(path("cut" + ending))) << ending;
    }
    expect_fault("cut.tif", "it is a TIFF file without its end");
    expect_fault("cut.png", "it is a PNG file without its end");
    expect_fault("cut.jpg", "it is a JPEG file without its end");
    expect_fault("cut.webp", "it is a WebP file without its end");
}

TEST_F(PictureFile, IsRefusedUnderTheNameOfAnotherFormat) {
    for (const std::string ending : kFormats) save("right" + ending);
    for (const std::string ending : kFormats) {
        for (const std::string other : kFormats) {
            // The first bytes of a TGA file can be any.
            if (ending == other || ending == ".tga") continue;
            write("wrong" + other, bytes_of("right" + ending));
            expect_fault("wrong" + other, ": name it 'wrong" + ending + "'");
        }
    }
    write("WRONG.JPG", bytes_of("right.png"));
    expect_fault("WRONG.JPG", "it is a PNG file: name it 'WRONG.png'");
    // A name that says nothing is right.
    write("picture", bytes_of("right.png"));
    EXPECT_TRUE(load_image(path("picture")));
}

TEST_F(PictureFile, ThatIsTextIsRefused) {
    for (const std::string ending : kFormats) {
        write("text" + ending, "this is no picture, but a text that somebody gave the wrong name\n");
        if (ending != ".tga") expect_fault("text" + ending, "it is not a");
        EXPECT_FALSE(load_image(path("text" + ending))) << ending;
        write("empty" + ending, "");
        expect_fault("empty" + ending, "it has no bytes");
    }
}

// A name chooses one reader: a picture of another format that has no first bytes of its own is not tried.
TEST_F(PictureFile, IsReadByOneReaderAlone) {
    save("right.tga");
    ASSERT_TRUE(load_image(path("right.tga")));
    for (const std::string name : {"wrong.ppm", "wrong.dpx", "wrong.cr2", "wrong.unknown", "wrong"}) {
        write(name, bytes_of("right.tga"));
        EXPECT_FALSE(load_image(path(name))) << name;
        EXPECT_FALSE(decode_image(path(name), bytes_of(name))) << name;
        EXPECT_EQ(stated_space(path(name)).space, ColorSpace::None) << name;
    }
    expect_fault("wrong.unknown", "neither its first bytes nor its name belong to a format that can be read");
    expect_fault("wrong", "neither its first bytes nor its name belong to a format that can be read");
    // SGI's reader opens the file itself. Bytes of another file, such as a model, are no file on the disk.
    save("right.sgi");
    EXPECT_TRUE(load_image(path("right.sgi")));
    const Outcome<Image> decoded = decode_image(path("right.sgi"), bytes_of("right.sgi"));
    ASSERT_FALSE(decoded);
    EXPECT_NE(decoded.error.find("cannot be read from memory"), std::string::npos) << decoded.error;
}

// A PNG says where it lies on a page (oFFs).
TEST_F(PictureFile, FarOutsideOfAnyPictureIsRefused) {
    for (const int x : {2'000'000'000, -2'000'000'000}) {
        OIIO::ImageSpec spec(4, 4, 3, OIIO::TypeDesc::UINT8);
        spec.x = spec.full_x = x;
        const auto output = OIIO::ImageOutput::create("far.png");
        const std::vector<float> pixels(48, 0.5f);
        ASSERT_TRUE(output && output->open(path("far.png"), spec) &&
                    output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close());
        expect_fault("far.png", "its header places it far outside of any picture");
    }
}

TEST_F(PictureFile, OfKtxIsRefusedWithAdvice) {
    write("a.ktx2", "\xabKTX 20\xbb\r\n\x1a\n" + std::string(100, '\0'));
    expect_fault("a.ktx2", "it is a KTX2 file, which is not supported: convert it to PNG, or to OpenEXR if it is HDR");
    write("a.png", bytes_of("a.ktx2"));
    expect_fault("a.png", "it is a KTX2 file, which is not supported");
}

// --- sizes

std::string number(std::uint32_t value, bool is_big, int count = 4) {
    std::string made;
    for (int i = 0; i < count; ++i) made += char(value >> 8 * (is_big ? count - 1 - i : i) & 0xff);
    return made;
}

// CRC-32 of ISO 3309, as the PNG specification has it.
std::string chunk(const std::string& name, const std::string& data) {
    std::uint32_t crc = 0xffffffffu;
    for (const char c : name + data) {
        crc ^= static_cast<unsigned char>(c);
        for (int k = 0; k < 8; ++k) crc = (crc & 1) != 0 ? 0xedb88320u ^ crc >> 1 : crc >> 1;
    }
    return number(std::uint32_t(data.size()), true) + name + data + number(~crc, true);
}

const std::string kPngHeader = "\x89PNG\r\n\x1a\n";

std::string png_of(std::uint32_t width, std::uint32_t height) {
    return kPngHeader + chunk("IHDR", number(width, true) + number(height, true) + std::string("\x08\x06\0\0\0", 5)) +
           chunk("IDAT", std::string("\x78\x9c\x63\x60\x60\x60\0\0", 8)) + chunk("IEND", "");
}

// Each size that a file states is compared with its length before anything is read by it. The bytes lie in memory of
// exactly their length, so that a sanitizer sees a read behind them.
TEST_F(PictureFile, IsRefusedIfAChunkClaimsMoreThanThereIs) {
    const std::string png = png_of(1, 1);
    const auto expect_cut = [&](const std::string& name, const std::string& bytes) {
        const std::vector<char> exact(bytes.begin(), bytes.end());
        const std::string_view view(exact.data(), exact.size());
        EXPECT_NE(picture_fault(name, view).find("without its end"), std::string::npos) << name;
        if (const PictureKind* kind = picture_kind(view)) {
            EXPECT_EQ(damage_of(*kind, view), "without its end") << name;
        }
    };
    // Of IEND, and of the chunk before it.
    for (const std::uint32_t length : {1u, 0x20u, 0x7fffffffu, 0x80000000u, 0xfffffff0u, 0xfffffff4u, 0xffffffffu}) {
        for (const std::string chunk : {"IEND", "IDAT", "IHDR"}) {
            std::string bytes = png;
            bytes.replace(bytes.find(chunk) - 4, 4, number(length, true));
            if (bytes != png) expect_cut("a.png", bytes);
        }
    }
    // Every piece of the file is as long as it says.
    for (std::size_t size = 8; size < png.size(); ++size) expect_cut("a.png", png.substr(0, size));
    expect_cut("a.webp", "RIFF" + number(0xffffffffu, false) + "WEBP");
    expect_cut("a.webp", "RIFF" + number(5, false) + "WEBP");
    expect_cut("a.jpg", "\xff\xd8\xff");
    expect_cut("a.jpg", std::string("\xff\xd8\xff\xe0\xff", 5));
    expect_cut("a.jpg", std::string("\xff\xd8\xff\xe0\xff\xff\xff\xd9", 8));
    // TIFF: the directory, and the list of pieces that it names. Offsets of 64 bits, whose sums do not fit.
    expect_cut("a.tif", "II*" + std::string(1, '\0') + number(0xfffffff0u, false));
    const std::string large = std::string("II+\0\x08\0\0\0", 8);
    expect_cut("a.tif", large + std::string(8, '\xff'));
    const std::string entry = number(273, false, 2) + number(16, false, 2) + std::string(8, '\xff') + number(16, false);
    expect_cut("a.tif", large + number(16, false) + number(0, false) + number(1, false) + number(0, false) + entry);
    // A kind that is asked for bytes of another one.
    const std::string_view webp("RIFF\0\0\0\0WEBP", 12);
    EXPECT_EQ(damage_of(*picture_kind(webp), "RI"), "without its end");
}

// OpenImageIO's own reader takes a place before the first byte, to which a damaged BMP moves it.
TEST_F(PictureFile, IsReadWithinTheBoundsOfItsMemory) {
    const std::vector<char> exact = {'a', 'b', 'c', 'd'};
    MemoryReader reader({exact.data(), exact.size()});
    constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min(), kMost = -(kLeast + 1);
    char to[8] = {};
    for (const std::int64_t place : {kLeast, std::int64_t(-4), std::int64_t(-1), std::int64_t(4), kMost}) {
        EXPECT_EQ(reader.pread(to, sizeof to, place), 0u) << place;
        EXPECT_EQ(reader.seek(place), place == 4) << place;
        EXPECT_EQ(reader.tell(), place == 4 ? 4 : 0) << place;  // one that is not there changes nothing
        ASSERT_TRUE(reader.seek(0));
    }
    EXPECT_EQ(reader.pread(to, std::size_t(-1), 1), 3u);
    EXPECT_EQ(std::string(to, 3), "bcd");
    EXPECT_EQ(reader.read(to, 3), 3u);
    EXPECT_EQ(reader.read(to, 3), 1u);
    EXPECT_EQ(to[0], 'd');
}

// A directory that lists the same pieces 60000 times: each list is read once.
TEST_F(PictureFile, OfTiffWithRepeatedListsIsReadOnce) {
    constexpr std::uint32_t kEntries = 60000, kPieces = 200000;
    std::string bytes = "II*" + std::string(1, '\0') + number(8, false) + number(kEntries, false, 2);
    const std::uint32_t list = 8 + 2 + 12 * kEntries + 4;
    for (std::uint32_t i = 0; i < kEntries; ++i)
        bytes += number(273, false, 2) + number(4, false, 2) + number(kPieces, false) + number(list, false);
    bytes += number(0, false) + std::string(4 * kPieces, '\0');
    EXPECT_EQ(picture_fault("a.tif", bytes), "");
}

long peak_kilobytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

// Small files with large numbers in their headers. None may take the memory that it claims.
TEST_F(PictureFile, OfGigabytesIsRefusedBeforeItTakesMemory) {
    const long before = peak_kilobytes();
    write("side.png", png_of(30000, 10));
    expect_fault("side.png", "it is 30000 x 10 pixels, and the limit is 16384 on a side");
    write("all.png", png_of(16384, 16384));
    expect_fault("all.png", "it is 16384 x 16384 pixels, and the limit is 67108864 in all");
    write("claim.png", png_of(8192, 8000));
    expect_fault("claim.png", "cannot read");
    write("claim.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8000 +X 8192\nabc");
    expect_fault("claim.hdr", "cannot read");
    write("claim.tga", std::string("\0\0\2\0\0\0\0\0\0\0\0\0", 12) + number(8192, false, 2) + number(8000, false, 2) +
                           std::string("\x20\0", 2) + "abc");
    expect_fault("claim.tga", "cannot read");
    write("claim.bmp", "BM" + number(60, false) + number(0, false) + number(54, false) + number(40, false) +
                           number(8192, false) + number(8000, false) + std::string("\1\0\x18\0", 4) +
                           std::string(24, '\0') + "abcdef");
    expect_fault("claim.bmp", "cannot read");
    // The corner of an EXR's data window, which stands behind the words of its attribute.
    save("real.exr");
    std::string exr = bytes_of("real.exr");
    const std::string word("dataWindow\0box2i\0", 17);
    const std::size_t at = exr.find(word);
    ASSERT_NE(at, std::string::npos);
    exr.replace(at + word.size() + 4 + 8, 8, number(8191, false) + number(7999, false));
    write("claim.exr", exr);
    expect_fault("claim.exr", "cannot read");
    // A file of holes, which takes no room on the disk.
    write("holes.tif", std::string("II*\0\x08\0\0\0", 8));
    fs::resize_file(path("holes.tif"), std::uintmax_t(5) << 30);
    const Outcome<Image> holes = load_image(path("holes.tif"));
    ASSERT_FALSE(holes);
    EXPECT_EQ(holes.error, "cannot read '" + path("holes.tif") + "': it has more than 1140850688 bytes");
    EXPECT_LT(peak_kilobytes() - before, 400 * 1024);
}

// --- environments

TEST_F(PictureFile, OfSurroundingsIsRefusedForTheSameReasons) {
    save("right.hdr");
    const std::string bytes = bytes_of("right.hdr");
    write("cut.hdr", bytes.substr(0, bytes.size() / 2));
    write("wrong.exr", bytes);
    write("text.hdr", "no picture");
    for (const auto& [name, reason] : {std::pair("cut.hdr", "cannot read"), std::pair("text.hdr", "not a Radiance HDR"),
                                       std::pair("wrong.exr", "it is a Radiance HDR file: name it 'wrong.hdr'")}) {
        const auto loaded = load_environment({.path = path(name)}, {});
        ASSERT_FALSE(loaded) << name;
        EXPECT_NE(loaded.error.find(path(name)), std::string::npos) << loaded.error;
        EXPECT_NE(loaded.error.find(reason), std::string::npos) << loaded.error;
    }
}

// --- colour spaces

// A PNG of one white pixel with these chunks before its pixels.
std::string stating(const std::string& chunks, char bits = 8) {
    return kPngHeader +
           chunk("IHDR", number(1, true) + number(1, true) + std::string(1, bits) + std::string("\2\0\0\0", 4)) +
           chunks +
           // A stored block of deflate: a filter byte and three channels of 255, and Adler-32 of these.
           (bits == 8 ? chunk("IDAT", std::string("\x78\x01\x01\x04\0\xfb\xff\0\xff\xff\xff\x05\xfe\x02\xfe", 15))
                      : chunk("IDAT", std::string("\x78\x01\x01\x07\0\xf8\xff\0\xff\xff\xff\xff\xff\xff", 14) +
                                          std::string("\x14\xf2\x05\xfb", 4))) +
           chunk("IEND", "");
}
const std::string kSrgbChunk = chunk("sRGB", std::string(1, '\0'));
std::string gama(std::uint32_t value) {
    return chunk("gAMA", number(value, true));
}

TEST_F(PictureFile, StatesAColourSpaceOnlyInWords) {
    struct Case {
        std::string chunks;
        ColorSpace space;
        std::string by;
    };
    const std::vector<Case> cases = {
        {"", ColorSpace::None, ""},
        {kSrgbChunk, ColorSpace::Srgb, "its sRGB chunk"},
        {gama(45455), ColorSpace::Srgb, "its gAMA chunk"},
        {gama(100000), ColorSpace::Linear, "its gAMA chunk"},
        {gama(55556), ColorSpace::None, ""},  // 1.8
        {gama(100000) + kSrgbChunk, ColorSpace::Srgb, "its sRGB chunk"},
        {chunk("cICP", std::string("\x01\x0d\0\x01", 4)), ColorSpace::Srgb, "its cICP chunk"},
        {chunk("cICP", std::string("\x01\x08\0\x01", 4)) + kSrgbChunk, ColorSpace::Linear, "its cICP chunk"},
        {chunk("tEXt", std::string("Comment\0a long text before the chunk that counts", 48)) + kSrgbChunk,
         ColorSpace::Srgb, "its sRGB chunk"},
    };
    for (const Case& each : cases) {
        const StatedSpace stated = stated_space(write("a.png", stating(each.chunks)));
        EXPECT_EQ(stated.space, each.space) << each.by;
        EXPECT_EQ(stated.by, each.by);
        EXPECT_TRUE(load_image(path("a.png")));
    }
    save("plain.jpg");
    EXPECT_EQ(stated_space(path("plain.jpg")).space, ColorSpace::None);
    save("plain.exr");
    EXPECT_EQ(stated_space(path("plain.exr")).space, ColorSpace::None);
    EXPECT_EQ(stated_space(path("none.png")).space, ColorSpace::None);
}

// What this program writes for data states nothing, and its colours are sRGB.
TEST_F(PictureFile, OfDataStatesNothing) {
    ASSERT_EQ(save_png_as_is(path("data.png"), make_image(2, 2)), "");
    ASSERT_EQ(save_png(path("color.png"), make_image(2, 2)), "");
    EXPECT_EQ(stated_space(path("data.png")).space, ColorSpace::None);
    EXPECT_EQ(stated_space(path("color.png")).space, ColorSpace::Srgb);
}

TEST_F(PictureFile, ThatStatesAnotherColourSpaceIsAWarning) {
    write("srgb.png", stating(kSrgbChunk));
    write("linear.png", stating(gama(100000)));
    write("srgb16.png", stating(kSrgbChunk, 16));
    write("plain.png", stating(""));
    const auto warning = [&](TextureUsage usage, const std::string& file, const MemoryFiles* in_memory = nullptr) {
        Reflection reflection;
        Texture& texture = reflection.textures.emplace_back();
        texture.name = "_Map";
        texture.usage = usage;
        texture.default_texture = TextureDefault::File;
        texture.default_file = "./" + file;
        const LoadedTextures loaded = load_textures(reflection, folder.string(), {}, false, in_memory);
        EXPECT_TRUE(loaded.errors.empty()) << file;
        EXPECT_LE(loaded.warnings.size(), 1U);
        return loaded.warnings.empty() ? "" : loaded.warnings[0].text;
    };
    for (const TextureUsage usage : {TextureUsage::Data, TextureUsage::Normal}) {
        EXPECT_EQ(
            warning(usage, "srgb.png"),
            "'_Map' is read as numbers that are not decoded, but '" + path("srgb.png") +
                "' is encoded as sRGB, as its sRGB chunk says: write \"usage\": \"color\", or save the file without "
                "a colour space");
        EXPECT_NE(warning(usage, "srgb16.png"), "");
        EXPECT_EQ(warning(usage, "linear.png"), "");
        EXPECT_EQ(warning(usage, "plain.png"), "");
    }
    EXPECT_EQ(warning(TextureUsage::Color, "srgb.png"), "");
    EXPECT_EQ(warning(TextureUsage::Color, "plain.png"), "");
    EXPECT_EQ(warning(TextureUsage::Color, "linear.png"),
              "'_Map' is read as a colour, decoded from sRGB, but '" + path("linear.png") +
                  "' is linear, as its gAMA chunk says: write \"usage\": \"data\", or save the file encoded as sRGB");
    EXPECT_EQ(warning(TextureUsage::Color, "srgb16.png"),
              "'_Map' is read as linear light, because it has more than 8 bits a channel, but '" + path("srgb16.png") +
                  "' is encoded as sRGB, as its sRGB chunk says: save the file with 8 bits a channel, or as linear "
                  "light");
    // In a model's pictures, such words do not count.
    const MemoryFiles none;
    EXPECT_EQ(warning(TextureUsage::Data, "srgb.png", &none), "");
}

}  // namespace
}  // namespace patina::runtime
