// "maxInstructions" and "maxTextures" of a material: the most that each of its passes may cost. Only a check reads
// them, so a Graph does not hold them.
//
//   const CostLimits limits = read_budget(json, sources, diagnostics);
#pragma once

#include <optional>

#include "compiler/base/diagnostics.h"
#include "compiler/json/json.h"

namespace patina::graph {

struct CostLimit {
    int most = 0;
    Span span{};
};
struct CostLimits {
    std::optional<CostLimit> instructions{}, textures{};
};
CostLimits read_budget(const Json& material, const SourceMap& sources, Diagnostics& diagnostics);

}  // namespace patina::graph
