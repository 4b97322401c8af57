#include "compiler/importers/unitymaterial/shaders.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace patina::importers::unitymaterial {
namespace {

// Shaders of Unity. Those of the built-in pipeline have one GUID and numbers; those of the other pipelines have the
// GUIDs of their files in their packages.
constexpr std::string_view kBuiltIn = "0000000000000000f000000000000000";
struct Row {
    std::string_view guid;
    std::int64_t file;  // 0: any
    std::string_view name;
    Family family;
    bool is_specular = false;
    std::string_view difference = {};
};
constexpr Row kShaders[] = {
    {kBuiltIn, 46, "Standard", Family::Standard},
    {kBuiltIn, 45, "Standard (Specular setup)", Family::Standard, true},
    {kBuiltIn, 10750, "Unlit/Transparent", Family::UnlitTransparent},
    {kBuiltIn, 10751, "Unlit/Transparent Cutout", Family::UnlitCutout},
    {kBuiltIn, 10752, "Unlit/Texture", Family::UnlitTexture},
    {kBuiltIn, 10755, "Unlit/Color", Family::UnlitColor},
    {"933532a4fcc9baf4fa0491de14d08ed7", 0, "Universal Render Pipeline/Lit", Family::UniversalLit},
    {"ee7e4c9a5f6364b688a332c67fc32cca", 0, "Universal Render Pipeline/Complex Lit", Family::UniversalLit},
    {"8d2bb70cbf9db8d4da26e15b26e74248", 0, "Universal Render Pipeline/Simple Lit", Family::SimpleLit},
    {"0ca6dca7396eb48e5849247ffd444914", 0, "Universal Render Pipeline/Baked Lit", Family::BakedLit, false,
     "lights shine on it, too, and not baked light alone"},
    {"650dd9526735d5b46b79224bc6e94025", 0, "Universal Render Pipeline/Unlit", Family::Unlit},
    {"6e4ae4064600d784cac1e41a9e6f2e59", 0, "HDRP/Lit", Family::HighDefinitionLit, false,
     "highlights lose the light that is reflected several times, which that pipeline adds"},
};

constexpr std::string_view kShaderGraphs[] = {".shadergraph"};
constexpr std::string_view kShaderFiles[] = {".shader"};

bool has_any(const MaterialFile& material, std::initializer_list<const char*> names) {
    return std::ranges::any_of(names, [&](const char* name) { return material.has(name); });
}

// The known shader whose properties the material has.
Shader guessed(const MaterialFile& material) {
    const bool is_lit = has_any(material, {"_Metallic", "_Glossiness", "_Smoothness", "_BumpMap", "_SpecColor"});
    if (has_any(material, {"_BaseColorMap", "_MaskMap"}))
        return {.family = Family::HighDefinitionLit, .name = "HDRP/Lit"};
    if (has_any(material, {"_BaseMap", "_BaseColor"}))
        return is_lit ? Shader{.family = Family::UniversalLit, .name = "Universal Render Pipeline/Lit"}
                      : Shader{.family = Family::Unlit, .name = "Universal Render Pipeline/Unlit"};
    if (!has_any(material, {"_MainTex", "_Color"})) return {};
    if (!is_lit) return {.family = Family::UnlitTexture, .name = "Unlit/Texture"};
    const bool is_specular = has_any(material, {"_SpecColor"}) && !has_any(material, {"_Metallic"});
    return {.family = Family::Standard,
            .name = is_specular ? "Standard (Specular setup)" : "Standard",
            .is_specular = is_specular};
}

std::string file_of(const Assets::Found& found) {
    return std::filesystem::path(found.path).filename().string();
}

}  // namespace

Shader shader_of(const MaterialFile& material, Assets& assets) {
    const AssetId& id = material.shader;
    for (const Row& row : kShaders)
        if (row.guid == id.guid && (row.file == 0 || row.file == id.file))
            return {.family = row.family,
                    .name = std::string(row.name),
                    .is_specular = row.is_specular,
                    .difference = std::string(row.difference)};
    std::string what = id.guid.empty() ? "the material has no shader" : "";
    if (!id.guid.empty()) {
        if (const auto found = assets.find(id.guid, "", kShaderGraphs)) {
            Shader made{.family = Family::ShaderGraph, .name = file_of(*found), .graph = found->path};
            if (!found->other.empty())
                made.difference =
                    fmt::format("'{}' has the same GUID as '{}', which is taken", found->other, found->path);
            return made;
        }
        const auto found = assets.find(id.guid, "", kShaderFiles);
        what = found                 ? fmt::format("the shader '{}' is not known", file_of(*found))
               : id.guid == kBuiltIn ? fmt::format("the built-in shader {} is not known", id.file)
                                     : fmt::format("no file in {} has the GUID {}", assets.folders(), id.guid);
    }
    Shader made = guessed(material);
    made.is_guessed = true;
    made.difference =
        made.family == Family::Unknown
            ? what + ", and no property has a name that is known"
            : fmt::format("{}: the properties are read as those of '{}'; how it is lit and blends is not known", what,
                          made.name);
    return made;
}

}  // namespace patina::importers::unitymaterial
