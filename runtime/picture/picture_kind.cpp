#include "runtime/picture/picture_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace patina::runtime {
namespace {

using namespace std::string_view_literals;

std::uint32_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint32_t made = 0;
    for (std::size_t i = 0; i < count; ++i) made = made << 8 | static_cast<unsigned char>(bytes[at + i]);
    return made;
}

// Chunks: length, name, data, checksum. The last one is IEND.
bool is_whole_png(std::string_view bytes) {
    constexpr std::size_t kHeader = 8;
    for (std::size_t at = kHeader; at + 12 <= bytes.size();) {
        if (bytes.substr(at + 4, 4) == "IEND") return true;
        const std::size_t length = big_endian(bytes, at, 4);
        if (length > bytes.size() - at - 12) return false;
        at += 12 + length;
    }
    return false;
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

// Of the chunks that a picture needs: their names begin with a capital. The checksum is of name and data (PNG
// specification, annex D).
bool is_intact_png(std::string_view bytes) {
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        const std::size_t length = big_endian(bytes, at, 4);
        const bool is_needed = (bytes[at + 4] & 0x20) == 0;
        if (is_needed && crc_of(bytes.substr(at + 4, length + 4)) != big_endian(bytes, at + 8 + length, 4))
            return false;
        if (bytes.substr(at + 4, 4) == "IEND") return true;
        at += 12 + length;
    }
    return true;
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

// The length is little-endian, and does not count the first eight bytes.
bool is_whole_webp(std::string_view bytes) {
    std::uint32_t length = 0;
    for (std::size_t i = 8; i-- > 4;) length = length << 8 | static_cast<unsigned char>(bytes[i]);
    return length <= bytes.size() - 8;
}

// The first directory of a TIFF lists where its pieces of pixels begin and how long they are. Those who decode them
// take what is missing as black.
class TiffDirectory {
public:
    explicit TiffDirectory(std::string_view bytes)
        : bytes_(bytes), is_big_endian_(bytes[0] == 'M'), is_large_(number(2, 2) == kLarge) {}

    bool has_all_pieces() {
        const std::uint64_t at = is_large_ ? number(8, 8) : number(4, 4);
        const std::uint64_t count = number(at, is_large_ ? 8 : 2), size = is_large_ ? 20 : 12;
        std::vector<std::uint64_t> begins, lengths;
        for (std::uint64_t i = 0; is_good_ && i < count; ++i) {
            const std::uint64_t entry = at + (is_large_ ? 8 : 2) + i * size, tag = number(entry, 2);
            if (tag == kStripOffsets || tag == kTileOffsets) begins = values(entry);
            if (tag == kStripLengths || tag == kTileLengths) lengths = values(entry);
        }
        for (std::size_t i = 0; i < begins.size() && i < lengths.size(); ++i)
            is_good_ = is_good_ && has(begins[i], lengths[i]);
        return is_good_;
    }

private:
    static constexpr std::uint64_t kLarge = 43, kStripOffsets = 273, kStripLengths = 279, kTileOffsets = 324,
                                   kTileLengths = 325;

    bool has(std::uint64_t at, std::uint64_t count) const {
        return count <= bytes_.size() && at <= bytes_.size() - count;
    }

    std::uint64_t number(std::uint64_t at, std::uint64_t size) {
        std::uint64_t made = 0;
        is_good_ = is_good_ && has(at, size);
        for (std::uint64_t i = 0; is_good_ && i < size; ++i)
            made = made << 8 | static_cast<unsigned char>(bytes_[at + (is_big_endian_ ? i : size - 1 - i)]);
        return made;
    }

    // In the entry itself if there is room.
    std::vector<std::uint64_t> values(std::uint64_t entry) {
        constexpr std::uint64_t kShort = 3, kLong = 16;
        const std::uint64_t type = number(entry + 2, 2), size = type == kShort ? 2 : type == kLong ? 8 : 4;
        const std::uint64_t word = is_large_ ? 8 : 4, count = number(entry + 4, word);
        is_good_ = is_good_ && count <= bytes_.size();
        const std::uint64_t inside = entry + 4 + word,
                            at = is_good_ && count * size > word ? number(inside, word) : inside;
        std::vector<std::uint64_t> made;
        for (std::uint64_t i = 0; is_good_ && i < count; ++i) made.push_back(number(at + i * size, size));
        return made;
    }

    std::string_view bytes_;
    bool is_good_ = true;  // false: something lies behind the end of the file
    bool is_big_endian_, is_large_;
};

bool is_whole_tiff(std::string_view bytes) {
    return TiffDirectory(bytes).has_all_pieces();
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

struct Row {
    PictureKind kind;
    std::string_view first;  // its first bytes; empty: they can be any
    std::string_view inner{};
    std::size_t inner_at = 0;  // where `inner` stands
};
constexpr Row kRows[] = {
    {{"PNG", kPng, true, is_whole_png, is_intact_png}, "\x89PNG\r\n\x1a\n"sv},
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

const Row* row_named(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const auto* const found = std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& row) {
        return std::find(row.kind.endings.begin(), row.kind.endings.end(), ending) != row.kind.endings.end();
    });
    return found == std::end(kRows) ? nullptr : found;
}

}  // namespace

const PictureKind* picture_kind(std::string_view bytes) {
    for (const Row& row : kRows) {
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
    const Row* const named = row_named(path);
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
