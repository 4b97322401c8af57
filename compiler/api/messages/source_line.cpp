#include "compiler/api/messages/source_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "compiler/api/messages/char_width.h"
#include "compiler/base/broken_text.h"
#include "compiler/base/text.h"

namespace patina {
namespace {

// Of a longer line (a whole graph on one), only the part around the place is shown: so many cells.
constexpr std::size_t kShown = 110;

bool is_inner_byte(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u;
}

char32_t decoded(std::string_view character) {
    char32_t made = static_cast<unsigned char>(character[0]);
    if (character.size() > 1) made &= 0x7fu >> character.size();
    for (const char byte : character.substr(1)) made = made << 6 | (static_cast<unsigned char>(byte) & 0x3Fu);
    return made;
}

// The control characters of ASCII, and those of ISO 6429 with codes of their own: terminals execute them.
bool is_control(char32_t character) {
    return character < 0x20 || (character >= 0x7f && character < 0xa0);
}

// A character with its combining characters: the content of one or two cells.
struct Glyph {
    std::string text{};
    std::size_t begin = 0, end = 0;  // cells
};

// A line as a terminal shows it: a blank for each control character, and U+FFFD for each byte that is not UTF-8.
class ShownLine {
public:
    explicit ShownLine(std::string_view line) {
        for (std::size_t at = 0; at < line.size();) {
            std::size_t length = 1, bad = 0;
            while (at + length < line.size() && length < 4 && is_inner_byte(line[at + length])) ++length;
            const bool is_good = is_utf8(line.substr(at, length), bad);
            // What follows the first wrong byte can be right.
            if (!is_good) length = std::max<std::size_t>(bad, 1);
            const std::string_view character = line.substr(at, length);
            if (!is_good && bad == 0)
                add("\xEF\xBF\xBD", 1, 1);
            else if (is_control(decoded(character)))
                add(" ", length, 1);
            else
                add(character, length, cells_of(decoded(character)));
            at += length;
        }
    }

    const std::vector<Glyph>& glyphs() const { return glyphs_; }
    std::size_t cells() const { return glyphs_.empty() ? 0 : glyphs_.back().end; }
    // The cell at which the character of this byte begins; behind the last byte: the end of the line.
    std::size_t begin_at(std::size_t byte) const {
        return byte < glyph_of_byte_.size() ? glyphs_[glyph_of_byte_[byte]].begin : cells();
    }
    // The cell at which the last character before this byte ends.
    std::size_t end_before(std::size_t byte) const {
        if (byte == 0) return 0;
        return byte <= glyph_of_byte_.size() ? glyphs_[glyph_of_byte_[byte - 1]].end : cells();
    }

private:
    void add(std::string_view character, std::size_t bytes, std::size_t width) {
        if (width > 0 || glyphs_.empty()) glyphs_.push_back({.begin = cells(), .end = cells() + width});
        glyphs_.back().text += character;
        glyph_of_byte_.insert(glyph_of_byte_.end(), bytes, glyphs_.size() - 1);
    }

    std::vector<Glyph> glyphs_{};
    std::vector<std::size_t> glyph_of_byte_{};
};

}  // namespace

std::string printable(std::string_view text) {
    std::string made = as_utf8(text);
    // U+0080 to U+009F are 0xC2 and one byte of the same value.
    for (std::size_t i = 0; i < made.size(); ++i) {
        const auto byte = static_cast<unsigned char>(made[i]);
        const bool is_c1 = byte == 0xC2 && is_control(decoded(std::string_view(made).substr(i, 2)));
        if (is_c1 || (is_control(byte) && byte < 0x80 && byte != '\n' && byte != '\t'))
            made.replace(i, is_c1 ? 2 : 1, "\xEF\xBF\xBD");
    }
    return made;
}

void show_source(std::string& text, const Diagnostic& d, bool colors) {
    if (d.source_line.empty() || d.column < 1) return;
    const std::size_t size = d.source_line.size();
    const std::size_t place = std::min(static_cast<std::size_t>(d.column) - 1, size);
    // Behind the last byte of the range.
    const std::size_t end =
        d.end_line > d.line ? size : std::clamp(static_cast<std::size_t>(std::max(d.end_column, 1)) - 1, place, size);
    // Cuts out a part that contains all shown characters, however long the line is.
    constexpr std::size_t kBytes = 4 * kShown;
    std::size_t cut = place - std::min(place, kBytes), rest = std::min(place + kBytes, size);
    for (int i = 0; i < 3 && cut < place && is_inner_byte(d.source_line[cut]); ++i) ++cut;
    for (int i = 0; i < 3 && rest > place && rest < size && is_inner_byte(d.source_line[rest]); ++i) --rest;
    const ShownLine line(std::string_view(d.source_line).substr(cut, rest - cut));
    const std::size_t from = line.begin_at(place - cut), to = line.end_before(end - cut);
    // The place may be the cell behind the last character: then that one is a part of the line.
    const std::size_t extent = std::max(line.cells(), from + 1);
    std::size_t first = from > kShown * 3 / 4 ? from - kShown / 2 : 0;
    first = std::min(first, extent - std::min(extent, kShown));
    std::string shown;
    std::size_t begin = from, last = from;  // number of cells that are shown
    for (const Glyph& glyph : line.glyphs()) {
        if (glyph.begin < first || glyph.end > first + kShown) continue;
        begin = std::min(begin, glyph.begin);
        last = glyph.end;
        shown += glyph.text;
    }
    const std::size_t width = std::max<std::size_t>(std::min(to, last) - std::min({to, last, from}), 1);
    text += fmt::format("{:>5} | {}\n", d.line, shown);
    text += fmt::format("{:>5} | {}{}^{}{}\n", "", std::string(from - begin, ' '), colors ? "\x1b[1;32m" : "",
                        std::string(width - 1, '~'), colors ? "\x1b[0m" : "");
}

}  // namespace patina
