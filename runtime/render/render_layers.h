// A picture with values of its nodes as layers, for `patina render --aov`. Each layer is the preview of a node where
// its object is visible, and transparent zeros elsewhere.
//
//   LayersOutcome outcome = render_layers(compiler, request, {"normalWS", "rust.amount"}, machine);
//   if (outcome.drawn.ok) encode_layers(outcome.drawn.image, outcome.layers);
#pragma once

#include <span>
#include <string>
#include <vector>

#include "runtime/picture/image.h"
#include "runtime/render/render_request.h"

namespace patina::runtime {

struct LayersOutcome {
    RenderOutcome drawn{};  // the picture; not ok if a layer could not be drawn
    std::vector<Layer> layers{};
};

// `request.options.preview` is empty; `request.object` and `request.material` are of the layers.
LayersOutcome render_layers(const Compiler& compiler, const RenderRequest& request, std::span<const std::string> names,
                            RenderMachine& machine);

}  // namespace patina::runtime
