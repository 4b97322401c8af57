#include "compiler/lower/lower.h"

#include <algorithm>
#include <array>

#include "compiler/base/spelling.h"
#include "compiler/format/clipped_blend.h"
#include "compiler/format/words.h"
#include "compiler/ir/texture_kinds.h"
#include "compiler/lower/instances.h"
#include "compiler/lower/lowering.h"

namespace patina::lower {

using emit::Typed;
using ir::Op;
using ir::Type;
using ir::Value;
using nodelang::FunctionDecl;

namespace {

ir::Rate rate_of(paths::SemanticSource source) {
    switch (source) {
        case paths::SemanticSource::Attribute: return ir::Rate::Pixel;  // where a fragment reads it, it is interpolated
        case paths::SemanticSource::Builtin:
        case paths::SemanticSource::Vertex:
        case paths::SemanticSource::Pixel:
        case paths::SemanticSource::Given: return ir::Rate::Pixel;
        case paths::SemanticSource::Extern:
        case paths::SemanticSource::Uniform: return ir::Rate::Uniform;
    }
    return ir::Rate::Pixel;
}

// The value of a property that chooses the kind of the surface ("materialOverride"): a bool, or an enum as an int.
Value read_choice(const Lowering& lowering, std::string_view name, ir::Builder& builder) {
    const std::size_t index = lowering.material.property_index.find(name)->second;
    const resolve::MaterialProperty& entry = lowering.material.properties[index];
    const Type type = entry.property->type == PropertyType::Bool ? ir::kBool : ir::kInt;
    const ir::GlobalId keyword = lowering.out.property_globals[index].keyword;
    return keyword ? builder.emit(Op::Global, type, {}, keyword.index) : builder.constant(type, {entry.chosen});
}

// Whether the surface is one of these kinds, where materials choose it. A surface that blends may be clipped, too.
Value read_kind(const Lowering& lowering, std::span<const std::string_view> words, ir::Builder& builder) {
    const auto is_asked = [&](SurfaceKind kind) {
        return std::find(words.begin(), words.end(), to_string(kind)) != words.end();
    };
    const auto either = [&](Value a, Value b) { return a ? builder.emit(Op::Or, ir::kBool, {a, b}) : b; };
    Value blends{}, is_any{};
    bool asks_for_all = true;
    for (int i = 0; const resolve::BlendingKind& each : resolve::kBlendingKinds) {
        if (is_asked(each.kind)) {
            const Value blend = read_choice(lowering, resolve::kBlendChoice, builder);
            blends =
                either(blends, builder.emit(Op::Equal, ir::kBool, {blend, builder.constant(ir::kInt, {double(i)})}));
        }
        asks_for_all = asks_for_all && is_asked(each.kind);
        ++i;
    }
    if (blends) {
        is_any = read_choice(lowering, resolve::kTransparentChoice, builder);
        if (!asks_for_all) is_any = builder.emit(Op::And, ir::kBool, {is_any, blends});
    }
    if (is_asked(SurfaceKind::Cutout)) is_any = either(is_any, read_choice(lowering, resolve::kClipChoice, builder));
    if (is_asked(SurfaceKind::Opaque)) {
        const Value other = either(read_choice(lowering, resolve::kTransparentChoice, builder),
                                   read_choice(lowering, resolve::kClipChoice, builder));
        is_any = either(is_any, builder.emit(Op::Not, ir::kBool, {other}));
    }
    return is_any;
}

void declare_statics(Lowering& lowering) {
    const format::RenderState& render = lowering.material.graph->graph->render;
    const auto depends_on_choice = [&](const paths::StaticDecl& asked) {
        return render.is_overridable && asked.about == paths::StaticDecl::About::Surface &&
               std::find(asked.words.begin(), asked.words.end(), paths::kChosenKind) == asked.words.end();
    };
    const auto is_true = [&](const paths::StaticDecl& asked, std::string_view word) {
        switch (asked.about) {
            case paths::StaticDecl::About::Surface:
                if (word == paths::kChosenKind) return render.is_overridable;
                if (word == format::kClippedKind) return format::is_clipped_blend(*lowering.material.graph->graph);
                return word == to_string(render.surface);
            case paths::StaticDecl::About::Cull:
                // A material may show both sides. While it shows the front alone, the answer makes no difference.
                return word == to_string(render.is_overridable ? Cull::Off : render.cull);
            case paths::StaticDecl::About::Clip:
            case paths::StaticDecl::About::UvOrigin:
            case paths::StaticDecl::About::Slot:
            case paths::StaticDecl::About::Reads:
            case paths::StaticDecl::About::Pass: break;
        }
        return false;
    };
    for (const paths::StaticDecl& asked : lowering.session.paths->statics) {
        if (asked.is_of_passes()) continue;      // known later (lower_passes.cpp)
        if (asked.is_of_engine()) continue;      // known already (declare_engine())
        if (depends_on_choice(asked)) continue;  // emitted where it is read
        const bool is_any = std::any_of(asked.words.begin(), asked.words.end(),
                                        [&](std::string_view word) { return is_true(asked, word); });
        lowering.emitter.known.statics[asked.variable] = is_any ? 1 : 0;
    }
    if (!render.is_overridable) return;
    lowering.emitter.known.make_static = [&lowering](const nodelang::VariableDecl& variable, ir::Builder* builder) {
        emit::StaticValue made;
        for (const paths::StaticDecl& asked : lowering.session.paths->statics)
            if (builder && asked.variable == &variable && asked.about == paths::StaticDecl::About::Surface)
                made.emitted = read_kind(lowering, asked.words, *builder);
        return made;
    };
}

void declare_semantics(Lowering& lowering) {
    const emit::Scope scope{.declarations = lowering.session.declarations};
    for (const paths::SemanticDecl& semantic : lowering.session.paths->semantics) {
        const Type type = emit::type(lowering.emitter,
                                     semantic.function ? semantic.function->result : semantic.variable->type, scope);
        const bool from_bottom = semantic.is_uv && lowering.session.engine.uv_origin == UvOrigin::Bottom;
        lowering.out.module.semantics.push_back({.name = std::string(semantic.name),
                                                 .type = type,
                                                 .rate = rate_of(semantic.source),
                                                 .from_bottom = from_bottom});
        lowering.out.module.has_values_from_bottom |= from_bottom;
        SemanticRecipe& recipe = lowering.out.semantics.emplace_back();
        recipe.source = semantic.source;
        recipe.declaration = &semantic;
        if (const engines::VertexInput* input = lowering.session.engine.vertex_input(semantic.name)) {
            recipe.location = input->location;
            recipe.hlsl = input->hlsl;
        }
    }
}

// The slot without parameters, which a pass calls for the surface to be lit.
const FunctionDecl* surface_slot(const paths::PathDeclarations& paths) {
    const auto found = std::find_if(paths.slots.begin(), paths.slots.end(),
                                    [](const paths::SlotDecl& slot) { return slot.function->params.empty(); });
    return found == paths.slots.end() ? nullptr : found->function;
}

// A lighting model's own inputs become members of the lighting surface.
void extend_lighting_surface(Lowering& lowering) {
    const FunctionDecl* slot = surface_slot(*lowering.session.paths);
    const nodelang::StructDecl* surface = slot ? lowering.session.declarations->structure(slot->result.name) : nullptr;
    if (!surface) return;
    std::vector<ir::Member> members;
    for (const format::Input& input : lowering.material.lighting->graph->inputs) {
        const auto clash = std::find_if(surface->members.begin(), surface->members.end(),
                                        [&](const auto& m) { return m.name == input.name; });
        if (clash != surface->members.end()) {
            lowering.session.diagnostics.report(Code::DuplicateId, input.name_span, "surface member", input.name)
                .note("every lighting surface already has it: choose another name");
            continue;
        }
        const Type type = input_type(lowering, input);
        if (!type.is_error()) members.push_back({input.name, type});
    }
    lowering.emitter.known.extra_members[surface] = std::move(members);
}

void lower_vertex_outputs(Lowering& lowering) {
    const resolve::CheckedGraph& graph = *lowering.material.graph;
    ir::Module& module = lowering.out.module;
    for (const format::PortValue& port : graph.graph->vertex) {
        const auto semantic = lowering.session.paths->semantic_index.find(port.name);
        if (semantic == lowering.session.paths->semantic_index.end()) continue;
        ir::Function function{};
        function.name = joined("vertex", port.name);
        ir::Builder builder(module, function, lowering.emitter.options);
        GraphScope scope(lowering, graph, builder, true);
        if (!port.value) continue;
        scope.announce(*port.value);
        Lowering::VertexReader& reader =
            lowering.vertex_readers.emplace_back(Lowering::VertexReader{port.name, port.name_span, false, &graph});
        resolve::collect_reads(*port.value, graph, reader.reads);
        scope.emit_nodes(graph.reachable(std::span(&port, 1)));
        function.result = module.semantics[semantic->second].type;
        lowering.session.diagnostics.set_context("vertex", port.name);
        module.origins.push_back({.span = port.value_span});
        builder.set_origin({static_cast<std::uint32_t>(module.origins.size() - 1)});
        Typed value = scope.value(*port.value);
        // If a graph gives a tangent without its handedness, the mesh's handedness is kept.
        if (value.ok() && value.type == ir::kFloat3 && function.result == ir::kFloat4) {
            const Value mesh = builder.emit(Op::Semantic, ir::kFloat4, {}, semantic->second);
            value.value = builder.construct(ir::kFloat4, std::array{value.value, builder.extract(mesh, 3)});
            value.type = ir::kFloat4;
        }
        value = emit::convert(lowering.emitter, emit::primary(lowering.emitter, value, scope.scope(), port.value_span),
                              function.result, scope.scope(), port.value_span,
                              fmt::format("the vertex output '{}'", port.name));
        lowering.session.diagnostics.set_context({}, {});
        lowering.vertex_readers.pop_back();
        if (!value.ok()) continue;
        scope.watch(ir::Probe::Kind::Output, "vertex", port.name, value, port.name_span);
        builder.ret(value.value);
        lowering.out.semantics[semantic->second].override = add_function(module, std::move(function));
    }
}

// A variant of the lighting graph, whose value the material gives.
const format::Property* variant_of_lighting(const resolve::Material& material, std::string_view name) {
    for (const format::Property& property : material.lighting->graph->properties) {
        if (property.name == name && property.binding == Binding::Variant) return &property;
    }
    return nullptr;
}

// A switch that only changes positions or reads of all passes, and adds no pass. The path has it only while a renderer
// turns it on.
bool is_of_wraps(const paths::PathDeclarations& paths, std::string_view name) {
    return std::any_of(paths.wraps.begin(), paths.wraps.end(), [&](const paths::WrapDecl& wrap) {
        return std::find(wrap.with.begin(), wrap.with.end(), name) != wrap.with.end();
    });
}

// Declares the switches with the values that the caller chose.
void declare_switches(Lowering& lowering) {
    resolve::Session& session = lowering.session;
    const bool has_passes = !session.request.functions && !session.engine.has_own_passes();
    std::vector<std::string_view> known;
    for (const paths::SwitchDecl& each : session.paths->switches) {
        known.push_back(each.variable->name);
        lowering.out.switches.emplace_back(each.variable->name, false);
    }
    for (const auto& [name, value] : session.options.switches) {
        const auto found = std::find(known.begin(), known.end(), name);
        const bool is_switch = found != known.end();
        if (!is_switch && lowering.material.property_index.contains(name)) continue;  // of the graph (keywords.cpp)
        const format::Property* of_lighting = is_switch ? nullptr : variant_of_lighting(lowering.material, name);
        if (of_lighting && lowering.material.variants.contains(of_lighting)) continue;  // (choose_lighting.cpp)
        if (!is_switch && lowering.material.unused_variants.contains(name)) continue;
        if (!is_switch || !has_passes) {
            std::vector<std::string_view> words = resolve::keyword_names(lowering.material);
            for (const format::Property& property : lowering.material.lighting->graph->properties) {
                if (lowering.material.variants.contains(&property)) words.push_back(property.name);
            }
            // Switches that only a renderer turns on are not for readers.
            for (std::size_t i = known.size(); has_passes && i-- > 0;) {
                const bool is_internal =
                    is_of_wraps(*session.paths, known[i]) || !session.paths->switch_named(known[i])->otherwise.empty();
                if (!is_internal) words.insert(words.begin(), known[i]);
            }
            DiagnosticRecord& record = session.diagnostics.report(
                Code::UnknownWord, {}, name,
                has_passes ? "a switch of the path, a variant or a specialization constant of the graph"
                           : "a variant or specialization constant of the graph");
            if (of_lighting) {
                record.note(
                    of_lighting->name_span,
                    "the material sets this variant of the lighting graph to a property of its own: set that property");
                continue;
            }
            record.note(is_switch       ? fmt::format("it is a switch of the rendering paths, and {} no path",
                                                session.engine.has_own_passes() ? "the file of this target has"
                                                                                      : "functions have")
                        : words.empty() ? "there are none"
                                        : Diagnostics::suggestion(name, words));
        } else if (!value.empty() && value != "true" && value != "false") {
            session.diagnostics.report(Code::UnknownWord, {}, value, fmt::format("a value of '{}'", name))
                .note("these exist: true and false");
        } else {
            lowering.out.switches[static_cast<std::size_t>(found - known.begin())].second = value != "false";
        }
    }
    // Switches that are off and that no reader of the reflection needs are left out.
    std::erase_if(lowering.out.switches, [&](const auto& each) {
        return !each.second &&
               (is_of_wraps(*session.paths, each.first) || !session.paths->switch_named(each.first)->otherwise.empty());
    });
    for (const paths::SwitchDecl& each : session.paths->switches)
        lowering.emitter.known.statics[each.variable] = lowering.is_on(each.variable->name) ? 1 : 0;
    for (const nodelang::VariableDecl* older : session.paths->repeated) {
        if (session.library.paths.switch_of(older))
            lowering.emitter.known.statics[older] = lowering.is_on(older->name) ? 1 : 0;
    }
}

void report_large_instance(resolve::Session& session, const resolve::Material& material, const Lowered& lowered,
                           const std::set<std::uint32_t>& globals, const OptionalValues& optional) {
    const auto first = std::find_if(material.properties.begin(), material.properties.end(),
                                    [](const auto& each) { return each.property->binding == Binding::Instance; });
    const std::uint32_t most = session.engine.most_block_bytes;
    const auto [bytes, room] = size_of_instance(lowered, globals, optional, most);
    session.diagnostics.report(Code::TooMany, first->property->name_span, bytes, "bytes for each instance", room)
        .note(fmt::format("a uniform block has {} bytes, too little for one instance: remove \"as\": \"instance\" from "
                          "properties that all instances share",
                          most));
}

OptionalValues optional_values(Lowering& lowering) {
    OptionalValues made;
    const emit::Scope scope{.declarations = lowering.session.declarations};
    for (const paths::ExternDecl& each : lowering.session.paths->externs) {
        if (!each.is_per_object || each.with.empty() || each.block.empty()) continue;
        if (const auto global = emit::find_extern(lowering.emitter.known, *each.variable))
            made.declared.insert(global->index);
        else
            made.absent.push_back(emit::type(lowering.emitter, each.variable->type, scope));
    }
    return made;
}

// The switches that are on, and the path.
std::vector<std::string_view> what_is_on(const Lowering& lowering) {
    const resolve::Session& session = lowering.session;
    std::vector<std::string_view> on = {session.path};
    if (session.path == resolve::kAllPaths) on = session.paths->names();
    for (const auto& [name, value] : lowering.out.switches)
        if (value) on.push_back(name);
    return on;
}

}  // namespace

namespace {

template <class What>
const Given<What>* find_given(const std::vector<Given<What>>& given, What what, ir::StageKind stage) {
    const auto found = std::find_if(given.begin(), given.end(), [&](const Given<What>& each) {
        return each.what == what && (stage == ir::StageKind::Vertex ? each.in_vertex_stage : each.in_fragment_stage);
    });
    return found == given.end() ? nullptr : &*found;
}

}  // namespace

const Given<ir::SemanticId>* LoweredPass::recipe_of(ir::SemanticId semantic, ir::StageKind stage) const {
    return find_given(recipes, semantic, stage);
}

const Given<ir::FunctionId>* LoweredPass::replacement_of(ir::FunctionId function, ir::StageKind stage) const {
    return find_given(replaced, function, stage);
}

std::optional<ir::GlobalId> LoweredPass::attribute_of(ir::SemanticId semantic) const {
    for (const auto& [known, global] : attributes) {
        if (known == semantic) return global;
    }
    return {};
}

std::string_view known_as(const paths::PassDecl& pass) {
    const auto tag =
        std::find_if(pass.tags.begin(), pass.tags.end(), [](const auto& each) { return each.first != "Name"; });
    return tag == pass.tags.end() ? pass.name : std::string_view(tag->second);
}

const paths::BlendRow* blend_of(const paths::PassDecl& pass, SurfaceKind surface) {
    for (const paths::BlendRow& row : pass.blends) {
        if (!row.surface || *row.surface == surface) return &row;
    }
    return nullptr;
}

bool Lowering::is_on(std::string_view wanted) const {
    return std::any_of(out.switches.begin(), out.switches.end(),
                       [&](const auto& each) { return each.first == wanted && each.second; });
}

std::string_view Lowering::slot_name(ir::FunctionId function) const {
    const std::string_view name = emit::slot_name(emitter.known, function);
    if (!name.empty()) return name;
    for (const auto& [slot, part] : derived_slots) {
        if (part.slot.function == function) return slot;
    }
    return {};
}

bool Lowering::is_packing(std::string_view slot) const {
    const paths::SlotDecl* found = session.paths->slot(slot);
    return found &&
           (found->making == paths::SlotDecl::Making::Pack || found->making == paths::SlotDecl::Making::Unpack);
}

ir::FunctionId add_function(ir::Module& module, ir::Function function) {
    module.functions.push_back(std::move(function));
    return {static_cast<std::uint32_t>(module.functions.size() - 1)};
}

Type type_of_word(Lowering& lowering, std::string_view word, Span span) {
    constexpr std::pair<std::string_view, std::string_view> kOthers[] = {{"color", "float4"},
                                                                         {"color3", "float3"},
                                                                         {"gradient", "Gradient"},
                                                                         {"curve", "Curve"},
                                                                         {"sampler", "SamplerState"}};
    const emit::Scope scope{.declarations = lowering.session.declarations};
    const std::optional<PropertyType> texture = format::texture_type(word);
    std::string_view name = texture ? ir::texture_kind(texture_kind(*texture))->name : word;
    for (const auto& [ours, theirs] : kOthers) {
        if (word == ours) name = theirs;
    }
    return emit::type(lowering.emitter, {.name = name, .span = span}, scope);
}

Type input_type(Lowering& lowering, const format::Input& input) {
    return type_of_word(lowering, input.type, input.type_span);
}

namespace {

// If just one pass draws the surface, its functions are pasted into it, as everywhere else.
void paste_slots_of_one_pass(Lowering& lowering) {
    Lowered& out = lowering.out;
    const auto draws = [](const LoweredPass& pass) { return !pass.declaration->state.targets.empty(); };
    if (!out.keeps_functions || lowering.material.pass ||
        std::count_if(out.passes.begin(), out.passes.end(), draws) > 1)
        return;
    out.keeps_functions = false;
    for (const paths::SlotDecl& declared : lowering.session.paths->slots) {
        const auto slot = lowering.emitter.known.slots.find(std::string(declared.name()));
        if (slot != lowering.emitter.known.slots.end() && slot->second.function)
            out.module[slot->second.function].always_inline = true;
    }
}

}  // namespace

Lowered lower(resolve::Session& session, const resolve::Material& material, ir::BuildOptions options) {
    Lowered out;
    Lowering lowering{.session = session,
                      .material = material,
                      .out = out,
                      .emitter = {.module = out.module,
                                  .diagnostics = session.diagnostics,
                                  .options = options,
                                  .growth = &session.growth},
                      .enumerators = {},
                      .interpolators = {},
                      .subgraph_uses = subgraph_uses(material),
                      .subgraph_functions = {},
                      .vertex_readers = {},
                      .derived_slots = {},
                      .per_object = {},
                      .surface = {}};
    declare_switches(lowering);
    const std::vector<std::string_view> on = what_is_on(lowering);
    const engines::Engine& engine = session.engine;
    EngineGlobals declared = declare_engine(engine, *session.paths, *session.declarations, lowering.emitter, on);
    lowering.per_object = std::move(declared.per_object);
    out.reads = std::move(declared.reads);
    const bool may_be_instanced = !session.request.functions && engine.instances == engines::Instances::Arrays;
    const bool instanced = may_be_instanced && is_instanced(material);
    out.property_globals = declare_material(
        engine, material, out.module, session.options.keep_variants,
        instanced ? std::optional(out.module.globals[*lowering.per_object.begin()].block) : std::nullopt);
    for (std::size_t i = 0; instanced && i < material.properties.size(); ++i) {
        if (material.properties[i].property->binding == Binding::Instance)
            lowering.per_object.insert(out.property_globals[i].value.index);
    }
    for (const PropertyGlobals& globals : out.property_globals) {
        if (globals.tiling && engine.uv_origin == UvOrigin::Bottom)
            out.module.globals[globals.tiling.index].from_bottom = true;
    }
    // An extra pass of a material shares functions with other passes only if it is lit.
    out.keeps_functions = engine.is_one_file() && (!material.pass || !material.lighting->graph->nodes.empty());
    keep_values(lowering);
    out.shifts = place_globals(out.module, engine, declared.numbering);
    out.target_set = engine.places_of(ir::Group::Targets).set;
    out.clip_depth = engine.clip_depth;
    declare_statics(lowering);
    extend_lighting_surface(lowering);
    declare_semantics(lowering);
    lower_wraps(lowering, on);
    lower_slots(lowering);
    lower_vertex_outputs(lowering);
    if (session.diagnostics.has_errors()) return out;
    if (!session.request.functions) {
        lower_passes(lowering);
        paste_slots_of_one_pass(lowering);
        give_texts(lowering);
    } else {
        lower_functions(lowering);
    }
    if (session.diagnostics.has_errors()) return out;
    if (instanced || (may_be_instanced && reads_instance(out))) {
        out.instance_globals = lowering.per_object;
        const OptionalValues optional = optional_values(lowering);
        // Arrays that every device takes; longer ones only if a single instance needs them.
        out.instances = make_instanced(out, out.instance_globals, optional, engine.guaranteed_block_bytes);
        if (out.instances == 0)
            out.instances = make_instanced(out, out.instance_globals, optional, engine.most_block_bytes);
        if (out.instances == 0) report_large_instance(session, material, out, out.instance_globals, optional);
    }
    return out;
}

}  // namespace patina::lower
