#include "runtime/lighting/map_cache.h"

#include <OpenImageIO/hash.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include "compiler/base/disk/disk.h"
#include "runtime/files/files.h"
#include "runtime/lighting/prefilter.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

// Changes whenever the same picture would give other numbers.
constexpr std::uint32_t kVersion = 3;
constexpr std::string_view kEnding = ".environment";

// A file: this, then `count` floats: the coefficients, and red, green and blue of each texel, level by level.
struct Header {
    char magic[8] = {'p', 'a', 't', 'i', 'n', 'a', 'E', 'N'};
    std::uint32_t version = kVersion, face_size = 0;
    std::uint64_t fingerprint = 0;  // of the floats
};
static_assert(sizeof(Header) == 24);

constexpr std::size_t kAmbientNumbers = 27;
constexpr std::uint32_t kSmallestFace = 1u << (kEnvironmentLevels - 1), kLargestFace = 4096;

std::size_t level_numbers(std::uint32_t face_size, int level) {
    const std::size_t size = face_size >> level;
    return 18 * size * size;
}

std::size_t count_of(std::uint32_t face_size) {
    std::size_t count = kAmbientNumbers;
    for (int level = 0; level < kEnvironmentLevels; level++) count += level_numbers(face_size, level);
    return count;
}

std::string_view bytes_of(const std::vector<float>& numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float)};
}

std::uint64_t fingerprint(std::string_view bytes) {
    return OIIO::farmhash::Fingerprint64(bytes.data(), bytes.size());
}

// The XDG Base Directory Specification: a relative path is ignored.
std::string cache_folder() {
    const char* said = std::getenv("XDG_CACHE_HOME");
    if (said && fs::path(said).is_absolute()) return (fs::path(said) / "patina").string();
    const char* home = std::getenv("HOME");
    return home && fs::path(home).is_absolute() ? (fs::path(home) / ".cache" / "patina").string() : "";
}

KeptEnvironment unpacked(const std::vector<float>& numbers, std::uint32_t face_size) {
    KeptEnvironment kept{.map = {.levels = {}, .sampler = {.wrap = Wrap::Clamp}, .layers = 6}};
    const float* from = numbers.data();
    for (glm::vec3& coefficient : kept.ambient.coefficients) {
        coefficient = {from[0], from[1], from[2]};
        from += 3;
    }
    for (int level = 0; level < kEnvironmentLevels; level++) {
        const int size = int(face_size >> level);
        TextureLevel& made = kept.map.levels.emplace_back(TextureLevel{.width = size, .height = size, .texels = {}});
        made.texels.resize(level_numbers(face_size, level) / 3 * 4);
        for (std::size_t i = 0; i < made.texels.size(); i += 4, from += 3) {
            std::copy(from, from + 3, made.texels.begin() + std::ptrdiff_t(i));
            made.texels[i + 3] = 1;
        }
    }
    return kept;
}

std::vector<float> packed(const KeptEnvironment& environment) {
    std::vector<float> numbers;
    numbers.reserve(count_of(std::uint32_t(environment.map.levels.front().width)));
    for (const glm::vec3& c : environment.ambient.coefficients) numbers.insert(numbers.end(), {c.r, c.g, c.b});
    for (const TextureLevel& level : environment.map.levels) {
        for (std::size_t i = 0; i < level.texels.size(); i += 4) {
            const float* texel = level.texels.data() + i;
            numbers.insert(numbers.end(), texel, texel + 3);
        }
    }
    return numbers;
}

void remove_oldest(const std::string& folder) {
    std::error_code ignored;
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().extension() == kEnding) files.emplace_back(entry.last_write_time(ignored), entry.path());
    std::sort(files.begin(), files.end());
    for (std::size_t i = 0; i + MapCache::kMostKept < files.size(); i++) fs::remove(files[i].second, ignored);
}

}  // namespace

MapCache::MapCache() : folder_(cache_folder()) {}

std::string MapCache::path_of(const std::string& name) const {
    return (fs::path(folder_) / (name + std::string(kEnding))).string();
}

std::string MapCache::name_of(std::string_view picture, double rotation) {
    const auto made = OIIO::farmhash::Fingerprint128(picture.data(), picture.size());
    return fmt::format("{:016x}{:016x}-{:016x}", made.first, made.second,
                       std::bit_cast<std::uint64_t>(rotation == 0 ? 0.0 : rotation));
}

std::optional<KeptEnvironment> MapCache::read(const std::string& name) const {
    if (folder_.empty()) return std::nullopt;
    const std::string path = path_of(name);
    // The cache is the program's own, wherever graphs may read.
    const DiskFile start = read_beginning(path, sizeof(Header), anywhere());
    Header header;
    if (!start.bytes || start.bytes->size() != sizeof header) return std::nullopt;
    std::memcpy(&header, start.bytes->data(), sizeof header);
    const bool is_known = std::memcmp(header.magic, Header{}.magic, sizeof header.magic) == 0 &&
                          header.version == kVersion && header.face_size >= kSmallestFace &&
                          header.face_size <= kLargestFace && std::has_single_bit(header.face_size);
    if (!is_known) return std::nullopt;
    const std::size_t count = count_of(header.face_size), size = sizeof header + count * sizeof(float);
    if (start.size != size) return std::nullopt;
    const DiskFile file = read_disk(path, size, anywhere());
    if (!file.bytes || file.bytes->size() != size) return std::nullopt;
    std::vector<float> numbers(count);
    std::memcpy(numbers.data(), file.bytes->data() + sizeof header, count * sizeof(float));
    if (fingerprint(bytes_of(numbers)) != header.fingerprint) return std::nullopt;
    return unpacked(numbers, header.face_size);
}

void MapCache::write(const std::string& name, const KeptEnvironment& environment) const {
    if (folder_.empty()) return;
    const std::vector<float> numbers = packed(environment);
    Header header;
    header.face_size = std::uint32_t(environment.map.levels.front().width);
    header.fingerprint = fingerprint(bytes_of(numbers));
    std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
    bytes += bytes_of(numbers);
    if (write_file(path_of(name), std::move(bytes), anywhere()).empty()) remove_oldest(folder_);
}

}  // namespace patina::runtime
