// HLSL as words, numbers and operators.
#pragma once

#include <string_view>
#include <vector>

namespace patina::importers::shadergraph {

inline bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
inline bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

struct Token {
    std::string_view text;  // a part of the whole text; empty: the end
    int line = 1;
};
// The last one is the end.
std::vector<Token> tokens_of(std::string_view text);

}  // namespace patina::importers::shadergraph
