// view_graph(): the boxes and lines of a checked graph.
#include <algorithm>
#include <set>
#include <tuple>

#include "compiler/api/compiler_impl.h"
#include "compiler/api/report.h"
#include "compiler/format/read_budget.h"
#include "compiler/format/read_graph.h"
#include "compiler/json/json.h"
#include "compiler/resolve/check_graph.h"
#include "patina/graph_view.h"

namespace patina {
namespace {

using nodelang::Expr;

std::string_view kind_of(graph::GraphKind kind) {
    switch (kind) {
        case graph::GraphKind::Material: return "material";
        case graph::GraphKind::Subgraph: return "subgraph";
        case graph::GraphKind::Lighting: return "lighting";
        case graph::GraphKind::Workflow: return "workflow";
    }
    return {};
}

class View {
public:
    View(graph::Session& session, const graph::CheckedGraph& checked, GraphView& view)
        : session_(session), checked_(checked), graph_(*checked.graph), view_(view) {}

    void make() {
        for (std::size_t i = 0; i < graph_.nodes.size(); ++i) add_node(graph_.nodes[i], checked_.nodes[i]);
        add_list("vertex", graph_.vertex);
        add_list("surface", graph_.surface);
        add_list("outputs", graph_.outputs);
        for (const graph::ExtraPass& pass : graph_.passes) {
            if (!is_same(pass.graph->vertex, graph_.vertex))
                add_list("pass " + pass.name + " vertex", pass.graph->vertex);
            if (!is_same(pass.graph->surface, graph_.surface)) add_list("pass " + pass.name, pass.graph->surface);
        }
        for (const auto& [expr, box, port] : reads_) connect(*expr, box, port);
    }

private:
    // A pass has the values that it inherits.
    static bool is_same(const std::vector<graph::PortValue>& a, const std::vector<graph::PortValue>& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                          [](const auto& x, const auto& y) { return x.value == y.value; });
    }

    void add_node(const graph::Node& node, const graph::ResolvedNode& resolved) {
        GraphBox box{.id = node.id, .title = node.type, .note = node.note, .inputs = {}, .outputs = {}};
        const std::size_t index = view_.boxes.size();
        if (node.is_expression) {
            box.title = "= " + text_of(node.expr, node.expr_span);
            box.inputs.push_back({.name = "expr", .type = {}, .value = {}});
            box.outputs.push_back({.name = "out", .type = {}, .value = {}});
            if (node.expr) reads_.emplace_back(node.expr, index, 0);
        } else {
            declare_ports(resolved, box);
            for (const graph::PortValue& port : node.inputs) set_input(port, index, box);
        }
        view_.boxes.push_back(std::move(box));
    }

    static void declare_ports(const graph::ResolvedNode& resolved, GraphBox& box) {
        const auto port = [](std::string_view name, std::string_view type) {
            return GraphPort{.name = std::string(name), .type = std::string(type), .value = {}};
        };
        if (const nodelang::FunctionDecl* function = resolved.function) {
            if (function->result.name != "void") box.outputs.push_back(port("out", function->result.name));
            for (const nodelang::ParamDecl& param : function->params)
                (param.is_out ? box.outputs : box.inputs).push_back(port(param.name, param.type.name));
        } else if (resolved.subgraph) {
            for (const graph::Input& input : resolved.subgraph->graph->inputs)
                box.inputs.push_back(port(input.name, input.type));
            for (const graph::PortValue& output : resolved.subgraph->graph->outputs)
                box.outputs.push_back(port(output.name, {}));
        }
    }

    void set_input(const graph::PortValue& value, std::size_t index, GraphBox& box) {
        auto found = std::find_if(box.inputs.begin(), box.inputs.end(),
                                  [&](const GraphPort& port) { return port.name == value.name; });
        if (found == box.inputs.end()) found = box.inputs.insert(found, {.name = value.name, .type = {}, .value = {}});
        if (!value.value) return;
        const bool is_link = value.value->kind == Expr::Kind::Name && checked_.by_id.contains(value.value->text);
        if (!is_link) found->value = text_of(value.value, value.value_span);
        reads_.emplace_back(value.value, index, static_cast<std::size_t>(found - box.inputs.begin()));
    }

