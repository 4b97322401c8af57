#include "compiler/cli/eval/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "compiler/base/letters.h"
#include "compiler/json/json_writer.h"

namespace patina::cli {
namespace {

constexpr std::size_t kMostRows = 100000;

template <class Number>
bool read_number(std::string_view text, Number& number) {
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && rest == end && !text.empty();
}

// The text with each $name replaced.
std::string with(const std::string& text, const std::string& name, const std::string& number) {
    const std::string wanted = "$" + name;
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = at + wanted.size();
        if (text.compare(at, wanted.size(), wanted) == 0 && (end == text.size() || !is_word_letter(text[end]))) {
            result += "(" + number + ")";
            at = end;
        } else {
            result += text[at++];
        }
    }
    return result;
}

bool is_read(const Values& values, const std::string& name) {
    return std::ranges::any_of(values, [&](const auto& value) { return with(value.second, name, "") != value.second; });
}

}  // namespace

std::optional<std::vector<double>> numbers_of_range(std::string_view text, std::string& error, std::size_t most) {
    const std::size_t dots = text.find("..");
    if (dots == text.npos) return {};
    const std::string_view last = text.substr(dots + 2);
    const std::size_t colon = std::min(last.find(':'), last.size());
    double from = 0, to = 0;
    if (!read_number(text.substr(0, dots), from) || !read_number(last.substr(0, colon), to)) return {};
    int count = 0;
    const bool has_count = colon < last.size() && read_number(last.substr(colon + 1), count);
    if (!has_count || count < 2 || static_cast<std::size_t>(count) > most || !std::isfinite(from) ||
        !std::isfinite(to)) {
        error = fmt::format("'{}' is not of the form FROM..TO:COUNT with a count of 2 to {}", text, most);
        return {};
    }
    std::vector<double> numbers;
    // std::lerp meets both ends exactly.
    for (int i = 0; i < count; ++i) numbers.push_back(std::lerp(from, to, double(i) / (count - 1)));
    return numbers;
}

std::vector<Axis> axes_of(const Values& values, std::string& error) {
    std::vector<Axis> axes;
    double rows = 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto& [name, text] = values[i];
        std::optional<std::vector<double>> numbers = numbers_of_range(text, error, kMostRows);
        if (!error.empty()) return {};
        if (!numbers) continue;
        rows *= static_cast<double>(numbers->size());
        axes.push_back(
            {.index = i, .name = name, .numbers = std::move(*numbers), .is_variable = is_read(values, name)});
    }
    if (rows > kMostRows) {
        error = fmt::format("the ranges have {:.0f} combinations, more than the {} rows that a table may have", rows,
                            kMostRows);
    }
    return axes;
}

std::vector<SweepRow> rows_of(const Values& values, const std::vector<Axis>& axes) {
    std::vector<SweepRow> all = {{.at = {}, .values = values}};
    for (const Axis& axis : axes) {
        std::vector<SweepRow> more;
        for (const SweepRow& before : all) {
            for (double number : axis.numbers) {
                SweepRow& row = more.emplace_back(before);
                row.at.push_back(number);
                const std::string digits = fmt::format("{}", number);
                for (auto& [name, text] : row.values) text = with(text, axis.name, digits);
                row.values[axis.index].second = digits;
            }
        }
        all = std::move(more);
    }
    for (SweepRow& row : all) {
        for (std::size_t i = axes.size(); i-- > 0;) {
            const auto at = row.values.begin() + static_cast<std::ptrdiff_t>(axes[i].index);
            if (axes[i].is_variable) row.values.erase(at);
        }
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
        text += fmt::format("{}", fmt::join(row.at, ","));
        for (const EvalOutput& output : row.outputs) text += fmt::format(",{}", fmt::join(output.values, ","));
        text += "\n";
    }
    return text;
}

std::string sweep_json(const std::vector<Axis>& axes, const std::vector<SweepRow>& rows) {
    JsonWriter json;
    json.begin('[');
    for (const SweepRow& row : rows) {
        json.begin('{');
        for (std::size_t i = 0; i < axes.size(); ++i) json.write(axes[i].name, row.at[i]);
        for (const EvalOutput& output : row.outputs) json.write_numbers(output.name, output.values);
        json.end();
    }
    json.end();
    return json.take() + "\n";
}

}  // namespace patina::cli
