// The preprocessor of HLSL, between the lexer and the parser of a file that is read by HLSL's rules. It leaves out
// lines whose #if is false, and replaces the names of macros by their tokens. These tokens have the location of the
// macro's use, so that messages point at the text of the author. It reads no other file: #include is ignored, as are
// #pragma and #line.
//
//   Preprocessor preprocessor(lexer, ast, diagnostics);
//   for (Token t = preprocessor.next(); t.kind != Token::Kind::End; t = preprocessor.next()) ...
#pragma once

#include <deque>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "compiler/nodelang/lex.h"

namespace patina::nodelang {

class Preprocessor {
public:
    Preprocessor(Lexer& lexer, Ast& ast, Diagnostics& diagnostics)
        : lexer_(lexer), ast_(ast), diagnostics_(diagnostics) {}

    // The next token of the text that remains.
    Token next();

    // Forgets the tokens that it has read ahead: the lexer goes on at another place.
    void forget_ahead() {
        ahead_.clear();
        made_.clear();
    }
    // A name that is not defined, and that a condition may compare: it is 0.
    void make_zero(std::string_view name) { zeros_.insert(name); }

private:
    struct Macro {
        bool has_parameters = false;
        bool takes_more = false;  // its last parameter is "..."
        std::vector<std::string_view> parameters{};
        std::vector<Token> body{};
    };
    struct Branch {
        bool is_open = true, was_open = true;  // this part is read; one of the parts was
        Token mark{};                          // the '#'
    };
    using Tokens = std::vector<Token>;
    using Rest = std::deque<Token>;
    using Active = std::set<std::string_view>;  // macros that are being replaced

    bool is_open() const { return branches_.empty() || branches_.back().is_open; }
    Span span(const Token& token) const { return lexer_.span(token.begin, token.end); }
    void wrong(const Token& at, std::string_view expected, std::string_view found);
    Token raw();
    void directive(const Token& mark);
    void read_line(const Token& mark, Tokens line);
    void define(const Tokens& line);
    void branch(const Token& mark, const Token& word, const Tokens& line);
    bool holds(const Token& word, const Tokens& line);
    Tokens with_defined_decided(const Tokens& line);
    bool replace(const Token& name, Tokens& into, Rest* rest, const Active& active);
    void replace_by(const Macro& macro, const Token& name, Tokens& into, const std::vector<Tokens>& given,
                    const Active& active);
    bool arguments(const Token& name, Rest* rest, std::size_t most, std::vector<Tokens>& into);
    Tokens replaced(const Tokens& list, const Active& active);
    Token pasted(const Token& left, const Token& right);

    Lexer& lexer_;
    Ast& ast_;
    Diagnostics& diagnostics_;
    Diagnostics unread_{};  // what is wrong in lines that are left out
    std::map<std::string_view, Macro> macros_{};
    std::set<std::string_view> zeros_{};
    std::vector<Branch> branches_{};
    std::deque<Token> ahead_{};   // of the lexer
    std::deque<Token> made_{};    // of macros: they are not replaced again
    bool begins_line_ = false;    // what comes next, behind a macro that stands for nothing
    std::size_t made_count_ = 0;  // of all macros so far
    int depth_ = 0;               // of macros in arguments and in macros
};

}  // namespace patina::nodelang
