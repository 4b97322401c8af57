#include <algorithm>
#include <utility>

#include "compiler/ir/passes/dependence.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

// Longer functions have something that is not there already.
constexpr std::size_t kMaxBody = 32;

// True for a function that is one expression: no branch, no loop, no call.
bool is_expression(const Function& function) {
    return !is_elsewhere(function) && function.blocks.size() == 1 && function.insts.size() <= kMaxBody &&
           std::none_of(function.insts.begin(), function.insts.end(), [](const Inst& i) { return i.op == Op::Call; });
}

bool has_loop_and_call(const Function& function) {
    const auto has = [&](Op op) {
        return std::any_of(function.insts.begin(), function.insts.end(), [&](const Inst& i) { return i.op == op; });
    };
    return has(Op::For) && has(Op::Call);
}

// What the call would compute. Values that are there already are found; prune() drops the others if they are not used.
Value opened(Copy& outer, const Function& callee, const Inst& call) {
    const auto args = outer.from.args(call);
    Value result;
    Copy copy{.from = callee, .to = outer.to, .origin = call.origin, .rewrite = [&](Copy& c, Value v) {
                  const Inst& inst = c.from[v];
                  if (inst.op == Op::Param) c.map[v.index] = outer.map[args[inst.data].index];
                  if (inst.op == Op::Return && inst.operand_count == 1) result = c.map[c.from.args(inst)[0].index];
                  return inst.op == Op::Param || inst.op == Op::Return;
              }};
    copy_body(copy);
    return result;
}

bool has_new_work(const Function& function, std::size_t before) {
    return std::any_of(function.insts.begin() + std::ptrdiff_t(before), function.insts.end(),
                       [](const Inst& inst) { return is_work(inst.op); });
}

bool reuse(const Module& module, Copy& copy, Value value) {
    const Inst& inst = copy.from[value];
    if (inst.op != Op::Call || !is_expression(module.functions[inst.data])) return false;
    const std::size_t before = copy.to.function().insts.size();
    const Value same = opened(copy, module.functions[inst.data], inst);
    if (!same || has_new_work(copy.to.function(), before)) return false;
    copy.map[value.index] = same;
    return true;
}

}  // namespace

Module reuse_values(Module module) {
    for (Function& function : module.functions) {
        if (!has_loop_and_call(function)) continue;
        const Function from = std::move(function);
        function = shell(from);
        Builder builder(module, function);
        Copy copy{.from = from, .to = builder, .rewrite = [&](Copy& c, Value v) { return reuse(module, c, v); }};
        copy_body(copy);
    }
    return module;
}

}  // namespace patina::ir
