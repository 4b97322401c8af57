// Parses what only files of HLSL have: more statements, casts, assignments in expressions, qualifiers.
#include <algorithm>

#include "compiler/nodelang/hlsl/jumps.h"
#include "compiler/nodelang/parser.h"

namespace patina::nodelang {
namespace {

// Words before a type that change no value.
constexpr std::string_view kQualifiers[] = {"column_major",    "extern",  "groupshared", "inline",
                                            "nointerpolation", "precise", "row_major",   "shared",
                                            "static",          "uniform", "volatile"};
// Hints for the compiler of the engine.
constexpr std::string_view kHints[] = {"allow_uav_condition", "branch", "call", "fastopt", "flatten",
                                       "forcecase",           "loop"};

// Each is in the else of the one before.
constexpr std::size_t kMostCases = 100;

template <std::size_t count>
bool is_one_of(const Token& token, const std::string_view (&words)[count]) {
    return token.kind == Token::Kind::Word &&
           std::find(std::begin(words), std::end(words), token.text) != std::end(words);
}

// "float3", "half", "int2", "float4x4"
bool is_number_type(std::string_view word) {
    for (const std::string_view scalar : {"float", "half", "int", "uint", "bool"}) {
        if (word.starts_with(scalar)) return word.substr(scalar.size()).find_first_not_of("1234x") == word.npos;
    }
    return false;
}

bool begins_value(const Token& token) {
    return token.kind == Token::Kind::Number || token.kind == Token::Kind::Word;
}

}  // namespace

// --- declarations

bool Parser::begins_declaration() const {
    if (now().kind != Token::Kind::Word) return false;
    if (now().is_word("const") || is_one_of(now(), kQualifiers)) return true;
    return after().kind == Token::Kind::Word || (after().is("<") && now().text.starts_with("Texture"));
}

// "static const": the first of them alone would be a variable that keeps its value between calls.
void Parser::qualifiers(bool& is_const) {
    bool is_static = false;
    const Token first = now();
    for (;;) {
        if (take_word("const")) {
            is_const = true;
        } else if (is_one_of(now(), kQualifiers)) {
            is_static = is_static || now().is_word("static");
            take();
        } else {
            break;
        }
    }
    if (is_static && !is_const && braces_ > 0)
        lacks(span(first), "no variable keeps its value between two calls: write 'static const'");
}

// HLSL that the node language does not have. It is parsed all the same.
void Parser::lacks(Span at, std::string_view what) {
    diagnostics_.report(Code::NotYet, at, what);
}

bool Parser::hlsl_parameter(ParamDecl& into) {
    for (;;) {
        if (take_word("out")) {
            into.is_out = true;
        } else if (now().is_word("inout") && after().kind == Token::Kind::Word) {
            take();
            into.is_out = into.is_inout = true;
        } else if (now().is_word("in") && after().kind == Token::Kind::Word) {
            take();
        } else if (now().is_word("const") || is_one_of(now(), kQualifiers)) {
            take();  // it says only that the function does not assign to it
        } else {
            return typed_parameter(into);
        }
    }
}

// ": TEXCOORD0" of a stage's variables
void Parser::skip_semantic() {
    if (!is_hlsl() || !now().is(":") || after().kind != Token::Kind::Word) return;
    take();
    take();
}

// --- statements

bool Parser::hlsl_statement(Statements& into) {
    const std::size_t begin = now().begin;
    const auto add = [&](const Stmt* made) {
        if (made) into.push_back(made);
        return made != nullptr;
    };
    Stmt loop{.kind = Stmt::Kind::Loop};
    if (now().is("[") && !hints(loop)) return false;
    loop.name_span = span(now());
    if (now().is_word("if")) return add(if_statement());
    if (now().is_word("switch")) return add(switch_statement());
    if (take_word("while")) {
        Node test;
        if (!condition(test) || !body(loop.body)) return false;
        loop.value = test.expr;
        return add(finish(std::move(loop), begin));
    }
    if (take_word("do")) {
        Node test;
        loop.tests_later = true;
        if (!body(loop.body)) return false;
        if (!take_word("while")) {
            expected("'while' after the body of 'do'");
            return false;
        }
        if (!condition(test)) return false;
        loop.value = test.expr;
        return end_of_statement() && add(finish(std::move(loop), begin));
    }
    if (take_word("for")) {
        // What the loop declares is known in the loop alone.
        Stmt around{.kind = Stmt::Kind::Block};
        if (!for_loop(loop, around.body)) return false;
        const bool declares_one = around.body.size() == 1 && around.body[0]->kind == Stmt::Kind::Declare;
        if (declares_one) loop.counter = around.body[0];
        around.body.push_back(finish(std::move(loop), begin));
        return add(finish(std::move(around), begin));
    }
    if (now().is_word("break") || now().is_word("continue")) {
        const bool is_break = take().text == "break";
        const Stmt* made = finish({.kind = is_break ? Stmt::Kind::Break : Stmt::Kind::Continue}, begin);
        return end_of_statement() && add(made);
    }
    if (now().is_word("discard")) {
        const Node word = leaf(Expr::Kind::Call, take());
        lacks(word.expr->span, "a function leaves out no pixel: use the alpha clip of the surface");
        into.push_back(finish({.kind = Stmt::Kind::Evaluate, .value = word.expr}, begin));
        return end_of_statement();
    }
    if (now().is_word("struct")) {
        lacks(span(now()), "a struct inside of a function: declare it before the function");
        return structure({}, {});
    }
    if (now().is_word("typedef") || now().is_word("else")) {
        expected("a statement");
        return false;
    }
    return begins_declaration() ? declaration_statement(into) : expressions(into) && end_of_statement();
}

// [unroll], [branch] ... before a statement.
bool Parser::hints(Stmt& loop) {
    std::vector<Attribute> marks;
    if (!attributes(marks)) return false;
    for (const Attribute& mark : marks) {
        const bool is_hint = std::find(std::begin(kHints), std::end(kHints), mark.name) != std::end(kHints);
        if (mark.name == "unroll" && mark.args.empty()) {
            loop.is_unrolled = true;
        } else if (mark.name == "unroll") {
            diagnostics_.report(Code::BadAttribute, mark.span, mark.name,
                                "takes no number here: compilers differ in what they do with the rounds after it");
        } else if (!is_hint) {
            diagnostics_.report(Code::BadAttribute, mark.span, mark.name, "is not allowed before a statement");
        }
    }
    return true;
}

// In brackets, behind 'while' and 'switch'.
bool Parser::condition(Node& into) {
    const Token open = now();
    if (!expect("(", "'(' and a condition")) return false;
    into = expression();
    return into && expect_close(")", open);
}

bool Parser::for_loop(Stmt& loop, Statements& first) {
    const Token open = now();
    if (!expect("(", "'('")) return false;
    if (begins_declaration()) {
        if (!declaration_statement(first)) return false;
    } else if (!take_if(";")) {
        if (!expressions(first) || !expect(";", "';'")) return false;
    }
    if (!now().is(";")) {
        const Node test = expression();
        if (!test) return false;
        loop.value = test.expr;
    }
    if (!expect(";", "';'")) return false;
    if (!now().is(")") && !expressions(loop.step)) return false;
    return expect_close(")", open) && body(loop.body);
}

// "a = 1, b++, F(a)" as statements.
bool Parser::expressions(Statements& into) {
    do {
        const Node node = expression();
        if (!node) return false;
        const Expr& expr = *node.expr;
        const bool assigns = expr.kind == Expr::Kind::Assign || expr.kind == Expr::Kind::AssignLater;
        Stmt made{.kind = assigns ? Stmt::Kind::Assign : Stmt::Kind::Evaluate, .name_span = expr.name_span};
        made.value = node.expr;
        if (assigns) {
            made.op = expr.text;
            made.target = expr.args[0];
            made.value = expr.args[1];
        }
        into.push_back(finish(std::move(made), node.begin));
    } while (take_if(","));
    return true;
}

// As branches: "if (a == 0 || a == 1) { } else if (a == 2) { } else { }".
const Stmt* Parser::switch_statement() {
    const Token word = take();
    Node selector;
    if (!condition(selector)) return nullptr;
    const Token open = now();
    if (!expect("{", "'{'")) return nullptr;
    Stmt made{.kind = Stmt::Kind::Block, .takes_break = true};
    if (!cases(selector, made.body)) return nullptr;
    if (!expect_close("}", open)) return nullptr;
    return finish(std::move(made), word.begin);
}

bool Parser::cases(const Node& selector, Statements& into) {
    struct Case {
        std::size_t begin = 0;
        Span word{};
        const Expr* test = nullptr;  // null: of 'default'
        Statements body{};
    };
    std::vector<Case> found;
    while (now().is_word("case") || now().is_word("default")) {
        if (found.size() == kMostCases) {
            diagnostics_.report(Code::TooMany, span(now()), found.size() + 1, "branches of a switch", kMostCases);
            return false;
        }
        Case& each = found.emplace_back(Case{.begin = now().begin, .word = span(now())});
        bool is_default = false;
        Node test;
        while (now().is_word("case") || now().is_word("default")) {
            const Token word = take();
            is_default = is_default || word.text == "default";
            if (word.text == "case") {
                const Node value = expression();
                if (!value) return false;
                const Node equal = make({.kind = Expr::Kind::Binary, .name_span = span(word), .text = "=="}, word.begin,
                                        {selector, value});
                if (!equal) return false;
                test = test ? make({.kind = Expr::Kind::Binary, .name_span = span(word), .text = "||"}, word.begin,
                                   {test, equal})
                            : equal;
                if (!test) return false;
            }
            if (!expect(":", "':'")) return false;
        }
        each.test = is_default ? nullptr : test.expr;
        const int depth = braces_;
        while (now().kind != Token::Kind::End && !now().is("}") && !now().is_word("case") &&
               !now().is_word("default")) {
            if (take_if(";")) continue;
            if (!statement(each.body)) skip_statement(depth);
        }
        if (!now().is("}") && !always_leaves(each.body)) {
            expected("'break;' before the next case").note(each.word, "this one would run on into it");
            return false;
        }
    }
    // From the last to the first, each in the else of the one before; 'default' is behind all of them.
    Statements rest;
    for (const Case& each : found) {
        if (!each.test) rest = each.body;
    }
    for (auto each = found.rbegin(); each != found.rend(); ++each) {
        if (!each->test) continue;
        Stmt branch{.kind = Stmt::Kind::If, .name_span = each->word, .value = each->test};
        branch.body = each->body;
        branch.alternative = std::move(rest);
        rest = {finish(std::move(branch), each->begin)};
    }
    into = std::move(rest);
    return true;
}

// --- expressions

// The current token is an assignment. It groups to the right.
Node Parser::assigned(const Node& target) {
    const Token op = take();
    const Node value = expression();
    if (!value) return {};
    return make({.kind = Expr::Kind::Assign, .name_span = span(op), .text = op.text}, target.begin, {target, value});
}

// "++x" or "x++"
Node Parser::stepped(const Node& target, const Token& op, bool is_before) {
    Token one = op;
    one.number = 1;
    one.text = "1";
    one.number_kind = NumberKind::Int;
    const Node number = leaf(Expr::Kind::Number, one);
    return make({.kind = is_before ? Expr::Kind::Assign : Expr::Kind::AssignLater,
                 .name_span = span(op),
                 .text = op.text == "++" ? "+=" : "-="},
                std::min(target.begin, op.begin), {target, number});
}

// "(float3)x", or a name in brackets. The current token is the word, and the bracket is behind it.
Node Parser::cast(const Token& open) {
    const Token word = take();
    take();
    const bool is_number = is_number_type(word.text);
    const bool is_sign = now().is("-") || now().is("+") || now().is("!") || now().is("~") || now().is("(");
    if (!begins_value(now()) && !(is_number && is_sign)) {
        const bool is_bool = word.text == "true" || word.text == "false";
        Token value = word;
        value.number = word.text == "true" ? 1 : 0;
        Node inner = leaf(is_bool ? Expr::Kind::Bool : Expr::Kind::Name, value);
        inner.begin = open.begin;
        return inner;
    }
    const Nested nested(*this);
    if (!nested.allowed()) return {};
    const Node operand = unary();
    if (!operand) return {};
    return make({.kind = Expr::Kind::Call, .name_span = span(word), .text = word.text}, open.begin, {operand});
}

}  // namespace patina::nodelang
