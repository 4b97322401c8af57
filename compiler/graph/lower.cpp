#include "compiler/graph/lower.h"

#include <algorithm>
#include <array>

#include "compiler/graph/graph_scope.h"
#include "compiler/ir/passes/passes.h"

namespace patina::graph {

using ir::Op;
using ir::Type;
using ir::Value;
using nodelang::FunctionDecl;
using nodelang::Typed;

namespace {

// What the names in nodes/stage and nodes/passes mean: semantics and nothing else.
class LibraryEnvironment : public nodelang::Environment {
public:
    explicit LibraryEnvironment(Lowering& lowering) : lowering_(lowering) {}
    Typed name(const nodelang::Expr& expr, nodelang::Scope& scope) override {
        return semantic(expr.text, expr.span, scope);
    }
    Typed property(const nodelang::Expr&, nodelang::Scope&) override { return {}; }
    Typed file(const nodelang::Expr&, nodelang::Scope&) override { return {}; }
    Typed semantic(std::string_view name, Span span, nodelang::Scope& scope) override {
        const auto found = lowering_.session.library.semantic_index.find(name);
        if (found == lowering_.session.library.semantic_index.end()) {
            lowering_.session.diagnostics.report(Code::UnknownSemantic, span, name);
            return {};
        }
        const SemanticDecl& semantic = lowering_.session.library.semantics[found->second];
        if (semantic.source == Source::Extern) return lowering_.emitter.extern_value(*semantic.variable, scope);
        const Type type = lowering_.out.module.semantics[found->second].type;
        return {.value = scope.builder->emit(Op::Semantic, type, {}, found->second), .type = type};
    }

private:
    Lowering& lowering_;
};

ir::FunctionId add_function(ir::Module& module, ir::Function function) {
    module.functions.push_back(std::move(function));
    return {static_cast<std::uint32_t>(module.functions.size() - 1)};
}

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
        if (key == "surface") return render.surface == SurfaceKind::Cutout ? "cutout" : "opaque";
        if (key == "cull") return render.cull == Cull::Back ? "back" : render.cull == Cull::Front ? "front" : "off";
        return {};
    };
    for (const nodelang::VariableDecl& variable : lowering.session.library.ast.variables) {
        const nodelang::Attribute* attribute = variable.attribute("static");
        if (!attribute) continue;
        const std::string_view word = word_of(nodelang::attribute_text(*attribute));
        bool matches = false;
        for (std::size_t i = 1; i < attribute->args.size(); ++i) {
            matches = matches || nodelang::attribute_text(*attribute, i) == word;
        }
        lowering.emitter.set_static(&variable, matches ? 1 : 0);
    }
}

void declare_semantics(Lowering& lowering) {
    const Library& library = lowering.session.library;
    const nodelang::Scope scope{.declarations = &library.declarations};
    for (const SemanticDecl& semantic : library.semantics) {
        const Type type =
            lowering.emitter.type(semantic.function ? semantic.function->result : semantic.variable->type, scope);
        lowering.out.module.semantics.push_back(
            {.name = std::string(semantic.name), .type = type, .rate = rate_of(semantic.source)});
        lowering.out.semantics.push_back({.source = semantic.source, .declaration = &semantic});
    }
}

Type input_type(Lowering& lowering, const Input& input) {
    const nodelang::Scope scope{.declarations = &lowering.session.library.declarations};
    const std::string_view name = input.type == "color"       ? "float3"
                                  : input.type == "texture2d" ? "Texture2D"
                                                              : std::string_view(input.type);
    return lowering.emitter.type({.name = name, .span = input.type_span}, scope);
}

// The function without parameters that a pass calls for the surface that is to be lit.
const FunctionDecl* surface_slot(const Library& library) {
    for (const FunctionDecl& function : library.ast.functions) {
        if (function.attribute("slot") && function.params.empty()) return &function;
    }
    return nullptr;
}

