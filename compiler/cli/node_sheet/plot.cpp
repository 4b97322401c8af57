#include "compiler/cli/node_sheet/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/cli/eval/sweep.h"
#include "runtime/page/escaped.h"

namespace patina::cli {
namespace {

constexpr int kPoints = 81;
constexpr double kWidth = 240, kHeight = 170, kLeft = 40, kTop = 22, kRight = 232, kBottom = 138;
constexpr std::string_view kColors[] = {"#3b7dd8", "#e07b25", "#3b9f4a", "#c93b3b",
                                        "#8f62c2", "#8a5a44", "#d467a8", "#7d8a94"};

struct Table {
    std::vector<double> at{};
    std::vector<std::vector<EvalOutput>> rows{};
};

std::string replaced(std::string text, const std::string& word, const std::string& value) {
    for (std::size_t at = 0; !word.empty() && (at = text.find(word, at)) != text.npos; at += value.size())
        text.replace(at, word.size(), value);
    return text;
}

// The outputs of one curve. Nothing if one of them cannot be computed.
std::optional<Table> table_of(const Compiler& compiler, const PlotWish& wish, const std::string& value, int points) {
    const std::size_t equals = wish.over.find('=');
    Values values = {{wish.over.substr(0, equals),
                      wish.over.substr(equals + 1, wish.over.find(':') - equals - 1) + fmt::format(":{}", points)}};
    bool is_read = false;
    for (const auto& [name, text] : wish.inputs) {
        values.emplace_back(name, replaced(text, "{" + wish.curve + "}", value));
        is_read |= values.back().second != text;
    }
    if (!wish.curve.empty() && !is_read) values.emplace_back(wish.curve, value);
    std::string error;
    const std::vector<Axis> axes = axes_of(values, error);
    if (axes.size() != 1) return std::nullopt;
    Table made{.at = axes[0].numbers};
    for (const SweepRow& row : rows_of(values, axes)) {
        EvalResult result = compiler.evaluate(wish.node, row.values, false);
        if (!result.ok) return std::nullopt;
        made.rows.push_back(std::move(result.outputs));
    }
    return made;
}

// "out", "out.x", "tail.y".
double column(const std::vector<EvalOutput>& outputs, std::string_view name) {
    const std::size_t dot = name.find('.');
    const auto found = std::ranges::find(outputs, name.substr(0, dot), &EvalOutput::name);
    if (found == outputs.end()) return NAN;
    const std::size_t part = dot == name.npos ? 0 : std::string_view("xyzw").find(name.substr(dot + 1));
    return part < found->values.size() ? found->values[part] : NAN;
}

struct Curve {
    std::string name{}, color{};
    std::size_t style = 0;
    std::vector<double> values{};
};

struct Curves {
    std::vector<double> at{};
    std::vector<Curve> all{};
};

std::optional<Curves> curves_of(const Compiler& compiler, const PlotWish& wish) {
    Curves made;
    const std::vector<std::string> values = wish.curves.empty() ? std::vector<std::string>{""} : wish.curves;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::optional<Table> table = table_of(compiler, wish, values[i], kPoints);
        if (!table) return std::nullopt;
        made.at = table->at;
        for (std::size_t j = 0; j < wish.outputs.size(); ++j) {
            const auto& [name, part] = wish.outputs[j];
            Curve curve{.name = values[i],
                        .color = std::string(kColors[(wish.curve.empty() ? j : i) % std::size(kColors)]),
                        .style = wish.curve.empty() ? 0 : j};
            if (wish.curve.empty() && name == "red") curve.color = kColors[3];
            if (wish.curve.empty() && name == "green") curve.color = kColors[2];
            if (wish.curve.empty() && name == "blue") curve.color = kColors[0];
            if (wish.outputs.size() > 1) curve.name += (curve.name.empty() ? "" : " ") + name;
            for (const auto& row : table->rows) curve.values.push_back(column(row, part));
            made.all.push_back(std::move(curve));
        }
    }
    return made;
}

// From the lowest to the highest value that is finite, with room where they are equal.
std::optional<std::array<double, 2>> limits_of(const Curves& curves, const PlotWish& wish) {
    if (wish.limits) return wish.limits;
    std::optional<std::array<double, 2>> made;
    for (const Curve& curve : curves.all)
        for (const double each : curve.values) {
            if (!std::isfinite(each) || (wish.is_log && each <= 0)) continue;
            if (!made) made = {each, each};
            (*made)[0] = std::min((*made)[0], each);
            (*made)[1] = std::max((*made)[1], each);
        }
    if (made && (*made)[1] - (*made)[0] < 1e-9) made = {(*made)[0] - 0.5, (*made)[1] + 0.5};
    return made;
}

std::string polyline(const Curve& curve, const std::vector<double>& at, std::array<double, 2> limits, bool is_log) {
    static constexpr std::string_view kStyles[] = {"", " stroke-dasharray=\"6 3\"", " stroke-dasharray=\"2 2\"",
                                                   " stroke-dasharray=\"6 2 2 2\""};
    const auto scaled = [&](double value) { return is_log ? std::log10(value) : value; };
    const double low = scaled(limits[0]), high = scaled(limits[1]);
    std::string made, points;
    const auto end = [&] {
        if (!points.empty())
            made += fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{} points=\"{}\"/>",
                                curve.color, kStyles[curve.style % 4], points);
        points.clear();
    };
    for (std::size_t i = 0; i < at.size(); ++i) {
        const double value = scaled(curve.values[i]);
        if (!std::isfinite(value)) {
            end();
            continue;
        }
        const double share = std::clamp((value - low) / (high - low), -1.0, 2.0);
        points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ",
                              kLeft + (kRight - kLeft) * (at[i] - at.front()) / (at.back() - at.front()),
                              kBottom - (kBottom - kTop) * share);
    }
    end();
    return made;
}

