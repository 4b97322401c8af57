#include "compiler/format/read_graph.h"

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/format/read_fields.h"
#include "compiler/json/json_text.h"

namespace patina::format {
namespace {

void read_lighting_graph(Reading& reading, const json::Json& json, Graph& graph);

// The kind of a file's object, in the order of GraphKind.
constexpr std::array kGraphObjects = {ObjectKind::Material, ObjectKind::Subgraph, ObjectKind::Lighting,
                                      ObjectKind::Workflow};

// --- keys that every kind of graph has

void read_common(Reading& reading, const json::Json& json, Graph& graph, UniqueNames& names) {
    if (std::string name = read_text(reading, json, "name"); !name.empty()) {
        graph.name = std::move(name);
        graph.name_span = json.find("name")->span;
    }
    graph.help = read_text(reading, json, "help");
    if (const json::Json* schema = json.find("$schema")) (void)read_string(reading, *schema, "'$schema'");
    read_word(reading, json, "precision", "a precision", graph.precision);
    if (const json::Json* properties = json.find("properties")) {
        graph.properties = read_properties(reading, *properties, names);
    }
    if (const json::Json* nodes = json.find("nodes")) graph.nodes = read_nodes(reading, *nodes);
    if (const json::Json* meta = json.find("meta")) json::append_one_line(graph.meta, *meta, reading.sources);
}

// The key that holds an output's value also declares the output.
void read_declared_outputs(Reading& reading, const json::Json& json, std::vector<PortValue>& outputs) {
    outputs = read_ports(reading, json, "'outputs'", {});
    for (const PortValue& output : outputs) {
        if (!is_identifier(output.name)) {
            reading.diagnostics.report(Code::BadIdentifier, output.name_span, json::shown(output.name));
        }
    }
}

// --- materials

void read_lighting_use(Reading& reading, const json::Json& json, LightingUse& lighting) {
    lighting.present = true;
    lighting.span = json.span;
    if (json.kind == json::Json::Kind::String) {
        lighting.use = json.string;
        if (json.string.empty()) {
            reading.diagnostics.report(Code::Syntax, json.span, "a lighting model", "an empty string");
        }
    } else if (json.kind != json::Json::Kind::Object) {
        report_type(reading, json, "'lighting'", "a name, a file or a lighting graph");
    } else if (const json::Json* use = json.find("use")) {
        check_keys(reading, json, ObjectKind::LightingUse);
        lighting.use = read_text(reading, json, "use");
        lighting.span = use->span;
        if (const json::Json* in = json.find("in")) lighting.inputs = read_ports(reading, *in, "'in'", {});
    } else {
        lighting.inlined = std::make_shared<Graph>();
        lighting.inlined->kind = GraphKind::Lighting;
        lighting.inlined->name = "inline";
        lighting.inlined->span = json.span;
        read_lighting_graph(reading, json, *lighting.inlined);
    }
}

void read_variants(Reading& reading, const json::Json& array, std::vector<ListedVariant>& variants) {
    if (!expect(reading, array, json::Json::Kind::Array, "'variants'")) return;
    if (array.elements.empty()) {
        reading.diagnostics.report(Code::EmptyList, array.span, "variants")
            .note("list the combinations: \"variants\": [ { \"_DETAIL\": true }, { \"_Mode\": \"Wet\" } ]");
    }
    for (const json::Json& element : array.elements) {
        if (!expect(reading, element, json::Json::Kind::Object, "a variant")) continue;
        ListedVariant& listed = variants.emplace_back();
        listed.span = element.span;
        for (const json::JsonMember& member : element.members) {
            const json::Json& value = member.value;
            const bool is_bool = value.kind == json::Json::Kind::Bool;
            if (!is_bool && value.kind != json::Json::Kind::String) {
                report_type(reading, value, fmt::format("'{}'", json::shown(member.key)),
                            "true, false or one of its values");
                continue;
            }
            listed.values.push_back({.name = member.key,
                                     .name_span = member.key_span,
                                     .word = is_bool ? (value.boolean ? "true" : "false") : value.string,
                                     .is_bool = is_bool,
                                     .value_span = value.span});
        }
    }
}

Budget read_budget(Reading& reading, const json::Json& json) {
    Budget budget;
    if (!expect(reading, json, json::Json::Kind::Object, "'budget'")) return budget;
    check_keys(reading, json, ObjectKind::Budget);
    const auto read = [&](std::string_view key, std::optional<Budget::Limit>& limit) {
        const json::Json* found = json.find(key);
        if (!found) return;
        const Form& form = form_of(ObjectKind::Budget, key, Form::Of::Integer);
        if (const auto most = read_int(reading, *found, fmt::format("'budget.{}'", key), form))
            limit = {.most = *most, .span = found->span};
    };
    read("maxInstructions", budget.instructions);
    read("maxTextures", budget.textures);
    return budget;
}

// The keys that a material and an extra pass share.
void read_models(Reading& reading, const json::Json& json, Graph& graph) {
    if (const json::Json* workflow = json.find("workflow")) {
        graph.workflow.clear();
        if (const std::string* text = read_string(reading, *workflow, "'workflow'")) graph.workflow = *text;
        graph.workflow_span = workflow->span;
    }
    if (const json::Json* lighting = json.find("lighting")) {
        graph.lighting = {};
        read_lighting_use(reading, *lighting, graph.lighting);
    }
}

void read_look(Reading& reading, const json::Json& json, Graph& graph) {
    if (const json::Json* vertex = json.find("vertex")) graph.vertex = read_ports(reading, *vertex, "'vertex'", {});
    if (const json::Json* surface = json.find("surface"))
        graph.surface = read_ports(reading, *surface, "'surface'", {});
    if (const json::Json* render = json.find("render")) graph.render = read_render(reading, *render);
}

constexpr std::size_t kMostPasses = 16;

// Each pass starts as a copy of the material. A pass with another workflow drops the surface inputs, because they
// belong to the material's workflow.
void read_passes(Reading& reading, const json::Json& json, Graph& material) {
    if (!expect(reading, json, json::Json::Kind::Array, "'passes'")) return;
    if (json.elements.size() > kMostPasses) {
        reading.diagnostics.report(Code::TooMany, opening(json), json.elements.size(), "passes", kMostPasses);
        return;
    }
    UniqueNames names;
    std::vector<ExtraPass> passes;
    for (const json::Json& element : json.elements) {
        if (!expect(reading, element, json::Json::Kind::Object, "a pass")) continue;
        check_keys(reading, element, ObjectKind::ExtraPass);
        ExtraPass& pass = passes.emplace_back();
        read_name(reading, element, "pass", pass.name, pass.name_span, names);
        pass.graph = std::make_shared<Graph>(material);
        pass.graph->span = element.span;
        if (element.find("workflow")) {
            pass.graph->lighting = {};
            pass.graph->surface.clear();
        }
        read_models(reading, element, *pass.graph);
        read_look(reading, element, *pass.graph);
    }
    material.passes = std::move(passes);
}

void read_material(Reading& reading, const json::Json& json, Graph& graph) {
    UniqueNames names;
    check_keys(reading, json, ObjectKind::Material);
    read_models(reading, json, graph);
    read_common(reading, json, graph, names);
    read_look(reading, json, graph);
    if (const json::Json* passes = json.find("passes")) read_passes(reading, *passes, graph);
    if (const json::Json* variants = json.find("variants")) read_variants(reading, *variants, graph.variants);
    if (const json::Json* budget = json.find("budget")) graph.budget = read_budget(reading, *budget);
}

// --- the other kinds

void read_subgraph(Reading& reading, const json::Json& json, Graph& graph) {
    UniqueNames names;
    check_keys(reading, json, ObjectKind::Subgraph);
    const json::Json* inputs = json.find("inputs");
    const json::Json* properties = json.find("properties");
    const bool comes_later = inputs && properties && properties->span.begin < inputs->span.begin;
    // If two names are equal, the one that comes second in the file is reported.
    if (inputs && !comes_later) graph.inputs = read_inputs(reading, *inputs, names, false);
    read_common(reading, json, graph, names);
    if (inputs && comes_later) graph.inputs = read_inputs(reading, *inputs, names, false);
    if (const json::Json* outputs = json.find("outputs")) read_declared_outputs(reading, *outputs, graph.outputs);
}

void read_lighting_graph(Reading& reading, const json::Json& json, Graph& graph) {
    UniqueNames surface_names, names;  // @surface.name and $name are separate namespaces
    check_keys(reading, json, ObjectKind::Lighting);
    if (const json::Json* surface = json.find("surface"))
        graph.inputs = read_inputs(reading, *surface, surface_names, false);
    read_common(reading, json, graph, names);
    for (const std::string_view key : {"direct", "indirect", "final"}) {
        const json::JsonMember* output = find_member(json, key);
        if (!output) continue;
        reading.diagnostics.set_context({}, key);
        graph.outputs.push_back(
            {.name = std::string(key),
             .name_span = output->key_span,
             .value_span = output->value.span,
             .value = read_value(output->value, reading.sources, reading.ast, reading.diagnostics)});
        reading.diagnostics.set_context({}, {});
    }
}

// Reports a name that is not another input of the same workflow.
void check_input_name(Reading& reading, const Graph& graph, std::string_view name, Span span) {
    std::vector<std::string_view> inputs;
    for (const Input& input : graph.inputs) inputs.push_back(input.name);
    if (std::find(inputs.begin(), inputs.end(), name) != inputs.end()) return;
    suggest(reading,
            reading.diagnostics.report(Code::UnknownWord, span, json::shown(name), "an input of this workflow"), name,
            inputs);
}

void read_workflow(Reading& reading, const json::Json& json, Graph& graph) {
    UniqueNames names;
    check_keys(reading, json, ObjectKind::Workflow);
    if (const json::Json* inputs = json.find("inputs")) graph.inputs = read_inputs(reading, *inputs, names, true);
    for (const Input& input : graph.inputs) {
        if (!input.gives.empty()) check_input_name(reading, graph, input.gives, input.name_span);
    }
    if (const json::Json* preview = json.find("preview")) {
        graph.preview_input = read_text(reading, json, "preview");
        if (preview->kind == json::Json::Kind::String) {
            check_input_name(reading, graph, graph.preview_input, inside(preview->span));
        }
    }
    if (const json::Json* lighting = json.find("lighting")) read_lighting_use(reading, *lighting, graph.lighting);
    read_common(reading, json, graph, names);
    if (const json::Json* surface = json.find("surface"))
        graph.surface = read_ports(reading, *surface, "'surface'", {});
}

// --- the file

void read_kind(Reading& reading, const json::Json& json, Graph& graph) {
    switch (graph.kind) {
        case GraphKind::Material: return read_material(reading, json, graph);
        case GraphKind::Subgraph: return read_subgraph(reading, json, graph);
        case GraphKind::Lighting: return read_lighting_graph(reading, json, graph);
        case GraphKind::Workflow: return read_workflow(reading, json, graph);
    }
}

}  // namespace

std::string name_of_file(std::string_view path) {
    if (const std::size_t slash = path.find_last_of("/\\"); slash != std::string_view::npos)
        path.remove_prefix(slash + 1);
    for (const std::string_view ending :
         {".graph.json", ".subgraph.json", ".lighting.json", ".workflow.json", ".scene.json", ".json"}) {
        if (path.size() > ending.size() && path.ends_with(ending))
            return std::string(path.substr(0, path.size() - ending.size()));
    }
    return std::string(path);
}

std::shared_ptr<Graph> read_graph(const json::Json& json, std::string path, const SourceMap& sources,
                                  nodelang::Ast& ast, Diagnostics& diagnostics, std::optional<GraphKind> expected) {
    Reading reading{sources, ast, diagnostics};
    auto graph = std::make_shared<Graph>();
    graph->kind = expected.value_or(GraphKind::Material);
    graph->name = name_of_file(path);
    graph->path = std::move(path);
    graph->span = json.span;
    std::span<const ObjectKind> allowed = kGraphObjects;
    if (expected) allowed = allowed.subspan(static_cast<std::size_t>(*expected), 1);
    const std::optional<ObjectKind> kind = read_header(reading, json, allowed);
    if (!kind) return graph;
    const auto found = std::find(kGraphObjects.begin(), kGraphObjects.end(), *kind);
    graph->kind = static_cast<GraphKind>(found - kGraphObjects.begin());
    // A sub-graph is read in the middle of reading its parent's node. Messages about the sub-graph must not name that
    // node.
    const std::string outer_node(diagnostics.context_node());
    diagnostics.set_context({}, {});
    read_kind(reading, json, *graph);
    diagnostics.set_context(outer_node, {});
    return graph;
}

FileLocation place_of(const SourceMap& sources, Span span) {
    const Position begin = sources.resolve(span.begin), end = sources.resolve(span.end);
    FileLocation place{.file = std::string(begin.file),
                       .line = begin.line,
                       .column = begin.column,
                       .end_line = end.line,
                       .end_column = end.column,
                       .source_line = {}};
    constexpr std::size_t kMaxLine = 1000;  // a file may be one line, which is too long to copy for each word
    if (begin.line_text.size() <= kMaxLine) place.source_line = begin.line_text;
    return place;
}

}  // namespace patina::format
