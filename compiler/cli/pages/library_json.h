// Nodes, lighting models and rendering paths of the library as JSON, for `nodes --json`, `model --json` and so on;
// and what shaders read of the engine, for `values --json`.
// Every field is written, unless it is empty.
#pragma once

#include <string>

#include "patina/engine_values.h"
#include "patina/patina.h"

namespace patina::cli {

std::string to_json(const NodeInfo& node);
std::string to_json(std::span<const NodeInfo* const> nodes);
// With what the model costs, for which it compiles a material.
std::string to_json(const Compiler& compiler, const ModelInfo& model);
std::string to_json(const Compiler& compiler, std::span<const ModelInfo> models);
std::string to_json(std::span<const PathInfo> paths);
std::string to_json(std::span<const EngineInfo> engines);
std::string to_json(std::span<const SemanticInfo> semantics, std::span<const EngineBlockInfo> blocks);

}  // namespace patina::cli
