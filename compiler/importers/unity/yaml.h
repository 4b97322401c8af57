// The YAML in which Unity writes its files, as trees whose values know their places. It knows no key. What Unity never
// writes is an error: aliases, keys that are lists, and deep nesting.
//
//   const YamlFile file = read_yaml("x.mat", text);
//   if (!file.error.empty()) ...                       // "x.mat:3:9: ..."
//   const Yaml* material = file.documents[0].find("Material");
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace patina::importers {

struct Place {
    int line = 0;    // from 1; 0: nowhere
    int column = 0;  // from 1, in bytes
};

struct Yaml {
    enum class Kind { Null, Text, List, Map };
    Kind kind = Kind::Null;
    std::string text{};
    std::vector<std::string> keys{};  // of a map, in file order; a key may be there twice
    std::vector<Yaml> values{};       // of a list, or of the keys
    std::vector<Place> key_places{};
    Place place{};

    const Yaml* find(std::string_view key) const;       // the first one, or null
    std::string_view word(std::string_view key) const;  // of a map: the text at the key; empty: there is none
};

struct YamlFile {
    std::string error{};  // not empty: why there is nothing else
    std::vector<Yaml> documents{};
};

YamlFile read_yaml(const std::string& path, const std::string& text);

}  // namespace patina::importers
