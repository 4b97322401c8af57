// Checks a graph: loads its files, finds the meaning of every node (a function, a sub-graph, an expression), resolves
// ports and links, finds circles, and sorts the nodes so that each comes after the nodes that it reads. Types are
// checked when the graph is lowered (lower.h), where they are known.
#pragma once

#include "compiler/resolve/session.h"

namespace patina::resolve {

// How many sub-graphs may be used through one another: most steps recurse into them.
inline constexpr std::size_t kMostLevels = 200;

struct ResolvedNode {
    const nodelang::FunctionDecl* function = nullptr;
    const nodelang::Declarations* home = nullptr;
    const CheckedGraph* subgraph = nullptr;
    std::vector<std::uint32_t> reads;  // nodes, each once
    bool ok = true;                    // false: its meaning was not found, which has been reported
};

struct CheckedGraph {
    std::shared_ptr<const format::Graph> graph;
    std::vector<ResolvedNode> nodes;
    std::unordered_map<std::string_view, std::uint32_t> by_id;
    std::vector<std::uint32_t> order;  // all nodes
    std::size_t size = 0;              // nodes, with those of each use of a sub-graph
    std::size_t levels = 1;            // files that use one another, with this graph's
    bool ok = true;

    // Marks the nodes that the expressions read, directly or through other nodes.
    std::vector<bool> reachable(std::span<const format::PortValue> roots) const;
    std::vector<bool> reachable(std::uint32_t node) const;
};

// The port that a preview shows, as seen from one graph: a link ("mask.amount"), or a port inside the sub-graph of a
// node ("layers/mask.amount").
struct Shown {
    std::string_view text{};  // null: the port is not in this graph
    std::uint32_t base = 0;   // of the text in the source map

    explicit operator bool() const { return text.data() != nullptr; }
    // The link, or the node whose sub-graph has the port.
    Shown head() const { return {text.substr(0, text.find('/')), base}; }
    Shown inside(std::string_view node) const;
};
// The output that a sub-graph gets in addition, with the shown port inside; no output of a file can have this name.
inline constexpr std::string_view kShown = "/shown";
// The value to show, as this graph reads it. Null after an error.
const nodelang::Expr* parse_shown(Session& session, const Shown& shown);

const CheckedGraph* check_graph(Session& session, std::shared_ptr<const format::Graph> graph, const Shown& shown = {});

// Reads and checks a graph file of the given kind, once for each file. Exception: a sub-graph with the previewed port
// inside, which is read again with that port as an output more. Null after an error.
const CheckedGraph* load_graph(Session& session, const std::string& path, format::GraphKind kind, Span where,
                               const Shown& shown = {});

// Reads a .node.hlsl file; each file once. Null after an error.
const NodeFile* load_node_file(Session& session, const std::string& path, Span where);

// Collects the nodes of `graph` that an expression names.
void collect_reads(const nodelang::Expr& expr, const CheckedGraph& graph, std::vector<std::uint32_t>& reads);

// The [range] of a parameter or of a function's result.
std::optional<std::array<double, 2>> range_of(std::span<const nodelang::Attribute> attributes);
// Reports a literal outside a range. In a list, only the first `components` are checked, because alpha has no range.
void check_range(Session& session, const nodelang::Expr& value, std::array<double, 2> range, bool hard,
                 std::string_view name, std::size_t components = 4);

}  // namespace patina::resolve
