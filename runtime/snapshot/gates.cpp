#include "runtime/snapshot/gates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace patina::runtime {
namespace {

constexpr ToleranceKey kKeys[] = {
    {"pixel", &Tolerance::pixel, 0, 1},           {"share", &Tolerance::share, 0, 1},
    {"average", &Tolerance::average, 0, 1},       {"tile", &Tolerance::tile, 0, 1},
    {"perceptual", &Tolerance::perceptual, 0, 1}, {"otherDriver", &Tolerance::other_driver, 1, 1000}};

std::string shown_value(const Gate& gate, double value) {
    return gate.name == "share" ? fmt::format("{:.3g} %", 100 * value) : fmt::format("{:.2g}", value);
}

}  // namespace

std::span<const ToleranceKey> tolerance_keys() {
    return kKeys;
}

const ToleranceKey* find_tolerance_key(std::string_view name) {
    const auto* found = std::ranges::find(kKeys, name, &ToleranceKey::name);
    return found == std::end(kKeys) ? nullptr : found;
}

std::string check_tolerance(const ToleranceKey& key, double value) {
    if (std::isfinite(value) && value >= key.lowest && value <= key.highest) return {};
    return fmt::format("'{}' must be between {} and {}", key.name, key.lowest, key.highest);
}

Tolerance widened(Tolerance tolerance) {
    for (double* limit : {&tolerance.share, &tolerance.average, &tolerance.tile, &tolerance.perceptual})
        *limit = std::min(*limit * tolerance.other_driver, 1.0);
    return tolerance;
}

std::vector<Gate> figures(const Comparison& comparison, double perceptual, const Tolerance& tolerance) {
    return {{"share", comparison.share, tolerance.share},
            {"average", comparison.average, tolerance.average},
            {"tile", comparison.tile, tolerance.tile},
            {"perceptual", perceptual, tolerance.perceptual}};
}

bool all_pass(std::span<const Gate> gates) {
    return std::ranges::all_of(gates, &Gate::passes);
}

std::string to_text(const Gate& gate) {
    const std::string text = fmt::format("{} {}", gate.name, shown_value(gate, gate.value));
    return gate.passes() ? text : text + fmt::format(" (limit {})", shown_value(gate, gate.limit));
}

}  // namespace patina::runtime
