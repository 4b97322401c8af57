// What the pages of the reference say: one for each node, one for each lighting model.
#pragma once

#include "compiler/cli/pages/page.h"

namespace patina::cli {

// `name`: as the user named it, which for a node file is its path.
Page node_page(const NodeInfo& node, const std::string& name);
// Names of the semantics that its graph asks for, by itself or through the defaults of its nodes: "surface.f0".
std::vector<std::string> semantics_read(const Compiler& compiler, const ModelInfo& model);
// Compiles a material that uses the model, to say what it costs.
Page model_page(const Compiler& compiler, const ModelInfo& model);

}  // namespace patina::cli