// A lighting model's own inputs become members of the lighting surface.
void extend_lighting_surface(Lowering& lowering) {
    const Library& library = lowering.session.library;
    const FunctionDecl* slot = surface_slot(library);
    const nodelang::StructDecl* surface = slot ? library.declarations.structure(slot->result.name) : nullptr;
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

// A previewed port of any type as a colour: a scalar is grey, two components are red and green.
Typed as_color(Lowering& lowering, Typed value, GraphScope& scope, Span span) {
    ir::Builder& b = *scope.scope().builder;
    value = lowering.emitter.primary(value, scope.scope(), span);
    if (!value.ok()) return {};
    if (!value.type.is_numeric() || value.type.is_matrix()) {
        lowering.session.diagnostics.report(Code::TypeMismatch, span, "the previewed port",
                                            lowering.out.module.type_name(value.type), "a number or vector");
        return {};
    }
    Value v = value.value;
    if (value.type.scalar != ir::Scalar::Float) v = b.convert(v, ir::Scalar::Float);
    if (value.type.is_scalar()) v = b.splat(v, 3);
    if (value.type.width() == 2) v = b.construct(ir::kFloat3, std::array{v, b.constant(ir::kFloat, {0})});
    if (value.type.width() == 4) v = b.swizzle(v, std::array{0u, 1u, 2u});
    return {.value = v, .type = ir::kFloat3};
}

// Value of one surface input: as given, or by another name for it, or its default.
Typed surface_value(Lowering& lowering, GraphScope& scope, std::span<const Input* const> inputs, const Input& input,
                    Type type) {
    const std::vector<PortValue>& ports = lowering.material.graph->graph->surface;
    for (const PortValue& port : ports) {
        if (!lowering.material.is_preview) lowering.session.diagnostics.set_context("surface", port.name);
        if (port.name == input.name) {
            if (!port.value) return {};
            if (lowering.material.is_preview)
                return as_color(lowering, scope.value(*port.value), scope, port.value_span);
            return scope.value_as(port, type, fmt::format("the surface input '{}'", port.name));
        }
        for (const Input* other : inputs) {
            if (other->name != port.name || other->gives != input.name || !other->as) continue;
            const Typed given =
                scope.value_as(port, input_type(lowering, *other), fmt::format("the surface input '{}'", port.name));
            if (!given.ok()) return {};
            scope.set_input(other->name, given);
            return scope.value_as(*other->as, type, fmt::format("the surface input '{}'", port.name));
        }
    }
    lowering.session.diagnostics.set_context({}, {});
    if (!input.value) {
        const Span span = lowering.material.graph->graph->span;
        lowering.session.diagnostics.report(Code::MissingInput, span, "the surface", input.name);
        return {};
    }
    return scope.value_as(*input.value, type, fmt::format("the default of '{}'", input.name));
}

// Nodes to emit for the pixel stage: what the surface reads without passing an interpolator, and nodes that nothing
// reads at all, whose mistakes are worth knowing.
std::vector<bool> pixel_nodes(const CheckedGraph& graph) {
    std::vector<bool> pixel(graph.nodes.size(), false), vertex = graph.reachable(graph.graph->vertex);
    const auto walk = [&](std::vector<std::uint32_t> work, std::vector<bool>& seen, bool stop_at_interpolators) {
        while (!work.empty()) {
            const std::uint32_t at = work.back();
            work.pop_back();
            if (seen[at]) continue;
            seen[at] = true;
            if (stop_at_interpolators && graph.graph->nodes[at].vertex_stage) continue;
            work.insert(work.end(), graph.nodes[at].reads.begin(), graph.nodes[at].reads.end());
        }
    };
    std::vector<std::uint32_t> roots;
    for (const PortValue& port : graph.graph->surface) {
        if (port.value) collect_reads(*port.value, graph, roots);
    }
    walk(roots, pixel, true);
    for (std::uint32_t i = 0; i < graph.nodes.size(); ++i) {
        if (graph.graph->nodes[i].vertex_stage) walk({i}, vertex, false);
    }
    for (std::size_t i = 0; i < pixel.size(); ++i) pixel[i] = pixel[i] || !vertex[i];
    return pixel;
}

// Where a surface input gets its value.
Span span_of(std::span<const PortValue> ports, const Input& input) {
    const auto port = std::find_if(ports.begin(), ports.end(), [&](const auto& p) { return p.name == input.name; });
    return port == ports.end() ? input.name_span : port->name_span;
}

// surface(): everything that the workflow and the lighting model ask of the graph, in one struct.
ir::FunctionId lower_surface(Lowering& lowering, std::vector<const Input*>& members) {
    ir::Module& module = lowering.out.module;
    const CheckedGraph& graph = *lowering.material.graph;
    ir::Function function{};
    function.name = "surface";
    ir::Builder builder(module, function, lowering.emitter.options());
    GraphScope scope(lowering, graph, builder, false);
    scope.emit_nodes(pixel_nodes(graph));

    ir::Struct made{.name = "Surface", .members = {}};
    std::vector<Value> values;
    bool good = true;
    const std::vector<const Input*> inputs = lowering.material.surface_inputs();
    for (const Input* input : inputs) {
        if (!input->gives.empty()) continue;
        const Type type = input_type(lowering, *input);
        const Typed value = surface_value(lowering, scope, inputs, *input, type);
        good = good && value.ok();
        scope.watch(ir::Probe::Kind::Output, "surface", input->name, value, span_of(graph.graph->surface, *input));
        made.members.push_back({input->name, type});
        values.push_back(value.value);
        members.push_back(input);
    }
    lowering.session.diagnostics.set_context({}, {});
    if (!good) return {};
    module.structs.push_back(std::move(made));
    function.result = Type::structure(static_cast<std::uint32_t>(module.structs.size() - 1));
    builder.ret(builder.construct(function.result, values));
    return add_function(module, std::move(function));
}

// lighting_surface(): the workflow's set-up, over the surface.
ir::FunctionId lower_setup(Lowering& lowering, const FunctionDecl& slot, ir::FunctionId surface,
                           std::span<const Input* const> members) {
    ir::Module& module = lowering.out.module;
    const CheckedGraph& workflow = *lowering.material.workflow;
    ir::Function function{};
    function.name = slot.name;
    function.always_inline = true;
    ir::Builder builder(module, function, lowering.emitter.options());
    GraphScope scope(lowering, workflow, builder, false);
    const Value inputs = builder.call(surface, {});
    builder.name(inputs, module.intern("material"));
    for (std::uint32_t i = 0; i < members.size(); ++i) {
        const Value member = builder.extract(inputs, i);
        scope.set_input(members[i]->name, {.value = member, .type = builder.type(member)});
    }
    scope.emit_nodes(workflow.reachable(workflow.graph->surface));
    const Type type = lowering.emitter.type(slot.result, scope.scope());
    if (type.is_error()) return {};
    std::vector<Value> values;
    for (const ir::Member& member : std::vector<ir::Member>(module.structs[type.ref].members)) {
        const auto port = std::find_if(workflow.graph->surface.begin(), workflow.graph->surface.end(),
                                       [&](const PortValue& p) { return p.name == member.name; });
        Typed value;
        if (port != workflow.graph->surface.end()) {
            value = scope.value_as(*port, member.type, fmt::format("'{}'", member.name));
        } else {
            const auto input =
                std::find_if(members.begin(), members.end(), [&](const Input* i) { return i->name == member.name; });
            if (input == members.end()) {
                lowering.session.diagnostics.report(Code::MissingInput, workflow.graph->span, workflow.graph->name,
                                                    member.name);
                return {};
            }
            const Value own = builder.extract(inputs, static_cast<std::uint32_t>(input - members.begin()));
            value = {.value = own, .type = member.type};
        }
        if (!value.ok()) return {};
        builder.name(value.value, module.intern(member.name));
        scope.watch(ir::Probe::Kind::Output, "surface", member.name, value,
                    port == workflow.graph->surface.end() ? workflow.graph->span : port->name_span);
        values.push_back(value.value);
    }
    function.result = type;
    builder.ret(builder.construct(type, values));
    return add_function(module, std::move(function));
}

// Neighbouring pixels see the same lights in the same order, but a derivative in the loop would be computed per light.
void refuse_derivatives_per_light(Lowering& lowering, const ir::Function& function) {
    const ir::Module& module = lowering.out.module;
    std::vector<bool> needs_quad(module.functions.size(), false);
    const auto looks_around = [&](const ir::Inst& inst) {
        return ir::has(inst.op, ir::Derivative) || (inst.op == Op::Call && needs_quad[inst.data]);
    };
    for (std::size_t i = 0; i < module.functions.size(); ++i) {
        needs_quad[i] = std::any_of(module.functions[i].insts.begin(), module.functions[i].insts.end(), looks_around);
    }
    const std::vector<ir::Rate> rates = ir::rates(module, function);
    for (std::uint32_t i = 0; i < function.insts.size(); ++i) {
        const ir::Inst& inst = function.insts[i];
        if (!looks_around(inst) || rates[i] != ir::Rate::Light) continue;
        const ir::Origin origin = inst.origin ? module.origins[inst.origin.index] : ir::Origin{};
        lowering.session.diagnostics
            .report(Code::DerivativePerLight, origin.span,
                    inst.op == Op::Call ? module.functions[inst.data].name : std::string(ir::info(inst.op).text))
            .at(origin.id)
            .note("sample with an explicit level, or move it before what depends on the light");
    }
}

// One output of the lighting graph, as the function that the slot declares.
ir::FunctionId lower_lighting(Lowering& lowering, const FunctionDecl& slot, const PortValue& output,
                              GraphScope& material, bool& needs_quad) {
    ir::Module& module = lowering.out.module;
    const CheckedGraph& lighting = *lowering.material.lighting;
    ir::Function function{};
    function.name = slot.name;
    function.always_inline = true;
    ir::Builder builder(module, function, lowering.emitter.options());
    GraphScope scope(lowering, lighting, builder, false);
    scope.set_property_values(lowering.material.lighting_inputs, material);
    bool per_light = false;
    for (const nodelang::ParamDecl& param : slot.params) {
        const bool is_light = std::any_of(param.attributes.begin(), param.attributes.end(),
                                          [](const nodelang::Attribute& a) { return a.name == "per_light"; });
        per_light = per_light || is_light;
        const Type type = lowering.emitter.type(param.type, scope.scope());
        function.params.push_back({std::string(param.name), type, is_light ? ir::Rate::Light : ir::Rate::Pixel});
        const Typed value{.value = builder.param(static_cast<std::uint32_t>(function.params.size() - 1)), .type = type};
        scope.give(param.name, value);
        if (function.params.size() == 1) {
            scope.shadow_by(value);
        } else {
            scope.watch(ir::Probe::Kind::Given, fmt::format("@{}", param.name), {}, value, output.name_span);
        }
    }
    scope.emit_nodes(lighting.reachable(std::span(&output, 1)));
    lowering.session.diagnostics.set_context(lowering.material.lighting_name, output.name);
    function.result = lowering.emitter.type(slot.result, scope.scope());
    module.origins.push_back({.label = {}, .id = {}, .span = output.value_span});
    builder.set_origin({static_cast<std::uint32_t>(module.origins.size() - 1)});
    const Typed value = scope.value_as(output, function.result, fmt::format("the output '{}'", output.name));
    lowering.session.diagnostics.set_context({}, {});
    if (!value.ok()) return {};
    scope.watch(ir::Probe::Kind::Output, output.name, {}, value, output.name_span);
    std::erase_if(function.probes, [&](const ir::Probe& probe) {
        return probe.kind == ir::Probe::Kind::Given && std::ranges::count(function.operands, probe.value) == 0;
    });
    builder.ret(value.value);
    needs_quad = scope.needs_quad();
    if (per_light && needs_quad) refuse_derivatives_per_light(lowering, function);
    return add_function(module, std::move(function));
}

void lower_slots(Lowering& lowering) {
    const Library& library = lowering.session.library;
    std::vector<const Input*> members;
    const ir::FunctionId surface = lower_surface(lowering, members);
    const nodelang::Scope scope{.declarations = &library.declarations};
    // The material's scope, for values that it hands to the lighting graph's properties.
    ir::Function unused{};
    ir::Builder unused_builder(lowering.out.module, unused, lowering.emitter.options());
    GraphScope material(lowering, *lowering.material.graph, unused_builder, false);
    const CheckedGraph& lighting = *lowering.material.lighting;
    for (const FunctionDecl& slot : library.ast.functions) {
        if (!slot.attribute("slot")) continue;
        nodelang::Slot made{.function = {}, .result = lowering.emitter.type(slot.result, scope)};
        const auto output = std::find_if(lighting.graph->outputs.begin(), lighting.graph->outputs.end(),
                                         [&](const PortValue& p) { return p.name == slot.name; });
        if (slot.params.empty()) {
            if (!surface) continue;
            made.function = lower_setup(lowering, slot, surface, members);
        } else if (output != lighting.graph->outputs.end()) {
            if (!output->value) continue;
            made.function = lower_lighting(lowering, slot, *output, material, made.needs_quad);
        } else if (slot.has_body) {
            made.function = lowering.emitter.plain_function(slot, library.declarations);
        }
        if (made.function) lowering.emitter.set_slot(slot.name, made);
    }
}

void lower_vertex_outputs(Lowering& lowering) {
    const CheckedGraph& graph = *lowering.material.graph;
    ir::Module& module = lowering.out.module;
    for (const PortValue& port : graph.graph->vertex) {
        const auto semantic = lowering.session.library.semantic_index.find(port.name);
        if (semantic == lowering.session.library.semantic_index.end()) continue;
        ir::Function function{};
        function.name = "vertex_" + port.name;
        ir::Builder builder(module, function, lowering.emitter.options());
        GraphScope scope(lowering, graph, builder, true);
        if (!port.value) continue;
        scope.announce(*port.value);
        scope.emit_nodes(graph.reachable(std::span(&port, 1)));
        function.result = module.semantics[semantic->second].type;
        lowering.session.diagnostics.set_context("vertex", port.name);
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
        if (!value.ok()) continue;
        scope.watch(ir::Probe::Kind::Output, "vertex", port.name, value, port.name_span);
        builder.ret(value.value);
        lowering.out.semantics[semantic->second].override = add_function(module, std::move(function));
    }
}

void lower_passes(Lowering& lowering, LibraryEnvironment& environment) {
    const Library& library = lowering.session.library;
    const std::vector<std::string>& wanted = lowering.session.options.passes;
    for (const PassDecl& pass : library.passes) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), pass.name) == wanted.end()) continue;
        if (!pass.vertex || !pass.fragment) continue;
        LoweredPass made{.declaration = &pass, .vertex = {}, .fragment = {}};
        made.vertex = lowering.emitter.semantic_function(*pass.vertex, library.declarations, environment, true);
        made.fragment = lowering.emitter.semantic_function(*pass.fragment, library.declarations, environment, false);
        if (made.vertex && made.fragment) lowering.out.passes.push_back(made);
    }
}

