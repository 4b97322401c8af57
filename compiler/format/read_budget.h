// "budget" of a material: the most that each of its passes may cost. Only a check reads it, so a Graph does not hold
// it.
//
//   const CostLimits limits = read_budget(*json.find("budget"), sources, diagnostics);
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
CostLimits read_budget(const Json& json, const SourceMap& sources, Diagnostics& diagnostics);

}  // namespace patina::graph
