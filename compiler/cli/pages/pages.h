// The room `cli/pages` makes the pages of the reference. It prints nothing.
//
// The pages of the reference: one for each node, one for each lighting model. This folder makes the output of `patina
// node`, `patina model` and their lists, as text (page.h) or as JSON (library_json.h), and measures the cost of a model
// (model_cost.h). It reads the library through public headers and prints nothing itself.
//
//   print(to_terminal(console, node_page(*compiler.node("Lerp"), "Lerp")));
#pragma once

#include "compiler/cli/pages/page.h"

namespace patina::cli {

// `name`: the node's name, or the path of its file.
Page node_page(const NodeInfo& node, const std::string& name);
// The same for a node of the library, with the name of the node that computes it as an engine does, if there is one.
Page node_page(const NodeInfo& node, const Compiler& compiler);
// The node with every input at its default, ready to paste into "nodes".
std::string example_of(const NodeInfo& node, const std::string& name);
// The semantics that its graph reads, directly or through the defaults of its nodes: "surface.f0".
std::vector<std::string> semantics_read(const Compiler& compiler, const ModelInfo& model);
// Compiles a material that uses the model, to measure its cost.
Page model_page(const Compiler& compiler, const ModelInfo& model);

}  // namespace patina::cli
