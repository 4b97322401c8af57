#include "compiler/importers/gradient.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "compiler/importers/values.h"

namespace patina::importers::terms {
namespace {

constexpr std::size_t kMostKeys = 8;

// Keys in the order of their times, as a graph writes them.
GraphValue keys_value(std::vector<Gradient::Key> keys, bool is_fixed) {
    std::ranges::stable_sort(keys, {}, &Gradient::Key::time);
    keys.resize(std::min(keys.size(), kMostKeys));
    std::vector<GraphValue> all;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        double time = std::clamp(keys[i].time, 0.0, 1.0);
        // In the engine, each value begins at the key before its own and one per cent of the way.
        if (is_fixed && i + 1 < keys.size()) time += (std::clamp(keys[i + 1].time, 0.0, 1.0) - time) / 100;
        const std::vector<float> numbers(keys[i].value.begin(), keys[i].value.end());
        const GraphValue value = numbers.size() == 1 ? GraphValue(numbers[0]) : list_of(numbers);
        all.push_back(GraphValue::list({static_cast<float>(time), value}));
    }
    return GraphValue::list(std::move(all));
}

}  // namespace

// IEC 61966-2-1. Values above 1 go on as the engine's function does.
double linear(double srgb) {
    if (srgb <= 0.04045) return srgb / 12.92;
    return srgb < 1 ? std::pow((srgb + 0.055) / 1.055, 2.4) : std::pow(srgb, 2.2);
}

GraphValue gradient_value(const Gradient& gradient) {
    const bool is_fixed = gradient.mode == 1;
    std::vector<Gradient::Key> colors = gradient.colors;
    if (gradient.is_perceptual())
        for (Gradient::Key& key : colors)
            for (double& each : key.value) each = linear(each);
    GraphMembers made = {{"colors", keys_value(colors, is_fixed)}};
    if (std::ranges::any_of(gradient.alphas, [](const Gradient::Key& key) { return key.value[0] != 1; }))
        made.push_back({"alphas", keys_value(gradient.alphas, is_fixed)});
    if (gradient.mode == 1 || gradient.is_perceptual()) made.push_back({"blend", is_fixed ? "fixed" : "perceptual"});
    return GraphValue::object(made);
}

}  // namespace patina::importers::terms
