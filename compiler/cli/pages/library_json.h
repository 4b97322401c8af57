// Nodes, lighting models and rendering paths of the library as JSON, for `nodes --json`, `model --json` and so on.
// Every field is written, unless it is empty.
#pragma once

#include <string>

#include "patina/patina.h"

namespace patina::cli {

std::string to_json(const NodeInfo& node);
std::string to_json(std::span<const NodeInfo* const> nodes);
std::string to_json(const Compiler& compiler, const ModelInfo& model);
std::string to_json(const Compiler& compiler, std::span<const ModelInfo> models);
std::string to_json(std::span<const PathInfo> paths);
std::string to_json(std::span<const EngineInfo> engines);

}  // namespace patina::cli
