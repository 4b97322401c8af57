// Patterns of expressions that get values. Numbers are computed, and what changes nothing is left out ("+ 0", "* 1").
//
//   computed("(a - b) / (c - b)", {value, low, high}, Type::Float);
//   const Pattern pattern = pattern_of("{in1} + {in2}");   // of a table
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/importers/terms.h"

namespace patina::importers::terms {

// The pattern with the terms as a, b, c, ... in it.
Term computed(std::string_view pattern, const std::vector<Term>& terms, Type type);

// "a * b * c", without brackets if a factor is a product; without factors 1.
Term product(const std::vector<Term>& factors);

// The text of a row of a table: "{...}" stands for a value, and "$" for one that was computed before.
struct Pattern {
    Tree tree{};
    std::vector<std::string> places{};  // what the brackets hold, in their order
};
Pattern pattern_of(std::string_view text);
std::optional<std::size_t> place_of(const nodelang::Expr& part);  // the number of the brackets
bool is_self(const nodelang::Expr& part);                         // "$"

// A tree with the terms that `term_of` knows; null: the part stays as it is. A tree that is a term in the end is that
// term.
using TermOf = std::function<const Term*(const nodelang::Expr&)>;
Term filled(const Tree& pattern, const TermOf& term_of, Type type);

}  // namespace patina::importers::terms
