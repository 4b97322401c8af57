// Finished stages as texts: a shader a stage and target, functions to be pasted, or the one file of a tool that holds
// all passes; each with its line map. What the texts say is compiler/targets'.
#pragma once

#include "compiler/lower/lower.h"
#include "compiler/output/reflect.h"

namespace patina {

// Both stages of a pass in every language that is asked for.
void print_pass(const graph::Session& session, const assemble::LinkedPass& pass, const std::string& name,
                Result& result);

// False, and a complaint: it cannot begin the names of functions.
bool is_good_prefix(graph::Session& session);
// Functions instead of passes, and their reflection.
void print_functions(const graph::Session& session, const graph::Material& material, graph::Lowered lowered,
                     const std::string& name, Result& result);

// Passes of which a tool's file holds all.
void print_file(const graph::Session& session, const graph::Material& material, const graph::Lowered& lowered,
                std::span<const assemble::LinkedPass> passes, const std::string& name, Result& result);

}  // namespace patina
