#include "compiler/lower/lower.h"

#include <algorithm>
#include <array>

#include "compiler/base/spelling.h"
#include "compiler/format/words.h"
#include "compiler/lower/instances.h"
#include "compiler/lower/lowering.h"

namespace patina::graph {

using ir::Op;
using ir::Type;
using ir::Value;
using nodelang::FunctionDecl;
using nodelang::Typed;

namespace {

ir::Rate rate_of(Source source) {
    switch (source) {
        case Source::Attribute: return ir::Rate::Pixel;  // where a fragment reads it, it has been interpolated
        case Source::Builtin:
        case Source::Vertex:
        case Source::Pixel:
        case Source::Given: return ir::Rate::Pixel;
        case Source::Extern:
        case Source::Uniform: return ir::Rate::Uniform;
    }
    return ir::Rate::Pixel;
}

void declare_statics(Lowering& lowering) {
    const RenderState& render = lowering.material.graph->graph->render;
    const auto word_of = [&](std::string_view key) -> std::string_view {
        if (key == "surface") return text_of(kSurfaceKinds, render.surface);
        if (key == "cull") return text_of(kCulls, render.cull);
        return {};
    };
    for (const nodelang::VariableDecl* variable : lowering.session.stages->statics) {
        const nodelang::Attribute* attribute = variable->attribute("static");
        if (is_of_lighting(nodelang::attribute_text(*attribute))) continue;  // known later (lower_passes.cpp)
        const std::string_view word = word_of(nodelang::attribute_text(*attribute));
        bool matches = false;
        for (std::size_t i = 1; i < attribute->args.size(); ++i) {
            matches = matches || nodelang::attribute_text(*attribute, i) == word;
        }
        lowering.emitter.set_static(variable, matches ? 1 : 0);
    }
}

void declare_semantics(Lowering& lowering) {
    const nodelang::Scope scope{.declarations = lowering.session.declarations};
    for (const SemanticDecl& semantic : lowering.session.stages->semantics) {
        const Type type =
            lowering.emitter.type(semantic.function ? semantic.function->result : semantic.variable->type, scope);
        lowering.out.module.semantics.push_back(
            {.name = std::string(semantic.name), .type = type, .rate = rate_of(semantic.source)});
        lowering.out.semantics.push_back({.source = semantic.source, .declaration = &semantic});
    }
}

// The function without parameters that a pass calls for the surface that is to be lit.
const FunctionDecl* surface_slot(const Stages& stages) {
    const auto found = std::find_if(stages.slots.begin(), stages.slots.end(),
                                    [](const FunctionDecl* slot) { return slot->params.empty(); });
    return found == stages.slots.end() ? nullptr : *found;
}

// A lighting model's own inputs become members of the lighting surface.
void extend_lighting_surface(Lowering& lowering) {
    const FunctionDecl* slot = surface_slot(*lowering.session.stages);
    const nodelang::StructDecl* surface = slot ? lowering.session.declarations->structure(slot->result.name) : nullptr;
    if (!surface) return;
    std::vector<ir::Member> members;
    for (const Input& input : lowering.material.lighting->graph->inputs) {
        const auto clash = std::find_if(surface->members.begin(), surface->members.end(),
                                        [&](const auto& m) { return m.name == input.name; });
        if (clash != surface->members.end()) {
            lowering.session.diagnostics.report(Code::DuplicateId, input.name_span, "surface member", input.name)
                .note("every lighting surface has it already");
            continue;
        }
        const Type type = input_type(lowering, input);
        if (!type.is_error()) members.push_back({input.name, type});
    }
    lowering.emitter.extend_structure(*surface, std::move(members));
}

void lower_vertex_outputs(Lowering& lowering) {
    const CheckedGraph& graph = *lowering.material.graph;
    ir::Module& module = lowering.out.module;
    for (const PortValue& port : graph.graph->vertex) {
        const auto semantic = lowering.session.stages->semantic_index.find(port.name);
        if (semantic == lowering.session.stages->semantic_index.end()) continue;
        ir::Function function{};
        function.name = joined("vertex", port.name);
        ir::Builder builder(module, function, lowering.emitter.options());
        GraphScope scope(lowering, graph, builder, true);
        if (!port.value) continue;
        scope.announce(*port.value);
        Lowering::VertexReader& reader =
            lowering.vertex_readers.emplace_back(Lowering::VertexReader{port.name, port.name_span, false, &graph});
        collect_reads(*port.value, graph, reader.reads);
        scope.emit_nodes(graph.reachable(std::span(&port, 1)));
        function.result = module.semantics[semantic->second].type;
        lowering.session.diagnostics.set_context("vertex", port.name);
        module.origins.push_back({.span = port.value_span});
        builder.set_origin({static_cast<std::uint32_t>(module.origins.size() - 1)});
        Typed value = scope.value(*port.value);
        // A tangent may be given without its handedness, which then stays the mesh's.
        if (value.ok() && value.type == ir::kFloat3 && function.result == ir::kFloat4) {
            const Value mesh = builder.emit(Op::Semantic, ir::kFloat4, {}, semantic->second);
            value.value = builder.construct(ir::kFloat4, std::array{value.value, builder.extract(mesh, 3)});
            value.type = ir::kFloat4;
        }
        value =
            lowering.emitter.convert(lowering.emitter.primary(value, scope.scope(), port.value_span), function.result,
                                     scope.scope(), port.value_span, fmt::format("the vertex output '{}'", port.name));
        lowering.session.diagnostics.set_context({}, {});
        lowering.vertex_readers.pop_back();
        if (!value.ok()) continue;
        scope.watch(ir::Probe::Kind::Output, "vertex", port.name, value, port.name_span);
        builder.ret(value.value);
        lowering.out.semantics[semantic->second].override = add_function(module, std::move(function));
    }
}

// A variant of a lighting graph has the value that the material gives it.
const Property* variant_of_lighting(const Material& material, std::string_view name) {
    for (const Property& property : material.lighting->graph->properties) {
        if (property.name == name && property.binding == Binding::Variant) return &property;
    }
    return nullptr;
}

// The switches as the caller wants them.
void declare_switches(Lowering& lowering) {
    Session& session = lowering.session;
    const bool has_passes = session.options.functions.empty() && !tool_of(session);
    std::vector<std::string_view> known;
    for (const SwitchDecl& each : session.stages->switches) {
        known.push_back(each.variable->name);
        lowering.out.switches.emplace_back(each.variable->name, false);
    }
    for (const auto& [name, value] : session.options.switches) {
        const auto found = std::find(known.begin(), known.end(), name);
        const bool is_switch = found != known.end();
        if (!is_switch && lowering.material.property_index.contains(name)) continue;  // the graph's own (keywords.cpp)
        if (!is_switch || !has_passes) {
            std::vector<std::string_view> words = keyword_names(lowering.material);
            if (has_passes) words.insert(words.begin(), known.begin(), known.end());
            DiagnosticRecord& record = session.diagnostics.report(
                Code::UnknownWord, {}, name,
                has_passes ? "a switch of a pass or a keyword of the graph" : "a keyword of the graph");
            if (const Property* property = variant_of_lighting(lowering.material, name)) {
                record.note(property->name_span,
                            fmt::format("it is a variant of the lighting graph: the material says what it is, by "
                                        "\"lighting\": {{ \"in\": {{ \"{}\": ... }} }}",
                                        name));
                continue;
            }
            record.note(is_switch       ? fmt::format("it is a part of the rendering paths, and {} of none",
                                                tool_of(session) ? "this target's file is" : "functions are")
                        : words.empty() ? "it has none"
                                        : Diagnostics::suggestion(name, words));
        } else if (!value.empty() && value != "true" && value != "false") {
            session.diagnostics.report(Code::UnknownWord, {}, value, fmt::format("a value of '{}'", name))
                .note("these exist: true and false");
        } else {
            lowering.out.switches[static_cast<std::size_t>(found - known.begin())].second = value != "false";
        }
    }
    for (const SwitchDecl& each : session.stages->switches)
        lowering.emitter.set_static(each.variable, lowering.is_on(each.variable->name) ? 1 : 0);
    for (const nodelang::VariableDecl* older : session.stages->repeated) {
        if (older->attribute("switch")) lowering.emitter.set_static(older, lowering.is_on(older->name) ? 1 : 0);
    }
}

void report_large_instance(Session& session, const Material& material, const Lowered& lowered,
                           const std::set<std::uint32_t>& globals) {
    const auto first = std::find_if(material.properties.begin(), material.properties.end(),
                                    [](const auto& each) { return each.property->binding == Binding::Instance; });
    const auto [bytes, room] = size_of_instance(lowered, globals);
    session.diagnostics.report(Code::TooMany, first->property->name_span, bytes, "bytes for each instance", room)
        .note(
            "a uniform block has 64 KiB, and not one instance fits; properties that all instances share need no "
            "\"as\": \"instance\"");
}

// The switches that are on, and the path.
std::vector<std::string_view> what_is_on(const Lowering& lowering) {
    const Session& session = lowering.session;
    std::vector<std::string_view> on = {session.path};
    if (session.path == kAllPaths) on = session.stages->paths();
    for (const auto& [name, value] : lowering.out.switches)
        if (value) on.push_back(name);
    return on;
}

}  // namespace

namespace {

template <class Key, class Found>
std::optional<Found> found(const std::vector<std::pair<Key, Found>>& pairs, Key wanted) {
    for (const auto& [key, what] : pairs) {
        if (key == wanted) return what;
    }
    return {};
}

std::optional<ir::FunctionId> in_stage(const LoweredPass& pass, std::optional<ir::FunctionId> function,
                                       ir::StageKind stage) {
    if (!function || stage == ir::StageKind::Fragment) return function;
    const bool is_there =
        std::find(pass.in_both_stages.begin(), pass.in_both_stages.end(), *function) != pass.in_both_stages.end();
    return is_there ? function : std::nullopt;
}

}  // namespace

std::optional<ir::FunctionId> LoweredPass::recipe_of(ir::SemanticId semantic, ir::StageKind stage) const {
    if (stage == ir::StageKind::Vertex) {
        if (const auto recipe = found(at_vertices, semantic)) return recipe;
    }
    return in_stage(*this, found(recipes, semantic), stage);
}

std::optional<ir::FunctionId> LoweredPass::replacement_of(ir::FunctionId function, ir::StageKind stage) const {
    return in_stage(*this, found(replaced, function), stage);
}

std::optional<ir::GlobalId> LoweredPass::attribute_of(ir::SemanticId semantic) const {
    return found(attributes, semantic);
}

std::string_view known_as(const PassDecl& pass) {
    const auto tag =
        std::find_if(pass.tags.begin(), pass.tags.end(), [](const auto& each) { return each.first != "Name"; });
    return tag == pass.tags.end() ? pass.name : std::string_view(tag->second);
}

const BlendRow* blend_of(const PassDecl& pass, std::string_view surface) {
    for (const BlendRow& row : pass.blends) {
        if (row.surface.empty() || row.surface == surface) return &row;
    }
    return nullptr;
}

bool Lowering::is_on(std::string_view wanted) const {
    return std::any_of(out.switches.begin(), out.switches.end(),
                       [&](const auto& each) { return each.first == wanted && each.second; });
}

std::string_view Lowering::slot_name(ir::FunctionId function) const {
    const std::string_view name = emitter.slot_name(function);
    if (!name.empty()) return name;
    for (const auto& [slot, part] : parts) {
        if (part.slot.function == function) return slot;
    }
    return {};
}

bool Lowering::is_packing(std::string_view slot) const {
    return std::any_of(session.stages->slots.begin(), session.stages->slots.end(), [&](const FunctionDecl* each) {
        return each->name == slot && (each->attribute("pack") || each->attribute("unpack"));
    });
}

ir::FunctionId add_function(ir::Module& module, ir::Function function) {
    module.functions.push_back(std::move(function));
    return {static_cast<std::uint32_t>(module.functions.size() - 1)};
}

Type input_type(Lowering& lowering, const Input& input) {
    const nodelang::Scope scope{.declarations = lowering.session.declarations};
    const std::string_view name = input.type == "color"       ? "float3"
                                  : input.type == "texture2d" ? "Texture2D"
                                                              : std::string_view(input.type);
    return lowering.emitter.type({.name = name, .span = input.type_span}, scope);
}

Lowered lower(Session& session, const Material& material, ir::BuildOptions options) {
    Lowered out;
    Lowering lowering{.session = session,
                      .material = material,
                      .out = out,
                      .emitter = nodelang::Emitter(out.module, session.diagnostics, options),
                      .enumerators = {},
                      .interpolators = {},
                      .vertex_readers = {},
                      .parts = {},
                      .per_object = {},
                      .surface = {}};
    declare_switches(lowering);
    const std::vector<std::string_view> on = what_is_on(lowering);
    EngineGlobals engine = declare_engine(*session.stages, *session.declarations, lowering.emitter, on);
    lowering.per_object = std::move(engine.per_object);
    out.reads = std::move(engine.reads);
    const bool instanced = is_instanced(material) && session.options.functions.empty() && !tool_of(session);
    out.property_globals = declare_material(
        material, out.module, session.options.keep_variants,
        instanced ? std::optional(out.module.globals[*lowering.per_object.begin()].block) : std::nullopt);
    for (std::size_t i = 0; instanced && i < material.properties.size(); ++i) {
        if (material.properties[i].property->binding == Binding::Instance)
            lowering.per_object.insert(out.property_globals[i].value.index);
    }
    if (tool_of(session)) {
        // A pass that it adds has nothing to share unless it is lit, and then reads as the others.
        out.keeps_functions = !material.pass || !material.lighting->graph->nodes.empty();
        mark_for_tool(lowering);
    }
    declare_statics(lowering);
    extend_lighting_surface(lowering);
    declare_semantics(lowering);
    lower_slots(lowering);
    lower_vertex_outputs(lowering);
    if (session.diagnostics.has_errors()) return out;
    if (session.options.functions.empty()) {
        lower_passes(lowering);
        if (tool_of(session)) tell_texts(lowering);
    } else {
        lower_functions(lowering);
    }
    if (instanced && !session.diagnostics.has_errors()) {
        out.instance_globals = lowering.per_object;
        out.instances = make_instanced(out, out.instance_globals);
        if (out.instances == 0) report_large_instance(session, material, out, out.instance_globals);
    }
    return out;
}

}  // namespace patina::graph
