// The kind of a picture's file, from its bytes, and errors that are found before a pixel is decoded: a file that is
// named as another kind, or whose end is missing. It opens no file.
//
//   const PictureKind* kind = picture_kind(bytes);   // by the first bytes
//   picture_fault("rust.jpg", bytes);                // "it is a PNG file: name it 'rust.png'"
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace patina::runtime {

struct PictureKind {
    std::string_view name;                      // "PNG"
    std::span<const std::string_view> endings;  // ".png"; the usual one first
    bool is_readable = true;                    // OpenImageIO reads it
    // False if the file ends too early. Null: the decoder of the pixels finds that.
    bool (*is_whole)(std::string_view bytes) = nullptr;
    // False if a checksum of a whole file does not fit. Null: the file has no checksum, or the decoder of the pixels
    // finds that.
    bool (*is_intact)(std::string_view bytes) = nullptr;
};
// By the first bytes. Null: none that is known.
const PictureKind* picture_kind(std::string_view bytes);

// What is wrong with the bytes of a picture of this kind: "without its end", "whose bytes are damaged"; or nothing.
std::string_view damage_of(const PictureKind& kind, std::string_view bytes);

// Why the bytes cannot be a picture of this name, or nothing.
std::string picture_fault(const std::string& path, std::string_view bytes);

}  // namespace patina::runtime
