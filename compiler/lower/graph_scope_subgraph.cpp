// Nodes that are sub-graphs. If one node uses a sub-graph, its nodes are emitted there, under an id path. If several
// nodes use it, it becomes a function, and each node a call. inline_calls() undoes this where it makes the text longer.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/bits.h"
#include "compiler/base/letters.h"
#include "compiler/base/spelling.h"
#include "compiler/lower/lowering.h"

namespace patina::lower {

using emit::Typed;
using ir::Type;
using ir::Value;

namespace {

// --- how a sub-graph appears in a shader

std::string function_name(const resolve::CheckedGraph& subgraph) {
    const std::string name = camel_case(resolve::file_stem(subgraph.graph->path));
    return name.empty() ? "subgraph" : name;
}

std::string struct_name(const resolve::CheckedGraph& subgraph) {
    std::string name = function_name(subgraph) + "Outputs";
    name[0] = to_upper(name[0]);
    return name;
}

// "layers.subgraph.json: where rust sits"
std::string comment_of(const format::Graph& graph) {
    const std::string file = graph.path.substr(graph.path.find_last_of("/\\") + 1);
    const std::string says = !graph.help.empty() ? nodelang::first_sentence(graph.help)
                             : graph.name_span   ? graph.name
                                                 : "";
    return says.empty() ? file : fmt::format("{}: {}", file, says);
}

// --- values that are known without the graph: those of constants and globals, and what a few instructions make of them

constexpr std::size_t kLongestDescription = 256;

// Adds what tells the value apart from others. False if it is no such value.
bool describe(const ir::Builder& b, Value value, std::vector<std::uint64_t>& into) {
    const ir::Inst& inst = b[value];
    constexpr std::uint8_t kImpure = ir::Effect | ir::Derivative | ir::Structure;
    const bool depends = ir::has(inst.op, ir::Traits{kImpure}) || inst.op == ir::Op::Param ||
                         inst.op == ir::Op::Semantic || inst.op == ir::Op::Call || inst.op == ir::Op::Result;
    if (depends || into.size() >= kLongestDescription) return false;
    const ir::Type type = inst.type;
    for (const std::uint32_t each : {static_cast<std::uint32_t>(inst.op), static_cast<std::uint32_t>(type.kind),
                                     static_cast<std::uint32_t>(type.scalar), std::uint32_t{type.rows},
                                     std::uint32_t{type.cols}, type.ref, inst.op == ir::Op::Constant ? 0 : inst.data})
        into.push_back(each);
    for (const double number : b.constant_of(value)) into.push_back(bits_as<std::uint64_t>(number));
    const auto parts = b.args(value);
    return std::all_of(parts.begin(), parts.end(), [&](Value part) { return describe(b, part, into); });
}

// Such a value in another function.
Value copied(const ir::Builder& from, Value value, ir::Builder& to) {
    const ir::Inst& inst = from[value];
    std::vector<Value> parts;
    for (const Value part : from.args(value)) parts.push_back(copied(from, part, to));
    return to.emit(inst.op, inst.type, parts, inst.data);
}

bool is_texture_or_sampler(const emit::Emitter& emitter, Type type) {
    return type.kind == ir::Kind::Sampler || emit::is_texture(emitter, type);
}

// If nothing is folded, sub-graphs do not become functions, so that each use has its probes and the CPU checks the
// functions. Only levels of sub-graphs that double their nodes many times have so many uses.
constexpr std::size_t kMostUnfolded = 4096;

// How the sub-graph is used, if it may be a function. A pinned node is an interpolator for each use, by its id path.
const SubgraphUses* shared_uses(const Lowering& lowering, const resolve::CheckedGraph& subgraph, bool in_vertex_stage) {
    if (!lowering.emitter.options.fold && lowering.subgraphs_in_place < kMostUnfolded) return nullptr;
    const auto found = lowering.subgraph_uses.find(&subgraph);
    if (found == lowering.subgraph_uses.end() || found->second.sites < 2) return nullptr;
    return found->second.has_pinned_node && !in_vertex_stage ? nullptr : &found->second;
}

}  // namespace

// --- inputs

void GraphScope::fill_input(GraphScope& inner, const format::Node& node, const format::Input& input) {
    const auto port = std::find_if(node.inputs.begin(), node.inputs.end(),
                                   [&](const format::PortValue& p) { return p.name == input.name; });
    const Type type = input_type(lowering_, input);
    if (type.is_error()) return;
    const std::string what = fmt::format("the input '{}'", input.name);
    if (port != node.inputs.end()) {
        inner.set_input(input.name, value_as(*port, type, what, input.type == "color"));
    } else if (input.value) {
        inner.set_input(input.name, inner.value_as(*input.value, type, what, input.type == "color"));
    } else {
        lowering_.session.diagnostics.report(Code::MissingInput, node.type_span, input.name, node.type);
        inner.set_input(input.name, {});
    }
}

void GraphScope::fill_inputs(GraphScope& inner, const format::Node& node, const format::Graph& subgraph) {
    for (const format::Input& input : subgraph.inputs) fill_input(inner, node, input);
}

// The outputs of a sub-graph node that are emitted here.
std::vector<bool> GraphScope::read_of_outputs(std::uint32_t index) const {
    const std::vector<format::PortValue>& outputs = graph_.nodes[index].subgraph->graph->outputs;
    const auto read = read_outputs_.find(index);
    std::vector<bool> marks(outputs.size(), !scope_.in_vertex_stage || read == read_outputs_.end());
    if (marks.empty() || marks[0]) return marks;
    for (std::string_view name : read->second) {
        const auto output =
            std::find_if(outputs.begin(), outputs.end(), [&](const format::PortValue& p) { return p.name == name; });
        // The node itself, or a swizzle of its only output.
        if (output == outputs.end()) return std::vector<bool>(outputs.size(), true);
        marks[static_cast<std::size_t>(output - outputs.begin())] = true;
    }
    return marks;
}

Typed GraphScope::subgraph_node(std::uint32_t index) {
    const format::Node& node = graph_.graph->nodes[index];
    const resolve::CheckedGraph& subgraph = *graph_.nodes[index].subgraph;
    const std::vector<bool> read = read_of_outputs(index);
    const std::unique_ptr<GraphScope> inner = subgraph_scope(index, *scope_.builder);
    const SubgraphUses* uses = shared_uses(lowering_, subgraph, scope_.in_vertex_stage);
    const auto is_left_to_function = [&](const format::Input& input) { return uses && is_never_given(*uses, input); };
    for (const format::Input& input : subgraph.graph->inputs) {
        if (!is_left_to_function(input)) fill_input(*inner, node, input);
    }
    if (uses) {
        if (const std::optional<Typed> called = subgraph_call(*inner, read)) return *called;
        for (const format::Input& input : subgraph.graph->inputs) {
            if (is_left_to_function(input)) fill_input(*inner, node, input);
        }
    }
    ++lowering_.subgraphs_in_place;
    const Typed outputs = inner->subgraph_outputs(read);
    needs_quad_ = needs_quad_ || inner->needs_quad_;
    return outputs;
}

Typed GraphScope::subgraph_outputs(const std::vector<bool>& read) {
    const std::vector<format::PortValue>& declared = graph_.graph->outputs;
    std::vector<format::PortValue> roots;
    for (std::size_t i = 0; i < read.size(); ++i) {
        if (!read[i] || !declared[i].value) continue;
        roots.push_back(declared[i]);
        announce(*roots.back().value);
    }
    emit_nodes(graph_.reachable(roots));
    std::vector<Value> values;
    ir::Struct made{.name = struct_name(graph_), .members = {}};
    const bool is_shown = !declared.empty() && declared.back().name == resolve::kShown;
    emit::Outputs outputs{.names = {}, .has_primary = declared.size() == (is_shown ? 2 : 1)};
    for (std::size_t i = 0; i < read.size(); ++i) {
        const format::PortValue& port = declared[i];
        if (!port.value) return {};
        outputs.names.push_back(port.name);
        if (!read[i]) {
            values.push_back(scope_.builder->constant(ir::kFloat, {0}));
            made.members.push_back({port.name, ir::kFloat});
            continue;
        }
        const ir::OriginId outside = scope_.builder->origin();
        if (!outside) scope_.builder->set_origin(origin_of_use(port.value_span));
        Typed output = emit::primary(lowering_.emitter, value(*port.value), scope_, port.value_span);
        if (output.literal)
            output = emit::convert(lowering_.emitter, output, ir::kFloat, scope_, port.value_span, "the output");
        scope_.builder->set_origin(outside);
        if (!output.ok()) return {};
        scope_.builder->name(output.value, lowering_.out.module.intern(port.name));  // only if it has no name yet
        values.push_back(output.value);
        made.members.push_back({port.name, output.type});
    }
    ir::Module& module = lowering_.out.module;
    module.structs.push_back(std::move(made));
    const Type type = Type::structure(static_cast<std::uint32_t>(module.structs.size() - 1));
    return {.value = scope_.builder->construct(type, values),
            .type = type,
            .outputs = emit::keep(lowering_.emitter, std::move(outputs))};
}

// --- a function of the sub-graph

struct SubgraphArguments {
    struct Given {
        const format::Input* input = nullptr;
        Typed value{};
        bool is_known = false;  // it is a part of the function, not a parameter
    };
    std::vector<Given> given{};
    std::vector<std::uint64_t> known{};  // of SubgraphKey
    bool can_be_given = true;            // false: one can be neither a parameter nor a part of the function
};

SubgraphArguments GraphScope::arguments_of(const GraphScope& inner) const {
    SubgraphArguments made;
    for (const format::Input& input : inner.graph_.graph->inputs) {
        const auto found = inner.inputs_.find(input.name);
        if (found == inner.inputs_.end()) continue;
        SubgraphArguments::Given& given = made.given.emplace_back();
        given = {.input = &input, .value = found->second};
        const bool is_resource = is_texture_or_sampler(lowering_.emitter, given.value.type);
        if (!is_resource && given.value.type != ir::kBool) continue;
        std::vector<std::uint64_t> description = {made.given.size()};
        given.is_known = given.value.ok() && describe(*scope_.builder, given.value.value, description);
        if (given.is_known) made.known.insert(made.known.end(), description.begin(), description.end());
        made.can_be_given = made.can_be_given && (given.is_known || !is_resource);
    }
    return made;
}

std::optional<Typed> GraphScope::subgraph_call(GraphScope& inner, const std::vector<bool>& read) {
    const SubgraphArguments arguments = arguments_of(inner);
    if (!arguments.can_be_given) return {};
    SubgraphKey key{
        .graph = &inner.graph_, .in_vertex_stage = scope_.in_vertex_stage, .outputs = read, .known = arguments.known};
    auto made = lowering_.subgraph_functions.find(key);
    if (made == lowering_.subgraph_functions.end()) {
        SubgraphFunction function = subgraph_function(inner, arguments, read);
        made = lowering_.subgraph_functions.emplace(std::move(key), function).first;
    }
    const SubgraphFunction& function = made->second;
    if (function.has_error) return Typed{};
    if (!function.id) return {};
    std::vector<Value> values;
    for (const SubgraphArguments::Given& each : arguments.given) {
        if (!each.value.ok()) return Typed{};
        if (!each.is_known) values.push_back(each.value.value);
    }
    needs_quad_ = needs_quad_ || function.needs_quad;
    ir::Builder& b = *scope_.builder;
    Value value = b.call(function.id, values);
    b.name(value, lowering_.out.module.intern(graph_.graph->nodes[inner.outer_node_].id));
    if (read.size() == 1) value = b.construct(function.type, {&value, 1});
    return Typed{.value = value, .type = function.type, .outputs = function.outputs};
}

SubgraphFunction GraphScope::subgraph_function(const GraphScope& inner, const SubgraphArguments& arguments,
                                               const std::vector<bool>& read) {
    ir::Module& module = lowering_.out.module;
    const format::Graph& graph = *inner.graph_.graph;
    ir::Function function{};
    function.name = function_name(inner.graph_);
    function.comment = comment_of(graph);
    function.inline_if_shorter = true;
    ir::Builder builder(module, function, lowering_.emitter.options);
    const std::unique_ptr<GraphScope> scope = subgraph_scope(inner.outer_node_, builder);
    scope->function_path_ = id_path(graph_.graph->nodes[inner.outer_node_].id).size() + 1;
    function.origin = scope->origin_of_use(graph.name_span ? graph.name_span : graph.span);
    for (const SubgraphArguments::Given& each : arguments.given) {
        Typed value = each.value;
        if (each.is_known) {
            value.value = copied(*scope_.builder, each.value.value, builder);
        } else {
            const Type type = input_type(lowering_, *each.input);
            function.params.push_back({each.input->name, type, ir::Rate::Pixel});
            value = {.value = builder.param(static_cast<std::uint32_t>(function.params.size() - 1)), .type = type};
        }
        scope->set_input(each.input->name, value);
    }
    const format::Node nothing_given{};
    for (const format::Input& input : graph.inputs) {
        if (!scope->inputs_.contains(input.name)) scope->fill_input(*scope, nothing_given, input);
    }
    const Typed outputs = scope->subgraph_outputs(read);
    if (!outputs.ok()) return {.has_error = true};
    const std::vector<ir::Member>& members = module.structs[outputs.type.ref].members;
    if (std::any_of(members.begin(), members.end(),
                    [&](const ir::Member& member) { return is_texture_or_sampler(lowering_.emitter, member.type); }))
        return {};
    builder.name(outputs.value, module.intern("outputs"));
    const Value result = members.size() == 1 ? builder.extract(outputs.value, 0) : outputs.value;
    function.result = builder.type(result);
    builder.set_origin(builder[result].origin);
    builder.ret(result);
    return {.id = add_function(module, std::move(function)),
            .needs_quad = scope->needs_quad_,
            .type = outputs.type,
            .outputs = outputs.outputs};
}

// The origin of code that belongs to no node of a function: the node that uses the sub-graph.
ir::OriginId GraphScope::origin_of_use(Span span) {
    std::vector<ir::Origin>& origins = lowering_.out.module.origins;
    const std::string path = outer_->id_path(outer_->graph_.graph->nodes[outer_node_].id);
    origins.push_back({.id = path, .function_path = static_cast<std::uint32_t>(path.size()), .span = span});
    return {static_cast<std::uint32_t>(origins.size() - 1)};
}

std::unique_ptr<GraphScope> GraphScope::subgraph_scope(std::uint32_t index, ir::Builder& builder) {
    auto inner =
        std::make_unique<GraphScope>(lowering_, *graph_.nodes[index].subgraph, builder, scope_.in_vertex_stage);
    inner->outer_ = this;
    inner->outer_node_ = index;
    inner->function_path_ = function_path_;
    return inner;
}

}  // namespace patina::lower
