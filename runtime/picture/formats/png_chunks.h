// The chunks of a PNG: length, name, data, checksum (PNG specification, section 5.3).
//
//   for (auto chunk = png_chunk(bytes); chunk; chunk = png_chunk(bytes, chunk->end)) use(chunk->name, chunk->data());
#pragma once

#include <optional>

#include "runtime/files/bytes.h"

namespace patina::runtime {

inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

struct PngChunk {
    std::string_view name{};
    std::string_view checked{};  // what the checksum is of: the name and the data
    std::uint64_t checksum = 0;
    std::size_t end = 0;  // where the next one begins

    std::string_view data() const { return checked.substr(name.size()); }
};

// None if it is not whole in the file. The first one is behind the signature.
inline std::optional<PngChunk> png_chunk(const Bytes& bytes, std::size_t at = kPngSignature.size()) {
    const auto length = bytes.big_endian(at, 4);
    const auto checked = length ? bytes.part(at + 4, *length + 4) : std::nullopt;
    const auto checksum = checked ? bytes.big_endian(at + 4 + checked->size(), 4) : std::nullopt;
    if (!checksum) return std::nullopt;
    return PngChunk{
        .name = checked->substr(0, 4), .checked = *checked, .checksum = *checksum, .end = at + 8 + checked->size()};
}

}  // namespace patina::runtime
