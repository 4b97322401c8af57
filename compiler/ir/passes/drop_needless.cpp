#include <utility>
#include <vector>

#include "compiler/ir/fold/known.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

bool may_be_needless(const Inst& inst) {
    return inst.op == Op::Normalize || inst.op == Op::Min || inst.op == Op::Max || inst.op == Op::Clamp ||
           inst.op == Op::Saturate;
}

// The replacement of an instruction: one of its operands, or the number 1.
struct Instead {
    Value operand{};
    bool is_one = false;  // the squared length of a unit vector

    bool is_found() const { return operand || is_one; }
};

Instead instead_of(const Module& module, const Function& function, const Inst& inst) {
    const FactsOf facts{module, function, true};
    const auto args = function.args(inst);
    if (inst.op == Op::Dot) return {.is_one = args[0] == args[1] && is_unit(facts, args[0])};
    if (!may_be_needless(inst)) return {};
    return {.operand = unchanged_operand(facts, inst.op, args)};
}

// By value. Empty if all are needed.
std::vector<Instead> all_instead(const Module& module, const Function& function) {
    std::vector<Instead> found;
    for (std::uint32_t i = 0; i < function.insts.size(); i++) {
        const Instead instead = instead_of(module, function, function.insts[i]);
        if (!instead.is_found()) continue;
        found.resize(function.insts.size());
        found[i] = instead;
    }
    return found;
}

}  // namespace

Module drop_needless(Module module) {
    for (Function& function : module.functions) {
        const std::vector<Instead> instead = all_instead(module, function);
        if (instead.empty()) continue;
        const Function from = std::move(function);
        function = shell(from);
        Builder builder(module, function);
        Copy copy{.from = from, .to = builder, .rewrite = [&](Copy& c, Value v) {
                      const Instead& found = instead[v.index];
                      if (!found.is_found()) return false;
                      if (found.is_one) {
                          c.map[v.index] = c.to.constant(c.from[v].type, {1});
                          return true;
                      }
                      const Value same = c.map[found.operand.index];
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
