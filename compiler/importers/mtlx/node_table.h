// The tables of nodes (nodes.def) and surface shaders (surfaces.def), read once.
//
//   if (const NodeRule* rule = rule_of("mix", facts)) for (const Port& each : rule->inputs) ...
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace patina::importers::mtlx {

struct Port {
    std::string name{}, type{};  // type: empty: that of the node
    std::string otherwise{};     // "0.5", "1,1,1", "@UV0"
    std::string unit{};          // of a surface: "micron"; empty: metres and degrees
};
struct Statement {
    std::string output{};     // "out"; "$": a value that the others read; of a surface: its input
    std::string otherwise{};  // of a surface: the input's own default; empty: it is always written
    std::string only_if{};    // of a surface: the input that the document must set, and not to 0
    std::string text{};
};
struct NodeRule {
    std::string_view condition{};
    std::vector<Port> inputs{};
    std::vector<Statement> statements{};
    std::string_view remark{};

    const Port* input(std::string_view name) const;
};
// What a condition asks of a node.
struct NodeFacts {
    std::string_view type{};                               // its own
    std::function<std::string(std::string_view)> type_of;  // of an input; empty: it is not set
    std::function<std::string(std::string_view)> word_of;  // the string, number or switch of an input
};
// Null: the category is not in the table, or no row fits.
const NodeRule* rule_of(std::string_view category, const NodeFacts& facts);
bool is_in_table(std::string_view category);
bool reads_input(std::string_view category, std::string_view input);  // a row of the category

struct TableRow {
    std::string_view category, condition, inputs, outputs, remark;
};
std::span<const TableRow> table_rows();

struct SurfaceRule {
    std::string_view workflow, lighting;
    NodeRule rule{};
    struct Ignored {
        std::string_view input, otherwise, text;
    };
    std::vector<Ignored> ignored{};
};
// Null: it is no surface shader that is known.
const SurfaceRule* surface_rule(std::string_view shader);
std::vector<std::string_view> surface_shaders();

}  // namespace patina::importers::mtlx
