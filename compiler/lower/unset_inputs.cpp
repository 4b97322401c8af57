// A lighting model declares inputs that most materials leave unset. In such a material their defaults are constants of
// the lighting graph, and what they switch off is left out of its functions before anything looks at them: a layer that
// a material does not use costs nothing, and no pass is refused for what only that layer reads.
#include <algorithm>
#include <map>

#include "compiler/ir/liveness.h"
#include "compiler/lower/lowering.h"

namespace patina::graph {

using ir::Op;
using ir::Value;
using nodelang::Expr;

namespace {

// The numbers of a literal default; empty if it is something else.
std::vector<double> numbers_of(const Expr& value, ir::Type type) {
    if (value.kind == Expr::Kind::Number) return std::vector<double>(type.components(), value.number);
    std::vector<double> numbers;
    if (value.kind != Expr::Kind::List) return numbers;
    for (const Expr* component : value.args) {
        if (component->kind != Expr::Kind::Number) return {};
        numbers.push_back(component->number);
    }
    return numbers.size() == type.components() ? numbers : std::vector<double>();
}

// By member of the lighting surface: the default of a model's input that the material does not set.
std::map<std::uint32_t, std::vector<double>> unset_members(const Lowering& lowering, ir::Type surface) {
    std::map<std::uint32_t, std::vector<double>> unset;
    const std::vector<PortValue>& set = lowering.material.graph->graph->surface;
    const std::vector<ir::Member>& members = lowering.out.module.structs[surface.ref].members;
    for (const Input& input : lowering.material.lighting->graph->inputs) {
        if (!input.value) continue;
        if (std::any_of(set.begin(), set.end(), [&](const PortValue& p) { return p.name == input.name; })) continue;
        const auto member =
            std::find_if(members.begin(), members.end(), [&](const ir::Member& m) { return m.name == input.name; });
        if (member == members.end() || !member->type.is_numeric()) continue;
        const std::vector<double> numbers = numbers_of(*input.value, member->type);
        if (!numbers.empty()) unset[static_cast<std::uint32_t>(member - members.begin())] = numbers;
    }
    return unset;
}

bool reads_member_of_surface(const ir::Function& function, const ir::Inst& inst) {
    if (inst.op != Op::Extract) return false;
    const ir::Inst& whole = function[function.args(inst)[0]];
    return whole.op == Op::Param && whole.data == 0;
}

// Rewrites what depends on an unset input alone, and choices that such a value decides. All else stays as it was
// emitted, so that a function that is not folded remains so.
class Rewrite {
public:
    Rewrite(const ir::Function& from, const std::map<std::uint32_t, std::vector<double>>& unset)
        : unset_(unset), follows_(from.insts.size(), 0) {}

    bool operator()(ir::Copy& copy, Value value) {
        const ir::Inst& inst = copy.from[value];
        if (reads_member_of_surface(copy.from, inst) && unset_.contains(inst.data)) {
            copy.map[value.index] = copy.to.constant(inst.type, unset_.at(inst.data));
            follows_[value.index] = 1;
            return true;
        }
        if (ir::has(inst.op, ir::Effect) || ir::has(inst.op, ir::Structure) || inst.op == Op::Call) return false;
        bool follows = false, is_constant = inst.operand_count > 0;
        std::vector<Value> args;
        for (const Value arg : copy.from.args(inst)) {
            args.push_back(copy.map[arg.index]);
            follows = follows || follows_[arg.index];
            is_constant = is_constant && !copy.to.constant_of(args.back()).empty();
        }
        const bool is_composite = inst.op == Op::Construct && is_constant && inst.type.is_numeric();
        if (!follows && !is_composite) return false;
        copy.to.set_origin(inst.origin);
        const Value known = ir::simplify(copy.to, inst.op, inst.type, args, inst.data);
        if (!known) return false;
        copy.map[value.index] = known;
        follows_[value.index] = follows && !copy.to.constant_of(known).empty();
        return true;
    }

private:
    const std::map<std::uint32_t, std::vector<double>>& unset_;
    std::vector<std::uint8_t> follows_;  // by old value: 1 if it is a constant because an input is unset
};

// A copy of the function; its probes follow their values, and go with them.
ir::Function copied(ir::Module& module, ir::BuildOptions options, ir::Function old, const ir::Liveness* live,
                    const std::function<bool(ir::Copy&, Value)>& rewrite) {
    ir::Function made = ir::take_shell(old);
    ir::Builder builder(module, made, options);
    ir::Copy copy{.from = old, .to = builder, .live = live, .rewrite = rewrite};
    ir::copy_body(copy);
    for (ir::Probe& probe : made.probes) probe.value = copy.map[probe.value.index];
    std::erase_if(made.probes, [](const ir::Probe& probe) { return !probe.value; });
    return made;
}

}  // namespace

ir::Function without_unset_inputs(Lowering& lowering, ir::Function function) {
    const ir::Type surface = function.params.empty() ? ir::Type() : function.params[0].type;
    if (surface.kind != ir::Kind::Struct) return function;
    const auto unset = unset_members(lowering, surface);
    if (std::none_of(function.insts.begin(), function.insts.end(), [&](const ir::Inst& inst) {
            return reads_member_of_surface(function, inst) && unset.contains(inst.data);
        }))
        return function;
    ir::Module& module = lowering.out.module;
    Rewrite rewrite(function, unset);
    ir::Function settled = copied(module, lowering.emitter.options, std::move(function), nullptr, std::ref(rewrite));
    const ir::Liveness live = ir::live_in(settled);
    return copied(module, lowering.emitter.options, std::move(settled), &live, {});
}

}  // namespace patina::graph
