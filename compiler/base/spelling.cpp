#include "compiler/base/spelling.h"

#include "compiler/base/letters.h"

namespace patina {
namespace {

// Of capitals in a row at the front the last one stays, if a small letter follows: "GGXTerm" -> "ggxTerm".
std::string with_small_start(std::string_view word) {
    std::string made(word);
    for (std::size_t i = 0; i < made.size() && is_upper(word[i]); ++i) {
        if (i > 0 && i + 1 < word.size() && is_lower(word[i + 1])) break;
        made[i] = to_lower(made[i]);
    }
    return made;
}

}  // namespace

std::string camel_case(std::string_view name) {
    std::string camel;
    while (!name.empty()) {
        std::size_t end = 0;
        while (end < name.size() && (is_letter(name[end]) || is_digit(name[end]))) ++end;
        if (end > 0) {
            const std::string word = with_small_start(name.substr(0, end));
            camel = camel.empty() ? word : joined(camel, word);
        }
        name.remove_prefix(end < name.size() ? end + 1 : end);
    }
    return camel;
}

std::string joined(std::string_view first, std::string_view second) {
    std::string made(first);
    made += second;
    if (!first.empty() && !second.empty()) made[first.size()] = to_upper(second[0]);
    return made;
}

std::string sentence(std::string_view words) {
    std::string made(words);
    if (made.empty()) return made;
    made[0] = to_upper(made[0]);
    if (made.back() != '.') made += '.';
    return made;
}

std::string numbered(std::string_view name, unsigned number) {
    std::string made(name);
    if (!name.empty() && is_digit(name.back())) made += '_';
    return made + std::to_string(number);
}

std::string initials(std::string_view name) {
    std::string letters;
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (i == 0 || (is_upper(name[i]) && !is_upper(name[i - 1]))) letters += to_lower(name[i]);
    }
    return letters;
}

}  // namespace patina
