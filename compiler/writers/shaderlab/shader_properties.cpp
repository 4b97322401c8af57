// Writes properties as ShaderLab declares them, for artists to see and set.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"
#include "compiler/format/words.h"
#include "compiler/writers/shaderlab/dialect.h"
#include "compiler/writers/shaderlab/shader_file.h"

namespace patina::writers::shaderlab {
namespace {

// "_BumpScale" -> "Bump Scale", "_NORMALMAP" -> "Normalmap"; "UV" is an abbreviation.
std::string readable(std::string_view name) {
    constexpr std::size_t kShort = 3;
    const bool is_shouted = std::none_of(name.begin(), name.end(), is_lower);
    std::string made;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        const bool begins = i == 0 || name[i - 1] == '_' || (is_upper(c) && is_lower(name[i - 1]));
        if (c == '_') continue;
        if (begins && !made.empty()) made += ' ';
        const std::size_t word = name.find('_', i) == name.npos ? name.size() : name.find('_', i);
        const std::size_t first = i == 0 ? 0 : name.rfind('_', i) + 1;  // of the word; rfind gives npos: 0
        const bool is_quiet = is_shouted && !begins && word - first > kShort;
        const bool is_first = made.empty();
        made += is_quiet ? to_lower(c) : is_first ? to_upper(c) : c;
    }
    return made.empty() ? "Value" : made;
}

// Encodes a linear component as sRGB (IEC 61966-2-1), with as many digits as a colour picker shows.
double encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}
double rounded(double value) {
    return std::round(value * 10000) / 10000;
}

// "textures/rust.png" -> "rust.png"
std::string_view file_name(std::string_view path) {
    return path.substr(path.find_last_of("/\\") + 1);
}

// The shortest decimal text that reads back as this float: 0.005, not 5e-3.
std::string number(double value) {
    return shortest_decimals(static_cast<float>(value));
}

std::string joined(std::span<const double> values) {
    std::string made;
    for (const double value : values) made += (made.empty() ? "" : ", ") + number(value);
    return "(" + made + ")";
}

// "material.SetMatrix("_M", ...): (1, 0), (0, 1)": a matrix by its rows, four vectors on a line.
void add_script_default(const format::Property& property, std::string_view setter, std::vector<std::string>& lines) {
    constexpr std::size_t kOnLine = 4;
    const bool is_matrix = property.type <= PropertyType::Float4x4;
    const std::size_t all = property.numbers.size(),
                      size = is_matrix ? static_cast<std::size_t>(std::lround(std::sqrt(all))) : 4;
    std::string line = fmt::format("// material.{}(\"{}\", ...):", setter, property.name);
    for (std::size_t i = 0; i < all; i += size) {
        if (i > 0 && i / size % kOnLine == 0) {
            lines.push_back(std::move(line));
            line = "//    ";
        }
        line += " " + joined(std::span(property.numbers).subspan(i, size)) + (i + size < all ? "," : "");
    }
    lines.push_back(std::move(line));
}

std::string vector(const std::array<double, 4>& value, std::size_t count) {
    std::string made;
    for (std::size_t i = 0; i < 4; ++i) made += (i == 0 ? "" : ", ") + number(i < count ? value[i] : 0);
    return "(" + made + ")";
}

std::string texture_word(const resolve::MaterialProperty& entry) {
    if (!entry.is_file && !entry.texture_path.empty()) return entry.texture_path;
    return std::string(entry.is_file ? default_word(*entry.property) : "white");
}

struct Declared {
    std::string attributes, type, value;
};

std::string range(const format::Property& property) {
    return fmt::format("Range({}, {})", number((*property.range)[0]), number((*property.range)[1]));
}

// An enum with more values than the inspector can list.
Declared counted(const format::Property& property, double value) {
    return {"[IntRange] ", fmt::format("Range(0, {})", property.values.size() - 1), number(value)};
}

