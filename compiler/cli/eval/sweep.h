// The room `cli/eval` makes the tables of numbers that `patina eval` shows. It prints nothing.
//
// Ranges of numbers on the command line of `patina eval` and of `patina render --time`: "0..1:101" is 101 numbers from
// 0 to 1, both included. Every combination of the ranges' numbers is a row of a table. If other values read a range by
// its name ("theta=0..90:91 ndoth=cos(radians($theta))"), it is a variable and not an input.
//
//   const std::vector<Axis> axes = axes_of(values, error);
//   for (SweepRow& row : rows_of(values, axes)) row.outputs = outputs_of(row.values);
//   print(sweep_csv(axes, rows));
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "patina/patina.h"

namespace patina::cli {

using Values = std::vector<std::pair<std::string, std::string>>;  // name, as written

struct Axis {
    std::size_t index = 0;  // of the value that has the range
    std::string name;
    std::vector<double> numbers;
    bool is_variable = false;
};

// "0..1:11": its numbers; nothing and no error if the text is not a range. `error`: what is wrong with a range.
std::optional<std::vector<double>> numbers_of_range(std::string_view text, std::string& error, std::size_t most);

// The ranges among the values, in order. `error`: what is wrong with a range, or with the number of rows.
std::vector<Axis> axes_of(const Values& values, std::string& error);

struct SweepRow {
    std::vector<double> at;  // by axis
    Values values;           // with a number in place of each range
    std::vector<EvalOutput> outputs{};
};
// Each combination of the axes' numbers, the last axis fastest; without axes, the values as they are.
std::vector<SweepRow> rows_of(const Values& values, const std::vector<Axis>& axes);

// A line of names, then a line for each row: the axes, then the outputs. A vector is "out.x", "out.y" and so on.
std::string sweep_csv(const std::vector<Axis>& axes, const std::vector<SweepRow>& rows);
// A list of objects.
std::string sweep_json(const std::vector<Axis>& axes, const std::vector<SweepRow>& rows);

}  // namespace patina::cli
