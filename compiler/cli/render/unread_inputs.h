// Which inputs of the surface have no effect in a lighting model. A sheet of all models shows them, because the model's
// picture lacks their meaning. Only workflows and models of the library are known; for others the result is empty.
//
//   unread_inputs(compiler, "metal.graph.json", options, "metallic-roughness", "lambert");   // {"roughness"}
#pragma once

#include <string>
#include <vector>

#include "patina/patina.h"

namespace patina::cli {

// Of those that the graph sets.
std::vector<std::string> unread_inputs(const Compiler& compiler, const std::string& graph,
                                       const CompileOptions& options, const std::string& workflow,
                                       const std::string& lighting);

}  // namespace patina::cli
