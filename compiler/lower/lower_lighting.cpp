// Lowers the slots that a lighting graph fills, and the slots that are derived from them.
#include <algorithm>

#include "compiler/ir/passes/passes.h"
#include "compiler/lower/lowering.h"

namespace patina::lower {

using emit::Typed;
using ir::Op;
using ir::Type;
using nodelang::FunctionDecl;

namespace {

// Neighbouring pixels see the same lights in the same order, but inside the loop a derivative would be computed once
// for each light.
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
            .note("sample with an explicit mip level, or move it before what depends on the light");
    }
}

// Lowers one output of the lighting graph as the function that the slot declares.
struct LoweredOutput {
    ir::FunctionId function{};
    bool needs_quad = false;
    bool is_per_light = false;  // the value depends on the light
};
LoweredOutput lower_lighting(Lowering& lowering, const paths::SlotDecl& declared, const format::PortValue& output,
                             GraphScope& material) {
    const FunctionDecl& slot = *declared.function;
    ir::Module& module = lowering.out.module;
    const resolve::CheckedGraph& lighting = *lowering.material.lighting;
    ir::Function function{};
    function.name = slot.name;
    function.comment = nodelang::first_sentence(slot.doc);
    function.always_inline = !lowering.out.keeps_functions;
    ir::Builder builder(module, function, lowering.emitter.options);
    GraphScope scope(lowering, lighting, builder, false);
    scope.set_property_values(lowering.material.lighting_inputs, material);
    for (const nodelang::ParamDecl& param : slot.params) {
        const bool is_light = declared.light_param == function.params.size();
        const Type type = emit::type(lowering.emitter, param.type, scope.scope());
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
    function.result = emit::type(lowering.emitter, slot.result, scope.scope());
    const Typed value = output.value == lowering.material.shown_value.value
                            ? as_color(lowering, scope.value(*output.value), scope, output.value_span)
                            : scope.value_as(output, function.result, fmt::format("the output '{}'", output.name));
    lowering.session.diagnostics.set_context({}, {});
    if (!value.ok()) return {};
    scope.watch(ir::Probe::Kind::Output, output.name, {}, value, output.name_span);
    std::erase_if(function.probes, [&](const ir::Probe& probe) {
        return probe.kind == ir::Probe::Kind::Given &&
               std::count(function.operands.begin(), function.operands.end(), probe.value) == 0;
    });
    builder.ret(value.value);
    LoweredOutput made{.needs_quad = scope.needs_quad()};
    made.is_per_light = ir::rates(module, function)[value.value.index] == ir::Rate::Light;
    if (declared.light_param && made.needs_quad) refuse_derivatives_per_light(lowering, function);
    made.function = add_function(module, without_unset_inputs(lowering, std::move(function)));
    return made;
}

// A slot of a preview that adds nothing; or, if its parameters have the sums of the other slots, adds only these.
ir::FunctionId lower_sum(Lowering& lowering, const paths::SlotDecl& declared) {
    ir::Module& module = lowering.out.module;
    const emit::Scope scope{.declarations = lowering.session.declarations};
    ir::Function function{};
    function.name = declared.function->name;
    function.always_inline = true;
    function.result = emit::type(lowering.emitter, declared.function->result, scope);
    ir::Builder builder(module, function, lowering.emitter.options);
    for (const nodelang::ParamDecl& param : declared.function->params)
        function.params.push_back(
            {std::string(param.name), emit::type(lowering.emitter, param.type, scope), ir::Rate::Pixel});
    ir::Value sum = builder.zero(function.result);
    for (std::uint32_t p = 1; p < function.params.size() && !declared.light_param; ++p) {
        const Type type = function.params[p].type;
        if (type.kind != ir::Kind::Struct) continue;
        const std::size_t count = module.structs[type.ref].members.size();
        for (std::uint32_t m = 0; m < count; ++m) {
            const ir::Value part = builder.extract(builder.param(p), m);
            if (builder.type(part) == function.result) sum = builder.emit(Op::Add, function.result, {sum, part});
        }
    }
    if (declared.light_param) function.params[*declared.light_param].rate = ir::Rate::Light;
    builder.ret(sum);
    return add_function(module, std::move(function));
}

bool reads_semantic(const nodelang::Expr& value, std::string_view semantic) {
    return (value.kind == nodelang::Expr::Kind::Semantic && value.text == semantic) ||
           std::any_of(value.args.begin(), value.args.end(),
                       [&](const auto* part) { return reads_semantic(*part, semantic); });
}

// True if a value of the lighting graph, or a node that it reads, reads a parameter of the slot other than the surface.
bool reads_parameter(const resolve::CheckedGraph& lighting, const format::PortValue& value,
                     const paths::SlotDecl& slot) {
    const std::vector<bool> reached = lighting.reachable(std::span(&value, 1));
    for (std::size_t p = 1; p < slot.function->params.size(); ++p) {
        const std::string_view name = slot.function->params[p].name;
        const auto is_read_by = [&](const format::PortValue& port) {
            return port.value && reads_semantic(*port.value, name);
        };
        if (is_read_by(value)) return true;
        for (std::size_t i = 0; i < reached.size(); ++i) {
            const format::Node& node = lighting.graph->nodes[i];
            if (reached[i] && ((node.expr && reads_semantic(*node.expr, name)) ||
                               std::any_of(node.inputs.begin(), node.inputs.end(), is_read_by)))
                return true;
        }
    }
    return false;
}

// The slot that has the sums of the others, if the value that a preview shows reads them. Then the other slots are as
// in the picture. Else null.
const paths::SlotDecl* shown_sum(const Lowering& lowering) {
    const resolve::Material& material = lowering.material;
    if (!material.shown_value.value) return nullptr;
    for (const paths::SlotDecl& slot : lowering.session.paths->slots) {
        const bool is_sum = !slot.is_derived() && !slot.light_param && slot.function->params.size() > 1;
        if (is_sum && reads_parameter(*material.lighting, material.shown_value, slot)) return &slot;
    }
    return nullptr;
}

// A preview of a value of the lighting graph: it is the only light. If the value depends on the light, it is summed
// over the lights; else it counts once.
void lower_shown(Lowering& lowering, GraphScope& material) {
    const format::PortValue& shown = lowering.material.shown_value;
    bool is_per_light = false;
    for (const bool of_lights : {true, false}) {
        for (const paths::SlotDecl& declared : lowering.session.paths->slots) {
            const std::size_t params = declared.function->params.size();
            if (declared.is_derived() || params == 0 || declared.light_param.has_value() != of_lights) continue;
            emit::Slot made{.function = {},
                            .result = emit::type(lowering.emitter, declared.function->result,
                                                 {.declarations = lowering.session.declarations})};
            if (of_lights || (params == 1 && !is_per_light)) {
                const LoweredOutput lowered = lower_lighting(lowering, declared, shown, material);
                if (!lowered.function) return;  // an error
                is_per_light |= lowered.is_per_light;
                if (!of_lights || is_per_light) {
                    made.function = lowered.function;
                    made.needs_quad = lowered.needs_quad;
                }
            }
            if (!made.function) made.function = lower_sum(lowering, declared);
            lowering.emitter.known.slots[std::string(declared.name())] = made;
        }
    }
}

}  // namespace

