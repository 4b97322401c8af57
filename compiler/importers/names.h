// Text of imported graphs: numbers as short as they can be, identifiers from names that may be any text.
//
//   camel_case("Tiling And Offset");   // "tilingAndOffset"
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace patina::importers::terms {

std::string digits(double number);  // "0.5"
// --- names

std::string camel_case(std::string_view name);   // "Tiling And Offset", "tiling_and_offset" -> "tilingAndOffset"
std::string pascal_case(std::string_view name);  // "tiling_and_offset" -> "TilingAndOffset"; may be empty
std::string identifier(std::string_view name);   // "_Main Tex" -> "_Main_Tex"; may be empty

// Each name once: "mask", "mask2", "mask3".
class Names {
public:
    std::string unique(std::string_view wanted, std::string_view otherwise);
    void take(std::string_view name) { taken_.insert(std::string(name)); }

private:
    std::set<std::string, std::less<>> taken_;
    std::map<std::string, int> next_;  // by the name without a number: the number that may be free
};

}  // namespace patina::importers::terms
