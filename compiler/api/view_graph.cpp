// view_graph(): the boxes and lines of a checked graph. The types of its values come from the graph's own program.
#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "compiler/api/compile_source.h"
#include "compiler/api/report.h"
#include "compiler/format/read_graph.h"
#include "compiler/json/json.h"
#include "compiler/link/program.h"
#include "compiler/resolve/check_graph.h"
#include "patina/graph_view.h"

namespace patina {
namespace {

using nodelang::Expr;

std::string_view kind_of(format::GraphKind kind) {
    switch (kind) {
        case format::GraphKind::Material: return "material";
        case format::GraphKind::Subgraph: return "subgraph";
        case format::GraphKind::Lighting: return "lighting";
        case format::GraphKind::Workflow: return "workflow";
    }
    return {};
}

// By the node's id and the name of the output.
using Types = std::map<std::pair<std::string, std::string>, std::string>;

// `before`: what the graph's nodes have before their ids.
void add_types(const ir::Module& module, const ir::Function& function, std::string_view graph, std::string_view before,
               Types& types) {
    for (const ir::Probe& probe : function.probes) {
        if (probe.kind != ir::Probe::Kind::Node || probe.graph != graph || !probe.id.starts_with(before)) continue;
        const ir::Type type = function[probe.value].type;
        const bool has_members = probe.ports.size() > 1 && type.kind == ir::Kind::Struct;
        for (std::size_t i = 0; i < probe.ports.size(); ++i) {
            const ir::Type own = has_members ? module.structs[type.ref].members[i].type : type;
            types[{probe.id.substr(before.size()), probe.ports[i]}] = module.type_name(own);
        }
    }
}

// What the values of nodes are. Of a part of a material: in the smallest one. Nothing if it does not compile.
Types types_of(const Compiler& compiler, const std::string& path, const CompileOptions& given, format::GraphKind kind,
               Trail& trail) {
    CompileOptions options = given;
    options.targets.clear();
    options.keep_programs = options.accept_parts = true;
    const Result result = compile_file(CompilerAccess::impl(compiler), path, options, trail);
    for (const Diagnostic& each : result.diagnostics) {
        constexpr std::string_view kWhy = ": ";
        const std::size_t why = each.message.find(kWhy);
        if (each.code == info(Code::Cancelled).name)
            throw Stopped{.why = why == each.message.npos ? "" : each.message.substr(why + kWhy.size())};
    }
    Types types;
    if (!result.program) return types;
    const std::string_view graph = kind == format::GraphKind::Lighting ? "lighting" : "material";
    const std::string_view before = kind == format::GraphKind::Subgraph ? "part/" : "";
    for (const ProgramStage& stage : result.program->stages)
        for (const ir::Function& function : stage.module.functions)
            add_types(stage.module, function, graph, before, types);
    return types;
}

class View {
public:
    View(resolve::Session& session, const resolve::Library& library, const resolve::CheckedGraph& checked, Types types,
         GraphView& view)
        : session_(session),
          library_(library),
          checked_(checked),
          graph_(*checked.graph),
          types_(std::move(types)),
          view_(view) {}

    void make() {
        for (std::size_t i = 0; i < graph_.nodes.size(); ++i) add_node(graph_.nodes[i], checked_.nodes[i]);
        add_list("vertex", graph_.vertex);
        add_list("surface", graph_.surface);
        add_list("outputs", graph_.outputs);
        for (const format::ExtraPass& pass : graph_.passes) {
            if (!is_same(pass.graph->vertex, graph_.vertex))
                add_list("pass " + pass.name + " vertex", pass.graph->vertex);
            if (!is_same(pass.graph->surface, graph_.surface)) add_list("pass " + pass.name, pass.graph->surface);
        }
        for (const auto& [expr, box, port] : reads_) connect(*expr, box, port);
    }

private:
    // A pass has the values that it inherits.
    static bool is_same(const std::vector<format::PortValue>& a, const std::vector<format::PortValue>& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                          [](const auto& x, const auto& y) { return x.value == y.value; });
    }

    void add_node(const format::Node& node, const resolve::ResolvedNode& resolved) {
        GraphBox box{.id = node.id, .title = node.type, .note = node.note, .inputs = {}, .outputs = {}};
        const std::size_t index = view_.boxes.size();
        if (node.is_expression) {
            box.title = "= " + text_of(node.expr, node.expr_span);
            box.inputs.push_back({.name = "expr", .type = {}, .value = {}});
            box.outputs.push_back({.name = "out", .type = {}, .value = {}});
            if (node.expr) reads_.emplace_back(node.expr, index, 0);
        } else {
            declare_ports(resolved, box);
            for (const format::PortValue& port : node.inputs) set_input(port, index, box);
        }
        deduce_types(node.id, box);
        view_.boxes.push_back(std::move(box));
    }

