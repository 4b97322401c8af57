#include <fmt/format.h>

#include <algorithm>

#include "compiler/cli/cost/report.h"

namespace patina::cli {
namespace {

using Row = std::vector<std::string>;

std::string number(std::uint32_t count) {
    return count == 0 ? "-" : std::to_string(count);
}

void add(Row& row, const CostCounts& counts) {
    for (const CostFigure& figure : kCostFigures) row.push_back(number(counts.*figure.count));
}

// The titles of the columns from add() come between the other titles.
Row titles(Row before, const Row& after) {
    for (const CostFigure& figure : kCostFigures) before.emplace_back(figure.name);
    before.insert(before.end(), after.begin(), after.end());
    return before;
}

// Columns as wide as their widest cell. The first `texts` ones are words, and the others numbers.
std::string table(const std::vector<Row>& rows, std::size_t texts) {
    std::vector<std::size_t> widths;
    for (const Row& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            line += i < texts ? fmt::format("{:<{}}", row[i], widths[i]) : fmt::format("{:>{}}", row[i], widths[i]);
            line += "  ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += "  " + line + "\n";
    }
    return text;
}

void add_stage(std::vector<Row>& rows, std::string pass, std::string each, const StageCost& cost, std::uint32_t bytes) {
    Row row = {std::move(pass), std::move(each)};
    add(row, cost.once);
    row.insert(row.end(), {number(cost.varyings), number(cost.registers), number(bytes)});
    rows.push_back(std::move(row));
    if (cost.per_light.instructions == 0) return;
    add(rows.emplace_back(Row{"", "light"}), cost.per_light);
}

std::string passes_table(const CostReport& report) {
    std::vector<Row> rows = {titles({"pass", "for each"}, {"varyings", "registers", "uniform bytes"})};
    for (const MeasuredPass& pass : report.passes) {
        add_stage(rows, pass.name, "vertex", pass.cost.vertex, 0);
        add_stage(rows, "", "pixel", pass.cost.fragment, pass.cost.uniform_bytes);
    }
    return table(rows, 2);
}

std::string name_of(const CostShare& share) {
    switch (share.part) {
        case CostShare::Part::Node: return share.node;
        case CostShare::Part::Surface: return "(surface)";
        case CostShare::Part::Lighting: return "(lighting)";
        case CostShare::Part::Pass: return "(pass)";
    }
    return {};
}

std::string shares_table(const MeasuredStage& stage) {
    std::vector<Row> rows = {titles({"node"}, {"instructions for each light"})};
    const auto add_row = [&](std::string name, const CostCounts& once, const CostCounts& per_light) {
        Row& row = rows.emplace_back(Row{std::move(name)});
        add(row, once);
        row.push_back(number(per_light.instructions));
    };
    for (const CostShare& share : stage.shares) add_row(name_of(share), share.once, share.per_light);
    add_row("all", stage.cost.once, stage.cost.per_light);
    return table(rows, 1);
}

// A stage in which no node of the graph and no surface input adds anything has one part, or two.
bool has_nodes(const MeasuredStage& stage) {
    return std::ranges::any_of(stage.shares, [](const CostShare& share) {
        const bool is_graphs = share.part == CostShare::Part::Node || share.part == CostShare::Part::Surface;
        return is_graphs && share.once.instructions + share.per_light.instructions > 0;
    });
}

}  // namespace

std::string report_text(const CostReport& report, const Console& console) {
    std::string text = heading(console, report.graph) + "\n" + passes_table(report);
    for (const MeasuredPass& pass : report.passes) {
        for (const bool is_vertex : {true, false}) {
            const MeasuredStage& stage = is_vertex ? pass.vertex : pass.fragment;
            if (!has_nodes(stage)) continue;
            text += fmt::format("\n  pass {}, for each {}\n", pass.name, is_vertex ? "vertex" : "pixel");
            text += shares_table(stage);
        }
    }
    return text;
}

}  // namespace patina::cli
