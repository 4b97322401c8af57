// The table of node classes (nodes.def), read once.
//
//   if (const NodeRule* rule = rule_of(node, facts)) for (const Statement& each : rule->statements) ...
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/importers/shadergraph/read/shader_graph.h"

namespace patina::importers::shadergraph {

struct Statement {
    int output = -1;  // slot; -1: "$", which the others read
    std::string text{};
};
struct NodeRule {
    std::string_view condition{};
    std::vector<Statement> statements{};
    std::string_view remark{};
};
// What a condition asks of a node.
struct NodeFacts {
    std::function<bool(int)> is_linked, is_used;   // an input, an output
    std::function<std::size_t(int)> components{};  // of an input's type
    bool is_in_fragment = true;                    // something but the vertex block reads it
};
// Null: the class is not in the table, or no row fits.
const NodeRule* rule_of(const Node& node, const NodeFacts& facts);
// What an input is if the file lacks its slot (inputs.def); empty: 0.
std::string_view value_without_slot(std::string_view kind, int slot);
// The newest version of a class of nodes whose settings are known.
int newest_version(std::string_view kind);
bool is_in_table(std::string_view kind);
std::vector<std::string_view> classes_in_table();  // each once, in order

// Choices "[s|a|b]" and settings "<s>" replaced by what the node says. A choice may have no such value: what is wrong
// then, else empty.
std::string fill_settings(std::string& text, const Node& node, const NodeFacts& facts);

}  // namespace patina::importers::shadergraph
