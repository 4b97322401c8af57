#include "compiler/format/read_budget.h"

#include "compiler/format/read_fields.h"

namespace patina::graph {

CostLimits read_budget(const Json& material, const SourceMap& sources, Diagnostics& diagnostics) {
    constexpr int kMost = 1'000'000;
    nodelang::Ast no_expressions;
    Reading reading{sources, no_expressions, diagnostics};
    const auto limit = [&](std::string_view key) -> std::optional<CostLimit> {
        const Json* found = material.find(key);
        if (!found) return {};
        const std::optional<int> most = read_int(reading, *found, fmt::format("'{}'", key), 0, kMost);
        return most ? std::optional(CostLimit{.most = *most, .span = found->span}) : std::nullopt;
    };
    return {.instructions = limit("maxInstructions"), .textures = limit("maxTextures")};
}

}  // namespace patina::graph
