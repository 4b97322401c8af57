// Running single nodes on the CPU: what `patina eval` and the test lines of the library's comments are built on.
#pragma once

#include "compiler/resolve/library.h"
#include "patina/interpret.h"

namespace patina {

// Where names are looked up: the library, or a user's node file on top of it.
struct EvaluationContext {
    const graph::Library& library;
    const nodelang::Declarations& declarations;
    const SourceMap& sources;
    std::span<const NamedValue> names = {};  // what expressions may read besides
};

// One call, not folded, in the interpreter. Fills outputs; reports into `diagnostics`.
struct Evaluation {
    bool ok = false;
    std::vector<EvalOutput> outputs;
    double relative = 0, absolute = 0;  // tolerance of a GPU's result, by the ops that took part
};
Evaluation evaluate_call(const EvaluationContext& context, const nodelang::FunctionDecl& function,
                         std::span<const nodelang::Expr* const> arguments, Precision precision,
                         Diagnostics& diagnostics, Span span);

Evaluation evaluate_expression(const EvaluationContext& context, const nodelang::Expr& expr, Precision precision,
                               Diagnostics& diagnostics);

// Errors in the functions of a file, whether anything calls them or not.
void check_functions(const EvaluationContext& context, const nodelang::Ast& ast, Diagnostics& diagnostics);

// The function's test lines, each with the interpreter's answer. A line that cannot be read is reported.
std::vector<NodeTest> node_tests(const EvaluationContext& context, const nodelang::FunctionDecl& function,
                                 Diagnostics& diagnostics);

}  // namespace patina
