// A gradient of an imported material, and how a graph writes it.
#pragma once

#include <vector>

#include "patina/graph_builder.h"

namespace patina::importers::terms {

double linear(double srgb);  // a component of a colour

struct Gradient {
    struct Key {
        double time = 0;
        std::vector<double> value{};  // a colour as a picker shows it, or an alpha
    };
    std::vector<Key> colors{}, alphas{};
    int mode = 0;  // 0 blend, 1 fixed, 2 perceptual
    bool is_perceptual() const { return mode == 2; }
};
// At a port or as a default: the keys as a picker shows them, but linear if the gradient is perceptual.
GraphValue gradient_value(const Gradient& gradient);

}  // namespace patina::importers::terms
