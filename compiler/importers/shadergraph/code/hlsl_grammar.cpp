#include "compiler/importers/shadergraph/code/hlsl_grammar.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "compiler/importers/shadergraph/code/hlsl_tokens.h"

namespace patina::importers::shadergraph {
namespace {

constexpr std::string_view kBinary[] = {
    "*", "/",  "%",  "+", "-",  "<<", ">>", "<",  ">",  "<=", ">=", "==", "!=",  "&",  "^",
    "|", "&&", "||", "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="};

constexpr std::string_view kStatements[] = {"if",     "else",  "for",      "while",  "do",
                                            "return", "break", "continue", "switch", "case"};

class Parser {
public:
    explicit Parser(std::string_view body) : tokens_(tokens_of(body)) {}

    std::optional<SyntaxError> run() {
        while (!wrong_ && !is_end()) statement();
        return wrong_;
    }

private:
    const Token& at(std::size_t ahead = 0) const { return tokens_[std::min(next_ + ahead, tokens_.size() - 1)]; }
    bool is_end() const { return at().text.empty(); }
    bool is(std::string_view text) const { return at().text == text; }
    bool is_word(std::size_t ahead = 0) const { return !at(ahead).text.empty() && is_letter(at(ahead).text[0]); }
    bool begins_statement() const { return std::ranges::find(kStatements, at().text) != std::end(kStatements); }
    bool take(std::string_view text) {
        if (wrong_ || !is(text)) return false;
        ++next_;
        return true;
    }
    std::string here() const { return is_end() ? "the end" : fmt::format("'{}'", at().text); }
    void fail(std::string text) {
        if (!wrong_) wrong_ = SyntaxError{.line = at().line, .text = std::move(text)};
    }
    void need(std::string_view text) {
        if (take(text) || wrong_) return;
        // What is missing at the end of a line is missing there.
        const int line = next_ > 0 ? tokens_[next_ - 1].line : at().line;
        fail(fmt::format("a '{}' is missing before {}", text, here()));
        wrong_->line = line;
    }
    bool is_deep() {
        if (++depth_ < kDeepest) return false;
        fail("it is nested too deeply");
        return true;
    }

    // --- statements

    void statement() {
        if (is_deep()) return;
        while (!wrong_ && take("[")) {  // [unroll], [loop]
            while (!wrong_ && !is_end() && !is("]")) ++next_;
            need("]");
        }
        if (wrong_ || take(";")) {
        } else if (is("{")) {
            block();
        } else if (take("if")) {
            condition();
            statement();
            if (take("else")) statement();
        } else if (take("while") || take("switch")) {
            condition();
            statement();
        } else if (take("do")) {
            statement();
            need("while");
            condition();
            need(";");
        } else if (take("for")) {
            for_loop();
        } else if (take("return")) {
            if (!is(";")) expression();
            need(";");
        } else if (take("break") || take("continue") || take("discard")) {
            need(";");
        } else if (take("case")) {
            expression();
            need(":");
        } else if (take("default")) {
            need(":");
        } else if (is("struct")) {
            skip_struct();
        } else {
            declaration_or_expression();
            need(";");
        }
        --depth_;
    }
    void block() {
        need("{");
        while (!wrong_ && !is_end() && !is("}")) statement();
        need("}");
    }
    void condition() {
        need("(");
        expression();
        need(")");
    }
    void for_loop() {
        need("(");
        if (!is(";")) declaration_or_expression();
        need(";");
        if (!is(";")) expression();
        need(";");
        if (!is(")")) expression();
        need(")");
        statement();
    }
    void skip_struct() {
        while (!wrong_ && !is_end() && !is("}")) ++next_;
        need("}");
        while (!wrong_ && !is_end() && !is(";")) ++next_;
        need(";");
    }
    // "float3 a = 1, b[2] = { 0, 1 }", "const Texture2D<float4> t", or an expression.
    void declaration_or_expression() {
        static constexpr std::string_view kQualifiers[] = {"const",     "static",       "uniform", "precise",
                                                           "row_major", "column_major", "unsigned"};
        const std::size_t begin = next_;
        while (std::ranges::find(kQualifiers, at().text) != std::end(kQualifiers)) ++next_;
        const bool is_qualified = next_ > begin;
        if (is_word() && !begins_statement()) {
            std::size_t behind = 1;
            if (at(1).text == "<" && is_word(2)) {
                while (!at(behind).text.empty() && at(behind).text != ">" && at(behind).text != ";") ++behind;
                ++behind;
            }
            if (is_word(behind)) {
                next_ += behind;
                declarators();
                return;
            }
        }
        if (is_qualified) return fail(fmt::format("a type and a name are missing before {}", here()));
        expression();
    }
    void declarators() {
        do {
            if (!is_word()) return fail(fmt::format("a name is missing before {}", here()));
            ++next_;
            while (take("[")) {
                if (!is("]")) expression();
                need("]");
            }
            if (take("=")) value_or_list();
        } while (take(","));
    }
    void value_or_list() {
        if (is_deep()) return;
        if (take("{")) {
            while (!wrong_ && !is_end() && !is("}")) {
                value_or_list();
                if (!take(",")) break;
            }
            need("}");
        } else {
            assignment();
        }
        --depth_;
    }

    // --- expressions: which operator binds more tightly changes nothing

    void expression() {
        do assignment();
        while (take(","));
    }
    void assignment() {
        if (is_deep()) return;
        unary();
        while (!wrong_) {
            if (take("?")) {
                assignment();
                need(":");
                assignment();
            } else if (std::ranges::find(kBinary, at().text) != std::end(kBinary)) {
                ++next_;
                unary();
            } else {
                break;
            }
        }
        --depth_;
    }
    void unary() {
        if (is_deep()) return;
        while (take("+") || take("-") || take("!") || take("~") || take("++") || take("--")) {
        }
        // "(float3)x": a type in brackets, and a value behind it.
        std::size_t close = 2;
        while (at(close).text == "[") close += 3;
        const bool is_cast =
            is("(") && is_word(1) && at(close).text == ")" &&
            (is_word(close + 1) || at(close + 1).text == "(" ||
             (!at(close + 1).text.empty() && (is_digit(at(close + 1).text[0]) || at(close + 1).text[0] == '.') &&
              at(close + 1).text != "."));
        if (is_cast) {
            next_ += close + 1;
            unary();
        } else {
            postfix();
        }
        --depth_;
    }
    void postfix() {
        if (wrong_) return;
        if (take("(")) {
            expression();
            need(")");
        } else if (is_word() || (!is_end() && (is_digit(at().text[0]) || (at().text[0] == '.' && at().text != ".")))) {
            if (begins_statement()) return fail(fmt::format("a value is missing before {}", here()));
            ++next_;
        } else {
            return fail(fmt::format("a value is missing before {}", here()));
        }
        while (!wrong_) {
            if (take(".") || take("::")) {
                if (!is_word()) return fail(fmt::format("a name is missing before {}", here()));
                ++next_;
            } else if (take("[")) {
                expression();
                need("]");
            } else if (take("(")) {
                if (!is(")")) expression();
                need(")");
            } else if (!take("++") && !take("--")) {
                break;
            }
        }
    }

    static constexpr int kDeepest = 200;
    std::vector<Token> tokens_;
    std::size_t next_ = 0;
    int depth_ = 0;
    std::optional<SyntaxError> wrong_{};
};

}  // namespace

std::optional<SyntaxError> syntax_error(std::string_view body) {
    return Parser(body).run();
}

}  // namespace patina::importers::shadergraph
