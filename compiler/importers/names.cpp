#include "compiler/importers/names.h"

#include <algorithm>
#include <optional>
#include <set>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"

namespace patina::importers::terms {
namespace {

// Words of the node language, which no name may be.
constexpr std::string_view kReserved[] = {"true",  "false", "if",  "else",  "for",    "return",
                                          "const", "in",    "out", "inout", "struct", "enum",
                                          "void",  "uint",  "int", "bool",  "half",   "float"};

}  // namespace

std::string digits(double number) {
    return shortest(static_cast<float>(number));
}

std::string camel_case(std::string_view name) {
    std::string made;
    bool starts_word = false;
    for (const char c : name) {
        if (!is_letter(c) && !is_digit(c)) {
            starts_word = !made.empty();
            continue;
        }
        made += starts_word ? to_upper(c) : c;
        starts_word = false;
    }
    // The first word in small letters: "UV" -> "uv", "HSVShift" -> "hsvShift", "MainTex" -> "mainTex".
    std::size_t capitals = 0;
    while (capitals < made.size() && is_upper(made[capitals])) ++capitals;
    if (capitals > 1 && capitals < made.size() && is_letter(made[capitals])) --capitals;
    for (std::size_t i = 0; i < std::max<std::size_t>(capitals, 1) && i < made.size(); ++i) made[i] = to_lower(made[i]);
    if (!made.empty() && is_digit(made[0])) made = "n" + made;
    return made;
}

std::string pascal_case(std::string_view name) {
    std::string made;
    bool starts_word = true;
    for (const char c : name) {
        if (is_letter(c) || is_digit(c)) made += starts_word ? to_upper(c) : c;
        starts_word = !is_letter(c) && !is_digit(c);
    }
    return made;
}

std::string identifier(std::string_view name) {
    std::string made;
    for (const char c : name) made += is_word_letter(c) ? c : '_';
    if (made.find_first_not_of('_') == made.npos) return {};
    if (is_digit(made[0])) made = "_" + made;
    return made;
}

std::string Names::unique(std::string_view wanted, std::string_view otherwise) {
    constexpr std::size_t kLongest = 100;  // also a name of a file
    std::string base((wanted.empty() ? otherwise : wanted).substr(0, kLongest));
    if (std::ranges::find(kReserved, base) != std::end(kReserved)) base += "Value";
    std::string made = base;
    for (int& i = next_.emplace(base, 2).first->second; taken_.contains(made); ++i)
        made = base + (is_digit(base.back()) ? "_" : "") + std::to_string(i);
    taken_.insert(made);
    return made;
}

}  // namespace patina::importers::terms
