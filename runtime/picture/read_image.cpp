// Pictures from files. A file is not trusted: it can be named as another kind, end too early, or claim more pixels than
// it has, or than fit into memory.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>

#include "runtime/files/files.h"
#include "runtime/picture/image.h"
#include "runtime/picture/openimageio.h"
#include "runtime/picture/picture_kind.h"

namespace patina::runtime {
namespace {

// As floats, a picture of so many takes 2 GiB.
constexpr std::size_t kMostPixels = std::size_t(kLargestImage) * kLargestImage / 2;
constexpr std::uintmax_t kMostBytes = std::uintmax_t(1) << 32;  // of a file

Failure unreadable(const std::string& path, const std::string& why) {
    return {"cannot read '" + path + "' as an image: " + why};
}

std::string size_fault(const OIIO::ImageSpec& spec) {
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1) return "it has no pixels, or is a volume";
    const std::string size = "it is " + std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels";
    if (spec.width > kLargestImage || spec.height > kLargestImage)
        return size + ", and the limit is " + std::to_string(kLargestImage) + " on a side";
    if (std::size_t(spec.width) * std::size_t(spec.height) > kMostPixels)
        return size + ", and the limit is " + std::to_string(kMostPixels) + " in all";
    return "";
}

// Some rows at a time: a file that claims many more pixels than it has fails before they take memory.
bool read_rows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int channels, Image& image) {
    constexpr int kRows = 256;
    const bool has_tiles = spec.tile_width > 0 && spec.tile_height > 0;
    const int step = has_tiles ? std::max(1, kRows / spec.tile_height) * spec.tile_height : kRows;
    std::vector<float> read;
    for (int y = 0; y < spec.height; y += step) {
        const int rows = std::min(step, spec.height - y), begin = spec.y + y, end = begin + rows;
        read.resize(std::size_t(spec.width) * std::size_t(rows) * std::size_t(channels));
        const auto as = OIIO::TypeDesc::FLOAT;
        const bool good = has_tiles ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, begin, end, 0, 1, 0, channels,
                                                       as, read.data())
                                    : input.read_scanlines(0, 0, begin, end, 0, 0, channels, as, read.data());
        if (!good) return false;
        for (auto p = read.begin(); p != read.end(); p += channels) {
            const bool grey = channels < 3;
            const float alpha = channels == 4 ? p[3] : channels == 2 ? p[1] : 1;
            image.pixels.insert(image.pixels.end(), {p[0], grey ? p[0] : p[1], grey ? p[0] : p[2], alpha});
        }
    }
    return true;
}

Outcome<Image> read_image(const std::string& path, OIIO::Filesystem::IOProxy* bytes) {
    OIIO::ImageSpec straight;
    straight.attribute("oiio:UnassociatedAlpha", 1);  // a texture's alpha is data: keep the colours under it
    if (bytes) straight.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &bytes);
    auto input = OIIO::ImageInput::open(path, &straight);
    if (!input) return unreadable(path, reason(OIIO::geterror()));
    const OIIO::ImageSpec spec = input->spec();
    if (const std::string fault = size_fault(spec); !fault.empty()) return unreadable(path, fault);
    Image image{.width = spec.width, .height = spec.height, .bits = int(spec.format.size() * 8), .pixels = {}};
    image.pixels.reserve(4 * std::size_t(spec.width) * std::size_t(spec.height));
    const int channels = std::clamp(spec.nchannels, 1, 4);
    if (!read_rows(*input, spec, channels, image)) return unreadable(path, reason(input->geterror()));
    return image;
}

Outcome<Image> checked_image(const std::string& path, std::string_view bytes, OIIO::Filesystem::IOProxy* proxy) {
    if (const std::string fault = picture_fault(path, bytes); !fault.empty()) return unreadable(path, fault);
    try {
        return read_image(path, proxy);
    } catch (const std::bad_alloc&) {
        return unreadable(path, "there is not enough memory for its pixels");
    } catch (const std::exception&) {
        // OpenImageIO asks for as much memory as a header says: std::length_error.
        return unreadable(path, "its header and its pixels do not fit together");
    }
}

// The bytes of a file; of a large one that needs no check of its end, only the first.
std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    constexpr std::size_t kFirst = 64;
    std::string bytes(kFirst, '\0');
    file.read(bytes.data(), std::streamsize(kFirst));
    bytes.resize(std::size_t(file.gcount()));
    const PictureKind* const kind = picture_kind(bytes);
    if (kind && kind->is_whole && file) bytes.append(std::istreambuf_iterator<char>(file), {});
    return bytes;
}

}  // namespace

Outcome<Image> load_image(const std::string& path) {
    std::error_code ignored;
    if (std::string error = no_file(path); !error.empty()) return Failure{std::move(error)};
    if (std::filesystem::file_size(path, ignored) > kMostBytes) return unreadable(path, "it is larger than 4 GiB");
    if (!std::ifstream(path, std::ios::binary)) return Failure{"cannot read '" + path + "': it cannot be opened"};
    return checked_image(path, bytes_of(path), nullptr);
}

Outcome<Image> decode_image(const std::string& path, std::string_view bytes) {
    MemoryReader reader(bytes);
    return checked_image(path, bytes, &reader);
}

PictureNotes load_notes(const std::string& path) {
    PictureNotes notes;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return notes;
    try {
        const auto input = OIIO::ImageInput::open(path);
        if (!input) {
            OIIO::geterror();  // or it would be the next file's
            return notes;
        }
        for (const OIIO::ParamValue& each : input->spec().extra_attribs)
            if (each.type() == OIIO::TypeDesc::STRING) notes[each.name().string()] = each.get_string();
    } catch (const std::exception&) {
        return {};  // of a damaged header
    }
    return notes;
}

}  // namespace patina::runtime
