// A lighting model declares inputs that most materials leave unset. In such a material their defaults are constants of
// the lighting graph, and everything that they switch off is left out of its functions before other steps see them. So
// a layer that a material does not use costs nothing. No pass is refused for values that only this layer reads.
#include <algorithm>
#include <map>
#include <optional>

#include "compiler/ir/liveness.h"
#include "compiler/lower/lowering.h"

namespace patina::lower {

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

// By member of the lighting surface: the default of a model's input that the material does not set, or the number that
// its workflow computes for it.
std::map<std::uint32_t, std::vector<double>> unset_members(const Lowering& lowering, ir::Type surface) {
    std::map<std::uint32_t, std::vector<double>> unset;
    const std::vector<format::PortValue>& set = lowering.material.graph->graph->surface;
    const std::vector<ir::Member>& members = lowering.out.module.structs[surface.ref].members;
    for (const format::Input& input : lowering.material.lighting->graph->inputs) {
        const format::PortValue* given = lowering.material.given_by_workflow(input);
        const auto& value = given ? given->value : input.value;
        if (!value) continue;
        if (!given &&
            std::any_of(set.begin(), set.end(), [&](const format::PortValue& p) { return p.name == input.name; }))
            continue;
        const auto member =
            std::find_if(members.begin(), members.end(), [&](const ir::Member& m) { return m.name == input.name; });
        if (member == members.end() || !member->type.is_numeric()) continue;
        const std::vector<double> numbers = numbers_of(*value, member->type);
        if (!numbers.empty()) unset[static_cast<std::uint32_t>(member - members.begin())] = numbers;
    }
    return unset;
}

bool reads_member_of_surface(const ir::Function& function, const ir::Inst& inst) {
    if (inst.op != Op::Extract) return false;
    const ir::Inst& whole = function[function.args(inst)[0]];
    return whole.op == Op::Param && whole.data == 0;
}

// Reads of unset inputs become their constants, and choices that depend on them become the chosen value: a Select, and
// a lerp whose weight is 0 or 1. All else stays as it was emitted, so that a function that is not folded remains so.
class Rewrite {
public:
    Rewrite(const ir::Module& module, const ir::Function& from, std::map<std::uint32_t, std::vector<double>> unset)
        : module_(module), unset_(std::move(unset)), known_(from.insts.size()) {}

    bool operator()(ir::Copy& copy, Value value) {
        const ir::Inst& inst = copy.from[value];
        const std::vector<Value> args(copy.from.args(inst).begin(), copy.from.args(inst).end());
        if (reads_member_of_surface(copy.from, inst) && unset_.contains(inst.data)) {
            known_[value.index] = unset_.at(inst.data);
            copy.map[value.index] = copy.to.constant(inst.type, unset_.at(inst.data));
            return true;
        }
        if (const Value chosen = chosen_of(inst, args)) {
            known_[value.index] = known_[chosen.index];
            copy.map[value.index] = copy.map[chosen.index];
            return true;
        }
        known_[value.index] = numbers_of(copy.from, inst, args);
        return false;
    }

private:
    Value chosen_of(const ir::Inst& inst, std::span<const Value> args) const {
        if (inst.op == Op::Select && inst.type.is_numeric()) {
            const std::vector<double>& condition = known_[args[0].index];
            return condition.size() != 1 ? Value() : condition[0] != 0 ? args[1] : args[2];
        }
        if (inst.op != Op::Lerp) return {};
        const std::vector<double>& weight = known_[args[2].index];
        const auto is_all = [&](double wanted) {
            return !weight.empty() && std::all_of(weight.begin(), weight.end(), [&](double w) { return w == wanted; });
        };
        return is_all(0) ? args[0] : is_all(1) ? args[1] : Value();
    }

    // What an instruction computes from constants alone; empty if it does not, or if that must not be folded.
    std::vector<double> numbers_of(const ir::Function& from, const ir::Inst& inst, std::span<const Value> args) {
        std::vector<double> numbers;
        if (inst.op == Op::Constant) {
            const auto constant = module_.numbers_of(module_.constants[inst.data]);
            return {constant.begin(), constant.end()};
        }
        if (!inst.type.is_numeric() || args.empty()) return numbers;
        std::vector<ir::Type> types;
        std::vector<std::span<const double>> operands;
        for (const Value arg : args) {
            if (known_[arg.index].empty()) return numbers;
            types.push_back(from[arg].type);
            operands.emplace_back(known_[arg.index]);
        }
        if (inst.op == Op::Construct) {
            for (const std::span<const double> part : operands) numbers.insert(numbers.end(), part.begin(), part.end());
            if (numbers.size() == 1) numbers.resize(inst.type.components(), numbers[0]);
            if (numbers.size() != inst.type.components()) numbers.clear();
        } else if (!ir::fold_constant(inst.op, inst.type, types, operands, inst.data, numbers)) {
            numbers.clear();
        }
        return numbers;
    }

