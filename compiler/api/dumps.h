// What `patina compile --dump` shows: the stages of a compilation as text, each only if it is asked for.
//
//   dump_graph(result, session, material);
#pragma once

#include "compiler/ir/ir.h"
#include "compiler/resolve/material.h"
#include "patina/patina.h"

namespace patina {

void dump_graph(Result& result, const graph::Session& session, const graph::Material& material);
// `name` is the word of --dump, `label` says which module it is.
void dump_stage(Result& result, const CompileOptions& options, std::string_view name, const std::string& label,
                const ir::Module& module);
void dump_rates(Result& result, const CompileOptions& options, const std::string& label, const ir::Module& module);

}  // namespace patina
