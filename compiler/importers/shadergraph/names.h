// Names of a shader graph, which may be any text, as identifiers.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace patina::importers::shadergraph {

std::string camel_case(std::string_view name);  // "Tiling And Offset" -> "tilingAndOffset"; may be empty
std::string identifier(std::string_view name);  // "_Main Tex" -> "_Main_Tex"; may be empty

// Each name once: "mask", "mask2", "mask3".
class Names {
public:
    std::string unique(std::string_view wanted, std::string_view otherwise);
    void take(std::string_view name) { taken_.insert(std::string(name)); }

private:
    std::set<std::string, std::less<>> taken_;
};

}  // namespace patina::importers::shadergraph
