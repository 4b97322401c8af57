#include "runtime/picture/formats/stated_space.h"

#include <cmath>
#include <exception>
#include <map>

#include "compiler/base/disk/disk.h"
#include "compiler/base/letters.h"
#include "runtime/files/files.h"
#include "runtime/picture/formats/png_chunks.h"
#include "runtime/picture/open_picture.h"
#include "runtime/picture/picture_bounds.h"

namespace patina::runtime {
namespace {

StatedSpace of_profile(const OIIO::ImageSpec& spec) {
    const std::string description =
        small_letters(std::string(spec.get_string_attribute("ICCProfile:profile_description")));
    const std::string by = "its ICC profile";
    if (description.find("linear") != std::string::npos) return {ColorSpace::Linear, by};
    if (description.find("srgb") != std::string::npos) return {ColorSpace::Srgb, by};
    return {};
}

// The chunks that set a colour space, which come before the pixels; none if the bytes are no PNG.
std::map<std::string_view, std::string_view> chunks_of(std::string_view bytes) {
    std::map<std::string_view, std::string_view> chunks;
    if (!bytes.starts_with(kPngSignature)) return chunks;
    const Bytes all(bytes);
    for (auto chunk = png_chunk(all); chunk && chunk->name != "IDAT"; chunk = png_chunk(all, chunk->end))
        chunks[chunk->name] = chunk->data();
    return chunks;
}

StatedSpace of_cicp(std::string_view chunk) {
    constexpr char kLinear = 8, kSrgb = 13;  // transfer characteristics of ITU-T H.273
    const char transfer = chunk.size() == 4 ? chunk[1] : '\0';
    if (transfer == kLinear) return {ColorSpace::Linear, "its cICP chunk"};
    return transfer == kSrgb ? StatedSpace{ColorSpace::Srgb, "its cICP chunk"} : StatedSpace{};
}

// 100000 times the exponent of the file: 45455 is 1 / 2.2, which stands for sRGB.
StatedSpace of_gama(std::string_view chunk) {
    const std::uint64_t gamma = Bytes(chunk).big_endian(0, 4).value_or(0);
    if (gamma == 100000) return {ColorSpace::Linear, "its gAMA chunk"};
    return std::abs(double(gamma) - 45455) < 100 ? StatedSpace{ColorSpace::Srgb, "its gAMA chunk"} : StatedSpace{};
}

StatedSpace of_chunks(const std::map<std::string_view, std::string_view>& chunks, const OIIO::ImageSpec& spec) {
    if (const auto cicp = chunks.find("cICP"); cicp != chunks.end()) return of_cicp(cicp->second);
    if (chunks.contains("iCCP")) return of_profile(spec);
    if (chunks.contains("sRGB")) return {ColorSpace::Srgb, "its sRGB chunk"};
    const auto gama = chunks.find("gAMA");
    return gama == chunks.end() ? StatedSpace{} : of_gama(gama->second);
}

StatedSpace stated_in(const std::string& path) {
    const Outcome<std::string> file = read_file(path, most_picture_bytes());
    if (!file) return {};
    const std::string_view bytes = file.value;
    MemoryReader memory(bytes);
    std::string ignored;
    const auto input = open_picture({.path = path, .bytes = bytes, .file = without_links(path)}, memory, ignored);
    if (!input) return {};
    const OIIO::ImageSpec spec = input->spec();
    if (const auto chunks = chunks_of(bytes); !chunks.empty()) return of_chunks(chunks, spec);
    if (const StatedSpace stated = of_profile(spec); stated.space != ColorSpace::None) return stated;
    constexpr int kExifSrgb = 1;
    if (spec.get_int_attribute("Exif:ColorSpace") == kExifSrgb) return {ColorSpace::Srgb, "its Exif data"};
    return {};
}

}  // namespace

StatedSpace stated_space(const std::string& path) {
    try {
        return stated_in(path);
    } catch (const std::exception&) {
        return {};  // OpenImageIO throws for some damaged headers
    }
}

}  // namespace patina::runtime