// Recipes of every semantic that a function reads, and of those that the recipes read.
void lower_recipes(Lowering& lowering, LibraryEnvironment& environment) {
    Lowered& out = lowering.out;
    for (std::size_t f = 0; f < out.module.functions.size(); ++f) {
        for (std::size_t i = 0; i < out.module.functions[f].insts.size(); ++i) {
            const ir::Inst inst = out.module.functions[f].insts[i];
            if (inst.op != Op::Semantic) continue;
            SemanticRecipe& recipe = out.semantics[inst.data];
            if (!recipe.declaration || !recipe.declaration->function || recipe.recipe) continue;
            const ir::FunctionId made = lowering.emitter.semantic_function(
                *recipe.declaration->function, lowering.session.library.declarations, environment, false);
            if (!made) return;  // a fault in the library, reported
            out.semantics[inst.data].recipe = made;
        }
    }
}

void unknown_passes(Session& session) {
    for (const std::string& wanted : session.options.passes) {
        const auto& passes = session.library.passes;
        if (std::any_of(passes.begin(), passes.end(), [&](const PassDecl& p) { return p.name == wanted; })) continue;
        std::vector<std::string_view> known;
        for (const PassDecl& pass : passes) known.push_back(pass.name);
        session.diagnostics.report(Code::UnknownPass, {}, wanted).note(Diagnostics::suggestion(wanted, known));
    }
}

}  // namespace

Lowered lower(Session& session, const Material& material, ir::BuildOptions options) {
    Lowered out;
    Lowering lowering{.session = session,
                      .material = material,
                      .out = out,
                      .emitter = nodelang::Emitter(out.module, session.diagnostics, options),
                      .enumerators = {},
                      .interpolators = {},
                      .active_interpolators = {}};
    declare_engine(session.library, lowering.emitter);
    out.property_globals = declare_material(material, out.module);
    declare_statics(lowering);
    extend_lighting_surface(lowering);
    declare_semantics(lowering);
    unknown_passes(session);
    lower_slots(lowering);
    lower_vertex_outputs(lowering);
    if (session.diagnostics.has_errors()) return out;
    LibraryEnvironment environment(lowering);
    lower_passes(lowering, environment);
    lower_recipes(lowering, environment);
    return out;
}

}  // namespace patina::graph
