#include <utility>
#include <vector>

#include "compiler/ir/fold/known.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

bool may_be_needless(const Inst& inst) {
    const bool is_limit = inst.op == Op::Min || inst.op == Op::Max || inst.op == Op::Clamp || inst.op == Op::Saturate;
    return (inst.op == Op::Normalize || is_limit) && inst.type.is_numeric();
}

// By function: whether something calls it still. Callers stand behind what they call.
std::vector<bool> called(const Module& module) {
    std::vector<bool> live(module.functions.size());
    for (std::size_t f = live.size(); f-- > 0;) {
        const Function& function = module.functions[f];
        const bool is_entry = module.stage.entry && module.stage.entry.index == f;
        if (is_entry || !module.stage.entry || function.linkage != Linkage::Internal) live[f] = true;
        if (!live[f]) continue;
        for (const Inst& inst : function.insts)
            if (inst.op == Op::Call) live[inst.data] = true;
    }
    return live;
}

// The square of a unit vector is 1, except for rounding.
bool is_one(const FactsOf& facts, const Inst& inst) {
    const auto args = facts.function.args(inst);
    return inst.op == Op::Dot && args[0] == args[1] && is_unit(facts, args[0]);
}

// By value: the operand that stands for it, or the value itself if it is 1. Empty if all are needed.
std::vector<Value> operands_instead(const Module& module, const Function& function, const std::vector<bool>& live) {
    std::vector<Value> found;
    for (std::uint32_t i = 0; i < function.insts.size(); i++) {
        const Inst& inst = function.insts[i];
        const FactsOf facts{module, function, true, &live};
        Value same;
        if (may_be_needless(inst)) same = unchanged_operand(facts, inst.op, function.args(inst));
        if (is_one(facts, inst)) same = {i};
        if (!same) continue;
        found.resize(function.insts.size());
        found[i] = same;
    }
    return found;
}

}  // namespace

Module drop_needless(Module module) {
    const std::vector<bool> live = called(module);
    for (Function& function : module.functions) {
        const std::vector<Value> instead = operands_instead(module, function, live);
        if (instead.empty()) continue;
        const Function from = std::move(function);
        function = shell(from);
        Builder builder(module, function);
        Copy copy{.from = from, .to = builder, .rewrite = [&](Copy& c, Value v) {
                      if (!instead[v.index]) return false;
                      if (instead[v.index] == v) {
                          c.map[v.index] = c.to.constant(from[v].type, {1});
                          return true;
                      }
                      const Value same = c.map[instead[v.index].index];
                      // A member of a struct has a name already.
                      if (c.to[same].op != Op::Extract) c.to.name(same, from[v].name);
                      c.map[v.index] = same;
                      return true;
                  }};
        copy_body(copy);
    }
    return module;
}

}  // namespace patina::ir
