// Decides the condition of an #if of which all macros have been replaced.
#pragma once

#include <set>
#include <span>
#include <string_view>

#include "compiler/nodelang/lex.h"

namespace patina::nodelang {

struct Decision {
    bool holds = false;
    std::string_view error{};  // what was expected; empty: nothing is wrong
    Token at{};                // instead of it; the end: nothing follows
};
// A name that is left is 0, as in C. But only names in `zeros` may be compared or computed with: only the engine has
// the values of other names.
Decision decide(std::span<const Token> condition, const std::set<std::string_view>& zeros);

}  // namespace patina::nodelang
