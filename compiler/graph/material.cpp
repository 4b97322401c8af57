#include "compiler/graph/material.h"

#include <algorithm>
#include <set>

#include "compiler/base/text.h"
#include "compiler/nodelang/parse.h"

namespace patina::graph {

using nodelang::Expr;

namespace {

template <class Map>
std::vector<std::string_view> keys(const Map& map) {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : map) names.push_back(name);
    return names;
}

const CheckedGraph* find_workflow(Session& session, const Graph& graph) {
    const auto& workflows = session.library.workflows;
    const auto found = workflows.find(graph.workflow);
    if (found == workflows.end()) {
        session.diagnostics
            .report(Code::UnknownWord, graph.workflow_span ? graph.workflow_span : graph.span, graph.workflow,
                    "a workflow")
            .note(Diagnostics::suggestion(graph.workflow, keys(workflows)));
        return nullptr;
    }
    return check_graph(session, found->second);
}

const CheckedGraph* find_lighting(Session& session, const Graph& graph, const Graph& workflow, std::string& name) {
    if (graph.lighting.inlined) {
        name = graph.lighting.inlined->name;
        return check_graph(session, graph.lighting.inlined);
    }
    const LightingUse& use = graph.lighting.present ? graph.lighting : workflow.lighting;
    name = use.use;
    if (use.use.starts_with(".") || use.use.starts_with("/")) {
        const std::string path = find_file(session, use.use, graph.path);
        if (path.empty()) {
            session.diagnostics.report(Code::MissingFile, use.span, use.use);
            return nullptr;
        }
        name = file_stem(path);
        return load_graph(session, path, GraphKind::Lighting, use.span);
    }
    const auto& models = session.library.lighting_models;
    const auto found = models.find(use.use);
    if (found == models.end()) {
        session.diagnostics.report(Code::UnknownWord, use.span, use.use, "a lighting model")
            .note(Diagnostics::suggestion(use.use, keys(models)))
            .note("a lighting graph of your own is named by its file: \"./toon.lighting.json\"");
        return nullptr;
    }
    return check_graph(session, found->second);
}

void add_property(Session& session, Material& material, const Property& property, const std::string& from) {
    const auto [existing, is_new] = material.property_index.emplace(property.name, material.properties.size());
    if (!is_new) {
        const Property& first = *material.properties[existing->second].property;
        if (&first == &property) return;
        if (first.type != property.type) {
            session.diagnostics.report(Code::DuplicateId, property.name_span, "property", property.name)
                .note(first.name_span, "the first is here, with another type");
        }
        return;  // a sub-graph's property of the same name and type is the same property
    }
    MaterialProperty entry{.property = &property, .texture_path = property.texture};
    if (property.type == PropertyType::Texture2D && property.texture.find_first_of("./") != std::string::npos) {
        entry.texture_path = find_file(session, property.texture, from);
        if (entry.texture_path.empty()) {
            session.diagnostics.report(Code::MissingFile, property.default_span ? property.default_span : property.span,
                                       property.texture);
        }
    }
    material.properties.push_back(std::move(entry));
}

// A file at a port is a texture without a name of its own.
void add_file(Session& session, Material& material, const Expr& expr, const std::string& from,
              std::deque<Property>& storage) {
    if (expr.kind == Expr::Kind::File) {
        Property& property = storage.emplace_back();
        property.name = file_texture_name(expr.text);
        property.name_span = property.span = property.default_span = expr.span;
        property.type = PropertyType::Texture2D;
        property.texture = std::string(expr.text);
        add_property(session, material, property, from);
    }
    for (const Expr* argument : expr.args) add_file(session, material, *argument, from, storage);
}

void add_values(Session& session, Material& material, const Graph& graph, std::deque<Property>& storage) {
    const auto add = [&](const Expr* value) {
        if (value) add_file(session, material, *value, graph.path, storage);
    };
    for (const Node& node : graph.nodes) {
        add(node.expr);
        for (const PortValue& port : node.inputs) add(port.value);
    }
    for (const auto* ports : {&graph.vertex, &graph.surface, &graph.outputs}) {
        for (const PortValue& port : *ports) add(port.value);
    }
}

void add_graph(Session& session, Material& material, const CheckedGraph& checked, std::set<const CheckedGraph*>& seen) {
    if (!seen.insert(&checked).second) return;
    for (const Property& property : checked.graph->properties) {
        add_property(session, material, property, checked.graph->path);
    }
    add_values(session, material, *checked.graph, session.file_properties);
    for (const ResolvedNode& node : checked.nodes) {
        if (node.subgraph) add_graph(session, material, *node.subgraph, seen);
    }
}

// Turns the material into one that shows a port, by the workflow that says it can show things.
bool make_preview(Session& session, Graph& graph, std::string_view preview) {
    for (const auto& [name, workflow] : session.library.workflows) {
        if (workflow->preview_input.empty()) continue;
        const std::uint32_t base = session.sources.add("--node", std::string(preview));
        const Expr* value = nodelang::parse_link({.text = session.sources.file_text(base), .base = base}, session.ast,
                                                 session.diagnostics);
        if (!value) return false;
        graph.workflow = name;
        graph.lighting = {};
        graph.surface.clear();
        graph.surface.push_back(
            {.name = workflow->preview_input, .name_span = value->span, .value_span = value->span, .value = value});
        return true;
    }
    return false;
}

void check_surface(Session& session, const Material& material) {
    const std::vector<const Input*> inputs = material.surface_inputs();
    const Graph& graph = *material.graph->graph;
    std::map<std::string_view, const PortValue*> said;
    for (const PortValue& port : graph.surface) {
        const auto found =
            std::find_if(inputs.begin(), inputs.end(), [&](const Input* i) { return i->name == port.name; });
        if (found == inputs.end()) {
            std::vector<std::string_view> names;
            for (const Input* input : inputs) names.push_back(input->name);
            DiagnosticRecord& record =
                session.diagnostics.report(Code::UnknownSurfaceInput, port.name_span, graph.workflow, port.name);
            if (const std::string_view near = nearest(port.name, names); !near.empty()) {
                record.note(fmt::format("did you mean '{}'?", near));
            }
            record.note(fmt::format("its inputs are {}", enumerate(names)));
            continue;
        }
        const std::string_view gives = (*found)->gives.empty() ? (*found)->name : (*found)->gives;
        const auto [first, is_new] = said.emplace(gives, &port);
        if (!is_new && first->second->name != port.name) {
            session.diagnostics.report(Code::ConflictingInputs, port.name_span, port.name, first->second->name)
                .note(first->second->name_span, "the other one is here");
        }
        if (port.value && (*found)->range) {
            check_range(session, *port.value, *(*found)->range, (*found)->hard, port.name);
        }
    }
}

void check_vertex(Session& session, const Graph& graph) {
    std::vector<std::string_view> names;
    for (const SemanticDecl& semantic : session.library.semantics) {
        if (semantic.is_vertex_output) names.push_back(semantic.name);
    }
    for (const PortValue& port : graph.vertex) {
        if (std::find(names.begin(), names.end(), port.name) != names.end()) continue;
        session.diagnostics.report(Code::UnknownPort, port.name_span, "the vertex stage", "output", port.name)
            .note(Diagnostics::suggestion(port.name, names));
    }
}

void warn_unused(Session& session, const Material& material) {
    if (material.is_preview) return;
    const Graph& graph = *material.graph->graph;
    std::vector<PortValue> roots = graph.surface;
    roots.insert(roots.end(), graph.vertex.begin(), graph.vertex.end());
    const std::vector<bool> used = material.graph->reachable(roots);
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i])
            session.diagnostics.report(Code::UnusedNode, graph.nodes[i].id_span, graph.nodes[i].id)
                .at(graph.nodes[i].id);
    }
}

}  // namespace

