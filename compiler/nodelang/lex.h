// Splits text of the node language into tokens, one at a time. So a large file needs no more memory than a small one.
// It reports bad characters and numbers; the parser does not report a Bad token again. Comments are not tokens: a token
// carries the `///` lines before it, and the `///<` text between it and the previous token.
//
// In a file of HLSL (hlsl_mark.h) it also knows what the preprocessor (preprocessor.h) needs: '#', and where lines
// begin.
//
//   Lexer lexer({text, base}, Lexer::Dialect::File, diagnostics);
//   for (Token t = lexer.next(); t.kind != Token::Kind::End; t = lexer.next()) ...
#pragma once

#include "compiler/base/diagnostics.h"
#include "compiler/base/precedence.h"
#include "compiler/nodelang/ast.h"
#include "compiler/nodelang/parse.h"

namespace patina::nodelang {

struct Token {
    enum class Kind : std::uint8_t {
        End,
        Word,         // identifiers and keywords alike
        Number,       // number, number_kind
        String,       // text: between the quotes
        Property,     // $name; text: without the $
        Semantic,     // @name; text: without the @
        Punctuation,  // text: the longest of the language's operators and brackets
        Bad,          // has been reported
    };
    Kind kind = Kind::End;
    NumberKind number_kind = NumberKind::Int;
    std::size_t begin = 0;  // offsets into Text::text
    std::size_t end = 0;
    bool begins_line = false;
    bool follows_space = false;  // or a comment
    std::string_view text;
    double number = 0;
    std::string_view doc;           // whole lines, slashes included; empty if there are none
    std::string_view trailing_doc;  // what follows `///<` on the line of the token before, without the spaces around it

    bool is(std::string_view punctuation) const {  // of one or two characters
        return kind == Kind::Punctuation && text.size() == punctuation.size() && text.front() == punctuation.front() &&
               text.back() == punctuation.back();
    }
    bool is_word(std::string_view word) const { return kind == Kind::Word && text == word; }
};

// Of an operator with two operands; Any: the token is none.
inline Precedence precedence(const Token& token) {
    return token.kind == Token::Kind::Punctuation ? binary_precedence(token.text) : Precedence::Any;
}

class Lexer {
public:
    // Only graphs have $properties and @semantics, and only HLSL has a preprocessor.
    enum class Dialect { File, Graph, Hlsl };

    Lexer(Text text, Dialect dialect, Diagnostics& diagnostics);

    // The next token. At the end of the text it is End, however often this is called.
    Token next();

    // From now on, errors are reported here.
    void report_to(Diagnostics& diagnostics) { diagnostics_ = &diagnostics; }
    // Continues at the offset.
    void go_to(std::size_t offset) { here_ = offset; }

    Span span(std::size_t begin, std::size_t end) const { return {text_.at(begin), text_.at(end)}; }

private:
    char at(std::size_t offset) const { return offset < text_.text.size() ? text_.text[offset] : '\0'; }
    bool looking_at(std::string_view word) const { return text_.text.substr(here_).starts_with(word); }
    std::size_t end_of_word(std::size_t from) const;

    void skip_space(Token& token);
    void skip_block_comment();
    void line_comment(Token& token, bool same_line_as_token);
    void word(Token& token);
    void number(Token& token);
    void string(Token& token);
    void graph_name(Token& token);
    void punctuation(Token& token);
    void bad_character(Token& token);

    Text text_;
    Dialect dialect_;
    Diagnostics* diagnostics_;
    std::size_t here_ = 0;
};

}  // namespace patina::nodelang
