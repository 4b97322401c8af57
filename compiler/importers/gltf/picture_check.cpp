#include "compiler/importers/gltf/picture_check.h"

#include <cstdint>

namespace patina::importers::gltf {
namespace {

constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kJpeg = "\xff\xd8\xff";

std::uint32_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint32_t made = 0;
    for (std::size_t i = 0; i < count; ++i) made = made << 8 | static_cast<unsigned char>(bytes[at + i]);
    return made;
}

// Chunks: length, name, data, checksum. The last one is IEND.
bool is_whole_png(std::string_view bytes) {
    for (std::size_t at = kPng.size(); at + 12 <= bytes.size();) {
        if (bytes.substr(at + 4, 4) == "IEND") return true;
        const std::size_t length = big_endian(bytes, at, 4);
        if (length > bytes.size() - at - 12) return false;
        at += 12 + length;
    }
    return false;
}

// Segments with a length, up to the first that begins the picture; the mark of the end is after that. A preview inside
// of a segment has an end of its own.
bool is_whole_jpeg(std::string_view bytes) {
    std::size_t at = 2;
    while (at + 4 <= bytes.size() && bytes[at] == '\xff' && bytes[at + 1] != '\xda') {
        if (bytes[at + 1] == '\xff') {
            ++at;  // padding
            continue;
        }
        at += 2 + big_endian(bytes, at + 2, 2);
    }
    return at < bytes.size() && bytes.find("\xff\xd9", at) != bytes.npos;
}

}  // namespace

PictureKind check_picture(std::string_view bytes) {
    if (bytes.starts_with(kPng))
        return is_whole_png(bytes) ? PictureKind{.ending = ".png"}
                                   : PictureKind{.error = "is a PNG file without its end"};
    if (bytes.starts_with(kJpeg))
        return is_whole_jpeg(bytes) ? PictureKind{.ending = ".jpg"}
                                    : PictureKind{.error = "is a JPEG file without its end"};
    if (bytes.size() >= 12 && bytes.starts_with("RIFF") && bytes.substr(8, 4) == "WEBP") {
        // The length is little-endian, and does not count the first eight bytes.
        const std::uint32_t length = static_cast<unsigned char>(bytes[4]) | static_cast<unsigned char>(bytes[5]) << 8 |
                                     static_cast<unsigned char>(bytes[6]) << 16 |
                                     static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[7])) << 24;
        return length <= bytes.size() - 8 ? PictureKind{.ending = ".webp"}
                                          : PictureKind{.error = "is a WebP file without its end"};
    }
    return {.error = bytes.empty() ? "has no bytes" : "is neither a PNG nor a JPEG file: convert it"};
}

}  // namespace patina::importers::gltf
