// Graph -> CheckedGraph: files loaded, every node's meaning found (a function, a sub-graph, an expression), ports and
// links resolved, circles found, and the nodes put in an order in which each stands behind what it reads. Types are
// checked when the graph is lowered (lower.h), where they are known.
#pragma once

#include "compiler/resolve/session.h"

namespace patina::graph {

struct ResolvedNode {
    const nodelang::FunctionDecl* function = nullptr;
    const nodelang::Declarations* home = nullptr;
    const CheckedGraph* subgraph = nullptr;
    std::vector<std::uint32_t> reads;  // nodes, each once
    bool ok = true;                    // false: its meaning was not found, and that has been reported
};

struct CheckedGraph {
    std::shared_ptr<const Graph> graph;
    std::vector<ResolvedNode> nodes;
    std::unordered_map<std::string_view, std::uint32_t> by_id;
    std::vector<std::uint32_t> order;  // all nodes
    bool ok = true;

    // Marks what the expressions read, directly or not.
    std::vector<bool> reachable(std::span<const PortValue> roots) const;
    std::vector<bool> reachable(std::uint32_t node) const;
};

// What a preview shows, as seen from one graph: a link ("mask.amount"), or what a sub-graph's node has inside
// ("layers/mask.amount").
struct Shown {
    std::string_view text{};  // null: nothing in here
    std::uint32_t base = 0;   // of the text in the source map

    explicit operator bool() const { return text.data() != nullptr; }
    // The link, or the node that it goes into.
    Shown head() const { return {text.substr(0, text.find('/')), base}; }
    Shown inside(std::string_view node) const;
};
const nodelang::Expr* parse_shown(Session& session, const Shown& shown);

const CheckedGraph* check_graph(Session& session, std::shared_ptr<const Graph> graph, const Shown& shown = {});

// Reads and checks a graph file of the given kind; each file once, but for a sub-graph of which something inside is
// shown: that is then its only output. Null after an error.
const CheckedGraph* load_graph(Session& session, const std::string& path, GraphKind kind, Span where,
                               const Shown& shown = {});

// Reads a .node.hlsl file; each file once. Null after an error.
const NodeFile* load_node_file(Session& session, const std::string& path, Span where);

// Nodes of `graph` that an expression names.
void collect_reads(const nodelang::Expr& expr, const CheckedGraph& graph, std::vector<std::uint32_t>& reads);

// What [range] says, of a parameter or of what a function returns.
std::optional<std::array<double, 2>> range_of(std::span<const nodelang::Attribute> attributes);
// Complains about a literal outside a range.
// Of a list, the first `components`: alpha has no range.
void check_range(Session& session, const nodelang::Expr& value, std::array<double, 2> range, bool hard,
                 std::string_view name, std::size_t components = 4);

}  // namespace patina::graph
