#include "compiler/emit/constant_value.h"

#include <algorithm>
#include <cmath>

namespace patina::emit {

std::optional<double> constant_value(const Known& known, const Expr& expr, const Scope& scope) {
    const auto of = [&](std::size_t i) { return constant_value(known, *expr.args[i], scope); };
    switch (expr.kind) {
        case Expr::Kind::Number:
        case Expr::Kind::Bool: return expr.number;
        case Expr::Kind::Name: {
            for (auto local = scope.locals.rbegin(); local != scope.locals.rend(); ++local) {
                if (local->name == expr.text) return local->constant;
            }
            const VariableDecl* variable = scope.declarations->variable(expr.text);
            if (variable && variable->is_const && variable->value && !variable->type.array_size) {
                return constant_value(known, *variable->value, scope);
            }
            return variable ? static_value(known, *variable, nullptr).constant : std::nullopt;
        }
        case Expr::Kind::Unary: {
            const std::optional<double> a = of(0);
            if (!a) return {};
            if (expr.text == "-") return -*a;
            if (expr.text == "!") return *a == 0 ? 1 : 0;
            return expr.text == "+" ? a : std::nullopt;
        }
        case Expr::Kind::Ternary: {
            const std::optional<double> condition = of(0);
            if (!condition) return {};
            return of(*condition != 0 ? 1 : 2);
        }
        case Expr::Kind::Binary: {
            // A drop-down is compared with a word: the word is looked up in its enumeration.
            if (expr.text == "==" || expr.text == "!=") {
                for (std::size_t side : {0u, 1u}) {
                    if (expr.args[side]->kind != Expr::Kind::Name) continue;
                    for (const Local& local : scope.locals) {
                        if (local.name != expr.args[side]->text || !local.value.enumerators || !local.constant)
                            continue;
                        const Expr& word = *expr.args[1 - side];
                        const auto& words = *local.value.enumerators;
                        const auto found = std::find(words.begin(), words.end(), word.text);
                        if (word.kind != Expr::Kind::Name || found == words.end()) continue;
                        const bool same = *local.constant == static_cast<double>(found - words.begin());
                        return same == (expr.text == "==") ? 1 : 0;
                    }
                }
            }
            const std::optional<double> a = of(0), b = of(1);
            // One side may decide the result alone.
            if (expr.text == "&&" && ((a && *a == 0) || (b && *b == 0))) return 0;
            if (expr.text == "||" && ((a && *a != 0) || (b && *b != 0))) return 1;
            if (!a || !b) return {};
            if (expr.text == "+") return *a + *b;
            if (expr.text == "-") return *a - *b;
            if (expr.text == "*") return *a * *b;
            // In HLSL, a quotient of integers is cut, and their kind is not known here.
            const bool may_be_cut = scope.hlsl && *a == std::floor(*a) && *b == std::floor(*b);
            if (expr.text == "/" && *b != 0 && !may_be_cut) return *a / *b;
            if (expr.text == "<") return *a < *b;
            if (expr.text == "<=") return *a <= *b;
            if (expr.text == ">") return *a > *b;
            if (expr.text == ">=") return *a >= *b;
            if (expr.text == "==") return *a == *b;
            if (expr.text == "!=") return *a != *b;
            if (expr.text == "&&") return *a != 0 && *b != 0;
            if (expr.text == "||") return *a != 0 || *b != 0;
            return {};
        }
        case Expr::Kind::List:
        case Expr::Kind::Color:
        case Expr::Kind::Property:
        case Expr::Kind::Semantic:
        case Expr::Kind::Member:
        case Expr::Kind::Index:
        case Expr::Kind::Call:
        case Expr::Kind::Method:
        case Expr::Kind::File:
        case Expr::Kind::Object:
        case Expr::Kind::Assign:
        case Expr::Kind::AssignLater:
        case Expr::Kind::Sequence: return {};
    }
    return {};
}

}  // namespace patina::emit
