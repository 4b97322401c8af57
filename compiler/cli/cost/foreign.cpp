#include "compiler/cli/cost/foreign.h"

#include <algorithm>

namespace patina::cli {

Result compile_if_foreign(const Compiler& compiler, const std::string& graph, CompileOptions options) {
    Result result = compiler.compile_file(graph, options);
    const auto found = std::ranges::find(result.diagnostics, "foreign-text", &Diagnostic::code);
    if (found == result.diagnostics.end()) return result;
    Diagnostic warning = *found;
    warning.severity = Severity::Warning;
    options.targets = {Target::Hlsl};
    result = compiler.compile_file(graph, options);
    result.diagnostics.push_back(std::move(warning));
    return result;
}

}  // namespace patina::cli
