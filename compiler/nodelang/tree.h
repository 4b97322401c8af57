// Expressions that code makes or changes, and their text. A tree owns what it is made of, so that parts of trees can be
// parts of others.
//
//   const Tree sum = parsed_tree("a + b");
//   printed(*binary("*", sum, number(2)));   // "(a + b) * 2"
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/precedence.h"
#include "compiler/nodelang/ast.h"

namespace patina::nodelang {

using Tree = std::shared_ptr<const Expr>;

// Of the text of an expression of a graph; null: it is none.
Tree parsed_tree(std::string_view text);

Tree number(double value);  // with the fewest digits that are this float
Tree flag(bool value);
Tree name(std::string_view text);  // "mask", "$_Tint", "@uv0"
Tree call(std::string_view function, std::vector<Tree> arguments);
Tree member(Tree object, std::string_view name);
Tree index(Tree object, Tree at);
Tree unary(std::string_view op, Tree operand);
Tree binary(std::string_view op, Tree left, Tree right);
Tree choice(Tree condition, Tree if_true, Tree if_false);

// An operand of the tree.
inline Tree arg(const Tree& tree, std::size_t at) {
    return {tree, tree->args[at]};
}
// The tree with other operands, as many as it has.
Tree with_args(const Tree& tree, std::vector<Tree> args);
// The tree with other parts: `by` is asked about each, from the root down, and null keeps the part.
Tree replaced(const Tree& tree, const std::function<Tree(const Tree&)>& by);

// The value of a number, with or without a sign; else `false` is returned.
bool is_number(const Expr& expr, double& value);
// The expression in one line, with the fewest parentheses: parsing it gives the same tree.
std::string printed(const Expr& expr);
Precedence precedence_of(const Expr& expr);

}  // namespace patina::nodelang
