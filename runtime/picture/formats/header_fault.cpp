#include "runtime/picture/formats/header_fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "runtime/files/bytes.h"
#include "runtime/picture/formats/tiff_directory.h"
#include "runtime/picture/picture_bounds.h"

namespace patina::runtime {
namespace {

using namespace std::string_view_literals;

constexpr const char* kMoreThanThere = "it is cut off, or its header is damaged: it claims more bytes than it has";

// --- OpenEXR: "OpenEXR File Layout", headers of attributes: name, type, size, value.

struct ExrPart {
    std::int64_t width = 0, height = 0;
    std::uint64_t channels = 0, tile_width = 0, tile_height = 0, chunks = 0;
    unsigned char compression = 0;
    bool is_deep = false;
};

std::int64_t whole(ByteStream& from) {
    return static_cast<std::int32_t>(from.little(4));
}

std::uint64_t channels_of(std::string_view list) {
    std::uint64_t count = 0;
    for (ByteStream from(list); from.is_good(); ++count) {
        if (from.word().empty()) break;
        from.take(16);  // type, linearity, sampling
    }
    return count;
}

// False: the headers are at their end.
bool read_part(ByteStream& from, ExrPart& part) {
    bool has_any = false;
    for (;;) {
        const std::string_view name = from.word();
        if (name.empty() || !from.is_good()) return has_any && from.is_good();
        has_any = true;
        from.word();
        const std::size_t size = from.little(4);
        const std::string_view value = from.take(size);
        ByteStream in(value);
        if (name == "dataWindow") {
            const std::int64_t left = whole(in), top = whole(in), right = whole(in), bottom = whole(in);
            part.width = right - left + 1;
            part.height = bottom - top + 1;
        } else if (name == "channels") {
            part.channels = channels_of(value);
        } else if (name == "compression") {
            part.compression = static_cast<unsigned char>(in.little(1));
        } else if (name == "tiles") {
            part.tile_width = in.little(4);
            part.tile_height = in.little(4);
        } else if (name == "chunkCount") {
            part.chunks = in.little(4);
        } else if (name == "type") {
            part.is_deep = value.starts_with("deep");
        }
    }
}

// Rows that are compressed together: none, RLE, ZIPS; ZIP; PIZ, PXR24, B44, B44A, DWAA; DWAB.
std::uint64_t rows_of_chunk(unsigned char compression) {
    constexpr std::uint64_t kRows[] = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
    return compression < std::size(kRows) ? kRows[compression] : 256;
}

std::string exr_fault(std::string_view bytes) {
    // OpenEXR keeps two chunks for each core.
    constexpr std::uint64_t kMostChunk = std::uint64_t{64} << 20, kBytesOfOffset = 8, kBytesOfNumber = 4;
    constexpr unsigned kManyParts = 0x1000;
    ByteStream from(bytes.substr(4));
    const bool has_parts = (from.little(4) & kManyParts) != 0;
    std::uint64_t chunks = 0;
    for (ExrPart part; read_part(from, part); part = {}) {
        if (part.is_deep) return "it is a deep picture, which has no single value for a pixel";
        if (part.width < 1 || part.height < 1) return "its header has no size";
        const auto width = static_cast<std::uint64_t>(part.width), height = static_cast<std::uint64_t>(part.height);
        if (std::string fault = size_fault(width, height, part.channels); !fault.empty()) return fault;
        const std::uint64_t tile_width = part.tile_width, tile_height = part.tile_height;
        const bool has_tiles = tile_width > 0 && tile_height > 0;
        const std::uint64_t rows = rows_of_chunk(part.compression);
        const std::uint64_t chunk = has_tiles ? tile_width * std::min(tile_height, kMostChunk) : width * rows;
        if (tile_width > kMostChunk || chunk > kMostChunk / kBytesOfNumber / std::max<std::uint64_t>(part.channels, 1))
            return fmt::format("its pieces have more than {} MiB each", kMostChunk >> 20);
        chunks += std::max(part.chunks, has_tiles ? ((width - 1) / tile_width + 1) * ((height - 1) / tile_height + 1)
                                                  : (height - 1) / rows + 1);
        if (chunks > bytes.size() / kBytesOfOffset)
            return "it is cut off, or its header is damaged: it claims more pieces than it has";
        if (!has_parts) break;
    }
    // OpenEXR takes as much memory for an attribute as its header says.
    return from.is_good() ? "" : kMoreThanThere;
}

// --- WebP: RFC 9649, sections 2.5 to 2.7.

std::string webp_fault(std::string_view bytes) {
    ByteStream from(bytes.substr(12));
    const std::string_view kind = from.take(4);
    from.take(4);
    if (kind == "VP8X") {
        from.take(4);
        const std::uint64_t width = from.little(3) + 1, height = from.little(3) + 1;
        return from.is_good() ? size_fault(width, height, 4) : std::string();
    }
    if (kind == "VP8L") {
        from.take(1);
        const std::uint64_t sizes = from.little(4);
        return size_fault((sizes & 0x3fff) + 1, (sizes >> 14 & 0x3fff) + 1, 4);
    }
    from.take(6);
    const std::uint64_t width = from.little(2) & 0x3fff, height = from.little(2) & 0x3fff;
    return from.is_good() ? size_fault(width, height, 4) : std::string();
}

// --- JPEG 2000: ISO 15444-1, the marker SIZ behind that of the beginning.

std::string jpeg2000_fault(std::string_view bytes) {
    const std::size_t at = bytes.find("\xff\x4f\xff\x51");
    if (at == bytes.npos) return {};
    ByteStream from(bytes.substr(at + 4));
    from.take(4);
    const std::uint64_t right = from.big(4), bottom = from.big(4), left = from.big(4), top = from.big(4);
    from.take(16);
    const std::uint64_t channels = from.big(2);
    if (!from.is_good() || right <= left || bottom <= top) return "its header has no size";
    return size_fault(right - left, bottom - top, channels);
}

// --- DirectDraw surfaces: the bits of each channel. OpenImageIO 2.4 widens a channel until it has 8 bits, which never
// ends if it has none.

std::string dds_fault(std::string_view all) {
    constexpr std::uint64_t kAlpha = 1, kColors = 0x40;  // DDPF_ALPHAPIXELS, DDPF_RGB
    const Bytes bytes(all);
    const auto flags = bytes.little_endian(80, 4);
    if (!flags || (*flags & kColors) == 0) return {};
    for (const std::uint64_t at : {92, 96, 100, 104}) {
        const auto mask = bytes.little_endian(at, 4);
        const bool is_read = at != 104 || (*flags & kAlpha) != 0;
        if (is_read && mask && *mask == 0) return "its header has a channel without bits";
    }
    return {};
}

// --- GIF: "Graphics Interchange Format, Version 89a", section 18. OpenImageIO opens a canvas of this size.

std::string gif_fault(std::string_view bytes) {
    ByteStream from(bytes);
    from.take(6);
    const std::uint64_t width = from.little(2), height = from.little(2);
    return size_fault(width, height, 4);
}

// --- Photoshop: "Adobe Photoshop File Formats Specification", the header and the sections behind it, each with its
// length.

// The blocks of the section of resources.
bool has_all_resources(std::string_view section) {
    ByteStream from(section);
    for (std::uint64_t at = 0; from.is_good() && at < section.size();) {
        from.take(6);                                // "8BIM" and a number
        const std::uint64_t name = from.big(1) | 1;  // with its length it has an even number of bytes
        from.take(name);
        const std::uint64_t size = from.big(4), padded = size + size % 2;
        from.take(padded);
        at += 11 + name + padded;
    }
    return from.is_good();
}

std::string psd_fault(std::string_view bytes) {
    constexpr std::uint64_t kLarge = 2;                                    // the version of .psb
    constexpr std::uint64_t kChannels[] = {1, 1, 1, 3, 4, 1, 1, 1, 1, 3};  // that a mode needs: RGB is 3, CMYK is 4
    ByteStream from(bytes.substr(4));
    const std::uint64_t version = from.big(2);
    from.take(6);
    const std::uint64_t channels = from.big(2), height = from.big(4), width = from.big(4);
    from.take(2);
    const std::uint64_t mode = from.big(2);
    from.take(from.big(4));  // colours of a palette
    const std::string_view resources = from.take(from.big(4));
    from.take(from.big(version == kLarge ? 8 : 4));  // layers
    if (!from.is_good() || !has_all_resources(resources)) return kMoreThanThere;
    if (channels < (mode < std::size(kChannels) ? kChannels[mode] : 1))
        return "its header has fewer channels than its colours need";
    return size_fault(width, height, channels);
}

// --- IPTC data in JPEG and TIFF: "IPTC-NAA Information Interchange Model", part I, section 1.6. OpenImageIO 2.4 reads
// as many bytes as they state, also behind their end.

bool is_whole_iptc(std::string_view data) {
    ByteStream from(data);
    for (std::size_t at = 0; from.is_good() && at < data.size() && from.take(1) == "\x1c";) {
        const std::uint64_t record = from.big(1);
        if (record != 1 && record != 2) break;
        from.take(1);
        const std::uint64_t size = from.big(2);
        from.take(size);
        at += 5 + size;
    }
    return from.is_good();
}

constexpr const char* kDamagedIptc = "its IPTC data are damaged: they claim more bytes than they have";

// In segments APP13, which begin with the name of Photoshop and the number 1028 of the resource. Libraries find them
// also behind bytes that belong to no segment.
std::string jpeg_fault(std::string_view bytes) {
    constexpr std::string_view kStart = "Photoshop 3.0\0008BIM\4\4"sv, kApp13 = "\xff\xed"sv;
    constexpr std::size_t kMark = 4;  // the mark and the length of the segment, before its data
    for (std::size_t at = bytes.find(kStart); at != bytes.npos; at = bytes.find(kStart, at + 1)) {
        if (at < kMark || bytes.substr(at - kMark, 2) != kApp13) continue;
        const std::uint64_t length = Bytes(bytes).big_endian(at - 2, 2).value_or(2);
        ByteStream from(bytes.substr(at, std::max<std::uint64_t>(length, 2) - 2));
        from.take(kStart.size() + 4);  // four zeros behind the number
        const std::string_view data = from.take(from.big(2));
        if (!from.is_good() || !is_whole_iptc(data)) return kDamagedIptc;
    }
    return {};
}

std::string tiff_fault(std::string_view bytes) {
    constexpr std::uint64_t kIptc = 33723;
    TiffDirectory directory(bytes);
    return is_whole_iptc(directory.bytes_of(kIptc)) ? "" : kDamagedIptc;
}

}  // namespace

std::string header_fault(std::string_view bytes) {
    if (bytes.starts_with("DDS ")) return dds_fault(bytes);
    if (bytes.starts_with("GIF8")) return gif_fault(bytes);
    if (bytes.starts_with("8BPS")) return psd_fault(bytes);
    if (bytes.starts_with("\xff\xd8\xff")) return jpeg_fault(bytes);
    if (bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv) || bytes.starts_with("II+\0"sv) ||
        bytes.starts_with("MM\0+"sv))
        return tiff_fault(bytes);
    if (bytes.starts_with("\x76\x2f\x31\x01"sv)) return exr_fault(bytes);
    if (bytes.starts_with("RIFF") && bytes.size() > 12 && bytes.substr(8, 4) == "WEBP") return webp_fault(bytes);
    const bool is_jpeg2000 = bytes.starts_with("\xff\x4f\xff\x51") || bytes.starts_with("\0\0\0\x0cjP  "sv);
    return is_jpeg2000 ? jpeg2000_fault(bytes) : std::string();
}

}  // namespace patina::runtime
