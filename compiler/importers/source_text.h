// Text of the files of other programs: as it may stand on a terminal or in a comment, and why it cannot be read or
// imported.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "patina/diagnostic.h"

namespace patina::importers {

// The text with its control characters as escapes, so that they neither move the cursor nor begin a line: "a\\nb",
// "\\x1b[31m". Those behind ASCII and the separators of lines of Unicode are escaped, too.
std::string printable(std::string_view text);

// The text of a file that the user or another file names, at most 64 MiB of it. If there is none, `why` is set: "cannot
// read 'a.mtlx': it is a FIFO".
std::optional<std::string> read_text(const std::string& path, std::string& why);
// The same for a file that another file names. It can be any file of the machine, and messages and graphs quote it: it
// is read only if its name, with all links followed, has one of the endings.
std::optional<std::string> read_named_text(const std::string& path, std::span<const std::string_view> endings,
                                           std::string& why);

// Why nothing can read the file, whatever its format: "rock.mat:12:1: a merge left a conflict here: ...". Nothing, if
// it is not known.
std::optional<std::string> why_unreadable(const std::string& path);

// The error of an import as a diagnostic, which has the place that the error begins with apart: "rock.mtlx:3:7: ...",
// or "rock.mtlx: ...". `path`: the file that was imported; the place may be in another one.
Diagnostic cannot_import(const std::string& path, std::string_view error);

}  // namespace patina::importers
