#include "runtime/picture/formats/picture_kind.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "compiler/base/letters.h"
#include "runtime/files/bytes.h"
#include "runtime/picture/formats/png_chunks.h"
#include "runtime/picture/formats/tiff_directory.h"

namespace patina::runtime {
namespace {

using namespace std::string_view_literals;

// The last chunk is IEND.
bool is_whole_png(std::string_view bytes) {
    std::optional<PngChunk> chunk = png_chunk(Bytes(bytes));
    while (chunk && chunk->name != "IEND") chunk = png_chunk(Bytes(bytes), chunk->end);
    return chunk.has_value();
}

constexpr std::array<std::uint32_t, 256> kCrc = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        table[i] = i;
        for (int bit = 0; bit < 8; ++bit) table[i] = table[i] >> 1 ^ (table[i] & 1 ? 0xedb88320 : 0);
    }
    return table;
}();

std::uint32_t crc_of(std::string_view bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const char byte : bytes) crc = kCrc[(crc ^ static_cast<unsigned char>(byte)) & 0xff] ^ crc >> 8;
    return ~crc;
}

// Of the chunks that a picture needs: their names begin with a capital.
bool is_intact_png(std::string_view bytes) {
    std::optional<PngChunk> chunk = png_chunk(Bytes(bytes));
    while (chunk) {
        const bool is_needed = (chunk->name[0] & 0x20) == 0;
        if (is_needed && crc_of(chunk->checked) != chunk->checksum) return false;
        if (chunk->name == "IEND") return true;
        chunk = png_chunk(Bytes(bytes), chunk->end);
    }
    return true;
}

// Segments with a length, up to the first that begins the picture; the mark of the end is after that. A preview inside
// of a segment has an end of its own.
bool is_whole_jpeg(std::string_view all) {
    const Bytes bytes(all);
    std::size_t at = 2;
    while (bytes.says(at, "\xff") && !bytes.says(at + 1, "\xda")) {
        if (bytes.says(at + 1, "\xff")) {
            ++at;  // padding
            continue;
        }
        const auto length = bytes.big_endian(at + 2, 2);
        if (!length) return false;
        at += 2 + static_cast<std::size_t>(*length);
    }
    return at < all.size() && all.find("\xff\xd9", at) != all.npos;
}

// The length does not count the first eight bytes.
bool is_whole_webp(std::string_view all) {
    const Bytes bytes(all);
    const auto length = bytes.little_endian(4, 4);
    return length && bytes.has(8, *length);
}

// Where its pieces of pixels begin, and how long they are. Decoders read missing pieces as black.
bool is_whole_tiff(std::string_view bytes) {
    constexpr std::pair<std::uint64_t, std::uint64_t> kPieces[] = {{273, 279}, {324, 325}};  // strips, tiles
    TiffDirectory directory(bytes);
    for (const auto& [begin, length] : kPieces) {
        const std::vector<std::uint64_t> begins = directory.values(begin), lengths = directory.values(length);
        for (std::size_t i = 0; i < begins.size() && i < lengths.size(); ++i)
            if (!directory.has(begins[i], lengths[i])) return false;
    }
    return directory.is_good();
}

constexpr std::array kPng = {".png"sv};
constexpr std::array kJpeg = {".jpg"sv, ".jpeg"sv, ".jpe"sv, ".jfif"sv};
constexpr std::array kWebp = {".webp"sv};
constexpr std::array kExr = {".exr"sv, ".sxr"sv, ".mxr"sv};
constexpr std::array kHdr = {".hdr"sv, ".rgbe"sv};
constexpr std::array kTiff = {".tif"sv, ".tiff"sv, ".tx"sv};
constexpr std::array kTga = {".tga"sv, ".tpic"sv};
constexpr std::array kBmp = {".bmp"sv, ".dib"sv};
constexpr std::array kGif = {".gif"sv};
constexpr std::array kPsd = {".psd"sv, ".psb"sv};
constexpr std::array kDds = {".dds"sv};
constexpr std::array kKtx2 = {".ktx2"sv};
constexpr std::array kKtx = {".ktx"sv};

