// Nodes in the vertex stage: nodes that are pinned there, whose values are interpolated, and messages for nodes that
// need a pixel.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/base/spelling.h"
#include "compiler/base/text.h"
#include "compiler/lower/graph_scope.h"

namespace patina::lower {

using emit::Typed;
using ir::Op;
using ir::Type;
using ir::Value;

// --- what exists only in pixels

constexpr std::size_t kMostOnTheWay = 8;

// "reads this value through 'b' and 'c'": the way from a reader to the node that is being emitted. Empty if the reader
// is that node.
std::string GraphScope::way_from(const Lowering::VertexReader& reader) const {
    const std::string plain = "reads this value";
    const GraphScope* scope = this;
    std::optional<std::uint32_t> to = at_;
    for (; &scope->graph_ != reader.graph; scope = scope->outer_) {
        if (!scope->outer_) return plain;
        to = scope->outer_node_;
    }
    if (!to) return plain;
    std::map<std::uint32_t, std::uint32_t> read_by;
    std::vector<std::uint32_t> work = reader.reads;
    for (const std::uint32_t first : work) read_by[first] = first;
    for (std::size_t i = 0; i < work.size(); ++i) {
        for (const std::uint32_t read : scope->graph_.nodes[work[i]].reads) {
            if (read_by.emplace(read, work[i]).second) work.push_back(read);
        }
    }
    if (!read_by.contains(*to)) return plain;
    std::vector<std::string> names;
    for (std::uint32_t at = *to, last = at + 1; at != last; last = std::exchange(at, read_by[at])) {
        const bool is_giver = scope == this && at == *to;
        const bool is_reader = reader.is_interpolator && read_by[at] == at;
        if (is_giver && is_reader) return {};
        if (!is_giver && !is_reader) names.push_back("'" + scope->graph_.graph->nodes[at].id + "'");
    }
    std::reverse(names.begin(), names.end());
    if (names.size() > kMostOnTheWay) {
        const std::string rest = fmt::format("{} more", names.size() - kMostOnTheWay);
        names.resize(kMostOnTheWay);
        names.push_back(rest);
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    return views.empty() ? plain : plain + " through " + enumerate(views);
}

void GraphScope::tell_reader(DiagnosticRecord& record) const {
    if (lowering_.vertex_readers.empty()) return;
    const Lowering::VertexReader& reader = lowering_.vertex_readers.back();
    const std::string way = way_from(reader);
    if (reader.is_interpolator) {
        record.note(reader.span,
                    fmt::format("'{0}' is pinned to the vertex stage here{1}: remove \"stage\": \"vertex\" "
                                "to compute '{0}' per pixel",
                                reader.name, way.empty() ? "" : ", and " + way));
    } else {
        record.note(reader.span,
                    fmt::format("'{}' in the vertex block {}: the vertex stage cannot read a value that the "
                                "fragment stage computes",
                                reader.name, way));
    }
}

// --- interpolators: "stage": "vertex"

std::unique_ptr<GraphScope> GraphScope::vertex_twin(ir::Builder& builder,
                                                    std::deque<std::unique_ptr<GraphScope>>& keep) {
    auto twin = std::make_unique<GraphScope>(lowering_, graph_, builder, true);
    if (!outer_) return twin;
    keep.push_back(outer_->vertex_twin(builder, keep));
    GraphScope& outer = *keep.back();
    std::vector<bool> reads = outer.graph_.reachable(outer_node_);
    reads[outer_node_] = false;
    for (const format::PortValue& port : outer.graph_.graph->nodes[outer_node_].inputs) {
        if (port.value) outer.announce(*port.value);
    }
    outer.emit_nodes(reads);
    twin->outer_ = &outer;
    twin->outer_node_ = outer_node_;
    outer.fill_inputs(*twin, outer.graph_.graph->nodes[outer_node_], *graph_.graph);
    return twin;
}

Typed GraphScope::interpolated(std::uint32_t index) {
    const format::Node& node = graph_.graph->nodes[index];
    const std::string path = id_path(node.id);
    ir::Module& module = lowering_.out.module;
    emit::Emitter& emitter = lowering_.emitter;
    if (!lowering_.interpolators.contains(path)) {
        Lowering::Interpolator& made = lowering_.interpolators[path];
        std::size_t count = 1;
        for (std::size_t output = 0; output < count; ++output) {
            ir::Function function{};
            function.always_inline = true;
            std::string name;
            for (const std::string_view id : split(path, "/")) name = joined(name, id);
            ir::Builder builder(module, function, emitter.options);
            std::deque<std::unique_ptr<GraphScope>> keep;
            lowering_.vertex_readers.push_back({path, node.id_span, true, &graph_, {index}});
            const std::unique_ptr<GraphScope> twin = vertex_twin(builder, keep);
            twin->emit_nodes(graph_.reachable(index));
            lowering_.vertex_readers.pop_back();
            Typed value = twin->values_[index];
            if (!value.ok()) return {};
            if (value.outputs) {
                made.outputs = value.outputs;
                count = value.outputs->names.size();
                if (output > 0 || !value.outputs->has_primary) name = joined(name, value.outputs->names[output]);
                const Value part = builder.extract(value.value, static_cast<std::uint32_t>(output));
                value = {.value = part, .type = builder.type(part)};
            }
            if (!value.type.is_floating() || value.type.is_matrix()) {
                lowering_.session.diagnostics.report(Code::TypeMismatch, node.id_span,
                                                     fmt::format("'{}', which is interpolated,", node.id),
                                                     module.type_name(value.type), "a float or a vector of floats");
                return {};
            }
            // A varying is always a float, because not every GPU has half varyings.
            if (value.type.scalar != ir::Scalar::Float) {
                value.value = builder.convert(value.value, ir::Scalar::Float);
                value.type = value.type.with_scalar(ir::Scalar::Float);
            }
            // The linker finds a varying by its name, so the name must be unique.
            const auto is_taken = [&](std::string_view wanted) {
                return std::any_of(module.semantics.begin(), module.semantics.end(),
                                   [&](const ir::Semantic& s) { return s.name == wanted; });
            };
            if (is_taken(name)) {
                unsigned number = 2;
                while (is_taken(numbered(name, number))) ++number;
                name = numbered(name, number);
            }
            function.name = joined("vertex", name);
            function.result = value.type;
            builder.ret(value.value);
            module.functions.push_back(std::move(function));
            module.semantics.push_back({.name = name, .type = value.type, .rate = ir::Rate::Pixel});
            lowering_.out.semantics.push_back({.source = paths::SemanticSource::Vertex,
                                               .recipe = {static_cast<std::uint32_t>(module.functions.size() - 1)}});
            made.semantics.push_back({static_cast<std::uint32_t>(module.semantics.size() - 1)});
        }
    }
    const Lowering::Interpolator& made = lowering_.interpolators[path];
    if (made.semantics.empty()) return {};
    std::vector<Value> values;
    ir::Struct structure{.name = node.id + "Outputs", .members = {}};
    for (std::size_t i = 0; i < made.semantics.size(); ++i) {
        const Type type = module.semantics[made.semantics[i].index].type;
        values.push_back(scope_.builder->emit(Op::Semantic, type, {}, made.semantics[i].index));
        structure.members.push_back({made.outputs ? made.outputs->names[i] : node.id, type});
    }
    if (!made.outputs) return {.value = values[0], .type = structure.members[0].type};
    module.structs.push_back(std::move(structure));
    const Type type = Type::structure(static_cast<std::uint32_t>(module.structs.size() - 1));
    return {.value = scope_.builder->construct(type, values), .type = type, .outputs = made.outputs};
}

}  // namespace patina::lower
