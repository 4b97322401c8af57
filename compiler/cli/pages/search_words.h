// The words of names, texts and queries, in a form in which those that mean the same are equal.
//
//   search_words("Blend two textures")  // blend, textur; "two" says nothing about a node
//   words_of("RoundedRectangle")        // round, rectangl, and together roundedrectangl
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace patina::cli {

// A word without its ending; British and American spellings meet: "posterised" is "posteriz". For comparison alone.
std::string stem(std::string word);

// Stems. A hump of a name begins a word, and so does a number.
struct Words {
    std::vector<std::string> single;  // "OkLab": ok, lab
    std::vector<std::string> joined;  // two or three consecutive words of them: oklab
};
Words words_of(std::string_view text);

// The stems of a query but for filler words ("a", "by", "make"); all of them if it has no others.
std::vector<std::string> search_words(std::string_view query);

}  // namespace patina::cli