    // An input of the same type as an output, such as floatN, has what that has.
    void deduce_types(const std::string& id, GraphBox& box) const {
        for (GraphPort& output : box.outputs) {
            const auto found = types_.find({id, output.name});
            if (found == types_.end()) continue;
            const std::string declared = std::exchange(output.type, found->second);
            if (!declared.ends_with('N')) continue;
            for (GraphPort& input : box.inputs)
                if (input.type == declared) input.type = found->second;
        }
    }

    // Empty, or the semantic that an open port reads.
    std::string default_of(const nodelang::ParamDecl& param) const {
        const Expr* root = param.initial;
        while (root && root->kind == Expr::Kind::Member) root = root->args[0];
        const bool is_semantic =
            root && root->kind == Expr::Kind::Name && library_.paths.semantic_index.contains(root->text);
        return is_semantic ? "@" + text_of(param.initial, {}) : std::string();
    }

    void declare_ports(const resolve::ResolvedNode& resolved, GraphBox& box) const {
        const auto port = [](std::string_view name, std::string_view type) {
            return GraphPort{.name = std::string(name), .type = std::string(type), .value = {}};
        };
        if (const nodelang::FunctionDecl* function = resolved.function) {
            if (function->result.name != "void") box.outputs.push_back(port("out", function->result.name));
            for (const nodelang::ParamDecl& param : function->params) {
                if (param.is_out) box.outputs.push_back(port(param.name, param.type.name));
                if (!param.is_input()) continue;
                box.inputs.push_back(port(param.name, param.type.name));
                box.inputs.back().value = default_of(param);
            }
        } else if (resolved.subgraph) {
            for (const format::Input& input : resolved.subgraph->graph->inputs)
                box.inputs.push_back(port(input.name, input.type));
            for (const format::PortValue& output : resolved.subgraph->graph->outputs)
                box.outputs.push_back(port(output.name, {}));
        }
    }

    void set_input(const format::PortValue& value, std::size_t index, GraphBox& box) {
        auto found = std::find_if(box.inputs.begin(), box.inputs.end(),
                                  [&](const GraphPort& port) { return port.name == value.name; });
        if (found == box.inputs.end()) found = box.inputs.insert(found, {.name = value.name, .type = {}, .value = {}});
        found->value.clear();
        if (!value.value) return;
        const bool is_link = value.value->kind == Expr::Kind::Name && checked_.by_id.contains(value.value->text);
        if (!is_link) found->value = text_of(value.value, value.value_span);
        reads_.emplace_back(value.value, index, static_cast<std::size_t>(found - box.inputs.begin()));
    }

    void add_list(std::string id, const std::vector<format::PortValue>& values) {
        if (values.empty()) return;
        GraphBox box{.id = std::move(id), .title = {}, .note = {}, .is_node = false, .inputs = {}, .outputs = {}};
        for (const format::PortValue& value : values) set_input(value, view_.boxes.size(), box);
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

    resolve::Session& session_;
    const resolve::Library& library_;
    const resolve::CheckedGraph& checked_;
    const format::Graph& graph_;
    const Types types_;
    GraphView& view_;
    std::vector<std::tuple<const Expr*, std::size_t, std::size_t>> reads_{};
    std::set<std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>> known_{};
};

GraphView view(const Compiler& compiler, const std::string& path, const CompileOptions& options, Trail& trail) {
    CompileOptions own;
    own.include_dirs = options.include_dirs;
    own.files = options.files;
    own.limits = options.limits;
    const resolve::Library& library = CompilerAccess::library(compiler);
    resolve::Session session(library, own);
    const TrailGuard guard(trail, session.diagnostics);
    GraphView view;
    resolve::until_stopped(session, [&] {
        const std::optional<std::uint32_t> base = resolve::load_source(session, path, {});
        if (!base) return;
        const std::unique_ptr<json::Json> json = json::parse_json(session.sources, *base, session.diagnostics);
        const std::shared_ptr<format::Graph> graph =
            json ? format::read_graph(*json, path, session.sources, session.ast, session.diagnostics, std::nullopt)
                 : nullptr;
        if (graph) {
            view.name = graph->name;
            view.kind = kind_of(graph->kind);
            const resolve::CheckedGraph* checked = resolve::check_graph(session, graph);
            if (checked && !session.diagnostics.has_errors())
                View(session, library, *checked, types_of(compiler, path, own, graph->kind, trail), view).make();
        }
    });
    view.diagnostics = to_public(session.diagnostics, session.sources);
    view.dependencies = std::move(session.dependencies);
    view.missing.assign(session.missing.begin(), session.missing.end());
    view.ok = !session.diagnostics.has_errors();
    return view;
}

}  // namespace

GraphView view_graph(const Compiler& compiler, const std::string& path, const CompileOptions& options) {
    return guarded<GraphView>(path, [&](Trail& trail) { return view(compiler, path, options, trail); });
}

}  // namespace patina
