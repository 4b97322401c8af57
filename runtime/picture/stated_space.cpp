#include "runtime/picture/stated_space.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <exception>
#include <fstream>
#include <map>

namespace patina::runtime {
namespace {

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

StatedSpace of_profile(const OIIO::ImageSpec& spec) {
    const std::string description = lower(std::string(spec.get_string_attribute("ICCProfile:profile_description")));
    const std::string by = "its ICC profile";
    if (description.find("linear") != std::string::npos) return {ColorSpace::Linear, by};
    if (description.find("srgb") != std::string::npos) return {ColorSpace::Srgb, by};
    return {};
}

// The chunks that tell a colour space, which stand before the pixels; none if the file is no PNG.
std::map<std::string, std::string> chunks_of(const std::string& path) {
    std::map<std::string, std::string> chunks;
    std::ifstream file(path, std::ios::binary);
    const auto read = [&](std::size_t count) {
        std::string bytes(count, '\0');
        file.read(bytes.data(), std::streamsize(count));
        return file ? bytes : std::string();
    };
    if (read(8) != "\x89PNG\r\n\x1a\n") return chunks;
    for (;;) {
        const std::string head = read(8);
        if (head.empty() || head.substr(4) == "IDAT") return chunks;
        std::uint32_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(head[i]);
        constexpr std::uint32_t kShort = 8;  // those whose contents count
        chunks[head.substr(4)] = length <= kShort ? read(length) : std::string();
        file.seekg(std::streamoff(length <= kShort ? 0 : length) + 4, std::ios::cur);
    }
}

StatedSpace of_cicp(const std::string& chunk) {
    constexpr char kLinear = 8, kSrgb = 13;  // transfer characteristics of ITU-T H.273
    const char transfer = chunk.size() == 4 ? chunk[1] : '\0';
    if (transfer == kLinear) return {ColorSpace::Linear, "its cICP chunk"};
    return transfer == kSrgb ? StatedSpace{ColorSpace::Srgb, "its cICP chunk"} : StatedSpace{};
}

// 100000 times the exponent of the file: 45455 is 1 / 2.2, which stands for sRGB.
StatedSpace of_gama(const std::string& chunk) {
    std::uint32_t gamma = 0;
    for (const char c : chunk) gamma = gamma << 8 | static_cast<unsigned char>(c);
    if (gamma == 100000) return {ColorSpace::Linear, "its gAMA chunk"};
    return std::abs(double(gamma) - 45455) < 100 ? StatedSpace{ColorSpace::Srgb, "its gAMA chunk"} : StatedSpace{};
}

StatedSpace of_chunks(const std::map<std::string, std::string>& chunks, const OIIO::ImageSpec& spec) {
    if (const auto cicp = chunks.find("cICP"); cicp != chunks.end()) return of_cicp(cicp->second);
    if (chunks.contains("iCCP")) return of_profile(spec);
    if (chunks.contains("sRGB")) return {ColorSpace::Srgb, "its sRGB chunk"};
    const auto gama = chunks.find("gAMA");
    return gama == chunks.end() ? StatedSpace{} : of_gama(gama->second);
}

StatedSpace stated_in(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) {
        OIIO::geterror();  // or it would be the next file's
        return {};
    }
    const OIIO::ImageSpec spec = input->spec();
    if (const auto chunks = chunks_of(path); !chunks.empty()) return of_chunks(chunks, spec);
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
