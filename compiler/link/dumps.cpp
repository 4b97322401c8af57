#include "compiler/link/dumps.h"

#include <algorithm>

#include "compiler/ir/dump.h"

namespace patina::link {

bool wants_dump(const CompileOptions& options, std::string_view stage) {
    return std::find(options.dump.begin(), options.dump.end(), stage) != options.dump.end();
}

void dump_stage(Result& result, const CompileOptions& options, std::string_view name, const std::string& label,
                const ir::Module& module) {
    if (wants_dump(options, name)) result.dumps.push_back({.stage = label, .text = ir::dump(module)});
}

void dump_rates(Result& result, const CompileOptions& options, const std::string& label, const ir::Module& module) {
    if (!wants_dump(options, "rates")) return;
    std::string text;
    for (const ir::Function& function : module.functions) text += ir::dump(module, function, true) + "\n";
    result.dumps.push_back({.stage = label, .text = std::move(text)});
}

}  // namespace patina::link
