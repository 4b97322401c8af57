// Values of a command line that stand for many: "0..1:101" is 101 numbers from 0 to 1, both included.
//
//   for (const Axis& axis : axes_of(values)) ...
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace patina::cli {

using Values = std::vector<std::pair<std::string, std::string>>;  // name, as written

inline constexpr int kMostSteps = 100000;  // of one axis, and of all of them together

struct Axis {
    std::size_t index = 0;  // of the value that it stands in
    std::vector<double> numbers;
};

// The numbers of a "FROM..TO:COUNT"; nothing if the text is no such thing, in `error` what is wrong if it almost is.
std::optional<std::vector<double>> numbers_of(std::string_view text, std::string& error);

// The axes among the values, in order.
std::vector<Axis> axes_of(const Values& values);

// Every combination of the axes' numbers, the last axis fastest: the values with the numbers in place.
std::vector<Values> combinations(const Values& values, const std::vector<Axis>& axes);

}  // namespace patina::cli
