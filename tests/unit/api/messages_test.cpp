// Messages as text, at every column of lines of every kind: the caret stands under its character, and whatever numbers
// a diagnostic has, it can be printed.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "patina/diagnostic.h"
#include "patina/patina.h"

namespace patina {
namespace {

// What a line is made of. This table is all that the test knows of widths.
struct Piece {
    std::string_view bytes;
    std::size_t cells;
    std::string_view shown;
};
using Pieces = std::vector<Piece>;
constexpr std::string_view kBad = "\xEF\xBF\xBD";

Piece letter(std::size_t i) {
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789{}[]:,\"";
    const std::string_view one = kLetters.substr(i % kLetters.size(), 1);
    return {one, 1, one};
}
const Piece kWide{"漢", 2, "漢"}, kEmoji{"😀", 2, "😀"}, kKana{"カ", 2, "カ"}, kUmlaut{"ü", 1, "ü"};
const Piece kAccent{"\xCC\x81", 0, "\xCC\x81"}, kJoiner{"\xE2\x80\x8D", 0, "\xE2\x80\x8D"};
const Piece kTab{"\t", 1, " "}, kEscape{"\x1b", 1, " "}, kCsi{"\xC2\x9B", 1, " "}, kReturn{"\r", 1, " "};
const Piece kByte{"\xff", 1, kBad}, kInner{"\x80", 1, kBad}, kHalf{"\xE6", 1, kBad};

// Each kind mixes its pieces with letters, which tell places apart.
const std::vector<std::pair<std::string, Pieces>> kKinds = {
    {"plain", {}},
    {"wide", {kWide, kKana}},
    {"emoji", {kEmoji, kUmlaut}},
    {"combining", {kAccent, kAccent, kAccent, kJoiner}},
    {"tabs and control characters", {kTab, kEscape, kCsi, kReturn}},
    {"bad UTF-8", {kByte, kHalf}},
    {"all", {kWide, kAccent, kTab, kByte, kEmoji, kInner, kCsi}},
};

struct Line {
    std::string bytes, shown;
    std::vector<std::size_t> begin, end;                     // by byte: the cells of its character
    std::vector<std::size_t> shown_at;                       // by cell: where it begins in `shown`, or kInside
    static constexpr std::size_t kInside = std::size_t(-1);  // the second cell of a character
    std::size_t cells() const { return shown_at.size() - 1; }
};

Line line_of(const Pieces& kind, std::size_t cells) {
    Line line;
    std::size_t cell = 0, last = 0;  // `last`: where the character begins that marks combine with
    for (std::size_t i = 0; cell < cells; ++i) {
        Piece piece = kind.empty() || i % 2 == 0 ? letter(i / 2) : kind[i / 2 % kind.size()];
        if (cell + piece.cells > cells) piece = letter(i);
        if (piece.cells > 0) last = cell;
        for (std::size_t k = 0; k < piece.cells; ++k)
            line.shown_at.push_back(k == 0 ? line.shown.size() : Line::kInside);
        line.bytes += piece.bytes;
        line.shown += piece.shown;
        cell += piece.cells;
        line.begin.resize(line.bytes.size(), last);
        line.end.resize(line.bytes.size(), cell);
    }
    line.shown_at.push_back(line.shown.size());
    line.begin.push_back(cell);
    return line;
}

std::vector<std::string> lines_of(std::string text) {
    for (const std::string_view color : {"\x1b[1;32m", "\x1b[1;31m", "\x1b[1m", "\x1b[0m"})
        for (std::size_t at = 0; (at = text.find(color)) != text.npos;) text.erase(at, color.size());
    std::vector<std::string> lines;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

constexpr std::size_t kMostCells = 110;
constexpr std::size_t kMargin = 8;  // "   12 | "

// `end`: the 0-based byte behind the range, on the same line or behind it.
void expect_caret(const Line& line, std::size_t byte, std::size_t end, bool is_on_next_line, bool colors) {
    Diagnostic d;
    d.message = "wrong";
    d.file = "a.graph.json";
    d.line = 12;
    d.end_line = is_on_next_line ? 13 : 12;
    d.column = static_cast<int>(byte) + 1;
    d.end_column = is_on_next_line ? 1 : static_cast<int>(end) + 1;
    d.source_line = line.bytes;
    const std::vector<std::string> lines = lines_of(to_text(d, colors));
    if (line.bytes.empty()) {
        ASSERT_EQ(lines.size(), 1u);
        return;
    }
    ASSERT_EQ(lines.size(), 3u);
    ASSERT_EQ(lines[1].substr(0, kMargin), "   12 | ");
    ASSERT_EQ(lines[2].substr(0, kMargin), "      | ");
    const std::string shown = lines[1].substr(kMargin);
    const std::size_t caret = lines[2].find('^') - kMargin, width = lines[2].size() - kMargin - caret;
    ASSERT_EQ(lines[2].substr(kMargin), std::string(caret, ' ') + "^" + std::string(width - 1, '~'));
    // The shown part lies in the line so that the caret is at the cell of the byte.
    const std::size_t cell = line.begin[byte];
    ASSERT_LE(caret, cell);
    const std::size_t first = cell - caret;
    ASSERT_NE(line.shown_at[first], Line::kInside);
    ASSERT_EQ(line.shown.substr(line.shown_at[first], shown.size()), shown);
    const auto last = static_cast<std::size_t>(
        std::find(line.shown_at.begin(), line.shown_at.end(), line.shown_at[first] + shown.size()) -
        line.shown_at.begin());
    ASSERT_LE(last, line.cells());
    ASSERT_LE(last - first, kMostCells);
    ASSERT_GE(last, cell);
    if (line.cells() < kMostCells) {
        ASSERT_EQ(shown, line.shown);
    }
    // The character itself is seen, and most of what is around it.
    if (byte < line.bytes.size()) {
        ASSERT_GE(last, line.end[byte]);
    }
    const std::size_t to = is_on_next_line ? line.cells() : end == 0 ? 0 : line.end[end - 1];
    ASSERT_EQ(width, std::max<std::size_t>(std::min(to, last) - std::min({to, last, cell}), 1));
    ASSERT_LE(caret + width, kMostCells);
}

TEST(Messages, CaretStandsUnderItsColumn) {
    std::size_t turn = 0;
    for (const auto& [name, pieces] : kKinds) {
        for (std::size_t cells = 0; cells <= 400; ++cells) {
            const Line line = line_of(pieces, cells);
            for (std::size_t byte = 0; byte <= line.bytes.size(); ++byte) {
                const std::size_t left = line.bytes.size() - byte;
                const std::size_t ends[] = {byte, byte + std::min<std::size_t>(left, 1 + turn % 150),
                                            line.bytes.size()};
                ++turn;
                expect_caret(line, byte, ends[turn % 3], turn % 7 == 0, turn % 2 == 0);
                if (!HasFatalFailure()) continue;
                FAIL() << name << ", " << cells << " cells, byte " << byte;
            }
        }
    }
}

// A long line is cut into pieces before it is shown: nothing of a character is left out, or shown as bytes.
TEST(Messages, LongLinesAreCutBetweenCharacters) {
    for (const Piece& piece : {kWide, kEmoji, kUmlaut, kAccent}) {
        for (std::size_t before = 0; before < 5; ++before) {
            std::string text(before, '-');
            for (int i = 0; i < 3000; ++i) text += piece.bytes;
            for (std::size_t at = before; at < text.size(); at += 97 * piece.bytes.size()) {
                Diagnostic d;
                d.line = d.end_line = 1;
                d.column = d.end_column = static_cast<int>(at) + 1;
                d.source_line = text;
                ASSERT_EQ(to_text(d).find(kBad), std::string::npos) << at;
            }
        }
    }
}

TEST(Messages, EveryNumberCanBePrinted) {
    constexpr int kLeast = std::numeric_limits<int>::min(), kMost = std::numeric_limits<int>::max();
    const int numbers[] = {kLeast, kLeast + 1, -1, 0, 1, 2, 5, 6, 7, 109, 110, 111, 200, 441, kMost - 1, kMost};
    const std::string lines[] = {"", "a", "hello", std::string(110, 'x'), std::string(1000, '\x80'), "\xff\xfe\n\0"};
    for (const std::string& line : lines) {
        for (const int number : {kLeast, 0, 3, kMost}) {
            for (const int column : numbers) {
                for (const int end_line : {kLeast, 0, 2, 3, 4, kMost}) {
                    for (const int end_column : numbers) {
                        Diagnostic d;
                        d.severity = static_cast<Severity>(end_column & 3);
                        d.line = number;
                        d.column = column;
                        d.end_line = end_line;
                        d.end_column = end_column;
                        d.source_line = line;
                        ASSERT_NO_THROW({ ASSERT_LT(to_text(d, column % 2 == 0).size(), 5000u); });
                        ASSERT_NO_THROW(to_json(d));
                    }
                }
            }
        }
    }
}

// A name that a file gives cannot move the terminal's cursor, or change its title.
TEST(Messages, TerminalsObeyNothingInThem) {
    Diagnostic d;
    d.message =
        "there is no node '\x1b]0;title\x07\xC2\x9B"
        "2J'\nsecond\tline";
    d.file = "a\x1b[2J.json";
    d.node = "n\r";
    d.port = "p\x7f\xff";
    d.code = "unknown-node";
    d.line = d.column = 1;
    d.source_line =
        "\"\x1b[2J\xC2\x9B"
        "2J\"";
    const std::string text = to_text(d);
    for (const std::string_view bad : {"\x1b", "\x07", "\r", "\x7f", "\xff", "\xC2\x9B"})
        EXPECT_EQ(text.find(bad), text.npos) << text;
    EXPECT_NE(text.find("\nsecond\tline"), text.npos);
}

// The comma that is missing is missed at the end of the line before, whatever its length.
TEST(Messages, ForgottenCommaOfALongLine) {
    const Compiler compiler;
    for (int length = 0; length <= 400; length += length < 150 ? 1 : 25) {
        const std::string line =
            "{ \"id\": \"mask\", \"expr\": \"1\", \"note\": \"" + std::string(length, 'x') + "\" }";
        for (const std::string rest : {"\n{ \"id\": \"b\", \"expr\": \"mask * 2\" } ] }", ""}) {
            const std::string text = "{ \"patina\": 1, \"workflow\": \"unlit\", \"nodes\": [\n" + line + rest;
            const Result result = compiler.compile_text("long.graph.json", text);
            ASSERT_FALSE(result.ok);
            ASSERT_FALSE(result.diagnostics.empty());
            ASSERT_NE(to_text(result.diagnostics[0]).find('^'), std::string::npos);
            ASSERT_EQ(result.diagnostics[0].line, 2);
        }
    }
}

}  // namespace
}  // namespace patina
