#include "compiler/resolve/check_graph.h"

#include <algorithm>

#include "compiler/base/file_names.h"
#include "compiler/base/text.h"
#include "compiler/format/read_graph.h"
#include "compiler/json/json.h"
#include "compiler/nodelang/other_names.h"
#include "compiler/nodelang/parse.h"

namespace patina::resolve {

using nodelang::Expr;

namespace {

constexpr std::size_t kMostNodes = Limits::kNone;  // a count stays there: graphs in graphs can have any number

std::vector<std::string_view> input_names(const ResolvedNode& node) {
    std::vector<std::string_view> names;
    if (node.function) {
        for (const nodelang::ParamDecl& param : node.function->params) {
            const bool hidden = std::any_of(param.attributes.begin(), param.attributes.end(),
                                            [](const nodelang::Attribute& a) { return a.name == "hidden"; });
            if (param.is_input() && !hidden) names.push_back(param.name);
        }
    } else if (node.subgraph) {
        for (const format::Input& input : node.subgraph->graph->inputs) names.push_back(input.name);
    }
    return names;
}

void find_meaning(Session& session, const format::Graph& graph, const format::Node& node, const Shown& inside,
                  ResolvedNode& resolved) {
    resolved.ok = false;
    if (!node.type_span) return;  // it has no type: reported already
    if (!is_file_name(node.type)) {
        const nodelang::Declarations& library = session.library.declarations;
        const nodelang::FunctionDecl* function = library.function(node.type);
        if (!function || !function->attribute("node")) {
            const bool is_shown = !session.diagnostics.is_full();
            DiagnosticRecord& record = session.diagnostics.report(Code::UnknownNode, node.type_span, node.type);
            if (!is_shown) return;  // advice takes longer than all else that is done for a node
            if (function) {
                record.note(
                    function->name_span,
                    fmt::format("'{}' is a function of the library, but no node: that has [node(\"Family/Name\")]",
                                node.type));
                return;
            }
            std::vector<std::string_view> known = library.function_names();
            std::erase_if(known, [&](std::string_view name) { return !library.function(name)->attribute("node"); });
            const std::string advice = nodelang::node_advice(node.type, known, library);
            if (!advice.empty())
                record.note(advice);
            else if (node.type.find_first_of("./\\") != std::string::npos)
                record.note(fmt::format("start a file name with ./, as in './{}'", node.type));
            else
                record.note("'patina nodes' lists the library's nodes; start a file name with ./");
            return;
        }
        resolved.function = function;
        resolved.home = &session.library.declarations;
        resolved.ok = true;
        return;
    }
    const std::string path = require_source(session, node.type, graph.path, node.type_span);
    if (path.empty()) return;
    if (node.type.ends_with(".hlsl") || path.ends_with(".hlsl")) {  // the path may be an id
        const NodeFile* file = load_node_file(session, path, node.type_span);
        if (!file) return;
        resolved.function = file->node;
        resolved.home = &file->declarations;
    } else {
        resolved.subgraph = load_graph(session, path, format::GraphKind::Subgraph, node.type_span, inside);
        if (!resolved.subgraph) return;
    }
    resolved.ok = true;
}

void check_ports(Session& session, const format::Node& node, const ResolvedNode& resolved) {
    const std::vector<std::string_view> names = input_names(resolved);
    for (const format::PortValue& port : node.inputs) {
        if (std::find(names.begin(), names.end(), port.name) == names.end()) {
            session.diagnostics.report(Code::UnknownPort, port.name_span, node.type, "input", port.name)
                .note(nodelang::port_advice(port.name, names, resolved.function));
            continue;
        }
        if (!port.value) continue;
        if (resolved.subgraph) {
            for (const format::Input& input : resolved.subgraph->graph->inputs) {
                if (input.name == port.name && input.range) {
                    check_range(session, *port.value, *input.range, input.hard, port.name);
                }
            }
            continue;
        }
        for (const nodelang::ParamDecl& param : resolved.function->params) {
            if (param.name != port.name) continue;
            if (const auto range = range_of(param.attributes))
                check_range(session, *port.value, *range, false, port.name);
        }
    }
}

// Counts a node with what its sub-graph has. Reports the one that is too many; the library's own graphs are free.
void count_node(Session& session, const format::Node& node, const ResolvedNode& resolved, CheckedGraph& checked) {
    const std::size_t most = session.options.limits.nodes, before = checked.size;
    const std::size_t own = 1 + (resolved.subgraph ? resolved.subgraph->size : 0);
    checked.size = own > kMostNodes - before ? kMostNodes : before + own;
    if (session.stopped || checked.size <= most || !session.library.sources.file(node.span.begin).empty()) return;
    session.diagnostics.report(Code::OverBudget, node.id_span, "nodes", checked.size, most)
        .note(resolved.subgraph ? "each use of a sub-graph counts all of its nodes" : "");
    session.stopped = true;
}

// Reports a sub-graph with too many levels inside it for the level at which it is used.
bool is_too_deep(Session& session, std::size_t levels, Span where) {
    if (session.active.size() + levels <= kMostLevels) return false;
    session.diagnostics.report(Code::TooDeep, where, kMostLevels)
        .note("each sub-graph that is used through another one is a level");
    return true;
}

// Of a search: a node, and which of the nodes that it reads comes next.
struct Step {
    std::uint32_t node = 0;
    std::size_t next = 0;
};

// "a > b > c > a", in the direction of the data: each node feeds the one before it in the search. Of a long circle, the
// first nodes and the last one are named.
std::string circle_of(const format::Graph& graph, std::span<const Step> search) {
    constexpr std::size_t kMostNamed = 12, kFirst = 4;
    std::string circle = graph.nodes[search.front().node].id;
    for (std::size_t i = 1; i <= search.size(); ++i) {
        if (i == kFirst && search.size() > kMostNamed) {
            const std::size_t left_out = search.size() - kFirst - 1;
            circle += fmt::format(" > ({} more)", left_out);
            i += left_out;
        }
        circle += " > " + graph.nodes[search[search.size() - i].node].id;
    }
    return circle;
}

// A depth-first search without recursion, so that a chain of ten thousand nodes does not overflow the stack.
void sort_nodes(Session& session, CheckedGraph& checked) {
    enum class Mark : std::uint8_t { New, Open, Done };
    std::vector<Mark> marks(checked.nodes.size(), Mark::New);
    std::vector<std::size_t> depths(checked.nodes.size());  // of nodes that are open: their places on the stack
    std::vector<Step> stack;
    for (std::uint32_t root = 0; root < checked.nodes.size(); ++root) {
        if (marks[root] != Mark::New) continue;
        stack.push_back({.node = root});
        marks[root] = Mark::Open;
        depths[root] = 0;
        while (!stack.empty()) {
            auto& [node, next] = stack.back();
            const std::vector<std::uint32_t>& reads = checked.nodes[node].reads;
            if (next == reads.size()) {
                marks[node] = Mark::Done;
                checked.order.push_back(node);
                stack.pop_back();
                continue;
            }
            const std::uint32_t read = reads[next++];
            if (marks[read] == Mark::New) {
                marks[read] = Mark::Open;
                depths[read] = stack.size();
                stack.push_back({.node = read});
            } else if (marks[read] == Mark::Open) {
                const format::Node& at = checked.graph->nodes[read];
                const std::string circle = circle_of(*checked.graph, std::span(stack).subspan(depths[read]));
                session.diagnostics.report(Code::Cycle, at.id_span, circle).at(at.id);
                checked.ok = false;
            }
        }
    }
}

}  // namespace

const NodeFile* load_node_file(Session& session, const std::string& path, Span where) {
    if (const auto found = session.node_files.find(path); found != session.node_files.end()) {
        return found->second.get();
    }
    std::unique_ptr<NodeFile>& slot = session.node_files[path];
    const std::optional<std::uint32_t> base = load_source(session, path, where);
    if (!base) return nullptr;
    auto file = std::make_unique<NodeFile>();
    const std::size_t errors = session.diagnostics.error_count();
    file->declarations.parent = &session.library.declarations;
    nodelang::parse_file({.text = session.sources.file_text(*base), .base = *base}, file->ast, session.diagnostics);
    nodelang::index_declarations(file->ast, file->declarations, session.diagnostics);
    for (const nodelang::FunctionDecl& f : file->ast.functions) {
        const nodelang::Attribute* foreign = f.attribute("foreign");
        if (foreign && (!f.has_body || !foreign->args.empty()))
            session.diagnostics.report(Code::BadAttribute, foreign->span, "foreign",
                                       "of a node file is written like this: [foreign] float f(float x) { ... }");
        const nodelang::Attribute* attribute = f.attribute("node");
        if (!attribute) continue;
        if (file->node) {
            session.diagnostics
                .report(Code::BadAttribute, attribute->span, "node", "is on a second function of the file")
                .note(file->node->name_span, "the first is here; helpers need no attribute");
        } else {
            file->node = &f;
        }
    }
    if (session.diagnostics.error_count() != errors) return nullptr;
    if (!file->node) {
        // Without a graph that names it, the place is the file.
        session.diagnostics.report(Code::NoNodeInFile, where ? where : Span{*base, *base}, "[node]")
            .note({*base, *base}, "write [node(\"Category/Title\")] before a function");
        return nullptr;
    }
    slot = std::move(file);
    return slot.get();
}

void collect_reads(const Expr& expr, const CheckedGraph& graph, std::vector<std::uint32_t>& reads) {
    if (expr.kind == Expr::Kind::Name) {
        const auto found = graph.by_id.find(expr.text);
        if (found != graph.by_id.end()) reads.push_back(found->second);
    }
    for (const Expr* argument : expr.args) collect_reads(*argument, graph, reads);
}

std::vector<bool> CheckedGraph::reachable(std::span<const format::PortValue> roots) const {
    std::vector<std::uint32_t> work;
    for (const format::PortValue& root : roots) {
        if (root.value) collect_reads(*root.value, *this, work);
    }
    std::vector<bool> seen(nodes.size(), false);
    while (!work.empty()) {
        const std::uint32_t node = work.back();
        work.pop_back();
        if (seen[node]) continue;
        seen[node] = true;
        work.insert(work.end(), nodes[node].reads.begin(), nodes[node].reads.end());
    }
    return seen;
}

std::vector<bool> CheckedGraph::reachable(std::uint32_t node) const {
    std::vector<std::uint32_t> work{node};
    std::vector<bool> seen(nodes.size(), false);
    while (!work.empty()) {
        const std::uint32_t at = work.back();
        work.pop_back();
        if (seen[at]) continue;
        seen[at] = true;
        work.insert(work.end(), nodes[at].reads.begin(), nodes[at].reads.end());
    }
    return seen;
}

std::optional<std::array<double, 2>> range_of(std::span<const nodelang::Attribute> attributes) {
    for (const nodelang::Attribute& attribute : attributes) {
        if (attribute.name != "range" || attribute.args.size() != 2) continue;
        std::array<double, 2> range{};
        for (std::size_t i : {0u, 1u}) {
            const Expr& bound = *attribute.args[i];
            range[i] = bound.kind == Expr::Kind::Unary ? -bound.args[0]->number : bound.number;
        }
        return range;
    }
    return {};
}

void check_range(Session& session, const Expr& value, std::array<double, 2> range, bool hard, std::string_view name,
                 std::size_t components) {
    if (value.kind == Expr::Kind::List || value.kind == Expr::Kind::Color) {
        for (std::size_t i = 0; i < std::min(components, value.args.size()); ++i)
            check_range(session, *value.args[i], range, hard, name);
        return;
    }
    const bool negative = value.kind == Expr::Kind::Unary && value.text == "-";
    const Expr& literal = negative ? *value.args[0] : value;
    if (literal.kind != Expr::Kind::Number) return;
    const double number = negative ? -literal.number : literal.number;
    if (number >= range[0] && number <= range[1]) return;
    session.diagnostics.report(hard ? Code::OutOfRange : Code::SoftRange, value.span, shortest(number),
                               shortest(range[0]), shortest(range[1]), name);
}

Shown Shown::inside(std::string_view node) const {
    if (!text.starts_with(node) || text.size() == node.size() || text[node.size()] != '/') return {};
    return {text.substr(node.size() + 1), base + static_cast<std::uint32_t>(node.size() + 1)};
}

const Expr* parse_shown(Session& session, const Shown& shown) {
    const Shown head = shown.head();
    const Expr* link = nodelang::parse_link({.text = head.text, .base = head.base}, session.ast, session.diagnostics);
    if (!link || head.text.size() == shown.text.size()) return link;
    if (link->kind != Expr::Kind::Name) {
        session.diagnostics.report(Code::DanglingLink, link->span, head.text);
        return nullptr;
    }
    Expr& inside = session.ast.exprs.emplace_back(*link);
    inside.kind = Expr::Kind::Member;
    inside.text = kShown;
    inside.args = {link};
    return &inside;
}

const CheckedGraph* check_graph(Session& session, std::shared_ptr<const format::Graph> graph, const Shown& shown) {
    CheckedGraph& checked = session.checked.emplace_back();
    checked.graph = graph;
    checked.nodes.resize(graph->nodes.size());
    for (std::uint32_t i = 0; i < graph->nodes.size(); ++i) checked.by_id.emplace(graph->nodes[i].id, i);
    for (std::uint32_t i = 0; i < graph->nodes.size(); ++i) {
        const format::Node& node = graph->nodes[i];
        ResolvedNode& resolved = checked.nodes[i];
        if (must_stop(session)) {
            resolved.ok = false;
            continue;
        }
        session.diagnostics.set_context(node.id, {});
        const Shown inside = shown.inside(node.id);
        if (node.is_expression) {
            resolved.ok = node.expr != nullptr;
            if (node.expr) collect_reads(*node.expr, checked, resolved.reads);
        } else {
            find_meaning(session, *graph, node, inside, resolved);
            if (resolved.ok) check_ports(session, node, resolved);
            for (const format::PortValue& port : node.inputs) {
                if (port.value) collect_reads(*port.value, checked, resolved.reads);
            }
        }
        if (inside && resolved.ok && !resolved.subgraph) {
            const Span span{inside.base, inside.base + static_cast<std::uint32_t>(inside.text.size())};
            session.diagnostics.report(Code::DanglingLink, span, inside.text)
                .note(fmt::format("'{}' is not a sub-graph and has no nodes inside", node.id));
        }
        if (resolved.subgraph) checked.levels = std::max(checked.levels, 1 + resolved.subgraph->levels);
        count_node(session, node, resolved, checked);
        std::sort(resolved.reads.begin(), resolved.reads.end());
        resolved.reads.erase(std::unique(resolved.reads.begin(), resolved.reads.end()), resolved.reads.end());
        session.diagnostics.set_context({}, {});
    }
    sort_nodes(session, checked);
    return &checked;
}

const CheckedGraph* load_graph(Session& session, const std::string& path, format::GraphKind kind, Span where,
                               const Shown& shown) {
    if (const auto found = session.graphs.find(path); !shown && found != session.graphs.end())
        return found->second && is_too_deep(session, found->second->levels, where) ? nullptr : found->second;
    if (std::find(session.active.begin(), session.active.end(), path) != session.active.end()) {
        std::string chain;
        for (const std::string& active : session.active) chain += active + " > ";
        session.diagnostics.report(Code::RecursiveSubgraph, where, chain + path);
        return nullptr;
    }
    if (is_too_deep(session, 1, where)) return nullptr;
    const std::optional<std::uint32_t> base = load_source(session, path, where);
    if (!base) return nullptr;
    session.active.push_back(path);
    const std::size_t errors = session.diagnostics.error_count();
    const CheckedGraph* checked = nullptr;
    if (const std::unique_ptr<json::Json> json = json::parse_json(session.sources, *base, session.diagnostics);
        json && !must_stop(session)) {
        if (auto graph = format::read_graph(*json, path, session.sources, session.ast, session.diagnostics, kind)) {
            if (shown) {
                const Expr* value = parse_shown(session, shown);
                graph->outputs.push_back({.name = std::string(kShown),
                                          .name_span = where,
                                          .value_span = value ? value->span : where,
                                          .value = value});
            }
            checked = check_graph(session, graph, shown);
        }
    }
    session.active.pop_back();
    // A broken sub-graph is reported once, and not again by the nodes that use it.
    if (session.diagnostics.error_count() != errors) checked = nullptr;
    if (!shown) session.graphs[path] = checked;
    return checked;
}

}  // namespace patina::resolve
