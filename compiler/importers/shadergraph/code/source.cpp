#include "compiler/importers/shadergraph/code/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "compiler/importers/shadergraph/code/engine_words.h"
#include "compiler/nodelang/hlsl/preprocessor.h"

namespace patina::importers::shadergraph {
namespace {

using nodelang::Token;

// A line of the author in a message.
constexpr std::size_t kLongestLine = 80;

bool is_of_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

int count_lines(std::string_view text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

// A number as the node language writes it: in the precision of the node.
std::string number(std::string_view text) {
    std::string made(text);
    if (made.starts_with("0x") || made.starts_with("0X")) return made;
    const bool is_real = made.find_first_of("fFhH") != made.npos;
    while (std::string_view("fFhHlL").find(made.back()) != std::string_view::npos) made.pop_back();
    if (is_real && made.find_first_of(".eE") == made.npos) made += ".";
    if (made.ends_with(".")) made += "0";
    return made;
}

// A function for each precision has its own name in the engine.
std::string_view word(std::string_view text) {
    for (const std::string_view ending : {"_float", "_half"})
        if (text.size() > ending.size() && text.ends_with(ending)) text.remove_suffix(ending.size());
    return text;
}

std::string written(const Token& token) {
    if (token.kind == Token::Kind::Number) return number(token.text);
    if (token.kind == Token::Kind::String) return fmt::format("\"{}\"", token.text);
    return std::string(token.kind == Token::Kind::Word ? word(token.text) : token.text);
}

// Without a space, they would be other tokens.
bool would_join(char last, char next) {
    if (is_of_word(last) && is_of_word(next)) return true;
    return std::string_view("+-&|<>=!*/%^").find(last) != std::string_view::npos && (next == last || next == '=');
}

// Behind `at`, if the engine's textures and samplers are no structs: "t.tex" is t, "s.samplerstate" is s.
std::size_t behind_member(const std::vector<Token>& tokens, std::size_t at,
                          const std::set<std::string, std::less<>>& samplers) {
    if (at == 0 || at + 1 >= tokens.size() || !tokens[at].is(".")) return at;
    const bool is_left_out = tokens[at + 1].is_word("tex") ||
                             (tokens[at + 1].is_word("samplerstate") && samplers.contains(tokens[at - 1].text));
    return is_left_out ? at + 2 : at;
}

}  // namespace

bool is_no_hlsl(Code code) {
    return info(code).severity == Level::Error && code != Code::NotYet && code != Code::BadAttribute;
}

Source::Source(std::string code, std::string_view head, std::set<std::string, std::less<>> samplers)
    : code_(std::move(code)), lines_before_(count_lines(kEngineWords)) {
    for (std::size_t at = 0; (at = code_.find("$precision", at)) != code_.npos;) code_.replace(at, 10, "float");
    preprocess(std::move(samplers));
    if (error_.empty()) parse(head);
}

void Source::preprocess(std::set<std::string, std::less<>> samplers) {
    const std::string whole = std::string(kEngineWords) + code_;
    nodelang::Ast names;
    Diagnostics wrong;
    nodelang::Lexer lexer({.text = whole, .base = kBase}, nodelang::Lexer::Dialect::Hlsl, wrong);
    nodelang::Preprocessor preprocessor(lexer, names, wrong);
    for (const std::string_view preview : {"SHADERGRAPH_PREVIEW", "SHADERGRAPH_PREVIEW_MAIN"})
        preprocessor.make_zero(preview);
    std::vector<Token> tokens;
    for (Token token = preprocessor.next(); token.kind != Token::Kind::End; token = preprocessor.next()) {
        if (!tokens.empty() && tokens.back().is_word("SamplerState")) samplers.emplace(token.text);
        tokens.push_back(token);
    }
    // A character that is not allowed matters only if the parser meets it.
    for (const DiagnosticRecord& each : wrong.records())
        if (each.code != Code::BadCharacter && each.code != Code::BadLiteral && each.code != Code::BadNumber) {
            const std::size_t at = std::min<std::size_t>(each.span.begin - kBase, whole.size());
            error_ = at_line(count_lines(std::string_view(whole).substr(0, at)) + 1 - lines_before_, each.message);
            return;
        }

    text_ = nodelang::kHlslMark;
    std::size_t counted = 0;
    const auto go_to_line_of = [&](std::size_t offset) {
        if (offset <= counted) return false;
        const int lines = count_lines(std::string_view(whole).substr(counted, offset - counted));
        text_.append(static_cast<std::size_t>(lines), '\n');
        counted = offset;
        return lines > 0;
    };
    const auto begin_code = [&] {
        go_to_line_of(kEngineWords.size());
        begin_ = text_.size();
    };
    for (std::size_t i = 0; (i = behind_member(tokens, i, samplers)) < tokens.size(); ++i) {
        const Token& token = tokens[i];
        if (begin_ == 0 && token.begin >= kEngineWords.size()) begin_code();
        const bool is_member = i > 0 && tokens[i - 1].is(".");
        const std::string text = is_member && token.is_word("samplerstate") ? "sampler" : written(token);
        const bool begins_line = token.begins_line && go_to_line_of(token.begin);
        if (!begins_line && (token.follows_space || would_join(text_.back(), text[0]))) text_ += ' ';
        text_ += text;
    }
    if (begin_ == 0) begin_code();
}

void Source::parse(std::string_view head) {
    if (!head.empty()) text_.insert(begin_, fmt::format("{} {{", head)).append("}");
    Diagnostics wrong;
    nodelang::parse_file({.text = text_, .base = kBase}, ast_, wrong);
    const auto at = [&](std::uint32_t offset, std::string_view message) {
        mistake_ = at_line(line_of(std::string_view(text_).substr(offset - kBase)), message);
    };
    for (const DiagnosticRecord& each : wrong.records())
        if (is_no_hlsl(each.code)) return at(each.span.begin, each.message);
    if (head.empty()) return;
    const auto main =
        std::ranges::find_if(ast_.functions, [&](const nodelang::FunctionDecl& each) { return is_own(each.span); });
    const std::uint32_t end = main->span.end;
    if (end - kBase < text_.size()) at(end, "a '}' closes nothing");
}

const nodelang::FunctionDecl* Source::function(std::string_view name) const {
    const nodelang::FunctionDecl* found = nullptr;
    for (const nodelang::FunctionDecl& each : ast_.functions)
        if (each.name == name && (!found || (is_own(each.span) && !is_own(found->span)))) found = &each;
    return found;
}

std::string_view Source::text(Span span) const {
    return std::string_view(text_).substr(span.begin - kBase, span.end - span.begin);
}

std::string_view Source::body(const nodelang::FunctionDecl& function) const {
    const std::string_view whole = text({function.name_span.end, function.span.end});
    const std::size_t open = whole.find('{');
    return whole.substr(open + 1, whole.size() - open - 2);
}

int Source::line_of(std::string_view part) const {
    const auto offset = static_cast<std::size_t>(part.data() - text_.data());
    return count_lines(std::string_view(text_).substr(0, offset)) + 1 - lines_before_;
}

std::string Source::at_line(int number, std::string_view message) const {
    return fmt::format("line {} of its code: {}{}", number, message, quoted(number));
}

std::string Source::quoted(int number) const {
    std::string_view rest = code_;
    for (int i = 1; i < number; ++i) rest.remove_prefix(std::min(rest.find('\n'), rest.size() - 1) + 1);
    rest = rest.substr(0, rest.find('\n'));
    constexpr std::string_view kSpaces = " \t\r";
    const std::size_t first = rest.find_first_not_of(kSpaces);
    if (number < 1 || first == rest.npos) return {};
    rest = rest.substr(first, rest.find_last_not_of(kSpaces) + 1 - first);
    return fmt::format(", in '{}'", rest.substr(0, kLongestLine));
}

bool Source::is_constant(const nodelang::VariableDecl& variable) const {
    std::string_view before = std::string_view(text_).substr(0, variable.type.span.begin - kBase);
    before.remove_prefix(before.find_last_of(";}") + 1);
    return variable.value && (variable.is_const || before.find("static") != before.npos);
}

}  // namespace patina::importers::shadergraph
