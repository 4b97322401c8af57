// Emits a graph into one IR function: holds the values of its nodes so far, and resolves $, @ and names in it. A
// sub-graph is a scope inside the scope of the graph that uses it. If several nodes use it, it is a function of its
// own.
#pragma once

#include <deque>
#include <set>
#include <tuple>

#include "compiler/lower/lower.h"
#include "compiler/lower/subgraph_uses.h"

namespace patina::lower {

// A slot that is derived from others (derived_slots.cpp): made when a pass first asks for it.
struct DerivedSlot {
    emit::Slot slot{};
    std::string why_not{};       // not empty: why it cannot be made
    ir::Origin where{};          // the node that prevents it
    bool is_zero = false;        // always zero: the slot does not read what the part is linear in
    bool is_of_missing = false;  // another derived slot cannot be made, and `why_not` is the reason of that slot
};

// What tells the functions of sub-graphs apart. Inputs that a function cannot take (textures and samplers), or that
// decide what it computes (bools), are in the key with their values, if known.
struct SubgraphKey {
    const resolve::CheckedGraph* graph = nullptr;
    bool in_vertex_stage = false;
    std::vector<bool> outputs{};         // those that are emitted
    std::vector<std::uint64_t> known{};  // the values of these inputs, as what they are computed from
    friend bool operator<(const SubgraphKey& a, const SubgraphKey& b) {
        const auto key = [](const SubgraphKey& k) { return std::tie(k.graph, k.in_vertex_stage, k.outputs, k.known); };
        return key(a) < key(b);
    }
};
struct SubgraphFunction {
    ir::FunctionId id{};     // null: it has an error, or must stay where it is used
    bool has_error = false;  // which has been reported
    bool needs_quad = false;
    ir::Type type{};                         // of all outputs together
    const emit::Outputs* outputs = nullptr;  // if there is just one, the function returns its value
};

// Shared by all scopes of one lowering.
struct Lowering {
    resolve::Session& session;
    const resolve::Material& material;
    Lowered& out;
    emit::Emitter emitter;
    std::deque<std::vector<std::string_view>> enumerators;  // of enum properties, by material property
    // The interpolators made so far, by id path: a semantic for each output, and the names of the outputs.
    struct Interpolator {
        std::vector<ir::SemanticId> semantics;
        const emit::Outputs* outputs = nullptr;
    };
    std::map<std::string, Interpolator> interpolators;
    AllSubgraphUses subgraph_uses;
    std::map<SubgraphKey, SubgraphFunction> subgraph_functions;
    std::size_t subgraphs_in_place = 0;  // uses whose nodes have been emitted where they are
    // A reader of values that the vertex stage computes: a node whose interpolator is being made, or an output of
    // "vertex".
    struct VertexReader {
        std::string name;  // id path, or the output's
        Span span;
        bool is_interpolator = false;
        const resolve::CheckedGraph* graph = nullptr;
        std::vector<std::uint32_t> reads{};  // the node, or those that the output reads
    };
    std::vector<VertexReader> vertex_readers;               // the innermost last
    std::map<std::string_view, DerivedSlot> derived_slots;  // the derived slots that have been requested
    std::set<std::uint32_t> per_object;                     // globals of the drawn object
    ir::FunctionId surface{};                               // surface(): all that the graph computes
    ir::FunctionId setup{};                                 // lightingSurface(): what lighting reads of it

    bool is_on(std::string_view wanted) const;  // a switch
    // The slot that the function fills, or empty.
    std::string_view slot_name(ir::FunctionId function) const;
    bool is_packing(std::string_view slot) const;  // true if it stores or restores members of the surface
};

// What a node that uses a sub-graph gives to its function (graph_scope_subgraph.cpp).
struct SubgraphArguments;

class GraphScope : public emit::Environment {
public:
    using Typed = emit::Typed;

    GraphScope(Lowering& lowering, const resolve::CheckedGraph& graph, ir::Builder& builder, bool in_vertex_stage);

    // --- what the surrounding graph adds
    void give(std::string_view semantic, Typed value) { given_[std::string(semantic)] = value; }
    void set_input(std::string_view name, Typed value) { inputs_[std::string(name)] = value; }
    // In a lighting graph: a semantic that is also a member of the lighting surface means that member.
    void shadow_by(Typed surface) { shadow_ = surface; }
    // Values that the material gives to a lighting graph's properties, read in the material's own scope.
    void set_property_values(std::span<const format::PortValue> values, GraphScope& scope) {
        property_values_ = values;
        property_scope_ = &scope;
    }
    bool needs_quad() const { return needs_quad_; }
    // Adds a probe of the value, unless values are folded. `port`: its name; empty for all outputs of the value.
    void watch(ir::Probe::Kind kind, std::string id, std::string_view port, const Typed& value, Span span);

