// Why a text cannot be read, in any format: it is UTF-16, or it has the markers of a merge. And text that can be read
// in any case.
//
//   if (const std::optional<BrokenText> wrong = broken_text(text)) ...   // {.line = 12, .what = "a merge left ..."}
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace patina {

struct BrokenText {
    std::size_t offset = 0;  // in bytes
    int line = 1;            // from 1
    std::string_view what{};
};
// Nothing, if neither is so.
std::optional<BrokenText> broken_text(std::string_view text);

// Writes U+FFFD for each byte that is not UTF-8. JSON output goes through this function, because the name of a file may
// have any bytes.
std::string as_utf8(std::string_view text);

}  // namespace patina