// A property that sets keywords. Unity itself derives an enum's keywords from the names.
Declared switched(const resolve::MaterialProperty& entry) {
    const format::Property& property = *entry.property;
    if (property.type == PropertyType::Bool)
        return {fmt::format("[Toggle({})] ", writers::shaderlab::keyword_of(property.name, {})), "Float",
                number(entry.chosen)};
    if (property.values.size() > kMostKeywords) return counted(property, entry.chosen);
    return {fmt::format("[KeywordEnum({})] ", fmt::join(property.values, ", ")), "Float", number(entry.chosen)};
}

Declared declared(const resolve::MaterialProperty& entry, bool is_decoded) {
    const format::Property& property = *entry.property;
    const auto& value = property.value;
    switch (property.type) {
        case PropertyType::Float: return {"", property.range ? range(property) : "Float", number(value[0])};
        case PropertyType::Float2: return {"", "Vector", vector(value, 2)};
        case PropertyType::Float3: return {"", "Vector", vector(value, 3)};
        case PropertyType::Float4: return {"", "Vector", vector(value, 4)};
        case PropertyType::Color: {
            std::string type(to_string(property.type));  // ShaderLab writes it with a capital
            type[0] = to_upper(type[0]);
            if (!is_decoded) return {"[HDR] ", type, vector(value, 4)};
            return {"", type,
                    vector({rounded(encoded(value[0])), rounded(encoded(value[1])), rounded(encoded(value[2])),
                            rounded(value[3])},
                           4)};
        }
        case PropertyType::Int:
            if (property.range) return {"[IntRange] ", range(property), number(value[0])};
            return {"", "Int", number(value[0])};
        case PropertyType::Bool: return {"[Toggle] ", "Float", number(value[0])};
        case PropertyType::Enum: {
            if (property.values.size() > kMostPairs) return counted(property, value[0]);
            std::string words;
            for (std::size_t i = 0; i < property.values.size(); ++i)
                words += fmt::format("{}{}, {}", i == 0 ? "" : ", ", property.values[i], i);
            return {fmt::format("[Enum({})] ", words), "Float", number(value[0])};
        }
        case PropertyType::Float2x2:
        case PropertyType::Float3x3:
        case PropertyType::Float4x4:
        case PropertyType::Gradient:
        case PropertyType::Curve:
        case PropertyType::Sampler: break;
        case PropertyType::Texture2D: {
            std::string attributes = property.tiling ? "" : "[NoScaleOffset] ";
            if (is_unity_normal_map(property)) attributes += "[Normal] ";
            return {attributes, "2D", fmt::format("\"{}\" {{}}", texture_word(entry))};
        }
        case PropertyType::TextureCube:
        case PropertyType::Texture2DArray:
        case PropertyType::Texture3D: {
            const std::string_view kind = property.type == PropertyType::TextureCube      ? "Cube"
                                          : property.type == PropertyType::Texture2DArray ? "2DArray"
                                                                                          : "3D";
            return {"[NoScaleOffset] ", std::string(kind), fmt::format("\"{}\" {{}}", texture_word(entry))};
        }
    }
    return {};
}

}  // namespace

std::string keyword_of(std::string_view property, std::string_view value) {
    // Unity's own shaders have other keywords for these two.
    if (property == resolve::kTransparentChoice && value.empty()) return "_SURFACE_TYPE_TRANSPARENT";
    if (property == resolve::kClipChoice && value.empty()) return "_ALPHATEST_ON";
    std::string made = capital_letters(property);
    if (!value.empty()) return made + "_" + capital_letters(value);
    return made == property ? made : made + "_ON";
}

std::string quoted(std::string_view text) {
    std::string made;
    for (const char c : text) made += c == '"' ? '\'' : static_cast<unsigned char>(c) < 0x20 || c == '\\' ? ' ' : c;
    return made;
}

std::string listed_name(std::string_view name) {
    return "Patina/" + shader_name(name);
}

