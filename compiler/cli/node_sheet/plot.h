// A plot of a node as SVG, and its bands of colours as pixels: what scripts/pictures draws for its page, smaller.
#pragma once

#include <optional>
#include <string>

#include "compiler/cli/node_sheet/drawings.h"
#include "patina/patina.h"
#include "runtime/picture/image.h"

namespace patina::cli {

// Lines and axes, of a width of 240 pixels. Nothing if the node cannot be computed, or if no curve is finite anywhere.
std::optional<std::string> plot_svg(const Compiler& compiler, const PlotWish& wish);
// Linear colours, a band for each curve. Nothing if the node cannot be computed.
std::optional<runtime::Image> plot_bands(const Compiler& compiler, const PlotWish& wish, int width, int height);

// What to plot of a node for which no line says it: its first output over the input that has a range, or over the first
// one. Nothing if it is no number, or is the same everywhere.
std::optional<PlotWish> usual_plot(const Compiler& compiler, const NodeInfo& node);

}  // namespace patina::cli