std::string label(double x, double y, std::string_view anchor, std::string_view text) {
    return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>", x, y, anchor, runtime::escaped(text));
}

std::string legend(const Curves& curves, const PlotWish& wish) {
    if (curves.all.size() < 2) return {};
    std::string made = wish.curve.empty() ? std::string() : runtime::escaped(wish.curve) + " ";
    std::size_t length = wish.curve.size();
    for (const Curve& each : curves.all) {
        length += each.name.size() + 1;
        if (length > 40) {
            made += "&#8230;";
            break;
        }
        made += fmt::format("<tspan fill=\"{}\">{}</tspan> ", each.color, runtime::escaped(each.name));
    }
    return fmt::format("<text x=\"{}\" y=\"13\">{}</text>", kLeft, made);
}

}  // namespace

std::optional<std::string> plot_svg(const Compiler& compiler, const PlotWish& wish) {
    const std::optional<Curves> curves = curves_of(compiler, wish);
    if (!curves) return std::nullopt;
    const std::optional<std::array<double, 2>> limits = limits_of(*curves, wish);
    if (!limits) return std::nullopt;
    std::string made = fmt::format(
        "<svg viewBox=\"0 0 {} {}\" font-size=\"10\" fill=\"currentColor\" role=\"img\"><title>{}</title>"
        "<clipPath id=\"plot-{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>",
        kWidth, kHeight, runtime::escaped(wish.node + " over " + wish.label), wish.node, kLeft, kTop - 1,
        kRight - kLeft, kBottom - kTop + 2);
    made += fmt::format("<path fill=\"none\" stroke=\"currentColor\" opacity=\"0.35\" d=\"M{0} {1}V{2}H{3}\"/>", kLeft,
                        kTop, kBottom, kRight);
    if (!wish.is_log && (*limits)[0] < 0 && (*limits)[1] > 0) {
        const double zero = kBottom + (kBottom - kTop) * (*limits)[0] / ((*limits)[1] - (*limits)[0]);
        made +=
            fmt::format("<path stroke=\"currentColor\" opacity=\"0.2\" d=\"M{} {:.1f}H{}\"/>", kLeft, zero, kRight) +
            label(kLeft - 4, zero + 3, "end", "0");
    }
    made += fmt::format("<g clip-path=\"url(#plot-{})\">", wish.node);
    for (const Curve& each : curves->all) made += polyline(each, curves->at, *limits, wish.is_log);
    made += "</g>" + legend(*curves, wish);
    // What only rounding makes unequal to 0 is 0.
    const auto digits = [](double value, double most) {
        return fmt::format("{:.3g}", std::abs(value) < 1e-9 * std::abs(most) || value == 0 ? 0.0 : value);
    };
    made += label(kLeft - 4, kTop + 7, "end", digits((*limits)[1], (*limits)[0]));
    made += label(kLeft - 4, kBottom, "end", digits((*limits)[0], (*limits)[1]));
    made += label(kLeft, kBottom + 12, "start", digits(curves->at.front(), curves->at.back()));
    made += label(kRight, kBottom + 12, "end", digits(curves->at.back(), curves->at.front()));
    constexpr std::size_t kLongest = 42;
    std::string under = wish.label;
    if (under.size() > kLongest) under = under.substr(0, under.find_last_of(" ", kLongest - 4)) + " ...";
    made += label(kWidth / 2, kBottom + 26, "middle", under);
    return made + "</svg>";
}

