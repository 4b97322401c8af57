#include "compiler/json/json_errors.h"

#include <algorithm>
#include <array>

#include "compiler/base/broken_text.h"
#include "compiler/base/letters.h"
#include "compiler/base/text.h"
#include "compiler/json/json.h"

namespace patina::json {
namespace {

bool is_word_byte(char c) {
    return is_word_letter(c) || c == '.' || c == '+' || c == '-' || c == '$' || c == '@' || c == '#' ||
           static_cast<unsigned char>(c) >= 0x80;
}

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

class Breaker {
public:
    Breaker(std::string_view text, std::uint32_t base, const JsonBreak& at, Diagnostics& diagnostics)
        : text_(text), base_(base), at_(at), diagnostics_(diagnostics) {}

    void report();

private:
    char byte(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }

    // The word that starts at `begin`, or one character.
    std::string_view word(std::size_t begin) const {
        std::size_t end = begin;
        while (end < text_.size() && is_word_byte(text_[end])) ++end;
        if (end == begin) end = std::min(begin + 1, text_.size());
        return text_.substr(begin, end - begin);
    }
    DiagnosticRecord& say(std::size_t begin, std::size_t end, const std::string& words) {
        const auto at = [&](std::size_t i) { return base_ + static_cast<std::uint32_t>(std::min(i, text_.size())); };
        return diagnostics_.report(Code::BadJson, Span{at(begin), at(end)}, words);
    }

    bool ends_here(std::size_t at);
    void bad_value();
    void bad_word(std::size_t begin, std::string_view word);
    void bad_key();
    void missing_colon();
    void missing_comma();
    void bad_escape();
    void open_string();
    void bad_comment();

