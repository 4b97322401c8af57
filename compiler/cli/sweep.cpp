#include "compiler/cli/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "compiler/base/text.h"
#include "compiler/cli/json_numbers.h"

namespace patina::cli {
namespace {

constexpr int kMostRows = 100000;

template <class Number>
bool read_number(std::string_view text, Number& number) {
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && rest == end && !text.empty();
}

// Nothing, and no error, if the text is no such thing.
std::optional<std::vector<double>> numbers_of(std::string_view text, std::string& error) {
    const std::size_t dots = text.find("..");
    if (dots == text.npos) return {};
    const std::string_view last = text.substr(dots + 2);
    const std::size_t colon = std::min(last.find(':'), last.size());
    double from = 0, to = 0;
    if (!read_number(text.substr(0, dots), from) || !read_number(last.substr(0, colon), to)) return {};
    int count = 0;
    const bool has_count = colon < last.size() && read_number(last.substr(colon + 1), count);
    if (!has_count || count < 2 || count > kMostRows || !std::isfinite(from) || !std::isfinite(to)) {
        error = fmt::format("'{}' is not of the form FROM..TO:COUNT with a count of 2 to {}", text, kMostRows);
        return {};
    }
    std::vector<double> numbers;
    // Of lerp it is known that it meets the ends exactly.
    for (int i = 0; i < count; ++i) numbers.push_back(std::lerp(from, to, double(i) / (count - 1)));
    return numbers;
}

std::vector<std::string> numbers_at(const std::vector<Axis>& axes, const SweepRow& row) {
    std::vector<std::string> numbers;
    for (const Axis& axis : axes) numbers.push_back(row.values[axis.index].second);
    return numbers;
}

}  // namespace

std::vector<Axis> axes_of(const Values& values, std::string& error) {
    std::vector<Axis> axes;
    double rows = 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::optional<std::vector<double>> numbers = numbers_of(values[i].second, error);
        if (!error.empty()) return {};
        if (!numbers) continue;
        rows *= static_cast<double>(numbers->size());
        axes.push_back({.index = i, .name = values[i].first, .numbers = std::move(*numbers)});
    }
    if (rows > kMostRows) {
        error = fmt::format("the ranges have {:.0f} combinations, more than the {} rows that a table may have", rows,
                            kMostRows);
    }
    return axes;
}

std::vector<Values> combinations(const Values& values, const std::vector<Axis>& axes) {
    std::vector<Values> all = {values};
    for (const Axis& axis : axes) {
        std::vector<Values> more;
        for (const Values& before : all) {
            for (double number : axis.numbers) {
                more.push_back(before);
                more.back()[axis.index].second = shortest(number);
            }
        }
        all = std::move(more);
    }
    return all;
}

std::string sweep_csv(const std::vector<Axis>& axes, const std::vector<SweepRow>& rows) {
    std::vector<std::string> names;
    for (const Axis& axis : axes) names.push_back(axis.name);
    for (const EvalOutput& output : rows.front().outputs) {
        const std::size_t count = output.values.size();
        for (std::size_t i = 0; i < count; ++i) {
            const std::string part = count == 1   ? ""
                                     : count <= 4 ? fmt::format(".{}", "xyzw"[i])
                                                  : fmt::format(".{}", i);
            names.push_back(output.name + part);
        }
    }
    std::string text = fmt::format("{}\n", fmt::join(names, ","));
    for (const SweepRow& row : rows) {
        text += fmt::format("{}", fmt::join(numbers_at(axes, row), ","));
        for (const EvalOutput& output : row.outputs) text += fmt::format(",{}", fmt::join(output.values, ","));
        text += "\n";
    }
    return text;
}

std::string sweep_json(const std::vector<Axis>& axes, const std::vector<SweepRow>& rows) {
    rapidjson::StringBuffer buffer;
    JsonWriter writer(buffer);
    writer.StartArray();
    for (const SweepRow& row : rows) {
        writer.StartObject();
        for (const Axis& axis : axes) {
            writer.Key(axis.name.c_str());
            const std::string& number = row.values[axis.index].second;
            writer.RawValue(number.data(), number.size(), rapidjson::kNumberType);
        }
        for (const EvalOutput& output : row.outputs) {
            writer.Key(output.name.c_str());
            write_numbers(writer, output.values);
        }
        writer.EndObject();
    }
    writer.EndArray();
    return std::string(buffer.GetString()) + "\n";
}

}  // namespace patina::cli
