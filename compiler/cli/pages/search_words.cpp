#include "compiler/cli/pages/search_words.h"

#include <algorithm>
#include <array>
#include <utility>

#include "compiler/base/letters.h"

namespace patina::cli {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kBritish = {{{"colour", "color"},
                                                                                    {"grey", "gray"},
                                                                                    {"centre", "center"},
                                                                                    {"metre", "meter"},
                                                                                    {"neighbour", "neighbor"},
                                                                                    {"behaviour", "behavior"}}};

constexpr std::array<std::string_view, 44> kFillers = {
    "a",    "an",   "the",  "of",   "for",  "to",   "in",    "on",    "at",   "by",     "with",
    "and",  "or",   "from", "into", "onto", "as",   "is",    "are",   "it",   "its",    "this",
    "that", "two",  "one",  "some", "my",   "how",  "do",    "does",  "can",  "make",   "making",
    "get",  "want", "need", "i",    "use",  "node", "nodes", "using", "give", "create", "between"};

// Removes the ending if at least `rest` letters stay.
bool drop(std::string& word, std::string_view ending, std::size_t rest) {
    if (word.size() < ending.size() + rest || !word.ends_with(ending)) return false;
    word.resize(word.size() - ending.size());
    return true;
}

// "Texture2D at 2": Texture, 2D, at, 2.
std::vector<std::string> raw_words(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    const auto end_word = [&] {
        if (!word.empty()) words.push_back(std::move(word));
        word.clear();
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i], before = i > 0 ? text[i - 1] : ' ', next = i + 1 < text.size() ? text[i + 1] : ' ';
        const bool is_hump = is_upper(c) && is_letter(before) && (!is_upper(before) || is_lower(next));
        const bool is_number = is_digit(c) && is_letter(before);
        const bool is_word = is_letter(c) || is_digit(c);
        if (is_hump || is_number || !is_word) end_word();
        if (is_word) word += to_lower(c);
    }
    end_word();
    return words;
}

}  // namespace

std::string stem(std::string word) {
    for (const auto& [british, american] : kBritish) {
        if (const std::size_t at = word.find(british); at != std::string::npos)
            word.replace(at, british.size(), american);
    }
    if (!word.ends_with("ss")) drop(word, "s", 3);
    if (!drop(word, "able", 3) && !drop(word, "ation", 3) && !drop(word, "ing", 3)) drop(word, "ed", 3);
    drop(word, "e", 2);
    drop(word, "at", 3);                                              // "pixelate", "saturated"
    if (word.size() >= 6 && word.ends_with("is")) word.back() = 'z';  // "posterise"
    const std::size_t size = word.size();
    const bool is_doubled = size > 3 && word[size - 1] == word[size - 2];
    if (is_doubled && std::string_view("lsz").find(word.back()) == std::string_view::npos) word.pop_back();  // "mapped"
    return word;
}

Words words_of(std::string_view text) {
    const std::vector<std::string> raw = raw_words(text);
    Words words;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        words.single.push_back(stem(raw[i]));
        std::string joined = raw[i];
        for (std::size_t k = i + 1; k < std::min(i + 3, raw.size()); ++k)
            words.joined.push_back(stem(joined += raw[k]));
    }
    return words;
}

std::vector<std::string> search_words(std::string_view query) {
    std::vector<std::string> all, telling;
    for (const std::string& word : raw_words(query)) {
        all.push_back(stem(word));
        if (std::find(kFillers.begin(), kFillers.end(), word) == kFillers.end()) telling.push_back(all.back());
    }
    return telling.empty() ? all : telling;
}

}  // namespace patina::cli
