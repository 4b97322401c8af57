// Text of the files of other programs: as it may stand on a terminal or in a comment, and why it cannot be read.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace patina::importers {

// The text with its control characters as escapes, so that they neither move the cursor nor begin a line: "a\\nb",
// "\\x1b[31m". Those behind ASCII and the separators of lines of Unicode are escaped, too.
std::string printable(std::string_view text);

// Why nothing can read the file, whatever its format: "rock.mat:12:1: a merge left a conflict here: ...". Nothing, if
// it is not known.
std::optional<std::string> why_unreadable(const std::string& path);

}  // namespace patina::importers
