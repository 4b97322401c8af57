#include "compiler/importers/shadergraph/names.h"

#include <algorithm>

namespace patina::importers::shadergraph {
namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
}
char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
}

// Words of the node language, which no name may be.
constexpr std::string_view kReserved[] = {"true",  "false", "if",  "else",  "for",    "return",
                                          "const", "in",    "out", "inout", "struct", "enum",
                                          "void",  "uint",  "int", "bool",  "half",   "float"};

}  // namespace

std::string camel_case(std::string_view name) {
    std::string made;
    bool starts_word = false;
    for (const char c : name) {
        if (!is_letter(c) && !is_digit(c)) {
            starts_word = !made.empty();
            continue;
        }
        made += starts_word ? upper(c) : c;
        starts_word = false;
    }
    // The first word in small letters: "UV" -> "uv", "HSVShift" -> "hsvShift", "MainTex" -> "mainTex".
    std::size_t capitals = 0;
    while (capitals < made.size() && made[capitals] >= 'A' && made[capitals] <= 'Z') ++capitals;
    if (capitals > 1 && capitals < made.size() && is_letter(made[capitals])) --capitals;
    for (std::size_t i = 0; i < std::max<std::size_t>(capitals, 1) && i < made.size(); ++i) made[i] = lower(made[i]);
    if (!made.empty() && is_digit(made[0])) made = "n" + made;
    return made;
}

std::string identifier(std::string_view name) {
    std::string made;
    for (const char c : name) made += is_letter(c) || is_digit(c) || c == '_' ? c : '_';
    if (made.find_first_not_of('_') == made.npos) return {};
    if (is_digit(made[0])) made = "_" + made;
    return made;
}

std::string Names::unique(std::string_view wanted, std::string_view otherwise) {
    constexpr std::size_t kLongest = 100;  // also a name of a file
    std::string base((wanted.empty() ? otherwise : wanted).substr(0, kLongest));
    if (std::ranges::find(kReserved, base) != std::end(kReserved)) base += "Value";
    std::string made = base;
    for (int i = 2; taken_.contains(made); ++i) made = base + (is_digit(base.back()) ? "_" : "") + std::to_string(i);
    taken_.insert(made);
    return made;
}

}  // namespace patina::importers::shadergraph
