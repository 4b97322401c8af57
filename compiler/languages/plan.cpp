#include "compiler/languages/plan.h"

#include <algorithm>

#include "compiler/languages/analysis.h"

namespace patina::languages {

using namespace ir;

bool is_leaf(Op op) {
    return op == Op::Constant || op == Op::Param || op == Op::Global;
}

bool is_splat(const Function& function, Value v) {
    const Inst& inst = function[v];
    return inst.op == Op::Construct && inst.type.is_vector() && inst.operand_count == 1 &&
           function[function.args(v)[0]].type.is_scalar();
}

bool is_aggregate(Type type) {
    return type.kind == Kind::Struct || type.kind == Kind::Array;
}

std::uint32_t slot_count(const Function& function, Value structure) {
    const Inst& inst = function[structure];
    if (inst.op == Op::For) return inst.operand_count - 2;
    return function[function.blocks[inst.data].insts.back()].operand_count;
}

void for_each_read(const Plan& plan, const Function& function, Value value, const std::function<void(Value)>& visit) {
    for (Value operand : function.args(value)) {
        const Value read = plan.resolve(operand);
        if (plan.variable[read.index] != Plan::kNone) {
            visit(read);
        } else {
            for_each_read(plan, function, read, visit);
        }
    }
}

bool has_plain_else(const Plan& plan, const Function& function, Value structure) {
    const std::vector<Value>& insts = function.blocks[function[structure].data + 1].insts;
    return std::all_of(insts.begin(), insts.end(), [&](Value v) {
        const Op op = function[v].op;
        const bool is_access = op == Op::Extract || op == Op::Swizzle || is_splat(function, v);
        return plan.reads[v.index] == 0 || is_leaf(op) || (is_access && !plan.stands[v.index]);
    });
}

bool Plan::is_printed(const Function& function, Value v) const {
    const Op op = function[v].op;
    return op == Op::Return || op == Op::DiscardIf || op == Op::Yield || reads[v.index] > 0;
}

namespace {

Plan make_plan(const Module& module, const Function& function, bool is_entry) {
    const Analysis analysis = analyse(module, function, is_entry);
    const std::size_t n = function.insts.size();
    Plan plan;
    plan.variable.assign(n, Plan::kNone);
    plan.first_slot.assign(n, 0);
    plan.same_as = analysis.same_as;
    plan.reads = analysis.reads;
    plan.stands = analysis.stands;
    plan.outputs = analysis.outputs;
    share_variables(analysis, plan);
    return plan;
}

}  // namespace

const Plan& Plans::of(FunctionId id) {
    std::optional<Plan>& plan = plans_[id.index];
    if (!plan) plan = make_plan(module_, module_[id], module_.stage.entry == id);
    return *plan;
}

}  // namespace patina::languages
