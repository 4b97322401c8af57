// Parses expressions, by precedence climbing.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/nodelang/parser.h"

namespace patina::nodelang {
namespace {

// Words that begin statements, and what to write in an expression.
constexpr std::pair<std::string_view, std::string_view> kStatements[] = {
    {"if", "write 'condition ? a : b'"},
    {"switch", "write 'condition ? a : b'"},
    {"for", "write the loop in a function of a node file (.node.hlsl)"},
    {"while", "write the loop in a function of a node file (.node.hlsl)"},
    {"return", "its value is its result"},
    {"const", "give a value a name by a node of its own"},
};

}  // namespace

// Makes every expression that is not a leaf. Its height is known here, so a chain of operators that is too deep for
// recursion is refused.
Node Parser::make(Expr expr, std::size_t begin, std::span<const Node> operands) {
    Node node{.begin = begin};
    for (const Node& operand : operands) {
        expr.args.push_back(operand.expr);
        node.height = std::max(node.height, operand.height + 1);
    }
    expr.span = span_from(begin);
    if (node.height > kMaxExpressionHeight) {
        diagnostics_.report(Code::TooDeep, expr.name_span, kMaxExpressionHeight)
            .note("operators in one chain also count: give a part of it a name");
        return {};
    }
    node.expr = &ast_.exprs.emplace_back(std::move(expr));
    return node;
}

Node Parser::leaf(Expr::Kind kind, const Token& token) {
    return make({.kind = kind,
                 .number_kind = token.number_kind,
                 .name_span = span(token),
                 .text = token.text,
                 .number = token.number},
                token.begin, {});
}

// condition ? value : value; groups to the right.
Node Parser::expression() {
    const Nested nested(*this);
    if (!nested.allowed()) return {};
    // Most defaults and arguments are one number or one name.
    const bool is_leaf = now().kind == Token::Kind::Number || now().kind == Token::Kind::Word;
    if (is_leaf && (after().is(",") || after().is(")") || after().is(";"))) return primary();
    const Node condition = binary(Precedence::LogicalOr);
    if (condition && is_hlsl() && is_assignment(now())) return assigned(condition);
    if (!condition || !now().is("?")) return condition;
    const Token question = take();
    const Node if_true = expression();
    if (!if_true) return {};
    if (!take_if(":")) {
        expected("':'").note(span(question), "to go with this '?'");
        return {};
    }
    const Node if_false = expression();
    if (!if_false) return {};
    return make({.kind = Expr::Kind::Ternary, .name_span = span(question), .text = question.text}, condition.begin,
                {condition, if_true, if_false});
}

Node Parser::binary(Precedence lowest) {
    Node left = unary();
    while (left) {
        const Precedence own = precedence(now());
        if (own == Precedence::Any || own < lowest) return left;
        const Token op = take();
        const Node right = binary(above(own));
        if (!right) return {};
        left = make({.kind = Expr::Kind::Binary, .name_span = span(op), .text = op.text}, left.begin, {left, right});
    }
    return left;
}

Node Parser::unary() {
    const bool is_step = is_hlsl() && (now().is("++") || now().is("--"));
    if (!is_step && !now().is("-") && !now().is("!") && !now().is("~") && !now().is("+")) return postfix();
    const Nested nested(*this);
    if (!nested.allowed()) return {};
    const Token op = take();
    const Node operand = unary();
    if (!operand) return {};
    if (is_step) return stepped(operand, op, true);
    return make({.kind = Expr::Kind::Unary, .name_span = span(op), .text = op.text}, op.begin, {operand});
}

Node Parser::postfix() {
    Node node = primary();
    while (node) {
        if (now().is(".")) {
            take();
            if (now().kind != Token::Kind::Word) {
                expected("the name of a member");
                return {};
            }
            node = after().is("(") ? method_of(node) : member_of(node);
        } else if (now().is("[")) {
            node = index_of(node);
        } else if (is_hlsl() && (now().is("++") || now().is("--"))) {
            node = stepped(node, take(), false);
        } else {
            return node;
        }
    }
    return node;
}

// The current token is the word behind the dot.
Node Parser::member_of(const Node& object) {
    const Token word = take();
    return make({.kind = Expr::Kind::Member, .name_span = span(word), .text = word.text}, object.begin, {object});
}

Node Parser::method_of(const Node& object) {
    const Token word = take();
    std::vector<Node> operands{object};
    if (!arguments(take(), operands)) return {};
    return make({.kind = Expr::Kind::Method, .name_span = span(word), .text = word.text}, object.begin, operands);
}

Node Parser::index_of(const Node& object) {
    const Token open = take();
    const Node at = expression();
    if (!at || !expect_close("]", open)) return {};
    return make({.kind = Expr::Kind::Index, .name_span = span(open)}, object.begin, {object, at});
}

Node Parser::primary() {
    switch (now().kind) {
        case Token::Kind::Number: return leaf(Expr::Kind::Number, take());
        case Token::Kind::Property: return leaf(Expr::Kind::Property, take());
        case Token::Kind::Semantic: return leaf(Expr::Kind::Semantic, take());
        case Token::Kind::Word: {
            if (now().text == "true" || now().text == "false") {
                Token word = take();
                word.number = word.text == "true" ? 1 : 0;
                return leaf(Expr::Kind::Bool, word);
            }
            Token word;
            if (dialect_ == Lexer::Dialect::Graph) {
                word = take();
            } else if (!name("a value", word)) {
                return {};
            }
            const Node made = now().is("(") ? call(word) : leaf(Expr::Kind::Name, word);
            return made && is_statement(word) ? Node{} : made;
        }
        case Token::Kind::Punctuation:
            if (!now().is("(")) break;
            return bracketed();
        case Token::Kind::String:
        case Token::Kind::End:
        case Token::Kind::Bad: break;
    }
    expected("a value");
    return {};
}

Node Parser::bracketed() {
    const Token open = take();
    if (is_hlsl() && now().kind == Token::Kind::Word && after().is(")")) return cast(open);
    Node inner = expression();
    while (inner && is_hlsl() && now().is(",")) {
        const Token comma = take();
        const Node next = expression();
        if (!next) return {};
        inner = make({.kind = Expr::Kind::Sequence, .name_span = span(comma), .text = comma.text}, inner.begin,
                     {inner, next});
    }
    if (!inner || !expect_close(")", open)) return {};
    inner.begin = open.begin;
    return inner;
}

// In an expression of a graph, words of statements are names like others, unless a value follows: "if (x) 1". Reports
// that at the word.
bool Parser::is_statement(const Token& word) {
    const bool begins_value = now().kind == Token::Kind::Number || now().kind == Token::Kind::Word ||
                              now().kind == Token::Kind::Property || now().kind == Token::Kind::Semantic ||
                              now().is("(") || now().is("{");
    if (dialect_ != Lexer::Dialect::Graph || !begins_value) return false;
    for (const auto& [statement, instead] : kStatements) {
        if (word.text != statement) continue;
        diagnostics_.report(Code::Syntax, span(word), "a value", describe(word))
            .note(fmt::format("an expression has no '{}': {}", statement, instead));
        return true;
    }
    return false;
}

// The current token is the bracket behind the callee.
Node Parser::call(const Token& callee) {
    std::vector<Node> operands;
    if (!arguments(take(), operands)) return {};
    return make({.kind = Expr::Kind::Call, .name_span = span(callee), .text = callee.text}, callee.begin, operands);
}

bool Parser::arguments(const Token& open, std::vector<Node>& into) {
    if (take_if(")")) return true;
    do {
        const Node argument = expression();
        if (!argument) return false;
        into.push_back(argument);
    } while (take_if(","));
    return expect_close(")", open, "','");
}

// What may follow the '=' of a declaration.
Node Parser::initializer() {
    return now().is("{") ? list() : expression();
}

Node Parser::list() {
    const Nested nested(*this);
    if (!nested.allowed()) return {};
    const Token open = take();
    std::vector<Node> elements;
    while (!now().is("}")) {
        const Node element = initializer();
        if (!element) return {};
        elements.push_back(element);
        if (!take_if(",")) break;
    }
    if (!expect_close("}", open, "','")) return {};
    return make({.kind = Expr::Kind::List, .name_span = span(open)}, open.begin, elements);
}

}  // namespace patina::nodelang