std::optional<runtime::Image> plot_bands(const Compiler& compiler, const PlotWish& wish, int width, int height) {
    const std::vector<std::string> values = wish.curves.empty() ? std::vector<std::string>{""} : wish.curves;
    runtime::Image made = runtime::make_image(width, height);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::optional<Table> table = table_of(compiler, wish, values[i], width);
        if (!table) return std::nullopt;
        for (int y = int(i) * height / int(values.size()); y < int(i + 1) * height / int(values.size()); ++y)
            for (int x = 0; x < width; ++x)
                for (std::size_t c = 0; c < 3; ++c)
                    made.at(x, y)[c] = runtime::to_unit_range(
                        float(column(table->rows[std::size_t(x)], fmt::format("out.{}", "xyz"[c]))));
    }
    return made;
}

std::optional<PlotWish> usual_plot(const Compiler& compiler, const NodeInfo& node) {
    const auto is_number = [](const PortInfo& port) { return port.type == "float" || port.type == "floatN"; };
    const auto output = std::ranges::find_if(node.ports, [](const PortInfo& each) { return each.is_output; });
    if (output == node.ports.end() || !is_number(*output)) return std::nullopt;
    const PortInfo* over = nullptr;
    for (const PortInfo& each : node.ports) {
        if (each.is_output || !is_number(each)) continue;
        if (!over || (each.range && !over->range)) over = &each;
    }
    if (!over) return std::nullopt;
    const double far = over->unit == "rad" ? 6.28 : over->unit == "deg" ? 360 : 2;
    const std::array<double, 2> range = over->range.value_or(std::array<double, 2>{-far, far});
    PlotWish made{
        .node = node.name, .over = fmt::format("{}={}..{}:2", over->name, range[0], range[1]), .label = over->name};
    for (const PortInfo& each : node.ports) {
        if (each.is_output || &each == over) continue;
        if (each.default_value.empty() || each.default_value.starts_with('@'))
            made.inputs.emplace_back(each.name, "0.5");
    }
    const std::optional<Curves> curves = curves_of(compiler, made);
    if (!curves) return std::nullopt;
    const std::vector<double>& values = curves->all[0].values;
    const bool is_flat =
        std::ranges::all_of(values, [&](double each) { return each == values[0] || !std::isfinite(each); });
    return is_flat ? std::nullopt : std::optional(made);
}

}  // namespace patina::cli
