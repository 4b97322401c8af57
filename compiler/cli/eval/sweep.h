// Values of a command line that stand for many: "0..1:101" is 101 numbers from 0 to 1, both included. Every combination
// of them is a row of a table. A range whose name other values read ("theta=0..90:91 ndoth=cos(radians($theta))") is a
// variable, and no value itself.
//
//   const std::vector<Axis> axes = axes_of(values, error);
//   for (SweepRow& row : rows_of(values, axes)) row.outputs = outputs_of(row.values);
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
    bool is_variable = false;
};

// The axes among the values, in order. `error`: what is wrong with one that almost is, or with their number.
std::vector<Axis> axes_of(const Values& values, std::string& error);

struct SweepRow {
    std::vector<double> at;  // by axis
    Values values;           // with the numbers in place
    std::vector<EvalOutput> outputs{};
};
// Each combination of the axes' numbers, the last axis fastest; without axes, the values as they are.
std::vector<SweepRow> rows_of(const Values& values, const std::vector<Axis>& axes);

// A line of names, then a line a row: the axes, then the outputs, those of vectors as "out.x", "out.y".
std::string sweep_csv(const std::vector<Axis>& axes, const std::vector<SweepRow>& rows);
// A list of objects.
std::string sweep_json(const std::vector<Axis>& axes, const std::vector<SweepRow>& rows);

}  // namespace patina::cli
