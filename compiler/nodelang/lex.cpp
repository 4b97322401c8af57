#include "compiler/nodelang/lex.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "compiler/base/cancellation.h"
#include "compiler/base/letters.h"
#include "compiler/base/text.h"

namespace patina::nodelang {
namespace {

constexpr std::string_view kNoBreakSpace = "\xc2\xa0";
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// 3 or 2 if the characters are one operator, 1 if the first is an operator alone, 0 if it is not an operator.
constexpr std::size_t punctuation_length(char first, char second, char third) {
    constexpr std::string_view kDoubled = "<>=&|+-", kBeforeEquals = "<>!+-*/%&|^", kAlone = "+-*/%<>=!&|^~?:;,.()[]{}";
    if (kAlone.find(first) == std::string_view::npos) return 0;
    if (second == first && (first == '<' || first == '>') && third == '=') return 3;
    if (second == first && kDoubled.find(first) != std::string_view::npos) return 2;
    return second == '=' && kBeforeEquals.find(first) != std::string_view::npos ? 2 : 1;
}

constexpr bool is_hex_digit(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}
constexpr bool is_space(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

// The number of bytes in the UTF-8 sequence that begins with `first`.
constexpr std::size_t sequence_length(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte >= 0xf0 ? 4 : byte >= 0xe0 ? 3 : byte >= 0xc0 ? 2 : 1;
}

// A literal without its sign: digits, then a suffix. False if it is malformed or too large.
bool read_number(std::string_view literal, bool is_hlsl, Token& token) {
    const bool is_hex = literal.starts_with("0x") || literal.starts_with("0X");
    std::string_view digits = literal;
    char suffix = '\0';
    const char last = literal.back();
    const bool has_suffix = is_hex ? last == 'u' || last == 'U' : is_word_start(last) || last == '_';
    if (has_suffix) {
        suffix = static_cast<char>(last | 0x20);
        digits.remove_suffix(1);
    }
    if (is_hex) {
        const char* end = digits.data() + digits.size();
        std::uint32_t value = 0;
        const auto [stop, error] = std::from_chars(digits.data() + 2, end, value, 16);
        if (error != std::errc() || stop != end) return false;
        token.number = value;
        // As in HLSL and GLSL: a hexadecimal that does not fit in an int is a uint.
        token.number_kind = suffix == 'u' || value > 0x7fffffffu ? NumberKind::Uint : NumberKind::Int;
        return true;
    }
    const std::optional<double> number = patina::read_number(digits);
    if (!number) return false;
    token.number = *number;
    if (!std::isfinite(token.number)) return false;
    const bool is_whole = digits.find_first_not_of("0123456789") == std::string_view::npos;
    switch (suffix) {
        case '\0': token.number_kind = is_whole ? NumberKind::Int : NumberKind::Float; break;
        case 'u': token.number_kind = NumberKind::Uint; break;
        case 'f': token.number_kind = NumberKind::Float; break;
        case 'h': token.number_kind = NumberKind::Half; break;
        case 'l':
            if (!is_hlsl) return false;
            token.number_kind = is_whole ? NumberKind::Int : NumberKind::Float;
            break;
        default: return false;
    }
    if (suffix == 'u' && (!is_whole || token.number > 4294967295.0)) return false;
    // 010 is eight in C, but ten to most readers, so it is refused.
    return !(is_whole && digits.size() > 1 && digits.front() == '0');
}

}  // namespace

Lexer::Lexer(Text text, Dialect dialect, Diagnostics& diagnostics)
    : text_(text), dialect_(dialect), diagnostics_(&diagnostics) {
    if (dialect != Dialect::Graph && looking_at(kByteOrderMark)) here_ = kByteOrderMark.size();
}

Token Lexer::next() {
    Cancellation::step();
    Token token;
    const std::size_t before = here_;
    skip_space(token);
    token.begin = here_;
    token.follows_space = here_ > before;
    const char c = at(here_);
    if (here_ >= text_.text.size()) {
        token.kind = Token::Kind::End;
    } else if (is_word_start(c)) {
        word(token);
    } else if (is_digit(c) || (c == '.' && is_digit(at(here_ + 1)))) {
        number(token);
    } else if (c == '"') {
        string(token);
    } else if ((c == '$' || c == '@') && is_word_start(at(here_ + 1))) {
        graph_name(token);
    } else {
        punctuation(token);
    }
    token.end = here_;
    return token;
}

std::size_t Lexer::end_of_word(std::size_t from) const {
    while (is_word_letter(at(from))) ++from;
    return from;
}

// --- comments and white space

void Lexer::skip_space(Token& token) {
    bool same_line_as_token = here_ > 0;
    token.begins_line = here_ == 0;
    int newlines = 0;           // since the last comment
    bool in_doc_block = false;  // the last thing was a /// line
    while (here_ < text_.text.size()) {
        if (is_space(at(here_))) {
            if (at(here_) == '\n') {
                same_line_as_token = false;
                token.begins_line = true;
                ++newlines;
            }
            ++here_;
        } else if (dialect_ == Dialect::Hlsl && (looking_at("\\\n") || looking_at("\\\r\n"))) {
            here_ += at(here_ + 1) == '\n' ? 2 : 3;  // the line goes on
        } else if (looking_at(kNoBreakSpace)) {
            here_ += kNoBreakSpace.size();
        } else if (looking_at("//")) {
            const bool is_doc = looking_at("///") && !looking_at("////") && !looking_at("///<");
            // A blank line or another comment between two blocks: only the nearer one describes what follows.
            if (is_doc && !(in_doc_block && newlines <= 1)) token.doc = {};
            line_comment(token, same_line_as_token);
            in_doc_block = is_doc;
            newlines = 0;
        } else if (looking_at("/*")) {
            skip_block_comment();
            in_doc_block = false;
            newlines = 0;
        } else {
            return;
        }
    }
}

void Lexer::skip_block_comment() {
    const std::size_t close = text_.text.find("*/", here_ + 2);
    if (close == std::string_view::npos) {
        diagnostics_->report(Code::Syntax, span(here_, here_ + 2), "'*/' after this", "the end of the text");
        here_ = text_.text.size();
        return;
    }
    here_ = close + 2;
}

void Lexer::line_comment(Token& token, bool same_line_as_token) {
    const std::size_t begin = here_;
    here_ = std::min(text_.text.find('\n', begin), text_.text.size());
    std::string_view line = text_.text.substr(begin, here_ - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with("///<")) {
        if (same_line_as_token) token.trailing_doc = trimmed(line.substr(4), " \t\r");
    } else if (line.starts_with("///") && !line.starts_with("////")) {
        const std::size_t doc_begin =
            token.doc.empty() ? begin : static_cast<std::size_t>(token.doc.data() - text_.text.data());
        token.doc = text_.text.substr(doc_begin, begin + line.size() - doc_begin);
    }
}

// --- tokens

void Lexer::word(Token& token) {
    const std::size_t begin = here_;
    here_ = end_of_word(begin);
    token.kind = Token::Kind::Word;
    token.text = text_.text.substr(begin, here_ - begin);
}

void Lexer::number(Token& token) {
    const std::size_t begin = here_;
    const bool is_hex = at(begin) == '0' && (at(begin + 1) == 'x' || at(begin + 1) == 'X');
    std::size_t end = begin;
    if (is_hex) {
        end += 2;
        while (is_hex_digit(at(end))) ++end;
    } else {
        while (is_digit(at(end))) ++end;
        if (at(end) == '.') {
            ++end;
            while (is_digit(at(end))) ++end;
        }
        const bool has_exponent = at(end) == 'e' || at(end) == 'E';
        if (has_exponent && (at(end + 1) == '+' || at(end + 1) == '-')) end += 2;
    }
    // A word directly after the digits belongs to the literal: a suffix, an exponent or an error.
    here_ = end_of_word(end);
    token.text = text_.text.substr(begin, here_ - begin);
    token.kind = Token::Kind::Number;
    if (read_number(token.text, dialect_ == Dialect::Hlsl, token)) return;
    token.kind = Token::Kind::Bad;
    if (std::isinf(token.number)) {
        diagnostics_->report(Code::BadNumber, span(begin, here_), token.text, "32-bit float");
    } else {
        diagnostics_->report(Code::BadLiteral, span(begin, here_), token.text);
    }
}

void Lexer::string(Token& token) {
    const std::size_t begin = here_ + 1;
    const std::size_t end = text_.text.find_first_of("\"\n", begin);
    if (end == std::string_view::npos || text_.text[end] == '\n') {
        token.kind = Token::Kind::Bad;
        diagnostics_->report(Code::Syntax, span(here_, begin), "another '\"' after this", "the end of the line");
        here_ = std::min(end, text_.text.size());
        return;
    }
    token.kind = Token::Kind::String;
    token.text = text_.text.substr(begin, end - begin);
    here_ = end + 1;
}

void Lexer::graph_name(Token& token) {
    const std::size_t begin = here_;
    here_ = end_of_word(begin + 1);
    const bool is_property = at(begin) == '$';
    token.kind = is_property ? Token::Kind::Property : Token::Kind::Semantic;
    token.text = text_.text.substr(begin + 1, here_ - begin - 1);
    if (dialect_ == Dialect::Graph) return;
    token.kind = Token::Kind::Bad;
    diagnostics_
        ->report(Code::BadCharacter, span(begin, here_), fmt::format("'{}'", text_.text.substr(begin, here_ - begin)))
        .note(is_property
                  ? "only a graph reads properties: give the function a parameter"
                  : fmt::format(
                        "only a graph writes a semantic with @: give the function a parameter with the default '{}'",
                        token.text));
}

void Lexer::punctuation(Token& token) {
    std::size_t length = punctuation_length(at(here_), at(here_ + 1), at(here_ + 2));
    if (dialect_ == Dialect::Hlsl && at(here_) == '#') length = at(here_ + 1) == '#' ? 2 : 1;
    if (length == 0) return bad_character(token);
    token.kind = Token::Kind::Punctuation;
    token.text = text_.text.substr(here_, length);
    here_ += length;
}

void Lexer::bad_character(Token& token) {
    const std::size_t begin = here_;
    const char c = at(begin);
    here_ = std::min(begin + sequence_length(c), text_.text.size());
    const bool is_color = c == '#' && dialect_ == Dialect::Graph && is_hex_digit(at(here_));
    while (is_color && is_hex_digit(at(here_))) ++here_;
    token.kind = Token::Kind::Bad;
    token.text = text_.text.substr(begin, here_ - begin);
    const auto byte = static_cast<unsigned char>(c);
    const bool is_printable = (byte > 0x20 && byte < 0x7f) || token.text.size() > 1;
    const std::string what =
        is_printable ? fmt::format("'{}'", token.text) : fmt::format("the character 0x{:02x}", unsigned{byte});
    DiagnosticRecord& record = diagnostics_->report(Code::BadCharacter, span(begin, here_), what);
    if (is_color)
        record.note(
            "an expression cannot contain a colour: read one by its name, of a property or of a value of `patina "
            "eval`");
    else if (c == '#' && dialect_ == Dialect::File)
        record.note(
            "there is no preprocessor: write a constant as 'const float NAME = 1;', or let the file begin with "
            "'#pragma hlsl'");
    if (c == '$' || c == '@') record.note(fmt::format("'{}' begins a name: put the name directly after it", c));
}

}  // namespace patina::nodelang