std::string file_texture_name(std::string_view path) {
    std::string name = "_";
    for (char c : file_stem(path)) name += is_identifier(std::string("_") + c) ? c : '_';
    return name;
}

std::vector<const Input*> Material::surface_inputs() const {
    std::vector<const Input*> inputs;
    for (const Input& input : workflow->graph->inputs) inputs.push_back(&input);
    if (lighting) {
        for (const Input& input : lighting->graph->inputs) inputs.push_back(&input);
    }
    return inputs;
}

std::unique_ptr<Material> resolve_material(Session& session, std::shared_ptr<Graph> graph, std::string_view preview) {
    auto material = std::make_unique<Material>();
    material->is_preview = !preview.empty();
    if (material->is_preview && !make_preview(session, *graph, preview)) return nullptr;
    material->graph = check_graph(session, graph);
    material->workflow = find_workflow(session, *graph);
    if (!material->workflow) return nullptr;
    material->lighting = find_lighting(session, *graph, *material->workflow->graph, material->lighting_name);
    if (!material->lighting) return nullptr;
    material->lighting_inputs = graph->lighting.inputs;
    std::set<const CheckedGraph*> seen;
    add_graph(session, *material, *material->graph, seen);
    add_graph(session, *material, *material->lighting, seen);
    for (const PortValue& port : material->lighting_inputs) {
        const auto& own = material->lighting->graph->properties;
        if (std::any_of(own.begin(), own.end(), [&](const Property& p) { return p.name == port.name; })) continue;
        std::vector<std::string_view> names;
        for (const Property& property : own) names.push_back(property.name);
        session.diagnostics.report(Code::UnknownPort, port.name_span, material->lighting_name, "property", port.name)
            .note(names.empty() ? "it has none" : Diagnostics::suggestion(port.name, names));
    }
    check_surface(session, *material);
    check_vertex(session, *graph);
    warn_unused(session, *material);
    return material;
}

}  // namespace patina::graph
