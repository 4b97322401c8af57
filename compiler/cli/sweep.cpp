#include "compiler/cli/sweep.h"

#include <charconv>
#include <cmath>

#include "compiler/base/text.h"

namespace patina::cli {
namespace {

template <class Number>
bool read_number(std::string_view text, Number& number) {
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && rest == end && !text.empty();
}

}  // namespace

std::optional<std::vector<double>> numbers_of(std::string_view text, std::string& error) {
    const std::size_t dots = text.find("..");
    if (dots == text.npos) return {};
    std::string_view last = text.substr(dots + 2);
    const std::size_t colon = std::min(last.find(':'), last.size());
    double from = 0, to = 0;
    if (!read_number(text.substr(0, dots), from) || !read_number(last.substr(0, colon), to)) return {};
    int count = 0;
    const bool has_count = colon < last.size() && read_number(last.substr(colon + 1), count);
    if (!has_count || count < 2 || count > kMostSteps || !std::isfinite(from) || !std::isfinite(to)) {
        error = "'" + std::string(text) + "' is not of the form FROM..TO:COUNT with a count of 2 to " +
                std::to_string(kMostSteps);
        return {};
    }
    std::vector<double> numbers;
    // The ends are met exactly.
    for (int i = 0; i < count; ++i) numbers.push_back(std::lerp(from, to, double(i) / (count - 1)));
    return numbers;
}

std::vector<Axis> axes_of(const Values& values) {
    std::vector<Axis> axes;
    std::string ignored;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (auto numbers = numbers_of(values[i].second, ignored)) axes.push_back({i, std::move(*numbers)});
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

}  // namespace patina::cli
