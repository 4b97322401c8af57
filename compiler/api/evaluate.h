// Runs single nodes on the CPU, for `patina eval` and the test lines in the library's comments.
#pragma once

#include "compiler/base/cancellation.h"
#include "compiler/resolve/library.h"
#include "patina/interpret.h"

namespace patina {

// The most work for all evaluations of one call: a test line can call functions that call others almost without end.
struct Effort {
    static constexpr std::uint64_t kMostSteps = 1u << 26;  // a second or two

    Growth growth{.most = Limits{}.instructions};  // of one line
    std::uint64_t steps = kMostSteps;              // that are left to the interpreter
};

// The declarations that names refer to: the library's, or those of a user's node file and the library.
struct EvaluationContext {
    const resolve::Library& library;
    const nodelang::Declarations& declarations;
    const SourceMap& sources;
    std::span<const NamedValue> names = {};  // further values that expressions may read
    Effort* effort = nullptr;                // null: there is no limit
};

// The result of one call, run in the interpreter without folding. Errors go to `diagnostics`.
struct Evaluation {
    bool ok = false;
    std::vector<EvalOutput> outputs;
    double relative = 0, absolute = 0;  // the tolerance of a GPU's result, from the ops that took part
};
Evaluation evaluate_call(const EvaluationContext& context, const nodelang::FunctionDecl& function,
                         std::span<const nodelang::Expr* const> arguments, Precision precision,
                         Diagnostics& diagnostics, Span span);

Evaluation evaluate_expression(const EvaluationContext& context, const nodelang::Expr& expr, Precision precision,
                               Diagnostics& diagnostics);

// Reports errors in the functions of files with nodes, called or not. `first`: the first of them in `ast`.
void check_functions(const EvaluationContext& context, const nodelang::Ast& ast, Diagnostics& diagnostics,
                     std::size_t first = 0);

// The function's test lines, each with the interpreter's result. Reports lines that cannot be read.
std::vector<NodeTest> node_tests(const EvaluationContext& context, const nodelang::FunctionDecl& function,
                                 Diagnostics& diagnostics);

}  // namespace patina