    // --- emitting
    // Emits the marked nodes in order.
    void emit_nodes(const std::vector<bool>& wanted);
    // In the vertex stage, the outputs of a sub-graph are emitted only if something reads them. The others may sample
    // textures, which the vertex stage cannot do. emit_nodes() announces what nodes read; announce() the expression of
    // a port.
    void announce(const nodelang::Expr& expr);
    // A port's value, converted; nodes that it reads must have been emitted. Three numbers are an opaque colour, as
    // "#ff8800" is.
    Typed value_as(const format::PortValue& port, ir::Type type, std::string_view what, bool is_color = false);
    Typed value_as(const nodelang::Expr& expr, ir::Type type, std::string_view what, bool is_color = false);
    Typed value(const nodelang::Expr& expr);
    emit::Scope& scope() { return scope_; }

    // --- Environment
    Typed name(const nodelang::Expr& expr, emit::Scope& scope) override;
    Typed sampler(const nodelang::Expr& expr, emit::Scope& scope) override;
    Typed property(const nodelang::Expr& expr, emit::Scope& scope) override;
    Typed semantic(std::string_view name, Span span, emit::Scope& scope) override;
    Typed file(const nodelang::Expr& expr, emit::Scope& scope) override;
    bool hides(std::string_view name) const override { return graph_.by_id.contains(name); }
    void tell_reader(DiagnosticRecord& record) const override;

private:
    void emit_node(std::uint32_t index);
    Typed call_node(const format::Node& node, const resolve::ResolvedNode& resolved);
    Typed subgraph_node(std::uint32_t index);
    std::vector<bool> read_of_outputs(std::uint32_t index) const;
    // Fills inputs of a sub-graph's scope from the node that uses it.
    void fill_inputs(GraphScope& inner, const format::Node& node, const format::Graph& subgraph);
    void fill_input(GraphScope& inner, const format::Node& node, const format::Input& input);
    // The outputs of this sub-graph, of which the marked ones are emitted.
    Typed subgraph_outputs(const std::vector<bool>& read);
    // The same by a call of a function that all nodes share which use the sub-graph; nothing if they cannot.
    std::optional<Typed> subgraph_call(GraphScope& inner, const std::vector<bool>& read);
    SubgraphArguments arguments_of(const GraphScope& inner) const;
    SubgraphFunction subgraph_function(const GraphScope& inner, const SubgraphArguments& arguments,
                                       const std::vector<bool>& read);
    ir::OriginId origin_of_use(Span span);
    std::unique_ptr<GraphScope> subgraph_scope(std::uint32_t index, ir::Builder& builder);
    Typed interpolated(std::uint32_t index);
    // The same graph in another function of the vertex stage, with only what `node` needs emitted.
    std::unique_ptr<GraphScope> vertex_twin(ir::Builder& builder, std::deque<std::unique_ptr<GraphScope>>& keep);
    Typed material_property(std::size_t index);
    Typed array_property(const format::Property& property, ir::Value stored);
    ir::Type type_of(const format::Property& property);
    Typed stand_in(const format::Property& property);
    Typed bound_property(const format::PortValue& port);
    Typed keyword(const format::Property& property, ir::Value value);
    ir::Value known_value(const format::Property& property, double value);
    bool uses_half(const format::Node& node) const;
    std::string id_path(std::string_view id) const;
    std::string way_from(const Lowering::VertexReader& reader) const;
    std::string_view what_graph() const;
    std::string_view outermost_kind() const;

    Lowering& lowering_;
    const resolve::CheckedGraph& graph_;
    emit::Scope scope_;
    bool needs_quad_ = false;
    std::vector<Typed> values_;
    std::vector<bool> emitted_;
    std::optional<std::uint32_t> at_;                                   // the node that is being emitted
    std::map<std::uint32_t, std::set<std::string_view>> read_outputs_;  // by sub-graph node; "": the node itself
    std::map<std::string, Typed, std::less<>> given_, inputs_;
    Typed shadow_;
    std::span<const format::PortValue> property_values_;
    GraphScope* property_scope_ = nullptr;
    GraphScope* outer_ = nullptr;
    std::uint32_t outer_node_ = 0;
    std::size_t function_path_ = 0;  // how much of an id path leads to the function that this is emitted into
};

}  // namespace patina::lower
