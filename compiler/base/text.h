// Functions about text that several rooms need: whether it is an identifier, which known word the user meant, and how
// to write a number so that it is read back unchanged. Not a string library.
//
// Numbers do not depend on the locale. They go through {fmt} rather than std::to_chars, which the standard library of
// Emscripten 3.1.6 (libc++ 13) has for whole numbers only.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace patina {

// [A-Za-z_][A-Za-z0-9_]*
bool is_identifier(std::string_view text);

// The word without what spellings differ by: case, underscores and spaces. "normal_ws" and "normalWS" are "normalws".
std::string spelled_alike(std::string_view word);

// The candidate that `word` probably means: a candidate that differs only in case and underscores (normal_ws,
// normalWS), else the nearest by edit distance. Empty if none is near enough.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

// Shortest text that reads back as the same value, as std::to_chars writes it: "0.5", "1", "1e-05".
std::string shortest(double value);
std::string shortest(float value);
// The same without an exponent: "0.00001".
std::string shortest_decimals(float value);

// "0.5", ".5e3": nothing if that is not the whole text; infinity if no double other than 0 is near.
std::optional<double> read_number(std::string_view text);

// "a, b and c"
std::string enumerate(std::span<const std::string_view> words);

// True if the text is well-formed UTF-8; otherwise `bad` is the offset of the first wrong byte.
bool is_utf8(std::string_view text, std::size_t& bad);

// The parts between the separators, those that are not empty.
std::vector<std::string_view> split(std::string_view text, std::string_view at);

}  // namespace patina
