// A graph as a drawing: each node a box with its ports, each link a line from port to port. Graphviz places them.
//
//   Drawing drawing = draw(dot_of(view));
//   if (drawing.error.empty()) files.add("rust.svg", drawing.svg);
#pragma once

#include <string>

#include "patina/graph_view.h"

namespace patina::runtime {

// In Graphviz's language.
std::string dot_of(const GraphView& view);

struct Drawing {
    std::string svg{};
    std::string error{};  // empty: there is a drawing
};
Drawing draw(const std::string& dot);

}  // namespace patina::runtime
