#include "compiler/cli/json_text.h"

#include <fmt/format.h>

namespace patina::cli {

std::string json_text(std::string_view text) {
    std::string made = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') made += '\\';
        made += static_cast<unsigned char>(c) < 0x20 ? fmt::format("\\u{:04x}", c) : std::string(1, c);
    }
    return made + '"';
}

}  // namespace patina::cli
