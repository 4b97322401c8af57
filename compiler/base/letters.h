// Letters of ASCII, in any locale: for the texts of the node language, of graphs and of other programs' files.
//
//   small_letters("Rock.MAT")   // rock.mat
//   trimmed("  a b ")           // "a b"
#pragma once

#include <algorithm>
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
// Of an identifier: its first letter, and each letter.
constexpr bool is_word_start(char c) {
    return is_letter(c) || c == '_';
}
constexpr bool is_word_letter(char c) {
    return is_word_start(c) || is_digit(c);
}
constexpr char to_upper(char c) {
    return is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c;
}
constexpr char to_lower(char c) {
    return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string small_letters(std::string_view text) {
    std::string made(text);
    for (char& c : made) c = to_lower(c);
    return made;
}

inline std::string capital_letters(std::string_view text) {
    std::string made(text);
    for (char& c : made) c = to_upper(c);
    return made;
}

// Without the spaces at both ends.
constexpr std::string_view trimmed(std::string_view text, std::string_view spaces = " ") {
    text.remove_prefix(std::min(text.find_first_not_of(spaces), text.size()));
    return text.substr(0, text.find_last_not_of(spaces) + 1);
}

}  // namespace patina
