#include "compiler/ir/fold/choices.h"

#include <algorithm>
#include <vector>

namespace patina::ir {
namespace {

// The search for an equal condition goes back so far, so that the time to build a function stays linear.
constexpr int kMaxDepth = 4;

// Ops that may be computed a second time to save a choice: no samples, and no ops with blocks.
bool may_repeat(Op op) {
    return !has(op, Structure) && !has(op, Effect) && !has(op, Derivative) && info(op).rule != TypeRule::Texel &&
           op != Op::Call;
}

// A condition of keywords stays: another pass makes branches of the text from it, and decides what each branch contains
// (branch_on_keywords).
bool is_of_keywords(Builder& b, Value condition, int depth) {
    const Inst& inst = b[condition];
    if (inst.op == Op::Global) return b.module().globals[inst.data].is_keyword();
    const auto args = b.args(condition);
    return depth < kMaxDepth &&
           std::any_of(args.begin(), args.end(), [&](Value arg) { return is_of_keywords(b, arg, depth + 1); });
}

// The value where the condition is known; none if that changes nothing. `changed`: the values that have become others.
Value knowing(Builder& b, Value value, Value condition, bool is_true, std::vector<Value>& changed, int depth = 0) {
    const Inst inst = b[value];
    if (inst.operand_count == 0 || depth == kMaxDepth || !may_repeat(inst.op)) return {};
    std::vector<Value> args(b.args(value).begin(), b.args(value).end());
    if (inst.op == Op::Select && args[0] == condition) return args[is_true ? 1 : 2];
    bool has_changed = false;
    for (Value& arg : args) {
        const Value known = knowing(b, arg, condition, is_true, changed, depth + 1);
        if (!known) continue;
        arg = known;
        has_changed = true;
    }
    if (!has_changed) return {};
    changed.push_back(value);
    const Value made = b.emit(inst.op, inst.type, args, inst.data);
    if (!b[made].name) b.name(made, inst.name);
    return made;
}

}  // namespace

Value simplify_choice(Builder& b, Type type, std::span<const Value> args) {
    if (is_of_keywords(b, args[0], 0)) return {};
    const Value condition = args[0], first = args[1], second = args[2];  // emitting may move the operands
    std::vector<Value> in_first, in_second;
    const Value yes = knowing(b, first, condition, true, in_first);
    const Value no = knowing(b, second, condition, false, in_second);
    if (!yes && !no) return {};
    // What both sides read is computed once for both as it is.
    if (std::find_first_of(in_first.begin(), in_first.end(), in_second.begin(), in_second.end()) != in_first.end())
        return {};
    return b.emit(Op::Select, type, {condition, yes ? yes : first, no ? no : second});
}

}  // namespace patina::ir
