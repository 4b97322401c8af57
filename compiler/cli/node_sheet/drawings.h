// What the pages of nodes say is drawn of each: the lines of docs/nodes/plots.json and pictures.json, which are a part
// of the program.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace patina::cli {

// A line of plots.json: outputs of the node over one variable.
struct PlotWish {
    std::string node{};
    std::string over{};                                         // "roughness=0..1:101"
    std::string label{};                                        // of the axis
    std::vector<std::pair<std::string, std::string>> inputs{};  // as `patina eval` reads them; "{curve}" stands for
    std::string curve{};                                        // this name's
    std::vector<std::string> curves{};                          // values, one for each curve
    std::vector<std::pair<std::string, std::string>> outputs{{"out", "out"}};  // what to call each, and its column
    std::optional<std::array<double, 2>> limits{};                             // of the values
    bool is_log = false;
    bool is_strip = false;  // a band of colours for each curve, instead of lines
};
const PlotWish* plot_wish(std::string_view node);  // null: there is no such line

// A panel of a line of pictures.json.
struct PanelWish {
    std::string expression{};  // of `uv`
    std::string mesh{};        // empty: a flat square
};
// The first panel that reads no texture.
std::optional<PanelWish> panel_wish(std::string_view node);

}  // namespace patina::cli
