// A material without a pass: its functions as one text that is pasted into shaders of an engine's own. Whatever it
// declares begins with a prefix, so that two materials can stand in one shader; what the engine provides does not.
//
//   prefix_interface(lowered.module, "Rust_");   // before name_interface()
//   ir::Module text = link_functions(link(std::move(lowered)), Stage::Fragment, "Rust_");
#pragma once

#include "compiler/link/link.h"
#include "patina/patina.h"

namespace patina::assemble {

// Names of the material's block, of what is in it, and of its textures and samplers.
void prefix_interface(ir::Module& module, std::string_view prefix);

// The functions that one stage calls, tidied, each told about in a comment. No entry point; no function at all if the
// material has none for this stage.
ir::Module link_functions(const Linked& linked, Stage stage, std::string_view prefix);

// What can be called, and what the engine must provide, of a module that link_functions() made.
std::vector<ShaderFunction> describe_functions(const ir::Module& module, Stage stage);

}  // namespace patina::assemble
