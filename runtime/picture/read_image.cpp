// Pictures from files. A file is not trusted: it can be named as another kind, end too early, or claim more pixels than
// it has, or than fit into memory. Its bytes are read here, with their limit, and OpenImageIO decodes them in memory
// (open_picture.h).
#include <algorithm>
#include <cstdint>
#include <exception>
#include <new>

#include "compiler/base/disk/disk.h"
#include "runtime/files/files.h"
#include "runtime/picture/formats/picture_kind.h"
#include "runtime/picture/image.h"
#include "runtime/picture/open_picture.h"
#include "runtime/picture/picture_bounds.h"

namespace patina::runtime {
namespace {

Failure unreadable(const std::string& path, const std::string& why) {
    return {"cannot read '" + path + "' as an image: " + why};
}

std::string fault_of(const OIIO::ImageSpec& spec) {
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.deep || spec.nchannels < 1)
        return "it has no pixels, or is a volume";
    constexpr int kFarthest = 1 << 30;
    if (std::max(spec.x, spec.y) > kFarthest || std::min(spec.x, spec.y) < -kFarthest)
        return "its header places it far outside of any picture";
    const auto size = [](int number) { return static_cast<std::uint64_t>(std::max(number, 1)); };
    std::string fault = size_fault(size(spec.width), size(spec.height), size(spec.nchannels));
    // A tile is decoded as a whole, even if the picture is smaller.
    if (fault.empty() && spec.tile_width > 0 && spec.tile_height > 0 &&
        size(spec.tile_width) * size(spec.tile_height) > most_pixels())
        fault = "its tiles are larger than the largest picture";
    return fault;
}

// The rows are read as the file has them: OpenImageIO would convert them in a buffer of 64 MiB, for the smallest
// picture.
bool read_scanlines(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int begin, int end, int channels,
                    std::vector<float>& into) {
    if (!spec.channelformats.empty())
        return input.read_scanlines(0, 0, begin, end, 0, 0, channels, OIIO::TypeDesc::FLOAT, into.data());
    const std::size_t line = spec.scanline_bytes(true), pixel = spec.pixel_bytes(true);
    std::vector<char> native(line * static_cast<std::size_t>(end - begin));
    if (!input.read_native_scanlines(0, 0, begin, end, 0, native.data())) return false;
    const auto stride = [](std::size_t bytes) { return static_cast<OIIO::stride_t>(bytes); };
    const std::size_t out = sizeof(float) * static_cast<std::size_t>(channels);
    return OIIO::convert_image(channels, spec.width, end - begin, 1, native.data(), spec.format, stride(pixel),
                               stride(line), stride(native.size()), into.data(), OIIO::TypeDesc::FLOAT, stride(out),
                               stride(out * std::size_t(spec.width)), stride(sizeof(float) * into.size()));
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
                                    : read_scanlines(input, spec, begin, end, channels, read);
        if (!good) return false;
        for (auto p = read.begin(); p != read.end(); p += channels) {
            const bool grey = channels < 3;
            const float alpha = channels == 4 ? p[3] : channels == 2 ? p[1] : 1;
            image.pixels.insert(image.pixels.end(), {p[0], grey ? p[0] : p[1], grey ? p[0] : p[2], alpha});
        }
    }
    return true;
}

Outcome<Image> read_image(const std::string& path, OIIO::ImageInput& input) {
    const OIIO::ImageSpec spec = input.spec();
    if (const std::string fault = fault_of(spec); !fault.empty()) return unreadable(path, fault);
    Image image{.width = spec.width, .height = spec.height, .bits = int(spec.format.size() * 8), .pixels = {}};
    image.pixels.reserve(4 * std::size_t(spec.width) * std::size_t(spec.height));
    const int channels = std::clamp(spec.nchannels, 1, 4);
    if (!read_rows(input, spec, channels, image)) return unreadable(path, reason(input.geterror()));
    return image;
}

// `file`: where OpenImageIO may open the picture itself, if it must; empty: nowhere.
Outcome<Image> checked_image(const std::string& path, std::string_view bytes, const std::string& file) {
    try {
        MemoryReader memory(bytes);
        std::string why;
        const auto input = open_picture({.path = path, .bytes = bytes, .file = file}, memory, why);
        if (!input) return unreadable(path, why);
        return read_image(path, *input);
    } catch (const std::bad_alloc&) {
        return unreadable(path, "there is not enough memory for its pixels");
    } catch (const std::exception&) {
        // OpenImageIO asks for as much memory as a header says: std::length_error.
        return unreadable(path, "its header and its pixels do not fit together");
    }
}

// The bytes of a picture's file. Of a file that is named as another kind, only the first bytes: the wrong name is its
// error.
Outcome<std::string> bytes_of(const std::string& path) {
    constexpr std::size_t kFirst = 64;
    Outcome<std::string> start = read_start(path, kFirst);
    if (!start || start.value.size() < kFirst) return start;
    const PictureKind* const kind = picture_kind(start.value);
    if (kind && !kind->is_readable) return start;
    return read_file(path, most_picture_bytes());
}

}  // namespace

Outcome<Image> load_image(const std::string& path) {
    const Outcome<std::string> bytes = bytes_of(path);
    return bytes ? checked_image(path, bytes.value, without_links(path)) : Failure{bytes.error};
}

Outcome<Image> decode_image(const std::string& path, std::string_view bytes) {
    return checked_image(path, bytes, "");
}

PictureNotes load_notes(const std::string& path) {
    PictureNotes notes;
    const Outcome<std::string> bytes = bytes_of(path);
    if (!bytes) return notes;
    try {
        MemoryReader memory(bytes.value);
        std::string ignored;
        const auto input = open_picture({.path = path, .bytes = bytes.value}, memory, ignored);
        if (!input) return notes;
        for (const OIIO::ParamValue& each : input->spec().extra_attribs)
            if (each.type() == OIIO::TypeDesc::STRING) notes[each.name().string()] = each.get_string();
    } catch (const std::exception&) {
        return {};  // of a damaged header
    }
    return notes;
}

}  // namespace patina::runtime
