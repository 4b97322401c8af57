// Small questions about text that several stages ask: is it an identifier, which known word did the user mean, how is a
// number written so that it reads back the same. Not a string library.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace patina {

// [A-Za-z_][A-Za-z0-9_]*
bool is_identifier(std::string_view text);

// The candidate that `word` means: the one that differs by case and underscores only ("normalWS", normalWS), else the
// nearest by edit distance, or empty if none is near enough.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

// Shortest text that reads back as the same value: "0.5", "1", "1e-05". Locale-independent.
std::string shortest(double value);
std::string shortest(float value);

// "a, b and c"
std::string enumerate(std::span<const std::string_view> words);

// True if the text is well-formed UTF-8; otherwise `bad` is the offset of the first wrong byte.
bool is_utf8(std::string_view text, std::size_t& bad);

// The parts between the separators, those that are not empty.
std::vector<std::string_view> split(std::string_view text, std::string_view at);

}  // namespace patina