    void add_list(std::string id, const std::vector<graph::PortValue>& values) {
        if (values.empty()) return;
        GraphBox box{.id = std::move(id), .title = {}, .note = {}, .is_node = false, .inputs = {}, .outputs = {}};
        for (const graph::PortValue& value : values) set_input(value, view_.boxes.size(), box);
        view_.boxes.push_back(std::move(box));
    }

    // As the file says it, on one line.
    std::string text_of(const Expr* expr, Span span) const {
        std::string text(expr && expr->span ? session_.sources.text(expr->span) : session_.sources.text(span));
        std::string line;
        for (char c : text) {
            const bool is_space = c == ' ' || c == '\n' || c == '\r' || c == '\t';
            if (!is_space || (!line.empty() && line.back() != ' ')) line += is_space ? ' ' : c;
        }
        return line;
    }

    void connect(const Expr& expr, std::size_t to, std::size_t to_port) {
        if (expr.kind == Expr::Kind::Name) return add_edge(expr.text, {}, to, to_port);
        if (expr.kind == Expr::Kind::Member && expr.args[0]->kind == Expr::Kind::Name)
            return add_edge(expr.args[0]->text, expr.text, to, to_port);
        for (const Expr* argument : expr.args) connect(*argument, to, to_port);
    }

    // A member that is no output is a part of the first one.
    void add_edge(std::string_view id, std::string_view port, std::size_t to, std::size_t to_port) {
        const auto node = checked_.by_id.find(id);
        if (node == checked_.by_id.end()) return;  // a constant, an enumerator
        const std::vector<GraphPort>& outputs = view_.boxes[node->second].outputs;
        const auto found =
            std::find_if(outputs.begin(), outputs.end(), [&](const GraphPort& output) { return output.name == port; });
        const std::size_t from_port = found == outputs.end() ? 0 : static_cast<std::size_t>(found - outputs.begin());
        if (outputs.empty() || !known_.insert({node->second, from_port, to, to_port}).second) return;
        view_.edges.push_back({.from = node->second, .from_port = from_port, .to = to, .to_port = to_port});
    }

    graph::Session& session_;
    const graph::CheckedGraph& checked_;
    const graph::Graph& graph_;
    GraphView& view_;
    std::vector<std::tuple<const Expr*, std::size_t, std::size_t>> reads_{};
    std::set<std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>> known_{};
};

// The reader of the graph has reported what is wrong with it.
Budget budget_of(const graph::Session& session, const graph::Json& json) {
    Diagnostics silent;
    const graph::CostLimits limits = graph::read_budget(json, session.sources, silent);
    const auto shown = [&](const std::optional<graph::CostLimit>& stated) {
        return stated ? std::optional(CostLimit{.most = static_cast<std::uint32_t>(stated->most),
                                                .place = graph::place_of(session.sources, stated->span)})
                      : std::nullopt;
    };
    return {.instructions = shown(limits.instructions), .textures = shown(limits.textures)};
}

}  // namespace

GraphView view_graph(const Compiler& compiler, const std::string& path, const CompileOptions& options) {
    CompileOptions own;
    own.include_dirs = options.include_dirs;
    own.loader = options.loader;
    graph::Session session(CompilerAccess::library(compiler), own);
    GraphView view;
    if (const std::optional<std::uint32_t> base = graph::load_source(session, path, {})) {
        const std::unique_ptr<graph::Json> json = graph::parse_json(session.sources, *base, session.diagnostics);
        const std::shared_ptr<graph::Graph> graph =
            json ? graph::read_graph(*json, path, session.sources, session.ast, session.diagnostics, std::nullopt)
                 : nullptr;
        if (graph) {
            view.name = graph->name;
            view.kind = kind_of(graph->kind);
            if (graph->kind == graph::GraphKind::Material) view.budget = budget_of(session, *json);
            const graph::CheckedGraph* checked = graph::check_graph(session, graph);
            if (checked && !session.diagnostics.has_errors()) View(session, *checked, view).make();
        }
    }
    view.diagnostics = to_public(session.diagnostics, session.sources);
    view.dependencies = std::move(session.dependencies);
    view.ok = !session.diagnostics.has_errors();
    return view;
}

}  // namespace patina
