// A material of Unity as its file says it: all values that it stores, whether or not its shader reads them. Both forms
// of the lists are read, the one of today ("- _Color: {...}") and the old one ("first: ... second: ...").
//
//   const MaterialFile file = read_material(path);
//   if (!file.error.empty()) ...
//   file.numbers.at("_Metallic").value
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "compiler/importers/unity/yaml.h"

namespace patina::importers::unitymaterial {

// What names another file: {fileID: 2800000, guid: 0f6a..., type: 3}
struct AssetId {
    std::int64_t file = 0;
    std::string guid{};  // 32 hexadecimal digits; empty: none

    bool is_none() const { return file == 0 && guid.empty(); }
};
struct SavedNumber {
    double value = 0;
    Place place{};
};
struct SavedColor {
    std::array<double, 4> value{};
    Place place{};
};
struct SavedTexture {
    AssetId picture{};
    std::array<double, 2> scale{1, 1}, offset{0, 0};
    Place place{};

    bool is_moved() const { return scale != std::array{1.0, 1.0} || offset != std::array{0.0, 0.0}; }
};
struct SavedKeyword {
    std::string name{};
    Place place{};
};
struct Setting {
    std::string key{}, text{};
    std::vector<std::string> words{};  // of a list its elements, of a map "key=value"
    Place place{};
};
struct Problem {
    std::string part{}, text{};
    Place place{};
    std::string file{};  // empty: the material; else one that it is a variant of
};

struct MaterialFile {
    std::string error{};  // not empty: why there is nothing else
    std::string path{}, name{};
    AssetId shader{}, parent{};
    Place shader_place{}, parent_place{};
    std::vector<SavedKeyword> keywords{};          // that are on
    std::vector<SavedKeyword> invalid_keywords{};  // that the shader does not have
    std::map<std::string, SavedNumber> numbers{};  // m_Floats and m_Ints
    std::map<std::string, SavedColor> colors{};
    std::map<std::string, SavedTexture> textures{};
    std::vector<Setting> settings{};               // everything else
    std::vector<std::string> parents{};            // whose values it has, too, the nearest one first
    std::map<std::string, std::string> origins{};  // of properties that are those of a parent: its file
    std::vector<Problem> problems{};               // values that cannot be read

    const Setting* setting(std::string_view key) const;
    bool has(const std::string& property) const;
};

inline constexpr std::string_view kMaterials[] = {".mat"};
// A file that another file names must have that ending (read_named_text()).
MaterialFile read_material(const std::string& path, bool is_named_by_user = true);

// "0.5"; false: it is no number, or not finite in 32 bits.
bool read_finite(std::string_view text, double& number);

}  // namespace patina::importers::unitymaterial
