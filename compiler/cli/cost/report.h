// The room `cli/cost` is the command `patina cost`. This file turns what was measured into tables or JSON.
//
//   CostReport report = {.graph = input.path, .passes = measure(compiled)};
//   print(report_text(report, console));
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/cli/console.h"
#include "patina/cost.h"

namespace patina::cli {

struct CostReport {
    std::string graph{};
    std::vector<MeasuredPass> passes{};
};

std::string report_text(const CostReport& report, const Console& console);
// One object for all graphs.
std::string report_json(std::span<const CostReport> reports);

}  // namespace patina::cli
