// Adds the dumps of `patina compile --dump`, each only if it is requested.
#pragma once

#include <array>
#include <string_view>

#include "compiler/ir/ir.h"
#include "patina/patina.h"

namespace patina::link {

// The steps that can be dumped.
inline constexpr std::array<std::string_view, 5> kDumps = {"graph", "ir", "linked", "tidy", "rates"};

bool wants_dump(const CompileOptions& options, std::string_view stage);
// `name` is the word of --dump, `label` says which module it is.
void dump_stage(Result& result, const CompileOptions& options, std::string_view name, const std::string& label,
                const ir::Module& module);
void dump_rates(Result& result, const CompileOptions& options, const std::string& label, const ir::Module& module);

}  // namespace patina::link
