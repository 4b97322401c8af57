// A graph as a drawing: each node a box with its ports, each link a line from port to port. Graphviz places them.
//
//   Drawing drawing = draw(view);
//   if (drawing.error.empty()) files.add("rust.svg", drawing.svg);
#pragma once

#include <map>
#include <string>

#include "patina/graph_view.h"

namespace patina::runtime {

// In Graphviz's language.
std::string dot_of(const GraphView& view);

struct Drawing {
    std::string svg{};
    std::string error{};  // empty: there is a drawing
};
// Graphviz takes minutes for more boxes: they are refused.
inline constexpr std::size_t kMostBoxes = 1000;

// The bytes of a PNG file for a box, by its index in GraphView::boxes. It is shown below the box's title.
using BoxPictures = std::map<std::size_t, std::string>;
Drawing draw(const GraphView& view, const BoxPictures& pictures = {});

}  // namespace patina::runtime
