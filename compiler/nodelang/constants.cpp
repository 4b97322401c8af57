#include "compiler/nodelang/constants.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace patina::nodelang {
namespace {

constexpr std::size_t kDeepestConstant = 64;  // constants that are made of constants
constexpr std::size_t kLargest = 100'000;     // expressions, if all constants are written out

class Checker {
public:
    Checker(const Declarations& declarations, Diagnostics& diagnostics)
        : declarations_(declarations), diagnostics_(diagnostics) {}

    // How many expressions the constant stands for, and how deeply constants are nested in it. 0: it is wrong, and that
    // has been reported.
    struct Size {
        std::size_t expressions = 0, height = 0;
    };
    // `at`: where the constant is read.
    Size size_of(const VariableDecl& constant, Span at) {
        const auto [found, is_new] = sizes_.try_emplace(&constant);
        if (!is_new && !is_open(constant)) return found->second;
        open_.push_back(&constant);
        Size size;
        if (!is_new) {
            std::string chain;
            const auto first = std::find(open_.begin(), open_.end(), &constant);
            for (auto each = first; each != open_.end(); ++each)
                chain += fmt::format("{}{}", each == first ? "" : " > ", (*each)->name);
            diagnostics_.report(Code::Recursion, at, chain);
        } else if (open_.size() > kDeepestConstant) {
            diagnostics_.report(Code::TooDeep, at, kDeepestConstant);
        } else {
            size = {.expressions = 1, .height = 1};
            for (const Expr* part : {constant.value, constant.type.array_size}) {
                if (part && size.expressions > 0) add(*part, size);
            }
            if (size.height > kDeepestConstant) {
                diagnostics_.report(Code::TooDeep, constant.span, kDeepestConstant);
                size = {};
            } else if (size.expressions > kLargest) {
                diagnostics_.report(Code::TooMany, constant.span, size.expressions, "expressions of a constant",
                                    kLargest);
                size = {};
            }
        }
        open_.pop_back();
        return sizes_[&constant] = size;
    }

private:
    bool is_open(const VariableDecl& constant) const {
        return std::find(open_.begin(), open_.end(), &constant) != open_.end();
    }

    // Adds the size of the expression; after an error, `size` is empty.
    void add(const Expr& expr, Size& size) {
        ++size.expressions;
        if (expr.kind == Expr::Kind::Name) {
            const auto found = declarations_.variables.find(expr.text);
            if (found != declarations_.variables.end() && found->second->is_const) {
                const Size more = size_of(*found->second, expr.span);
                if (more.expressions == 0) return void(size = {});
                size.expressions += more.expressions;
                size.height = std::max(size.height, more.height + 1);
            }
        }
        for (const Expr* arg : expr.args) {
            if (size.expressions > 0) add(*arg, size);
        }
    }

    const Declarations& declarations_;
    Diagnostics& diagnostics_;
    std::unordered_map<const VariableDecl*, Size> sizes_{};
    std::vector<const VariableDecl*> open_{};  // the innermost last
};

}  // namespace

void check_constants(Ast& ast, Declarations& declarations, Diagnostics& diagnostics) {
    Checker checker(declarations, diagnostics);
    std::vector<const VariableDecl*> wrong;
    for (const VariableDecl& variable : ast.variables) {
        if (variable.is_const && checker.size_of(variable, variable.span).expressions == 0) wrong.push_back(&variable);
    }
    for (const VariableDecl* variable : wrong) {
        declarations.variables[variable->name] =
            &ast.variables.emplace_back(VariableDecl{.type = {.name = variable->type.name, .span = variable->type.span},
                                                     .name = variable->name,
                                                     .span = variable->span,
                                                     .is_const = true,
                                                     .is_hlsl = variable->is_hlsl});
    }
}

}  // namespace patina::nodelang
