#include "compiler/importers/unity/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "compiler/importers/source_text.h"
#include "compiler/importers/unity/yaml.h"

namespace patina::importers {
namespace {

constexpr std::string_view kBuiltInResources[] = {"0000000000000000f000000000000000",
                                                  "0000000000000000e000000000000000"};

constexpr int kMostLayers = 256;  // of a row or a column, in a graph

int whole(const Yaml* holder, std::string_view key, int otherwise) {
    const std::string_view text = holder ? holder->word(key) : std::string_view();
    int made = otherwise;
    std::from_chars(text.data(), text.data() + text.size(), made);
    return made;
}

void read_sampler(const Yaml* settings, Picture& made) {
    const int old_wrap = whole(settings, "wrapMode", 0);
    const int u = std::max(whole(settings, "wrapU", old_wrap), 0);
    const int v = std::max(whole(settings, "wrapV", old_wrap), 0);
    made.repeats = u == 0 && v == 0;
    GraphMembers sampler;
    if (u > 0) sampler.push_back({"wrap", u == 1 ? "clamp" : "mirror"});
    if (u != v) made.differences.push_back("a sampler has one wrap mode for both directions, here that of u");
    if (u == 3) made.differences.push_back("it is mirrored again and again, not once");
    if (whole(settings, "filterMode", 1) == 0) sampler.push_back({"filter", "nearest"});
    const int anisotropy = whole(settings, "aniso", 1);
    int power = 1;
    while (power * 2 <= std::min(anisotropy, 16)) power *= 2;
    if (power > 1) sampler.push_back({"anisotropy", static_cast<double>(power)});
    if (!sampler.empty()) made.more.push_back({"sampler", GraphValue::object(sampler)});
}

void read_settings(const std::string& path, Picture& made) {
    std::string why;
    const std::optional<std::string> text = read_named_text(path + ".meta", kMetas, why);
    const YamlFile meta = read_yaml(path + ".meta", text.value_or(""));
    const Yaml* importer = meta.documents.empty() ? nullptr : meta.documents.front().find("TextureImporter");
    if (!meta.error.empty()) made.differences.push_back("its import settings cannot be read: " + meta.error);
    if (!importer) return;
    made.has_settings = true;
    const Yaml* mips = importer->find("mipmaps");
    const Yaml* bumps = importer->find("bumpmap");
    made.is_srgb = whole(mips, "sRGBTexture", 1) != 0 && whole(mips, "linearTexture", 0) == 0;
    // Before 2016, a normal map had a flag of its own, too.
    made.is_normal_map = whole(importer, "textureType", 0) == 1;
    made.flips_green = whole(bumps, "flipGreenChannel", 0) != 0;
    read_sampler(importer->find("textureSettings"), made);
    const int columns = std::clamp(whole(importer, "flipbookColumns", 1), 1, kMostLayers),
              rows = std::clamp(whole(importer, "flipbookRows", 1), 1, kMostLayers);
    if (columns > 1 || rows > 1)
        made.layers.push_back({"grid", GraphValue::list({static_cast<double>(columns), static_cast<double>(rows)})});
    if (whole(mips, "enableMipMap", 1) == 0) made.differences.push_back("it has mip levels");
    const int alpha = whole(importer, "alphaUsage", 1);
    if (!made.is_normal_map && alpha == 0) made.more.push_back({"swizzle", "rgb1"});
    if (!made.is_normal_map && alpha == 2) made.differences.push_back("its alpha is its own, and not its grey");
    if (made.is_normal_map && whole(bumps, "convertToNormalMap", 0) != 0)
        made.differences.push_back("Unity makes a normal map of this picture of heights: it is read as a normal map");
}

}  // namespace

const Picture& Pictures::find(std::string_view guid, std::int64_t file) {
    const auto [found, is_new] = known_.try_emplace(fmt::format("{} {}", guid, file));
    if (is_new) found->second = read(guid, file);
    return found->second;
}

Picture Pictures::read(std::string_view guid, std::int64_t file) {
    Picture made;
    if (std::ranges::find(kBuiltInResources, guid) != std::end(kBuiltInResources)) {
        made.missing = fmt::format("it is the picture {} of Unity itself", file);
        return made;
    }
    const auto found = assets_.find(guid, "", kPictures);
    if (!found) {
        made.missing =
            fmt::format("no picture in {} has the GUID {}", assets_.folders(), guid.empty() ? "(none)" : guid);
        return made;
    }
    made.file = path_from(folder_, found->path);
    if (made.file.empty()) {
        made.missing = fmt::format("'{}' has no path from the output folder", found->path);
        return made;
    }
    if (!found->other.empty())
        made.differences.push_back(
            fmt::format("'{}' has the same GUID as '{}', which is taken", found->other, found->path));
    read_settings(found->path, made);
    return made;
}

}  // namespace patina::importers
