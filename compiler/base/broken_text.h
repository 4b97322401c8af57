// What keeps a text from being read, whatever its format: it is UTF-16, or a merge left its markers in it.
//
//   if (const std::optional<BrokenText> wrong = broken_text(text)) ...   // {.line = 12, .what = "a merge left ..."}
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace patina {

struct BrokenText {
    std::size_t offset = 0;  // in bytes
    int line = 1;            // from 1
    std::string_view what{};
};
// Nothing, if neither is so.
std::optional<BrokenText> broken_text(std::string_view text);

}  // namespace patina