struct FormatRow {
    PictureKind kind;
    std::string_view first;  // its first bytes; empty: they can be any
    std::string_view inner{};
    std::size_t inner_at = 0;  // where `inner` stands
};
constexpr FormatRow kRows[] = {
    {{"PNG", kPng, true, is_whole_png, is_intact_png}, kPngSignature},
    {{"JPEG", kJpeg, true, is_whole_jpeg}, "\xff\xd8\xff"sv},
    {{"WebP", kWebp, true, is_whole_webp}, "RIFF"sv, "WEBP"sv, 8},
    {{"OpenEXR", kExr}, "\x76\x2f\x31\x01"sv},
    {{"Radiance HDR", kHdr}, "#?"sv},
    {{"TIFF", kTiff, true, is_whole_tiff}, "II*\0"sv},
    {{"TIFF", kTiff, true, is_whole_tiff}, "MM\0*"sv},
    {{"TIFF", kTiff, true, is_whole_tiff}, "II+\0"sv},
    {{"TIFF", kTiff, true, is_whole_tiff}, "MM\0+"sv},
    {{"BMP", kBmp}, "BM"sv},
    {{"GIF", kGif}, "GIF8"sv},
    {{"Photoshop", kPsd}, "8BPS"sv},
    {{"DDS", kDds}, "DDS "sv},
    {{"KTX2", kKtx2, false}, "\xabKTX 20\xbb\r\n\x1a\n"sv},
    {{"KTX", kKtx, false}, "\xabKTX 11\xbb\r\n\x1a\n"sv},
    {{"TGA", kTga}, ""sv},
};

const FormatRow* row_named(const std::string& path) {
    const std::string ending = small_letters(std::filesystem::path(path).extension().string());
    const auto* const found = std::find_if(std::begin(kRows), std::end(kRows), [&](const FormatRow& row) {
        return std::find(row.kind.endings.begin(), row.kind.endings.end(), ending) != row.kind.endings.end();
    });
    return found == std::end(kRows) ? nullptr : found;
}

}  // namespace

const PictureKind* picture_kind(std::string_view bytes) {
    for (const FormatRow& row : kRows) {
        const bool has_inner = row.inner.empty() || (bytes.size() >= row.inner_at + row.inner.size() &&
                                                     bytes.substr(row.inner_at, row.inner.size()) == row.inner);
        if (!row.first.empty() && bytes.starts_with(row.first) && has_inner) return &row.kind;
    }
    return nullptr;
}

std::string_view damage_of(const PictureKind& kind, std::string_view bytes) {
    if (kind.is_whole && !kind.is_whole(bytes)) return "without its end";
    return !kind.is_intact || kind.is_intact(bytes) ? "" : "whose bytes are damaged: a checksum does not fit";
}

std::string picture_fault(const std::string& path, std::string_view bytes) {
    if (bytes.empty()) return "it has no bytes";
    const PictureKind* const kind = picture_kind(bytes);
    const FormatRow* const named = row_named(path);
    const std::string name(kind ? kind->name : named ? named->kind.name : "");
    const bool is_refused = kind ? !kind->is_readable : named && !named->kind.is_readable;
    if (is_refused)
        return "it is a " + name + " file, which is not supported: convert it to PNG, or to OpenEXR if it is HDR";
    if (!kind) return !named || named->first.empty() ? "" : "it is not a " + name + " file";
    if (named && named->kind.name != kind->name) {
        const std::filesystem::path right = std::filesystem::path(path).filename().replace_extension(kind->endings[0]);
        return "it is a " + name + " file: name it '" + right.string() + "'";
    }
    const std::string_view damage = damage_of(*kind, bytes);
    return damage.empty() ? "" : "it is a " + name + " file " + std::string(damage);
}

}  // namespace patina::runtime