void lower_slots(Lowering& lowering) {
    std::vector<const format::Input*> members;
    const ir::FunctionId surface = lowering.surface = lower_surface(lowering, members);
    const nodelang::Declarations& declarations = *lowering.session.declarations;
    const emit::Scope scope{.declarations = &declarations};
    // The material's scope, for values that it gives to the lighting graph's properties.
    ir::Function unused{};
    ir::Builder unused_builder(lowering.out.module, unused, lowering.emitter.options);
    GraphScope material(lowering, *lowering.material.graph, unused_builder, false);
    const resolve::CheckedGraph& lighting = *lowering.material.lighting;
    const paths::SlotDecl* const sum = shown_sum(lowering);
    const bool is_only_light = lowering.material.shown_value.value && !sum;
    for (const paths::SlotDecl& declared : lowering.session.paths->slots) {
        if (declared.is_derived()) continue;
        const FunctionDecl* slot = declared.function;
        emit::Slot made{.function = {}, .result = emit::type(lowering.emitter, slot->result, scope)};
        const auto output = std::find_if(lighting.graph->outputs.begin(), lighting.graph->outputs.end(),
                                         [&](const format::PortValue& p) { return p.name == slot->name; });
        if (slot->params.empty()) {
            if (!surface) continue;
            made.function = lowering.setup = lower_setup(lowering, *slot, surface, members);
        } else if (is_only_light) {
            continue;
        } else if (&declared == sum) {
            const LoweredOutput lowered = lower_lighting(lowering, declared, lowering.material.shown_value, material);
            made.function = lowered.function;
            made.needs_quad = lowered.needs_quad;
        } else if (output != lighting.graph->outputs.end()) {
            if (!output->value) continue;
            const LoweredOutput lowered = lower_lighting(lowering, declared, *output, material);
            made.function = lowered.function;
            made.needs_quad = lowered.needs_quad;
        } else if (slot->has_body) {
            made.function = emit::plain_function(lowering.emitter, *slot, declarations);
        }
        if (made.function) lowering.emitter.known.slots[std::string(slot->name)] = made;
    }
    if (is_only_light) lower_shown(lowering, material);
}

}  // namespace patina::lower
