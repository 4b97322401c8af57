#include "compiler/format/read_budget.h"

#include "compiler/format/read_fields.h"

namespace patina::graph {

CostLimits read_budget(const Json& json, const SourceMap& sources, Diagnostics& diagnostics) {
    constexpr int kMost = 1'000'000;
    nodelang::Ast no_expressions;
    Reading reading{sources, no_expressions, diagnostics};
    CostLimits limits;
    if (!expect(reading, json, Json::Kind::Object, "'budget'")) return limits;
    check_keys(reading, json, ObjectKind::Budget);
    const auto limit = [&](std::string_view key) -> std::optional<CostLimit> {
        const Json* found = json.find(key);
        if (!found) return {};
        const std::optional<int> most = read_int(reading, *found, fmt::format("'budget.{}'", key), 0, kMost);
        return most ? std::optional(CostLimit{.most = *most, .span = found->span}) : std::nullopt;
    };
    limits.instructions = limit("instructions");
    limits.textures = limit("textures");
    return limits;
}

}  // namespace patina::graph
