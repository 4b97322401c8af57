// Links a material without a pass: its functions as one text that is pasted into an engine's own shaders. Everything
// that the text declares begins with a prefix, so that two materials fit into one shader. What the engine provides has
// no prefix.
//
//   prefix_interface(lowered.module, "Rust_");   // before name_interface()
//   ir::Module text = link_functions(link(std::move(lowered)), Stage::Fragment, "Rust_");
#pragma once

#include "compiler/link/link.h"
#include "patina/patina.h"

namespace patina::link {

// Prefixes the names of the material's block, its members, and the material's textures and samplers.
void prefix_interface(ir::Module& module, std::string_view prefix);

// The functions that one stage can call, tidied, each described in a comment. There is no entry point. There is no
// function if the material has none for this stage.
ir::Module link_functions(const Linked& linked, Stage stage, std::string_view prefix);

// The functions of a module of link_functions(): functions that can be called, and functions that the engine must
// provide.
std::vector<ShaderFunction> describe_functions(const ir::Module& module, Stage stage);

}  // namespace patina::link
