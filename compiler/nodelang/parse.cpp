// The entry points of the parser, its access to tokens, and its recovery after an error.
#include "compiler/nodelang/parse.h"

#include <algorithm>

#include "compiler/base/cancellation.h"
#include "compiler/base/text.h"
#include "compiler/nodelang/parser.h"

namespace patina::nodelang {
namespace {

// Names that a declaration cannot have. A graph may name its nodes so; there these are ordinary words.
constexpr std::string_view kReserved[] = {"break",  "const",  "continue", "discardIf", "do",  "else",
                                          "enum",   "false",  "for",      "if",        "out", "return",
                                          "struct", "switch", "true",     "while"};

bool is_too_large(Text text, Diagnostics& diagnostics) {
    if (text.text.size() <= kMaxTextBytes) return false;
    diagnostics.report(Code::TooLarge, {text.at(0), text.at(0)}, text.text.size(), kMaxTextBytes);
    return true;
}

bool has_hlsl_mark(Text text) {
    Diagnostics unread;
    Lexer lexer(text, Lexer::Dialect::Hlsl, unread);
    return lexer.next().is("#") && lexer.next().is_word("pragma") && lexer.next().is_word("hlsl");
}

}  // namespace

void parse_file(Text text, Ast& ast, Diagnostics& diagnostics, Bodies bodies) {
    if (is_too_large(text, diagnostics)) return;
    // Comments become documentation, so they must be text too.
    if (std::size_t bad = 0; !is_utf8(text.text, bad)) {
        const auto byte = static_cast<unsigned char>(text.text[bad]);
        diagnostics.report(Code::NotUtf8, {text.at(bad), text.at(bad + 1)}, bad + 1, unsigned{byte});
        return;
    }
    const bool is_hlsl = has_hlsl_mark(text);
    Parser(text, is_hlsl ? Lexer::Dialect::Hlsl : Lexer::Dialect::File, ast, diagnostics,
           is_hlsl ? Bodies::Now : bodies)
        .file();
}

namespace {

const ReadBody& read_body(const UnreadBody& body) {
    return body.read.get([&] {
        const Cancellation nobody;
        auto read = std::make_unique<ReadBody>();
        Parser(body.text, Lexer::Dialect::File, read->ast, read->diagnostics).function_body(read->statements);
        return read;
    });
}

}  // namespace

const Statements& body_of(const FunctionDecl& function) {
    return function.unread ? read_body(*function.unread).statements : function.body;
}

const Diagnostics* body_errors(const FunctionDecl& function) {
    return function.unread ? &read_body(*function.unread).diagnostics : nullptr;
}

const Expr* parse_expression(Text text, Ast& ast, Diagnostics& diagnostics) {
    if (is_too_large(text, diagnostics)) return nullptr;
    return Parser(text, Lexer::Dialect::Graph, ast, diagnostics).whole_expression();
}

const Expr* parse_link(Text text, Ast& ast, Diagnostics& diagnostics) {
    if (is_too_large(text, diagnostics)) return nullptr;
    return Parser(text, Lexer::Dialect::Graph, ast, diagnostics).link();
}

Parser::Parser(Text text, Lexer::Dialect dialect, Ast& ast, Diagnostics& diagnostics, Bodies bodies)
    : text_(text),
      dialect_(dialect),
      ast_(ast),
      diagnostics_(diagnostics),
      errors_before_(diagnostics.error_count()),
      bodies_(bodies),
      lexer_(text, dialect, diagnostics) {
    if (is_hlsl()) preprocessor_.emplace(lexer_, ast, diagnostics);
    now_ = next_token();
    after_ = next_token();
}

const Expr* Parser::whole_expression() {
    const Node node = expression();
    if (node && now().kind != Token::Kind::End) expected("an operator or the end of the expression");
    // The lexer may have reported a comment, which does not make an expression wrong.
    return diagnostics_.error_count() == errors_before_ ? node.expr : nullptr;
}

const Expr* Parser::link() {
    Node path;
    switch (now().kind) {
        case Token::Kind::Word: path = leaf(Expr::Kind::Name, take()); break;
        case Token::Kind::Property: path = leaf(Expr::Kind::Property, take()); break;
        case Token::Kind::Semantic: path = leaf(Expr::Kind::Semantic, take()); break;
        case Token::Kind::Number:
        case Token::Kind::String:
        case Token::Kind::Punctuation:
        case Token::Kind::End:
        case Token::Kind::Bad:
            expected("a node, a $property or a @semantic").note("a formula begins with '=': \"= 1 - mask\"");
            return nullptr;
    }
    while (path && now().kind != Token::Kind::End) {
        // "a . b" and "a/**/.b" are not paths.
        if (!now().is(".") || now().begin != last_end_ || after().begin != now().end) {
            expected("'.' or the end of the link").note("a formula begins with '=': \"= 1 - mask\"");
            return nullptr;
        }
        take();
        if (now().kind != Token::Kind::Word) {
            expected("the name of an output, member or swizzle");
            return nullptr;
        }
        path = member_of(path);
    }
    return diagnostics_.error_count() == errors_before_ ? path.expr : nullptr;
}

// --- tokens

Token Parser::take() {
    if (now_.is("{")) ++braces_;
    if (now_.is("}") && braces_ > 0) --braces_;
    last_end_ = now_.end;
    const Token taken = now_;
    now_ = after_;
    after_ = next_token();
    return taken;
}

bool Parser::take_if(std::string_view punctuation) {
    if (!now().is(punctuation)) return false;
    take();
    return true;
}

bool Parser::take_word(std::string_view word) {
    if (!now().is_word(word)) return false;
    take();
    return true;
}

std::string Parser::describe(const Token& token) const {
    switch (token.kind) {
        case Token::Kind::End:
            return dialect_ == Lexer::Dialect::Graph ? "the end of the expression" : "the end of the file";
        case Token::Kind::String: return "a string";
        case Token::Kind::Property: return fmt::format("'${}'", token.text);
        case Token::Kind::Semantic: return fmt::format("'@{}'", token.text);
        case Token::Kind::Word:
        case Token::Kind::Number:
        case Token::Kind::Punctuation:
        case Token::Kind::Bad: return fmt::format("'{}'", token.text);
    }
    return {};
}

DiagnosticRecord& Parser::expected(std::string_view what) {
    if (now().kind == Token::Kind::Bad) return silent_ = {};
    return diagnostics_.report(Code::Syntax, span(now()), what, describe(now()));
}

bool Parser::expect(std::string_view punctuation, std::string_view what) {
    if (take_if(punctuation)) return true;
    expected(what);
    return false;
}

// `or_else`: what else could have followed: "','".
bool Parser::expect_close(std::string_view punctuation, const Token& open, std::string_view or_else) {
    if (take_if(punctuation)) return true;
    expected(fmt::format("{}{}'{}'", or_else, or_else.empty() ? "" : " or ", punctuation))
        .note(span(open), fmt::format("to close this '{}'", open.text));
    return false;
}

bool Parser::name(std::string_view what, Token& into) {
    const bool is_free = std::find(std::begin(kReserved), std::end(kReserved), now().text) == std::end(kReserved);
    if (now().kind != Token::Kind::Word || !is_free) {
        expected(what);
        return false;
    }
    into = take();
    return true;
}

// A ';' that is missing at the end of a line is reported there, and not at the next word. Then nothing needs to be
// skipped.
bool Parser::end_of_statement() {
    if (take_if(";")) return true;
    // All tokens of an expanded macro are at one place.
    const std::size_t gap = std::max(now().begin, last_end_) - last_end_;
    const bool at_line_end = text_.text.substr(last_end_, gap).find('\n') != std::string_view::npos;
    if (!at_line_end || now().kind == Token::Kind::Bad) {
        expected("';'");
        return false;
    }
    diagnostics_.report(Code::Syntax, lexer_.span(last_end_, last_end_), "';' here", describe(now()));
    return true;
}

// --- after an error

// Moves behind the statement that begins in a block with `depth` open braces: behind its ';' or its last '}', but not
// out of the block.
void Parser::skip_statement(int depth) {
    while (now().kind != Token::Kind::End) {
        if (now().is("}") && braces_ <= depth) return;
        const Token skipped = take();
        if (braces_ <= depth && (skipped.is(";") || skipped.is("}"))) return;
    }
}

void Parser::skip_declaration() {
    while (now().kind != Token::Kind::End) {
        const Token skipped = take();
        if (braces_ == 0 && (skipped.is(";") || skipped.is("}"))) return;
    }
}

bool Parser::Nested::allowed() const {
    if (parser_.nesting_ <= kMaxNesting) return true;
    parser_.diagnostics_.report(Code::TooDeep, parser_.span(parser_.now()), kMaxNesting);
    return false;
}

}  // namespace patina::nodelang
