#include "compiler/interpret/trace.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "compiler/interpret/interpret.h"
#include "compiler/ir/passes/passes.h"

namespace patina::interpret {
namespace {

TracedValue::Kind kind_of(const ir::Probe& probe) {
    switch (probe.kind) {
        case ir::Probe::Kind::Node: return TracedValue::Kind::Node;
        case ir::Probe::Kind::Output: return TracedValue::Kind::Output;
        case ir::Probe::Kind::Given: return TracedValue::Kind::Given;
    }
    return TracedValue::Kind::Node;
}

class Rows {
public:
    Rows(const Program& program, const ir::Module& module) : program_(program), module_(module) {}

    void add(const ir::Probe& probe, ir::Type type, int light, std::span<const double> values) {
        TracedValue row{.kind = kind_of(probe),
                        .graph = std::string(probe.graph),
                        .node = probe.id,
                        .port = {},
                        .type = {},
                        .values = {},
                        .light = light,
                        .file = {},
                        .line = 0,
                        .column = 0};
        if (const auto place = program_.places.find(probe.span.begin); place != program_.places.end()) {
            row.file = place->second.file;
            row.line = place->second.line;
            row.column = place->second.column;
        }
        if (type.kind != ir::Kind::Struct) return add_part(row, probe.ports.front(), type, values);
        for (std::uint32_t m = 0; m < probe.ports.size(); ++m) {
            add_part(row, probe.ports[m], ir::part_type(module_, type, m), values);
        }
    }

    std::vector<TracedValue> take() { return std::move(rows_); }

private:
    // Takes the part's components from the front of `rest`. A struct is a row for each member: "light.color".
    void add_part(TracedValue& row, const std::string& port, ir::Type type, std::span<const double>& rest) {
        if (type.kind == ir::Kind::Struct) {
            const std::vector<ir::Member>& members = module_.structs[type.ref].members;
            for (const ir::Member& member : members) add_part(row, port + "." + member.name, member.type, rest);
            return;
        }
        const std::size_t size = flat_size(module_, type);
        row.port = port;
        row.type = module_.type_name(type);
        row.values.assign(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(size));
        rest = rest.subspan(size);
        // A texture has no value. If two outputs of a graph read a node, it is computed twice, and shown once.
        if (type.is_opaque() || !shown_.emplace(row.graph, row.node, port, row.light).second) return;
        rows_.push_back(row);
    }

    const Program& program_;
    const ir::Module& module_;
    std::set<std::tuple<std::string, std::string, std::string, int>> shown_;
    std::vector<TracedValue> rows_;
};

}  // namespace

std::vector<TracedValue> traced_values(const Program& program, const ir::Module& module, const Machine& machine,
                                       std::span<const Sighting> sightings) {
    struct Seen {
        std::size_t turn = 0;  // of its function among those that ran
        int light = -1;
        const Sighting* sighting = nullptr;
    };
    std::map<std::uint32_t, std::size_t> turns;
    std::map<std::uint32_t, std::vector<ir::Rate>> rates;
    std::vector<Seen> order;
    for (const Sighting& sighting : sightings) {
        const Watched& watched = machine.watched[sighting.watched];
        const ir::Function& function = module.functions[watched.function];
        const std::size_t turn = turns.emplace(watched.function, turns.size()).first->second;
        std::vector<ir::Rate>& of_function = rates[watched.function];
        if (of_function.empty()) of_function = ir::rates(module, function);
        const bool changes = of_function[function.probes[watched.probe].value.index] == ir::Rate::Light;
        order.push_back({.turn = turn, .light = changes ? sighting.light : -1, .sighting = &sighting});
    }
    std::stable_sort(order.begin(), order.end(), [](const Seen& a, const Seen& b) {
        return std::tie(a.turn, a.light) < std::tie(b.turn, b.light);
    });
    Rows rows(program, module);
    for (const Seen& seen : order) {
        const Watched& watched = machine.watched[seen.sighting->watched];
        const ir::Function& function = module.functions[watched.function];
        const ir::Probe& probe = function.probes[watched.probe];
        rows.add(probe, function[probe.value].type, seen.light, seen.sighting->values);
    }
    return rows.take();
}

}  // namespace patina::interpret

namespace patina {

std::string_view to_string(TracedValue::Kind kind) {
    switch (kind) {
        case TracedValue::Kind::Node: return "node";
        case TracedValue::Kind::Output: return "output";
        case TracedValue::Kind::Given: return "given";
    }
    return {};
}

}  // namespace patina
