#include "compiler/importers/source_text.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "compiler/base/broken_text.h"

namespace patina::importers {

std::string printable(std::string_view text) {
    std::string made;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0u;
        const bool is_separator = text.substr(i, 3) == "\u2028" || text.substr(i, 3) == "\u2029";
        if (byte == '\n') {
            made += "\\n";
        } else if (byte == '\r') {
            made += "\\r";
        } else if (byte == '\t') {
            made += ' ';
        } else if (byte < 0x20 || byte == 0x7f) {
            made += fmt::format("\\x{:02x}", byte);
        } else if (byte == 0xc2 && next >= 0x80 && next < 0xa0) {
            made += fmt::format("\\x{:02x}", next);
            ++i;
        } else if (is_separator) {
            made += text[i + 2] == '\xa8' ? "\\u2028" : "\\u2029";
            i += 2;
        } else {
            made += text[i];
        }
    }
    return made;
}

std::optional<std::string> why_unreadable(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::optional<BrokenText> wrong = broken_text(text);
    if (!wrong) return std::nullopt;
    return fmt::format("{}:{}:1: {}", path, wrong->line, wrong->what);
}

}  // namespace patina::importers
