#include "compiler/nodelang/tree.h"

#include "compiler/base/diagnostics.h"
#include "compiler/base/text.h"
#include "compiler/nodelang/parse.h"

namespace patina::nodelang {
namespace {

// What a tree consists of that was made, and what one consists of that was parsed.
struct Made {
    Expr expr{};
    std::string text{};
    std::vector<Tree> args{};
};
struct Parsed {
    std::string text{};
    Ast ast{};
};

Tree made(Expr::Kind kind, std::string_view text, std::vector<Tree> args, double value = 0) {
    const auto owner = std::make_shared<Made>();
    owner->text = text;
    owner->args = std::move(args);
    owner->expr.kind = kind;
    owner->expr.text = owner->text;
    owner->expr.number = value;
    owner->expr.number_kind = NumberKind::Float;
    for (const Tree& each : owner->args) owner->expr.args.push_back(each.get());
    return {owner, &owner->expr};
}

std::string at_least(Precedence needed, const Expr& expr) {
    const std::string text = printed(expr);
    return precedence_of(expr) < needed ? "(" + text + ")" : text;
}

// Before a dot or a bracket: "4.x" would be a number.
std::string object_of(const Expr& expr) {
    return expr.kind == Expr::Kind::Number ? "(" + printed(expr) + ")" : at_least(Precedence::Postfix, expr);
}

std::string list_of(const Expr& expr, std::size_t first) {
    std::string made;
    for (std::size_t i = first; i < expr.args.size(); ++i) made += (i > first ? ", " : "") + printed(*expr.args[i]);
    return made;
}

}  // namespace

Tree parsed_tree(std::string_view text) {
    const auto owner = std::make_shared<Parsed>();
    owner->text = text;
    Diagnostics diagnostics;
    const Expr* const root = parse_expression({.text = owner->text, .base = 1}, owner->ast, diagnostics);
    return root ? Tree(owner, root) : Tree();
}

Tree number(double value) {
    return made(Expr::Kind::Number, shortest(static_cast<float>(value)), {}, value);
}

Tree flag(bool value) {
    return made(Expr::Kind::Bool, value ? "true" : "false", {}, value ? 1 : 0);
}

Tree name(std::string_view text) {
    if (text.starts_with('$')) return made(Expr::Kind::Property, text.substr(1), {});
    if (text.starts_with('@')) return made(Expr::Kind::Semantic, text.substr(1), {});
    return made(Expr::Kind::Name, text, {});
}

Tree call(std::string_view function, std::vector<Tree> arguments) {
    return made(Expr::Kind::Call, function, std::move(arguments));
}

Tree member(Tree object, std::string_view name) {
    return made(Expr::Kind::Member, name, {std::move(object)});
}

Tree index(Tree object, Tree at) {
    return made(Expr::Kind::Index, {}, {std::move(object), std::move(at)});
}

Tree unary(std::string_view op, Tree operand) {
    return made(Expr::Kind::Unary, op, {std::move(operand)});
}

Tree binary(std::string_view op, Tree left, Tree right) {
    return made(Expr::Kind::Binary, op, {std::move(left), std::move(right)});
}

Tree choice(Tree condition, Tree if_true, Tree if_false) {
    return made(Expr::Kind::Ternary, "?", {std::move(condition), std::move(if_true), std::move(if_false)});
}

Tree with_args(const Tree& tree, std::vector<Tree> args) {
    return made(tree->kind, tree->text, std::move(args));
}

Tree replaced(const Tree& tree, const std::function<Tree(const Tree&)>& by) {
    if (const Tree other = by(tree)) return other;
    std::vector<Tree> args;
    bool is_changed = false;
    for (std::size_t i = 0; i < tree->args.size(); ++i) {
        args.push_back(replaced(arg(tree, i), by));
        is_changed = is_changed || args.back().get() != tree->args[i];
    }
    return is_changed ? with_args(tree, std::move(args)) : tree;
}

bool is_number(const Expr& expr, double& value) {
    if (expr.kind == Expr::Kind::Unary && expr.text == "-" && is_number(*expr.args[0], value)) {
        value = -value;
        return true;
    }
    if (expr.kind != Expr::Kind::Number) return false;
    value = expr.number;
    return true;
}

Precedence precedence_of(const Expr& expr) {
    switch (expr.kind) {
        case Expr::Kind::Number: return expr.text.starts_with('-') ? Precedence::Unary : Precedence::Primary;
        case Expr::Kind::Bool:
        case Expr::Kind::List:
        case Expr::Kind::Color:
        case Expr::Kind::Name:
        case Expr::Kind::Property:
        case Expr::Kind::Semantic:
        case Expr::Kind::File:
        case Expr::Kind::Object: return Precedence::Primary;
        case Expr::Kind::Member:
        case Expr::Kind::Index:
        case Expr::Kind::Call:
        case Expr::Kind::Method: return Precedence::Postfix;
        case Expr::Kind::Unary: return Precedence::Unary;
        case Expr::Kind::Binary: return binary_precedence(expr.text);
        case Expr::Kind::Ternary: return Precedence::Ternary;
        case Expr::Kind::Sequence:
        case Expr::Kind::Assign:
        case Expr::Kind::AssignLater: return Precedence::Any;
    }
    return Precedence::Any;
}

std::string printed(const Expr& expr) {
    const std::string text(expr.text);
    switch (expr.kind) {
        case Expr::Kind::Number:
        case Expr::Kind::Color:
        case Expr::Kind::Name: return text;
        case Expr::Kind::Bool: return expr.number != 0 ? "true" : "false";
        case Expr::Kind::Property: return "$" + text;
        case Expr::Kind::Semantic: return "@" + text;
        case Expr::Kind::File: return "\"" + text + "\"";
        case Expr::Kind::List: return "{" + list_of(expr, 0) + "}";
        case Expr::Kind::Member: return object_of(*expr.args[0]) + "." + text;
        case Expr::Kind::Index: return object_of(*expr.args[0]) + "[" + printed(*expr.args[1]) + "]";
        case Expr::Kind::Object:
        case Expr::Kind::Call: return text + "(" + list_of(expr, 0) + ")";
        case Expr::Kind::Method: return object_of(*expr.args[0]) + "." + text + "(" + list_of(expr, 1) + ")";
        case Expr::Kind::Unary: {
            const std::string operand = at_least(Precedence::Unary, *expr.args[0]);
            return operand.starts_with(text) ? text + "(" + operand + ")" : text + operand;  // "-(-a)"
        }
        case Expr::Kind::Binary: {
            const Precedence own = precedence_of(expr);
            return at_least(own, *expr.args[0]) + " " + text + " " + at_least(above(own), *expr.args[1]);
        }
        case Expr::Kind::Ternary:
            return at_least(Precedence::LogicalOr, *expr.args[0]) + " ? " + printed(*expr.args[1]) + " : " +
                   at_least(Precedence::Ternary, *expr.args[2]);
        case Expr::Kind::Sequence: return printed(*expr.args[0]) + ", " + printed(*expr.args[1]);
        case Expr::Kind::Assign:
        case Expr::Kind::AssignLater:
            return at_least(Precedence::Unary, *expr.args[0]) + " " + text + " " + printed(*expr.args[1]);
    }
    return text;
}

}  // namespace patina::nodelang
