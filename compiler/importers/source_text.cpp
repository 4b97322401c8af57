#include "compiler/importers/source_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "compiler/base/broken_text.h"
#include "compiler/base/disk/disk.h"
#include "patina/complaints.h"

namespace patina::importers {
namespace {

// The number at the end of the text, behind a colon, both of which it takes away; 0: there is none.
int take_number(std::string_view& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == text.npos) return 0;
    int number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, wrong] = std::from_chars(text.data() + colon + 1, end, number);
    if (wrong != std::errc() || stop != end || number < 1) return 0;
    text = text.substr(0, colon);
    return number;
}

// Where an error is, and how long it says that: "rock.mtlx:3:7: ".
struct Place {
    std::string file{};
    int line = 0, column = 0;
    std::size_t length = 0;
};

// A quoted name may look like a place, so the file must be there.
Place place_of(const std::string& path, std::string_view error) {
    for (std::size_t at = error.find(": "); at != error.npos; at = error.find(": ", at + 1)) {
        std::string_view file = error.substr(0, at);
        const int column = take_number(file), line = column > 0 ? take_number(file) : 0;
        if (line > 0 && (file == path || is_on_disk(std::string(file))))
            return {.file = std::string(file), .line = line, .column = column, .length = at + 2};
    }
    if (error.starts_with(path + ": ")) return {.file = path, .length = path.size() + 2};
    return {};
}

}  // namespace

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

std::optional<std::string> read_text(const std::string& path, std::string& why) {
    DiskFile file = read_disk(path, kMostTextBytes);
    if (!file.bytes)
        why = file.why.empty() ? fmt::format("there is no file '{}'", path)
                               : fmt::format("cannot read '{}': {}", path, file.why);
    return std::move(file.bytes);
}

std::optional<std::string> read_named_text(const std::string& path, std::span<const std::string_view> endings,
                                           std::string& why) {
    std::optional<std::string> text = read_text(path, why);
    const std::string real = text ? without_links(path) : std::string();
    const auto fits = [&](std::string_view ending) { return real.ends_with(ending); };
    if (!text || std::ranges::any_of(endings, fits)) return text;
    why = fmt::format("cannot read '{}': its name has none of the endings {}", path, fmt::join(endings, ", "));
    return {};
}

std::optional<std::string> why_unreadable(const std::string& path) {
    std::string unread;
    const std::optional<std::string> text = read_text(path, unread);
    const std::optional<BrokenText> wrong = text ? broken_text(*text) : std::nullopt;
    if (!wrong) return std::nullopt;
    return fmt::format("{}:{}:1: {}", path, wrong->line, wrong->what);
}

Diagnostic cannot_import(const std::string& path, std::string_view error) {
    const Place place = place_of(path, error);
    Diagnostic made = complaint(Complaint::CannotImport, {printable(error.substr(place.length))});
    made.file = place.file;
    made.line = place.line;
    made.column = place.column;
    return made;
}

}  // namespace patina::importers
