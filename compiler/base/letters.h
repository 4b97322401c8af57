// Letters of ASCII, in any locale: for the texts of the node language, of graphs and of other programs' files.
//
//   small_letters("Rock.MAT")   // rock.mat
//   trimmed("  a b ")           // "a b"
#pragma once

#include <string>
#include <string_view>

namespace patina {

constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
constexpr bool is_upper(char c) {
    return c >= 'A' && c <= 'Z';
}
constexpr bool is_lower(char c) {
    return c >= 'a' && c <= 'z';
}
constexpr bool is_letter(char c) {
    return is_upper(c) || is_lower(c);
}
// Of an identifier.
constexpr bool is_word_letter(char c) {
    return is_letter(c) || is_digit(c) || c == '_';
}
constexpr char to_upper(char c) {
    return is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c;
}
constexpr char to_lower(char c) {
    return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string small_letters(std::string text) {
    for (char& c : text) c = to_lower(c);
    return text;
}

// Without the spaces at both ends.
constexpr std::string_view trimmed(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
}

}  // namespace patina
