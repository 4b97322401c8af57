// Parses the statements of a function's body.
#include <algorithm>

#include "compiler/nodelang/parser.h"

namespace patina::nodelang {
namespace {

constexpr std::string_view kAssignments[] = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="};
constexpr std::string_view kLoopShape = "write a loop like this: for (int i = 0; i < 8; i++)";

// Statements of C that the language does not have.
bool is_left_out(const Token& token) {
    return token.is_word("while") || token.is_word("do") || token.is_word("break") || token.is_word("continue") ||
           token.is_word("switch");
}

std::string_view instead_of(const Token& token) {
    if (token.is_word("switch")) return "there is no switch: write if (x == 0) { } else if (x == 1) { }";
    if (token.is_word("break") || token.is_word("continue"))
        return "a loop cannot be left early: put the statements that may be skipped into an if";
    return kLoopShape;
}

}  // namespace

bool is_assignment(const Token& token) {
    return token.kind == Token::Kind::Punctuation &&
           std::find(std::begin(kAssignments), std::end(kAssignments), token.text) != std::end(kAssignments);
}

// Ends a statement with a span without the ';', which is never the error.
const Stmt* Parser::finish(Stmt stmt, std::size_t begin) {
    stmt.span = span_from(begin);
    return &ast_.stmts.emplace_back(std::move(stmt));
}

bool Parser::block(Statements& into) {
    const Token open = take();
    statements(into);
    return expect_close("}", open);
}

void Parser::statements(Statements& into) {
    const int depth = braces_;
    while (now().kind != Token::Kind::End && !now().is("}")) {
        if (take_if(";")) continue;
        if (!statement(into)) skip_statement(depth);
    }
}

bool Parser::statement(Statements& into) {
    const Nested nested(*this);
    if (!nested.allowed()) return false;
    const auto add = [&](const Stmt* made) {
        if (made) into.push_back(made);
        return made != nullptr;
    };
    const std::size_t begin = now().begin;
    if (now().is("{")) {
        Stmt inner{.kind = Stmt::Kind::Block};
        return block(inner.body) && add(finish(std::move(inner), begin));
    }
    if (now().is_word("if")) return add(if_statement());
    if (now().is_word("return")) return add(return_statement());
    if (now().is_word("discardIf")) return add(discard_statement());
    if (is_hlsl()) return hlsl_statement(into);
    if (now().is("[") || now().is_word("for")) return add(for_statement());
    if (now().is_word("const")) return declaration_statement(into);
    if (is_left_out(now())) {
        expected("a statement").note(std::string(instead_of(now())));
        return false;
    }
    const bool two_words = now().kind == Token::Kind::Word && after().kind == Token::Kind::Word;
    return two_words ? declaration_statement(into) : add(assignment());
}

bool Parser::declaration_statement(Statements& into) {
    std::size_t begin = now().begin;
    bool is_const = false;
    TypeName type;
    if (is_hlsl())
        qualifiers(is_const);
    else
        is_const = take_word("const");
    if (!type_name(type, "a statement")) return false;
    for (;;) {
        Stmt stmt{.kind = Stmt::Kind::Declare, .type = type, .is_const = is_const};
        Token word;
        if (!name("a name for the variable", word)) return false;
        stmt.name = word.text;
        stmt.name_span = span(word);
        if (!array_size(stmt.type)) return false;
        if (take_if("=")) {
            const Node value = initializer();
            if (!value) return false;
            stmt.value = value.expr;
        } else if (stmt.is_const) {
            expected("'=' and the value of the constant");
            return false;
        }
        into.push_back(finish(std::move(stmt), begin));
        if (!now().is(",")) return end_of_statement();
        if (!is_hlsl()) {
            expected("';'").note("declare each variable on its own");
            return false;
        }
        take();
        begin = now().begin;
    }
}

const Stmt* Parser::assignment() {
    Stmt stmt{.kind = Stmt::Kind::Assign};
    const Node target = postfix();
    if (!target) return nullptr;
    if (!is_assignment(now())) {
        DiagnosticRecord& record = expected("an assignment");
        if (target.expr->kind == Expr::Kind::Call)
            record.note("a call alone does nothing: functions have no side effects");
        if (now().is("++") || now().is("--")) record.note(fmt::format("write '{}= 1'", now().text[0]));
        return nullptr;
    }
    const Token op = take();
    const Node value = expression();
    if (!value) return nullptr;
    stmt.op = op.text;
    stmt.name_span = span(op);
    stmt.target = target.expr;
    stmt.value = value.expr;
    const Stmt* made = finish(std::move(stmt), target.begin);
    return end_of_statement() ? made : nullptr;
}

const Stmt* Parser::if_statement() {
    const Token word = take();
    Stmt stmt{.kind = Stmt::Kind::If, .name_span = span(word)};
    const Token open = now();
    if (!expect("(", "'(' and a condition")) return nullptr;
    const Node condition = expression();
    if (!condition || !expect_close(")", open) || !body(stmt.body)) return nullptr;
    stmt.value = condition.expr;
    if (take_word("else") && !body(stmt.alternative)) return nullptr;
    return finish(std::move(stmt), word.begin);
}

// One statement or a block.
bool Parser::body(Statements& into) {
    if (now().is("{")) return block(into);
    if (is_hlsl() && take_if(";")) return true;
    if (now().is(";")) {
        expected("a statement or '{'");
        return false;
    }
    return statement(into);
}

const Stmt* Parser::for_statement() {
    const std::size_t begin = now().begin;
    Stmt loop{.kind = Stmt::Kind::For};
    std::vector<Attribute> marks;
    if (!attributes(marks)) return nullptr;
    for (const Attribute& mark : marks) {
        if (mark.name == "light" && mark.args.empty()) {
            loop.is_light_loop = true;
        } else if (mark.name == "unroll" && mark.args.empty()) {
            loop.is_unrolled = true;
        } else {
            diagnostics_.report(Code::BadAttribute, mark.span, mark.name, "is not allowed before a statement");
        }
    }
    if (!take_word("for")) {
        expected("'for' after the attribute");
        return nullptr;
    }
    const Token open = now();
    if (!expect("(", "'('")) return nullptr;
    const bool is_sound = for_header(loop) && expect_close(")", open);
    if (!is_sound) skip_header();
    if (!body(loop.body)) return nullptr;
    // A loop without a valid header is dropped, but its body has been read, so that its errors are reported.
    if (!is_sound) return finish({.kind = Stmt::Kind::Block}, begin);
    return finish(std::move(loop), begin);
}

bool Parser::for_header(Stmt& loop) {
    const auto refuse = [&](std::string_view what) {
        expected(what).note(std::string(kLoopShape));
        return false;
    };
    if (!now().is_word("int")) return refuse("'int'");
    if (!type_name(loop.type, "'int'")) return false;
    Token index;
    if (!name("a name for the index", index)) return false;
    loop.name = index.text;
    loop.name_span = span(index);
    if (!take_if("=")) return refuse("'='");
    const Node first = expression();
    if (!first) return false;
    if (!take_if(";")) return refuse("';'");
    if (!take_word(index.text)) return refuse(fmt::format("'{}'", index.text));
    if (!take_if("<")) return refuse("'<'");
    const Node limit = expression();
    if (!limit) return false;
    if (!take_if(";")) return refuse("';'");
    loop.value = first.expr;
    loop.limit = limit.expr;
    return for_step(index.text) || refuse(fmt::format("'{}++'", index.text));
}

// i++, ++i or i += 1
bool Parser::for_step(std::string_view index) {
    if (take_if("++")) return take_word(index);
    if (!take_word(index)) return false;
    if (take_if("++")) return true;
    if (!take_if("+=")) return false;
    const bool is_one = now().kind == Token::Kind::Number && now().number == 1;
    if (is_one) take();
    return is_one;
}

// Moves from the middle of a header to behind its ')'.
void Parser::skip_header() {
    for (int open = 1; open > 0 && now().kind != Token::Kind::End && !now().is("{") && !now().is("}");) {
        const Token skipped = take();
        if (skipped.is("(")) ++open;
        if (skipped.is(")")) --open;
    }
}

const Stmt* Parser::return_statement() {
    const Token word = take();
    Stmt stmt{.kind = Stmt::Kind::Return, .name_span = span(word)};
    if (!now().is(";")) {
        const Node value = expression();
        if (!value) return nullptr;
        stmt.value = value.expr;
    }
    const Stmt* made = finish(std::move(stmt), word.begin);
    return end_of_statement() ? made : nullptr;
}

const Stmt* Parser::discard_statement() {
    const Token word = take();
    const Token open = now();
    if (!expect("(", "'(' and a condition")) return nullptr;
    const Node condition = expression();
    if (!condition || !expect_close(")", open)) return nullptr;
    const Stmt* made =
        finish({.kind = Stmt::Kind::Discard, .name_span = span(word), .value = condition.expr}, word.begin);
    return end_of_statement() ? made : nullptr;
}

}  // namespace patina::nodelang
