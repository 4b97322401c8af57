// Values of a command line that stand for many: "0..1:101" is 101 numbers from 0 to 1, both included. Every combination
// of them is a row of a table.
//
//   const std::vector<Axis> axes = axes_of(values, error);
//   for (const Values& at : combinations(values, axes)) rows.push_back({at, outputs_of(at)});
//   print(sweep_csv(axes, rows));
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "patina/patina.h"

namespace patina::cli {

using Values = std::vector<std::pair<std::string, std::string>>;  // name, as written

struct Axis {
    std::size_t index = 0;  // of the value that it stands in
    std::string name;
    std::vector<double> numbers;
};

// The axes among the values, in order. `error`: what is wrong with one that almost is, or with their number.
std::vector<Axis> axes_of(const Values& values, std::string& error);

// The values with each combination of the axes' numbers in place, the last axis fastest; without axes, the values.
std::vector<Values> combinations(const Values& values, const std::vector<Axis>& axes);

struct SweepRow {
    Values values;
    std::vector<EvalOutput> outputs;
};
// A line of names, then a line a row: the axes, then the outputs, those of vectors as "out.x", "out.y".
std::string sweep_csv(const std::vector<Axis>& axes, const std::vector<SweepRow>& rows);
// A list of objects.
std::string sweep_json(const std::vector<Axis>& axes, const std::vector<SweepRow>& rows);

}  // namespace patina::cli
