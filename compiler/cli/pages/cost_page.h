// What the passes of a graph cost, as text: `patina cost`.
#pragma once

#include <string>
#include <string_view>

#include "patina/cost.h"

namespace patina::cli {

// Tables of the stages, and of the nodes of each stage. `graph`: the file that they are about.
std::string cost_page(const MaterialCost& cost, std::string_view graph);

}  // namespace patina::cli
