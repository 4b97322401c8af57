// Files of pictures, of every format that is read, and the tables and maps that are read as bytes.
#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <cstdlib>
#include <memory>

#include "runtime/lighting/map_cache.h"
#include "runtime/lighting/merl.h"
#include "runtime/lighting/prefilter.h"
#include "runtime/picture/formats/picture_kind.h"
#include "runtime/picture/formats/stated_space.h"
#include "runtime/picture/image.h"
#include "runtime/picture/picture_bounds.h"
#include "tests/fuzz/fuzz.h"

namespace patina::fuzz {
namespace {

namespace fs = std::filesystem;

struct Form {
    int width, height, channels;
    OIIO::TypeDesc type;
    const char* compression;
};

// Small pictures, as OpenImageIO writes them. A format that does not take a form has none of it.
std::vector<Seed> written_pictures(const Setup& setup, const std::string& ending) {
    const Form forms[] = {{8, 8, 3, OIIO::TypeDesc::UINT8, ""},      {5, 9, 4, OIIO::TypeDesc::UINT8, ""},
                          {16, 4, 1, OIIO::TypeDesc::UINT16, ""},    {7, 3, 3, OIIO::TypeDesc::FLOAT, "zip"},
                          {33, 20, 3, OIIO::TypeDesc::HALF, "piz"},  {12, 12, 4, OIIO::TypeDesc::UINT8, "rle"},
                          {12, 12, 3, OIIO::TypeDesc::UINT8, "lzw"}, {9, 9, 3, OIIO::TypeDesc::HALF, "dwaa"},
                          {20, 20, 3, OIIO::TypeDesc::FLOAT, "b44"}, {10, 10, 3, OIIO::TypeDesc::UINT8, "none"}};
    std::vector<Seed> made;
    std::mt19937 random(3);
    for (const Form& form : forms) {
        const fs::path path = setup.scratch / ("seed" + ending);
        OIIO::ImageSpec spec(form.width, form.height, form.channels, form.type);
        spec.attribute("oiio:ColorSpace", form.channels == 3 ? "sRGB" : "linear");
        spec.attribute("compression", form.compression);
        spec.attribute("ImageDescription", "a seed");
        spec.attribute("IPTC:City", "a city");
        spec.attribute("Exif:FNumber", 2.8f);
        if (std::string_view(form.compression) == "zip" || std::string_view(form.compression) == "none")
            spec.tile_width = spec.tile_height = 16;
        std::vector<float> pixels(std::size_t(form.width) * std::size_t(form.height) * std::size_t(form.channels));
        for (float& each : pixels) each = float(random() % 8) / 7;
        auto output = OIIO::ImageOutput::create(path.string());
        if (!output || !output->supports("tiles")) spec.tile_width = spec.tile_height = 0;
        const bool is_written = output && output->open(path.string(), spec) &&
                                (spec.tile_width ? output->write_image(OIIO::TypeDesc::FLOAT, pixels.data())
                                                 : output->write_image(OIIO::TypeDesc::FLOAT, pixels.data())) &&
                                output->close();
        OIIO::geterror();
        if (is_written) made.push_back({.bytes = read_file(path)});
        fs::remove(path);
    }
    return made;
}

std::string big_endian(std::uint64_t number, std::size_t size) {
    std::string made(size, '\0');
    for (std::size_t i = 0; i < size; ++i) made[size - 1 - i] = static_cast<char>(number >> (8 * i));
    return made;
}
std::string little_endian(std::uint64_t number) {
    const std::string made = big_endian(number, 4);
    return {made.rbegin(), made.rend()};
}

// OpenImageIO writes neither of the two.
std::vector<Seed> dds_seeds() {
    std::string head = "DDS ";
    // The sizes of the header and of its pixel format, what it has, height, width, bytes of a row.
    for (const std::uint32_t each : {124u, 0x100fu, 4u, 4u, 16u, 0u, 0u}) head += little_endian(each);
    head += std::string(44, '\0');
    const auto rest = [](std::uint32_t flags, const std::string& code, std::uint32_t bits) {
        std::string made = little_endian(32) + little_endian(flags) + code + little_endian(bits);
        for (const std::uint32_t mask : {0xff0000u, 0xff00u, 0xffu, 0xff000000u}) made += little_endian(mask);
        return made + little_endian(0x1000) + std::string(16, '\0');
    };
    return {{head + rest(0x41, std::string(4, '\0'), 32) + std::string(64, '\x40')},
            {head + rest(4, "DXT1", 0) + std::string(8, '\x5a')},
            {head + rest(4, "DXT5", 0) + std::string(16, '\x5a')}};
}
std::vector<Seed> psd_seeds() {
    const auto file = [](int channels, int compression, const std::string& pixels) {
        return "8BPS" + big_endian(1, 2) + std::string(6, '\0') + big_endian(std::uint64_t(channels), 2) +
               big_endian(4, 4) + big_endian(4, 4) + big_endian(8, 2) + big_endian(3, 2) + std::string(12, '\0') +
               big_endian(std::uint64_t(compression), 2) + pixels;
    };
    std::string packed;
    for (int row = 0; row < 12; ++row) packed += big_endian(2, 2);
    for (int row = 0; row < 12; ++row) packed += "\xfd\x40";  // four times one byte
    return {{file(3, 0, std::string(48, '\x40'))}, {file(3, 1, packed)}};
}

std::uint32_t crc_of(std::string_view bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
    }
    return ~crc;
}

// Gives the chunks of a PNG checksums that fit: without them, nothing behind the first change is looked at.
void mend_checksums(std::string& png) {
    for (std::size_t at = 8; at + 12 <= png.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(png[at + i]);
        if (length > png.size() - at - 12) return;
        png.replace(at + 8 + length, 4, big_endian(crc_of(std::string_view(png).substr(at + 4, length + 4)), 4));
        at += 12 + length;
    }
}

std::string wrong_with(const runtime::Outcome<runtime::Image>& read, const std::string& path) {
    if (!read) return read.error.find(path) == std::string::npos ? "no file in: " + read.error : "";
    const runtime::Image& image = read.value;
    const bool fits = image.width > 0 && image.height > 0 &&
                      image.pixels.size() == 4 * std::size_t(image.width) * std::size_t(image.height);
    return fits ? "" : "its pixels do not fit its size";
}

constexpr std::size_t kUsualPixels = std::size_t{1} << 14;

template <std::size_t count>
Fuzzer pictures(const Setup& setup, const char (&ending)[count], std::vector<Seed> written = {}) {
    std::vector<Seed> seeds = seeds_in(setup, {}, ending);
    if (setup.seeds.empty()) seeds = written.empty() ? written_pictures(setup, ending) : std::move(written);
    auto all = std::make_shared<std::vector<Seed>>(std::move(seeds));
    const bool is_png = std::string_view(ending) == ".png";
    const auto make = [all, is_png](Random& random) {
        std::string bytes =
            changed_bytes((*all)[below(random, all->size())].bytes, (*all)[below(random, all->size())].bytes, random);
        if (is_png && !one_in(4, random)) mend_checksums(bytes);
        return Input{.bytes = std::move(bytes)};
    };
    const std::string path = (setup.scratch / ("fuzz" + std::string(ending))).string();
    // A pool of threads for a picture of a few pixels takes ten times as long as the picture.
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
    const auto run = [path](const Input& input, Random& random) -> Verdict {
        const std::string& bytes = input.bytes;
        // Of a changed header, the bound is most of the time: filling a gigabyte with zeros.
        runtime::limit_pixels(one_in(5000, random) ? runtime::kMostPixels : kUsualPixels);
        write_file(path, bytes);
        const auto loaded = runtime::load_image(path);
        std::string wrong = wrong_with(loaded, path);
        const auto decoded = runtime::decode_image(path, bytes);
        if (wrong.empty()) wrong = wrong_with(decoded, path);
        runtime::stated_space(path);
        runtime::load_notes(path);
        if (const runtime::PictureKind* kind = runtime::picture_kind(bytes)) runtime::damage_of(*kind, bytes);
        return {.is_accepted = bool(loaded), .wrong = std::move(wrong)};
    };
    return {.make = make, .run = run};
}

Fuzzer png(const Setup& setup) {
    return pictures(setup, ".png");
}
Fuzzer jpeg(const Setup& setup) {
    return pictures(setup, ".jpg");
}
Fuzzer webp(const Setup& setup) {
    return pictures(setup, ".webp");
}
Fuzzer exr(const Setup& setup) {
    return pictures(setup, ".exr");
}
Fuzzer hdr(const Setup& setup) {
    return pictures(setup, ".hdr");
}
Fuzzer tiff(const Setup& setup) {
    return pictures(setup, ".tif");
}
Fuzzer tga(const Setup& setup) {
    return pictures(setup, ".tga");
}
Fuzzer bmp(const Setup& setup) {
    return pictures(setup, ".bmp");
}
Fuzzer gif(const Setup& setup) {
    return pictures(setup, ".gif");
}
Fuzzer dds(const Setup& setup) {
    return pictures(setup, ".dds", dds_seeds());
}
Fuzzer psd(const Setup& setup) {
    return pictures(setup, ".psd", psd_seeds());
}

// --- tables of reflectances, and prefiltered environments that another run has kept

Fuzzer tables(const Setup& setup) {
    const std::string path = (setup.scratch / "fuzz.binary").string();
    const auto brdf = [](const runtime::DirectionPair&) { return std::array<double, 3>{0.5, 0.25, 1}; };
    runtime::write_merl(path, runtime::sampled_table(brdf, 4, 4, 6));
    const std::string seed = read_file(path);
    const auto run = [path](const Input& input, Random&) -> Verdict {
        const std::string& bytes = input.bytes;
        write_file(path, bytes);
        const auto table = runtime::read_merl(path);
        if (table) runtime::as_texture(table.value);
        const bool says_where = bool(table) || table.error.find(path) != std::string::npos;
        return {.is_accepted = bool(table), .wrong = says_where ? "" : table.error};
    };
    return {.make = [seed](Random& random) { return Input{.bytes = changed_bytes(seed, seed, random)}; }, .run = run};
}

// Only a file whose numbers fit its fingerprint is taken, so nearly all that is changed must be refused.
Fuzzer kept_maps(const Setup& setup) {
    setenv("XDG_CACHE_HOME", setup.scratch.c_str(), 1);
    runtime::KeptEnvironment kept{.map = {.levels = {}, .sampler = {}, .layers = 6}};
    for (int level = 0; level < runtime::kEnvironmentLevels; ++level) {
        const int size = 1 << (runtime::kEnvironmentLevels - 1 - level);
        kept.map.levels.push_back({.width = size, .height = size, .texels = {}});
        kept.map.levels.back().texels.assign(std::size_t(24) * std::size_t(size) * std::size_t(size), 0.5f);
    }
    const std::string name = runtime::MapCache::name_of("a picture", 0);
    const fs::path path = setup.scratch / "patina" / (name + ".environment");
    fs::create_directories(path.parent_path());
    runtime::MapCache().write(name, kept);
    const std::string seed = read_file(path);
    const auto make = [seed](Random& random) {
        return Input{.bytes = one_in(50, random) ? seed : changed_bytes(seed, seed, random)};
    };
    const auto run = [name, path, seed](const Input& input, Random&) -> Verdict {
        const std::string& bytes = input.bytes;
        write_file(path, bytes);
        const bool is_taken = runtime::MapCache().read(name).has_value();
        return {.is_accepted = is_taken, .wrong = is_taken && bytes != seed ? "a changed file is taken" : ""};
    };
    return {.make = make, .run = run};
}

}  // namespace

std::vector<InputKind> picture_kinds() {
    return {{"png", "pictures: PNG, with checksums that fit", 300, png},
            {"jpeg", "pictures: JPEG", 300, jpeg},
            {"webp", "pictures: WebP", 300, webp},
            {"exr", "pictures: OpenEXR", 200, exr},
            {"hdr", "pictures: Radiance HDR", 300, hdr},
            {"tiff", "pictures: TIFF", 300, tiff},
            {"tga", "pictures: TGA", 300, tga},
            {"bmp", "pictures: BMP", 300, bmp},
            {"gif", "pictures: GIF", 300, gif},
            {"dds", "pictures: DDS", 300, dds},
            {"psd", "pictures: Photoshop", 300, psd},
            {"merl", "tables of reflectances", 300, tables},
            {"map", "prefiltered environments that are kept", 300, kept_maps}};
}

}  // namespace patina::fuzz