    std::string_view text_;
    std::uint32_t base_;
    const JsonBreak& at_;
    Diagnostics& diagnostics_;
};

// The commonest break of all: the text stops too early.
bool Breaker::ends_here(std::size_t at) {
    if (at < text_.size()) return false;
    if (!at_.bracket) {
        say(at, at, "the file ends before its first '{'");
        return true;
    }
    const char closing = at_.bracket == '{' ? '}' : ']';
    const std::uint32_t bracket = base_ + static_cast<std::uint32_t>(at_.bracket_offset);
    say(at, at, fmt::format("the file ends before a closing '{}'", closing))
        .note({bracket, bracket + 1}, fmt::format("this '{}' is still open", at_.bracket));
    return true;
}

void Breaker::bad_word(std::size_t begin, std::string_view word) {
    static constexpr std::array<std::string_view, 3> kLiterals = {"true", "false", "null"};
    static constexpr std::array<std::string_view, 6> kNotNumbers = {"NaN", "nan", "Infinity", "infinity", "Inf", "inf"};
    const std::size_t end = begin + word.size();
    std::string_view unsigned_word = word;
    if (!word.empty() && (word[0] == '-' || word[0] == '+')) unsigned_word.remove_prefix(1);
    const std::string text = shown(word);
    if (std::find(kNotNumbers.begin(), kNotNumbers.end(), unsigned_word) != kNotNumbers.end()) {
        say(begin, end, fmt::format("'{}' is not a JSON number: write a finite number", text));
    } else if (!word.empty() && word[0] == '+') {
        say(begin, end, fmt::format("'{}' has a plus sign: leave it out", text));
    } else if (word.starts_with('.') || word.starts_with("-.")) {
        say(begin, end, fmt::format("'{}' needs a digit before its point", text));
    } else if (const std::string_view literal = nearest(word, kLiterals); !literal.empty()) {
        say(begin, end, fmt::format("'{}' is not a value: write {}", text, literal));
    } else {
        say(begin, end, fmt::format("'{}' is not a value: put text in double quotes", text));
    }
}

void Breaker::bad_value() {
    const std::size_t begin = skip_between_tokens(text_, at_.last_end);
    const char c = byte(at_.offset);
    if (at_.offset <= begin && (c == ',' || c == '}' || c == ']')) {
        say(at_.offset, at_.offset + 1, fmt::format("a value is missing before this '{}'", c));
    } else if (at_.offset <= begin && c == ':') {
        say(at_.offset, at_.offset + 1, "a ':' is not allowed here: keys belong in '{ }'");
    } else if (ends_here(begin)) {
        return;
    } else if (byte(begin) == '\'') {
        say(begin, begin + 1, "write a string in double quotes: \"...\"");
    } else if (byte(begin) == '=') {
        say(begin, begin + 1, "write an expression as a string: \"= ...\"");
    } else {
        bad_word(begin, word(begin));
    }
}

void Breaker::bad_key() {
    if (ends_here(at_.offset)) return;
    const char c = byte(at_.offset);
    const std::string_view found = word(at_.offset);
    const std::size_t end = at_.offset + found.size();
    if (c == ',') {
        say(at_.offset, end, "there is an extra ',' here");
    } else if (c == ']') {
        const std::uint32_t bracket = base_ + static_cast<std::uint32_t>(at_.bracket_offset);
        say(at_.offset, end, "a ']' cannot close a '{'").note({bracket, bracket + 1}, "this is the '{'");
    } else if (c == ':') {
        say(at_.offset, end, "a key is missing before this ':'");
    } else {
        say(at_.offset, end, fmt::format("a key in double quotes is needed here, not '{}'", shown(found)));
    }
}

void Breaker::missing_colon() {
    if (ends_here(at_.offset)) return;
    if (byte(at_.offset) == '=') {
        say(at_.offset, at_.offset + 1, "write ':' between a key and its value, not '='");
    } else {
        say(at_.last_begin, at_.last_end, "a ':' and a value are missing after this key");
    }
}

void Breaker::missing_comma() {
    if (ends_here(at_.offset)) return;
    const char c = byte(at_.offset);
    const bool touches = at_.offset == at_.last_end;
    const char last = byte(at_.last_end - 1);
    if (touches && last >= '0' && last <= '9' && is_word_byte(c)) {  // 0x10, 1.2.3, 01, 2px
        const std::string_view found = word(at_.last_begin);
        const bool zero = (last == '0' && at_.last_end - at_.last_begin == 1) && c >= '0' && c <= '9';
        say(at_.last_begin, at_.last_begin + found.size(),
            fmt::format("'{}' is not a JSON number{}", shown(found), zero ? ": leave out the leading zero" : ""));
    } else if (c == '}' || c == ']') {
        const std::uint32_t bracket = base_ + static_cast<std::uint32_t>(at_.bracket_offset);
        say(at_.offset, at_.offset + 1, fmt::format("a '{}' cannot close a '{}'", c, at_.bracket))
            .note({bracket, bracket + 1}, fmt::format("this is the '{}'", at_.bracket));
    } else if (c == ':' && at_.bracket == '[') {
        say(at_.offset, at_.offset + 1, "a ':' is not allowed here: keys belong in '{ }'");
    } else if (c == '"' || c == '{' || c == '[' || is_word_byte(c)) {
        say(at_.last_end, at_.last_end, "a ',' is missing after this value");
    } else {
        const char closing = at_.bracket == '{' ? '}' : ']';
        say(at_.offset, at_.offset + 1, fmt::format("expected ',' or '{}' after a value, not '{}'", closing, c));
    }
}

void Breaker::bad_escape() {
    const char c = byte(at_.offset);
    if (c == '\n' || c == '\r') return open_string();
    if (c != '\\') {
        say(at_.offset, at_.offset + 1,
            fmt::format("write the control character 0x{:02x} as \\u{:04x} in a string", static_cast<unsigned char>(c),
                        static_cast<unsigned char>(c)));
        return;
    }
    const std::string_view escape = text_.substr(at_.offset, 2);
    if (escape.size() == 2 && escape[1] > ' ' && escape[1] < 0x7f) {
        say(at_.offset, at_.offset + 2, fmt::format("there is no escape '{}': write a backslash as '\\\\'", escape));
    } else {
        say(at_.offset, at_.offset + 1, "write a backslash as '\\\\' in a string");
    }
}

void Breaker::open_string() {
    const std::size_t begin = skip_between_tokens(text_, at_.last_end);
    std::size_t end = std::min(text_.find('\n', begin), text_.size());
    if (end > begin && text_[end - 1] == '\r') --end;
    say(begin, end, "the string is not closed: a '\"' is missing");
}

void Breaker::bad_comment() {
    const std::size_t open = text_.rfind("/*", at_.offset);
    if (at_.offset >= text_.size() && open != std::string_view::npos && open >= at_.last_end) {
        const std::size_t begin = text_.find("/*", at_.last_end);
        say(begin, begin + 2, "the comment is not closed: a '*/' is missing");
    } else {
        const std::size_t slash = at_.offset > 0 ? at_.offset - 1 : 0;
        say(slash, slash + 1, "a '/' is not allowed here: a comment starts with '//' or '/*'");
    }
}

void Breaker::report() {
    if (const auto wrong = broken_text(text_); wrong && wrong->offset <= at_.offset) {
        say(wrong->offset, wrong->offset + 7, std::string(wrong->what));
        return;
    }
    const std::size_t token = skip_between_tokens(text_, at_.last_end);
    const std::size_t token_end = token + (token < text_.size() ? word(token).size() : 0);
    const std::string text = token < text_.size() ? shown(word(token)) : std::string();
    switch (at_.code) {
        case rapidjson::kParseErrorNone:
        case rapidjson::kParseErrorTermination: return;  // the builder has spoken
        case rapidjson::kParseErrorDocumentEmpty:
            if (!ends_here(at_.offset)) say(at_.offset, at_.offset + 1, "a graph starts with '{'");
            return;
        case rapidjson::kParseErrorDocumentRootNotSingular:
            say(at_.offset, at_.offset + word(at_.offset).size(), "there is text after the end of the JSON value");
            return;
        case rapidjson::kParseErrorValueInvalid: return bad_value();
        case rapidjson::kParseErrorObjectMissName: return bad_key();
        case rapidjson::kParseErrorObjectMissColon: return missing_colon();
        case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
        case rapidjson::kParseErrorArrayMissCommaOrSquareBracket: return missing_comma();
        case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
            say(at_.offset, at_.offset + 2, "'\\u' needs four hexadecimal digits");
            return;
        case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
            say(at_.offset, at_.offset + 6, "this is half of a surrogate pair without the other half");
            return;
        case rapidjson::kParseErrorStringEscapeInvalid: return bad_escape();
        case rapidjson::kParseErrorStringMissQuotationMark: return open_string();
        case rapidjson::kParseErrorNumberTooBig:
            say(token, token_end, fmt::format("the number '{}' is too large", text));
            return;
        case rapidjson::kParseErrorNumberMissFraction:
            say(token, token_end, fmt::format("'{}' needs a digit after its point", text));
            return;
        case rapidjson::kParseErrorNumberMissExponent:
            say(token, token_end, fmt::format("'{}' needs a digit in its exponent", text));
            return;
        case rapidjson::kParseErrorUnspecificSyntaxError: return bad_comment();
        case rapidjson::kParseErrorStringInvalidEncoding:
            say(at_.offset, at_.offset + 1, "these bytes are not UTF-8");
            return;
    }
}

}  // namespace

void report_json_break(std::string_view text, std::uint32_t base, const JsonBreak& at, Diagnostics& diagnostics) {
    Breaker(text, base, at, diagnostics).report();
}

std::size_t skip_between_tokens(std::string_view text, std::size_t from) {
    std::size_t i = from;
    while (i < text.size()) {
        const char c = text[i];
        if (is_space(c) || c == ',' || c == ':') {
            ++i;
        } else if (text.substr(i, 2) == "//") {
            i = std::min(text.find('\n', i), text.size());
        } else if (text.substr(i, 2) == "/*") {
            const std::size_t close = text.find("*/", i + 2);
            i = close == std::string_view::npos ? text.size() : close + 2;
        } else {
            break;
        }
    }
    return i;
}

}  // namespace patina::json