    const ir::Module& module_;
    std::map<std::uint32_t, std::vector<double>> unset_;
    std::vector<std::vector<double>> known_;  // by old value: its numbers, if they are known
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

namespace {

// The member of a struct that no function needs goes: what was put there, and the place itself.
void drop_member(ir::Module& module, std::uint32_t structure, std::uint32_t member) {
    const ir::Type type = module.structs[structure].members[member].type;
    const auto is_of = [&](const ir::Type& other) { return other.kind == ir::Kind::Struct && other.ref == structure; };
    for (ir::Function& function : module.functions) {
        for (ir::Inst& inst : function.insts) {
            if (inst.op == Op::Construct && is_of(inst.type)) {
                const auto first = function.operands.begin() + inst.first_operand;
                std::move(first + member + 1, first + inst.operand_count, first + member);
                --inst.operand_count;
            }
            const bool reads = inst.op == Op::Extract || inst.op == Op::Insert;
            if (!reads || !is_of(function[function.args(inst)[0]].type)) continue;
            if (inst.data > member) {
                --inst.data;
            } else if (inst.data == member && inst.op == Op::Extract) {
                // Only the member of another struct that goes, too, is made of it.
                inst.op = Op::Constant;
                inst.operand_count = 0;
                inst.data = static_cast<std::uint32_t>(module.constants.size());
                module.constants.push_back({type, static_cast<std::uint32_t>(module.numbers.size())});
                module.numbers.insert(module.numbers.end(), type.components(), 0);
            }
        }
    }
    module.structs[structure].members.erase(module.structs[structure].members.begin() + member);
}

std::optional<std::uint32_t> member_named(const ir::Module& module, ir::Type type, std::string_view name) {
    const std::vector<ir::Member>& members = module.structs[type.ref].members;
    const auto found =
        std::find_if(members.begin(), members.end(), [&](const ir::Member& m) { return m.name == name; });
    if (found == members.end()) return {};
    return static_cast<std::uint32_t>(found - members.begin());
}

bool is_read(const ir::Module& module, ir::Type type, std::uint32_t member) {
    return std::any_of(module.functions.begin(), module.functions.end(), [&](const ir::Function& function) {
        return std::any_of(function.insts.begin(), function.insts.end(), [&](const ir::Inst& inst) {
            return inst.op == Op::Extract && inst.data == member && function[function.args(inst)[0]].type == type;
        });
    });
}

}  // namespace

void leave_out_unset_inputs(Lowering& lowering) {
    ir::Module& module = lowering.out.module;
    if (!lowering.setup) return;
    const ir::Type lit = module[lowering.setup].result, given = module[lowering.surface].result;
    const std::vector<format::PortValue>& set = lowering.material.graph->graph->surface;
    for (const format::Input& input : lowering.material.lighting->graph->inputs) {
        if (std::any_of(set.begin(), set.end(), [&](const format::PortValue& p) { return p.name == input.name; }))
            continue;
        const auto place = member_named(module, lit, input.name), source = member_named(module, given, input.name);
        const bool has_source = source || lowering.material.given_by_workflow(input);
        if (!place || !has_source || !module.structs[lit.ref].members[*place].type.is_numeric()) continue;
        // One without a literal default may be read.
        if (is_read(module, lit, *place)) continue;
        drop_member(module, lit.ref, *place);
        if (source) drop_member(module, given.ref, *source);
    }
}

ir::Function without_unset_inputs(Lowering& lowering, ir::Function function) {
    const ir::Type surface = function.params.empty() ? ir::Type() : function.params[0].type;
    if (surface.kind != ir::Kind::Struct) return function;
    const auto unset = unset_members(lowering, surface);
    if (std::none_of(function.insts.begin(), function.insts.end(), [&](const ir::Inst& inst) {
            return reads_member_of_surface(function, inst) && unset.contains(inst.data);
        }))
        return function;
    ir::Module& module = lowering.out.module;
    Rewrite rewrite(module, function, unset);
    ir::Function settled = copied(module, lowering.emitter.options, std::move(function), nullptr, std::ref(rewrite));
    const ir::Liveness live = ir::live_in(settled);
    return copied(module, lowering.emitter.options, std::move(settled), &live, {});
}

}  // namespace patina::lower
