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

// By value: the operand that stands for it. Empty if all are needed.
std::vector<Value> operands_instead(const Module& module, const Function& function) {
    std::vector<Value> found;
    for (std::uint32_t i = 0; i < function.insts.size(); i++) {
        const Inst& inst = function.insts[i];
        if (!may_be_needless(inst)) continue;
        const Value same = unchanged_operand({module, function, true}, inst.op, function.args(inst));
        if (!same) continue;
        found.resize(function.insts.size());
        found[i] = same;
    }
    return found;
}

}  // namespace

Module drop_needless(Module module) {
    for (Function& function : module.functions) {
        const std::vector<Value> instead = operands_instead(module, function);
        if (instead.empty()) continue;
        const Function from = std::move(function);
        function = shell(from);
        Builder builder(module, function);
        Copy copy{.from = from, .to = builder, .rewrite = [&](Copy& c, Value v) {
                      if (!instead[v.index]) return false;
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
