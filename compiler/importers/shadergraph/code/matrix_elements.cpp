#include "compiler/importers/shadergraph/code/matrix_elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace patina::importers::shadergraph {
namespace {

bool is_of_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

struct Element {
    int row = 0, column = 0;
};

// "_m01_m02" counts from 0, "_12_13" from 1. Empty: the word is something else.
std::vector<Element> elements_in(std::string_view word) {
    std::vector<Element> made;
    const char first = word.starts_with("_m") ? '0' : '1';
    while (word.starts_with("_")) {
        word.remove_prefix(first == '0' && word.starts_with("_m") ? 2 : 1);
        if (word.size() < 2) return {};
        const Element each{word[0] - first, word[1] - first};
        if (each.row < 0 || each.row > 3 || each.column < 0 || each.column > 3) return {};
        made.push_back(each);
        word.remove_prefix(2);
    }
    return word.empty() && made.size() <= 4 ? made : std::vector<Element>();
}

}  // namespace

std::string with_matrix_elements(const std::string& code, std::string& error) {
    std::string made;
    for (std::size_t at = 0; at < code.size();) {
        if (code[at] != '.' || code.substr(at, 2) != "._") {
            made += code[at++];
            continue;
        }
        std::size_t end = at + 1;
        while (end < code.size() && is_of_name(code[end])) ++end;
        const std::string word = code.substr(at + 1, end - at - 1);
        const std::vector<Element> elements = elements_in(word);
        std::size_t begin = made.size();
        while (begin > 0 && is_of_name(made[begin - 1])) --begin;
        const std::string matrix = made.substr(begin);
        const std::size_t next = std::min(code.find_first_not_of(" \n", end), code.size());
        const bool is_assigned = code[next] == '=' && code[next + 1] != '=';
        if (elements.empty()) {
            made += code.substr(at, end - at);
        } else if (elements.size() == 1) {
            made += fmt::format("[{}][{}]", elements[0].row, elements[0].column);
        } else if (matrix.empty() || (begin > 0 && made[begin - 1] == '.') || is_assigned) {
            const auto line = std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
            if (error.empty())
                error = fmt::format("line {} of its code: the elements '{}' are {}", line, word,
                                    is_assigned ? "assigned together" : "those of an expression, not of a variable");
            return code;
        } else {
            made.resize(begin);
            made += fmt::format("float{}(", elements.size());
            for (std::size_t i = 0; i < elements.size(); ++i)
                made += fmt::format("{}{}[{}][{}]", i > 0 ? ", " : "", matrix, elements[i].row, elements[i].column);
            made += ")";
        }
        at = end;
    }
    return made;
}

}  // namespace patina::importers::shadergraph