std::string shader_name(std::string_view text) {
    std::vector<std::string> parts;
    const std::string whole = quoted(text);
    for (const std::string_view part : split(whole, "/")) {
        std::string made = fmt::format("{}", fmt::join(split(part, " "), " "));
        if (!made.empty()) parts.push_back(std::move(made));
    }
    return parts.empty() ? "Unnamed" : fmt::format("{}", fmt::join(parts, "/"));
}

std::string header_words(std::string_view text) {
    std::string made;
    bool is_gap = false;
    for (const char c : text) {
        const bool is_kept = is_letter(c) || is_digit(c) || static_cast<unsigned char>(c) >= 0x80;
        if (is_kept && is_gap && !made.empty()) made += ' ';
        if (is_kept) made += c;
        is_gap = !is_kept;
    }
    return made;
}

std::string sampler_words(const format::Property& property) {
    const Sampler& sampler = property.sampler;
    std::vector<std::string> words;
    if (sampler.wrap == Wrap::Clamp) words.emplace_back("Wrap Mode: Clamp");
    if (sampler.wrap == Wrap::Mirror) words.emplace_back("Wrap Mode: Mirror");
    if (sampler.filter == Filter::Nearest) words.emplace_back("Filter Mode: Point");
    if (sampler.anisotropy > 1) words.push_back(fmt::format("Aniso Level: {}", sampler.anisotropy));
    return fmt::format("{}", fmt::join(words, ", "));
}

bool is_unity_normal_map(const format::Property& property) {
    return property.usage == TextureUsage::Normal && property.swizzle.empty();
}

std::string_view script_setter(const format::Property& property) {
    if (!is_array(property.type)) return {};
    return property.type <= PropertyType::Float4x4 ? "SetMatrix" : "SetVectorArray";
}

std::string_view default_word(const format::Property& property) {
    return property.usage == TextureUsage::Normal ? "bump" : "white";
}

std::vector<std::string> shader_properties(const resolve::Material& material, const lower::Lowered& lowered) {
    std::vector<std::string> lines, by_script;
    std::string group;
    for (std::size_t i = 0; i < material.properties.size(); ++i) {
        const resolve::MaterialProperty& entry = material.properties[i];
        const format::Property& property = *entry.property;
        const lower::PropertyGlobals& globals = lowered.property_globals[i];
        const ir::GlobalId id = globals.texture ? globals.texture : globals.value;
        if (!id && !globals.keyword) continue;  // it is a constant
        if (const std::string_view setter = script_setter(property); !setter.empty()) {
            add_script_default(property, setter, by_script);
            continue;
        }
        const Declared made = id ? declared(entry, !lowered.module.globals[id.index].decoder.empty()) : switched(entry);
        if (property.group != group) {
            const bool is_first = lines.empty();
            if (!is_first) lines.emplace_back();
            const std::string words = header_words(property.group);
            // A property without a group would seem to belong to the group before.
            if (!words.empty())
                lines.push_back(fmt::format("[Header({})]", words));
            else if (!is_first)
                lines.emplace_back("[Space]");
            group = property.group;
        }
        std::string line = fmt::format(
            "{}{} (\"{}\", {}) = {}", made.attributes, lowered.module.globals[(id ? id : globals.keyword).index].name,
            quoted(property.label.empty() ? readable(property.name) : property.label), made.type, made.value);
        std::string asset = entry.is_file ? quoted(file_name(entry.texture_path)) : "";
        if (const std::string words = sampler_words(property); !words.empty())
            asset += (asset.empty() ? "" : ", ") + words;
        if (!asset.empty()) line += "  // " + asset;
        lines.push_back(std::move(line));
    }
    if (!by_script.empty()) {
        if (!lines.empty()) lines.emplace_back();
        lines.emplace_back("// ShaderLab cannot store these: a script sets them. The graph's defaults are");
        lines.insert(lines.end(), by_script.begin(), by_script.end());
    }
    return lines;
}

}  // namespace patina::writers::shaderlab
