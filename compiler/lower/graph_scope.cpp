#include "compiler/lower/graph_scope.h"

#include <algorithm>
#include <array>
#include <utility>

#include "compiler/base/text.h"
#include "compiler/format/words.h"
#include "compiler/ir/texture_kinds.h"
#include "compiler/lower/lowering.h"
#include "compiler/nodelang/other_names.h"

namespace patina::lower {

using emit::Typed;
using ir::Op;
using ir::Type;
using ir::Value;
using nodelang::Expr;

GraphScope::GraphScope(Lowering& lowering, const resolve::CheckedGraph& graph, ir::Builder& builder,
                       bool in_vertex_stage)
    : lowering_(lowering), graph_(graph), values_(graph.nodes.size()), emitted_(graph.nodes.size(), false) {
    scope_.builder = &builder;
    scope_.declarations = &lowering.session.library.declarations;
    scope_.environment = this;
    scope_.needs_quad = &needs_quad_;
    scope_.in_vertex_stage = in_vertex_stage;
}

std::string GraphScope::id_path(std::string_view id) const {
    if (!outer_) return std::string(id);
    return outer_->id_path(outer_->graph_.graph->nodes[outer_node_].id) + "/" + std::string(id);
}

std::string_view GraphScope::what_graph() const {
    switch (graph_.graph->kind) {
        case format::GraphKind::Material: return "a material";
        case format::GraphKind::Subgraph: return "a sub-graph";
        case format::GraphKind::Lighting: return "this output of a lighting graph";
        case format::GraphKind::Workflow: return "a workflow";
    }
    return {};
}

std::string_view GraphScope::outermost_kind() const {
    if (outer_) return outer_->outermost_kind();
    switch (graph_.graph->kind) {
        case format::GraphKind::Material:
        case format::GraphKind::Subgraph: return "material";
        case format::GraphKind::Lighting: return "lighting";
        case format::GraphKind::Workflow: return "workflow";
    }
    return {};
}

void GraphScope::watch(ir::Probe::Kind kind, std::string id, std::string_view port, const Typed& value, Span span) {
    if (lowering_.emitter.options.fold || function_path_ > 0 || !value.ok()) return;
    ir::Probe probe{
        .kind = kind, .graph = outermost_kind(), .id = std::move(id), .ports = {}, .value = value.value, .span = span};
    if (value.outputs) {
        probe.ports = value.outputs->names;
    } else if (value.type.kind == ir::Kind::Struct) {
        for (const ir::Member& member : lowering_.out.module.structs[value.type.ref].members) {
            probe.ports.push_back(member.name);
        }
    } else {
        probe.ports.emplace_back(port.empty() ? "out" : port);
    }
    scope_.builder->function().probes.push_back(std::move(probe));
}

bool GraphScope::uses_half(const format::Node& node) const {
    if (node.precision != format::Precision::Inherit) return node.precision == format::Precision::Half;
    return graph_.graph->precision == format::Precision::Half;
}

// --- nodes

void GraphScope::announce(const Expr& expr) {
    const bool is_member = expr.kind == Expr::Kind::Member && expr.args[0]->kind == Expr::Kind::Name;
    if (is_member || expr.kind == Expr::Kind::Name) {
        const auto node = graph_.by_id.find(is_member ? expr.args[0]->text : expr.text);
        if (node != graph_.by_id.end()) read_outputs_[node->second].insert(is_member ? expr.text : std::string_view());
        return;
    }
    for (const Expr* argument : expr.args) announce(*argument);
}

void GraphScope::emit_nodes(const std::vector<bool>& wanted) {
    for (std::size_t i = 0; scope_.in_vertex_stage && i < wanted.size(); ++i) {
        if (!wanted[i]) continue;
        const format::Node& node = graph_.graph->nodes[i];
        if (node.expr) announce(*node.expr);
        for (const format::PortValue& port : node.inputs) {
            if (port.value) announce(*port.value);
        }
    }
    for (std::uint32_t index : graph_.order) {
        if (!wanted[index] || emitted_[index]) continue;
        if (resolve::must_stop(lowering_.session)) return;
        emit_node(index);
    }
}

void GraphScope::emit_node(std::uint32_t index) {
    emitted_[index] = true;
    const format::Node& node = graph_.graph->nodes[index];
    emit::grow(lowering_.emitter, node.id_span);
    const resolve::ResolvedNode& resolved = graph_.nodes[index];
    if (!resolved.ok) return;
    at_ = index;
    if (node.stage == format::NodeStage::Fragment && scope_.in_vertex_stage) {
        Diagnostics& diagnostics = lowering_.session.diagnostics;
        diagnostics.set_context(id_path(node.id), {});
        tell_reader(diagnostics.report(Code::WrongStage, node.stage_span, fmt::format("'{}'", node.id),
                                       "it is pinned to the fragment stage"));
        return;
    }
    if (node.stage == format::NodeStage::Vertex && !scope_.in_vertex_stage) {
        values_[index] = interpolated(index);
        watch(ir::Probe::Kind::Node, id_path(node.id), {}, values_[index], node.span);
        return;
    }
    ir::Module& module = lowering_.out.module;
    ir::Builder& b = *scope_.builder;
    const std::string path = id_path(node.id);
    const ir::OriginId outer_origin = b.origin();
    module.origins.push_back({.label = node.is_expression  ? node.note
                                       : resolved.function ? std::string(resolved.function->name)
                                       : resolved.subgraph ? resolve::file_stem(resolved.subgraph->graph->path)
                                                           : node.type,
                              .is_note = node.is_expression,
                              .id = path,
                              .function_path = static_cast<std::uint32_t>(function_path_),
                              .span = node.span});
    b.set_origin({static_cast<std::uint32_t>(module.origins.size() - 1)});
    lowering_.session.diagnostics.set_context(path, {});
    Typed value;
    if (node.is_expression) {
        const bool outer_half = std::exchange(scope_.half, uses_half(node));
        value = emit::expression(lowering_.emitter, *node.expr, scope_);
        scope_.half = outer_half;
        const bool is_number = std::exchange(value.literal, false) || node.expr->kind == Expr::Kind::Number;
        // Whole numbers in graphs become floats. Only the node language computes with ints.
        if (value.ok() && is_number && value.type.is_integer()) {
            value = emit::convert(lowering_.emitter, {.value = value.value, .type = value.type, .literal = true},
                                  ir::kFloat, scope_, node.expr_span, "the value");
        }
    } else if (resolved.subgraph) {
        value = subgraph_node(index);
    } else {
        value = call_node(node, resolved);
    }
    if (value.ok() && !resolved.subgraph) b.name(value.value, module.intern(node.id));
    values_[index] = value;
    watch(ir::Probe::Kind::Node, path, {}, value, node.span);
    // Messages name the outer graph again, after the sub-graph.
    lowering_.session.diagnostics.set_context(
        outer_ ? outer_->id_path(outer_->graph_.graph->nodes[outer_node_].id) : std::string(), {});
    at_.reset();
    b.set_origin(outer_origin);
}

Typed GraphScope::call_node(const format::Node& node, const resolve::ResolvedNode& resolved) {
    const nodelang::FunctionDecl& function = *resolved.function;
    std::vector<const Expr*> arguments(function.params.size(), nullptr);
    for (const format::PortValue& port : node.inputs) {
        if (!port.value) return {};
        for (std::size_t i = 0; i < function.params.size(); ++i) {
            if (function.params[i].name == port.name) arguments[i] = port.value;
        }
    }
    // Texture coordinates need more precision than the eleven bits of a half, so functions that sample compute in
    // float.
    const bool samples = std::any_of(function.params.begin(), function.params.end(), [](const nodelang::ParamDecl& p) {
        return ir::texture_kind(p.type.name) != nullptr;
    });
    return emit::call(lowering_.emitter, function, *resolved.home, arguments, scope_, node.type_span,
                      uses_half(node) && !samples);
}

// --- values

Typed GraphScope::value(const Expr& expr) {
    return emit::expression(lowering_.emitter, expr, scope_);
}

Typed GraphScope::value_as(const Expr& expr, Type type, std::string_view what, bool is_color) {
    if (is_color && type == ir::kFloat4 && expr.kind == Expr::Kind::List && expr.args.size() == 3) {
        const Typed rgb = value_as(expr, ir::kFloat3, what);
        ir::Builder& b = *scope_.builder;
        if (!rgb.ok()) return {};
        return {.value = b.construct(type, std::array{rgb.value, b.constant(ir::kFloat, {1})}), .type = type};
    }
    return emit::view_as(lowering_.emitter, expr, type, scope_, what);
}

// Instructions that belong to no node belong to the port.
Typed GraphScope::value_as(const format::PortValue& port, Type type, std::string_view what, bool is_color) {
    if (!port.value) return {};
    ir::Module& module = lowering_.out.module;
    ir::Builder& b = *scope_.builder;
    const ir::OriginId outer = b.origin();
    if (!outer) {
        module.origins.push_back({.span = port.value_span});
        b.set_origin({static_cast<std::uint32_t>(module.origins.size() - 1)});
    }
    const Typed value = value_as(*port.value, type, what, is_color);
    b.set_origin(outer);
    return value;
}

// --- Environment

Typed GraphScope::sampler(const Expr& expr, emit::Scope& scope) {
    if (graph_.by_id.contains(expr.text) || find_sampler(expr.text)) return name(expr, scope);
    format::report_no_sampler(lowering_.session.diagnostics, expr.span, expr.text);
    return {};
}

Typed GraphScope::name(const Expr& expr, emit::Scope&) {
    const auto found = graph_.by_id.find(expr.text);
    if (found != graph_.by_id.end()) return values_[found->second];
    if (const auto sampler = lowering_.material.property_index.find(expr.text);
        sampler != lowering_.material.property_index.end() && find_sampler(expr.text))
        return material_property(sampler->second);
    Diagnostics& diagnostics = lowering_.session.diagnostics;
    DiagnosticRecord& record = diagnostics.report(Code::DanglingLink, expr.span, expr.text);
    if (diagnostics.is_full()) return {};
    std::vector<std::string_view> known;
    for (const format::Node& node : graph_.graph->nodes) known.push_back(node.id);
    if (inputs_.contains(expr.text) || lowering_.material.property_index.contains(expr.text)) {
        record.note(fmt::format("read an input or property as '${}'", expr.text));
    } else if (lowering_.session.paths->semantic_index.contains(expr.text)) {
        record.note(fmt::format("read a semantic as '@{}'", expr.text));
    } else {
        const std::string advice = nodelang::word_advice(expr.text);
        record.note(advice.empty() ? Diagnostics::suggestion(expr.text, known) : advice);
    }
    return {};
}

Typed GraphScope::property(const Expr& expr, emit::Scope&) {
    if (const auto input = inputs_.find(expr.text); input != inputs_.end()) return input->second;
    for (const format::PortValue& port : property_values_) {
        if (port.name == expr.text) return bound_property(port);
    }
    const auto& own = graph_.graph->properties;
    const auto declared =
        std::find_if(own.begin(), own.end(), [&](const format::Property& p) { return p.name == expr.text; });
    if (declared != own.end()) {
        const auto variant = lowering_.material.variants.find(&*declared);
        if (variant != lowering_.material.variants.end())
            return keyword(*declared, known_value(*declared, variant->second));
    }
    const bool is_own = graph_.graph->kind == format::GraphKind::Material || declared != own.end();
    const auto index = lowering_.material.property_index.find(expr.text);
    if (is_own && index != lowering_.material.property_index.end()) {
        const format::Property& joined = *lowering_.material.properties[index->second].property;
        const bool is_same =
            declared == own.end() || (declared->type == joined.type && declared->values == joined.values);
        return is_same ? material_property(index->second) : stand_in(*declared);
    }
    DiagnosticRecord& record = lowering_.session.diagnostics.report(Code::UnknownProperty, expr.span, expr.text);
    if (lowering_.session.diagnostics.is_full()) return {};
    std::vector<std::string> written;
    for (const format::Property& property : own) written.push_back("$" + property.name);
    for (const auto& [name, value] : inputs_) written.push_back("$" + std::string(name));
    const std::vector<std::string_view> known(written.begin(), written.end());
    const std::string_view none = graph_.graph->kind == format::GraphKind::Lighting
                                      ? "the lighting graph has no properties: it declares each one that it reads"
                                      : "the graph has no properties";
    record.note(known.empty() ? std::string(none) : Diagnostics::suggestion("$" + std::string(expr.text), known));
    return {};
}

// The type of a property where a graph reads it.
Type GraphScope::type_of(const format::Property& property) {
    if (property.type == PropertyType::Bool) return ir::kBool;
    if (!is_texture(property.type) && !is_array(property.type))
        return property_type(lowering_.out.module, property.type);
    return type_of_word(lowering_, to_string(property.type), property.span);
}

namespace {

// The words of an enum, once for all who read it.
const std::vector<std::string_view>* words_of(Lowering& lowering, const format::Property& property) {
    for (const std::vector<std::string_view>& known : lowering.enumerators) {
        if (!known.empty() && !property.values.empty() && known.front().data() == property.values.front().data())
            return &known;
    }
    return &lowering.enumerators.emplace_back(property.values.begin(), property.values.end());
}

}  // namespace

// A lighting graph's property that the material has bound to a value of its own. The value is read in the material's
// scope, but emitted into this function.
Typed GraphScope::bound_property(const format::PortValue& port) {
    const auto& own = graph_.graph->properties;
    const auto property =
        std::find_if(own.begin(), own.end(), [&](const format::Property& p) { return p.name == port.name; });
    if (property == own.end() || !port.value) return {};
    GraphScope reader(lowering_, property_scope_->graph_, *scope_.builder, false);
    reader.emit_nodes(reader.graph_.reachable(std::span(&port, 1)));
    Typed value = reader.value_as(port, type_of(*property), fmt::format("the property '{}'", port.name));
    if (property->type == PropertyType::Enum) {
        value.enumerators = words_of(lowering_, *property);
    }
    return value;
}

// A bool, or an enum as an int.
Typed GraphScope::keyword(const format::Property& property, Value value) {
    if (property.type == PropertyType::Bool) return {.value = value, .type = ir::kBool};
    return {.value = value, .type = ir::kInt, .enumerators = words_of(lowering_, property)};
}

Value GraphScope::known_value(const format::Property& property, double value) {
    return scope_.builder->constant(property.type == PropertyType::Bool ? ir::kBool : ir::kInt, {value});
}

// A value for a property that another graph declares differently, which has been reported.
Typed GraphScope::stand_in(const format::Property& property) {
    if (is_texture(property.type) || property.type == PropertyType::Sampler) return {};
    if (property.type == PropertyType::Bool || property.type == PropertyType::Enum)
        return keyword(property, known_value(property, property.value[0]));
    const Type type = type_of(property);
    if (is_array(property.type)) return {.value = scope_.builder->zero(type), .type = type};
    return {.value = scope_.builder->splat_constant(type, property.value[0]), .type = type};
}

namespace {

emit::TextureView view_of(const format::Property& property) {
    emit::TextureView view{.green_is_down = property.handedness == Handedness::DirectX};
    std::copy(property.swizzle.begin(), property.swizzle.end(), view.channels.begin());
    return view;
}

}  // namespace

// A matrix is the first rows and columns of the one in the block; a gradient and a curve are structs around their
// array.
Typed GraphScope::array_property(const format::Property& property, Value stored) {
    ir::Builder& b = *scope_.builder;
    const Type type = type_of(property);
    if (type == b.type(stored)) return {.value = stored, .type = type};
    std::vector<Value> parts;
    if (type.is_matrix()) {
        constexpr std::array<unsigned, 4> kColumns = {0, 1, 2, 3};
        for (unsigned row = 0; row < type.rows; ++row)
            parts.push_back(b.swizzle(b.extract(stored, row), std::span(kColumns).first(type.cols)));
    } else {
        parts.push_back(stored);
    }
    return {.value = b.construct(type, parts), .type = type};
}

Typed GraphScope::material_property(std::size_t index) {
    const PropertyGlobals& globals = lowering_.out.property_globals[index];
    const format::Property& property = *lowering_.material.properties[index].property;
    const double chosen = lowering_.material.properties[index].chosen;
    ir::Module& module = lowering_.out.module;
    ir::Builder& b = *scope_.builder;
    const auto read = [&](ir::GlobalId id) { return b.emit(Op::Global, module.globals[id.index].type, {}, id.index); };
    if (format::is_keyword(property.binding))
        return keyword(property, globals.keyword ? read(globals.keyword) : known_value(property, chosen));
    if (property.type == PropertyType::Sampler)
        return {.value = read(globals.sampler), .type = Type::of(ir::Kind::Sampler)};
    if (is_texture(property.type)) {
        const Value tiling = globals.tiling ? read(globals.tiling) : Value();
        const Value texture = read(globals.texture), sampler = read(globals.sampler);
        const Value texel_size = globals.texel_size ? read(globals.texel_size) : Value();
        return emit::make_texture(lowering_.emitter,
                                  {.texture = texture,
                                   .sampler = sampler,
                                   .tiling = tiling,
                                   .texel_size = texel_size,
                                   .view = view_of(property)},
                                  scope_);
    }
    const Value value = read(globals.value);
    if (property.type == PropertyType::Bool) {
        return {.value = b.emit(Op::NotEqual, ir::kBool, {value, b.constant(ir::kInt, {0})}), .type = ir::kBool};
    }
    if (is_array(property.type)) return array_property(property, value);
    Typed typed{.value = value, .type = b.type(value)};
    if (property.type == PropertyType::Enum) {
        typed.enumerators = words_of(lowering_, property);
    }
    return typed;
}

namespace {

// True if a semantic depends on the pixel's position. The visible side does not count, because vertices see the front.
bool reads_pixel(const paths::PathDeclarations& paths, const paths::SemanticDecl& semantic) {
    if (semantic.source == paths::SemanticSource::Builtin) return semantic.builtin == ir::Builtin::FragCoord;
    if (!semantic.function) return false;
    return std::any_of(semantic.function->params.begin(), semantic.function->params.end(), [&](const auto& param) {
        const nodelang::Expr* read = param.initial;
        while (read && read->kind == nodelang::Expr::Kind::Member) read = read->args[0];
        const paths::SemanticDecl* found = read ? paths.semantic(read->text) : nullptr;
        return found && reads_pixel(paths, *found);
    });
}

}  // namespace

Typed GraphScope::semantic(std::string_view name, Span span, emit::Scope& scope) {
    if (const auto given = given_.find(name); given != given_.end()) return given->second;
    const paths::PathDeclarations& paths = *lowering_.session.paths;
    const auto found = paths.semantic_index.find(name);
    if (shadow_.ok()) {
        const auto& members = lowering_.out.module.structs[shadow_.type.ref].members;
        for (std::uint32_t i = 0; i < members.size(); ++i) {
            if (members[i].name == name)
                return {.value = scope.builder->extract(shadow_.value, i), .type = members[i].type};
        }
    }
    if (found == paths.semantic_index.end() || paths.semantics[found->second].is_of_pass) {
        std::vector<std::string_view> known;
        for (const paths::SemanticDecl& semantic : paths.semantics) {
            if (!semantic.is_of_pass) known.push_back(semantic.name);
        }
        DiagnosticRecord& record = lowering_.session.diagnostics.report(Code::UnknownSemantic, span, name);
        const std::string_view near = nearest(name, known);
        if (!near.empty())
            record.note(fmt::format("did you mean '@{}'?", near));
        else
            record.note("'patina values' lists them");
        return {};
    }
    const paths::SemanticDecl& semantic = paths.semantics[found->second];
    // A default of a port stands in a node file, but the error is that the graph left the port open.
    const emit::OpenPort* open = scope.open_port;
    const auto report = [&](Code code, std::string_view where) -> DiagnosticRecord& {
        DiagnosticRecord& record = lowering_.session.diagnostics.report(code, open ? open->call : span, name, where);
        return open ? record.note(
                          fmt::format("'{}' of {} has no value, and its default reads it", open->port, open->function))
                    : record;
    };
    const bool per_light = graph_.graph->kind == format::GraphKind::Lighting && name == "light";
    if (semantic.source == paths::SemanticSource::Given || per_light) {
        const bool is_lighting = graph_.graph->kind == format::GraphKind::Lighting;
        const bool is_pinned = is_lighting && scope_.in_vertex_stage;
        report(Code::SemanticNotHere, is_pinned ? "a node of the vertex stage" : what_graph())
            .note(is_pinned     ? "lighting is computed for each pixel: remove \"stage\": \"vertex\" from the node"
                  : per_light   ? "only 'direct' is evaluated for each light"
                  : is_lighting ? "only 'final' is evaluated after all lights"
                                : "only a lighting graph has it");
        return {};
    }
    if (semantic.source == paths::SemanticSource::Extern)
        return emit::extern_value(lowering_.emitter, *semantic.variable, scope);
    const Type type = lowering_.out.module.semantics[found->second].type;
    if (type.is_error()) return {};
    if (scope_.in_vertex_stage && (semantic.source == paths::SemanticSource::Builtin || reads_pixel(paths, semantic))) {
        DiagnosticRecord& record = report(Code::NoSuchStageValue, "vertex");
        record.note(
            "the vertex stage runs before the fragment stage, and reads only the mesh and values that are the same for "
            "all of it");
        tell_reader(record);
        return {};
    }
    return {.value = scope.builder->emit(Op::Semantic, type, {}, found->second), .type = type};
}

Typed GraphScope::file(const Expr& expr, emit::Scope&) {
    const auto index = lowering_.material.property_index.find(resolve::file_texture_name(expr.text));
    if (index == lowering_.material.property_index.end()) return {};  // not found on disk, which has been reported
    return material_property(index->second);
}

}  // namespace patina::lower
