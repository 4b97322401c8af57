#include "compiler/ir/rebuild.h"

#include <algorithm>
#include <utility>

namespace patina::ir {
namespace {

bool is_leaf(Op op) {
    return op == Op::Constant || op == Op::Param || op == Op::Global || op == Op::Semantic;
}

// The instruction on its new operands.
Value emit_mapped(Copy& copy, Value value) {
    const Inst& inst = copy.from[value];
    copy.scratch.clear();
    std::uint8_t changed = 0;
    for (const Value arg : copy.from.args(inst)) {
        copy.scratch.push_back(copy.map[arg.index]);
        changed |= copy.changed[arg.index];
    }
    if (changed == 0) return copy.to.emit_settled(inst.op, inst.type, copy.scratch, inst.data);
    copy.changed[value.index] = 1;
    return copy.to.emit(inst.op, inst.type, copy.scratch, inst.data);
}

const Inst& yield_of(const Function& function, std::uint32_t block) {
    return function[function.blocks[block].insts.back()];
}

// What an If becomes in the copy.
enum class Fate { Kept, Then, Else, Selects };

bool computes_nothing(const Copy& copy, std::uint32_t block) {
    const std::vector<Value>& insts = copy.from.blocks[block].insts;
    return std::all_of(insts.begin(), insts.end() - 1, [&](Value v) {
        return is_leaf(copy.from[v].op) || (copy.live != nullptr && copy.live->values[v.index] == 0);
    });
}

Fate fate_of(const Copy& copy, const Inst& branch) {
    const auto condition = copy.to.constant_of(copy.map[copy.from.args(branch)[0].index]);
    if (!condition.empty()) return condition[0] != 0 ? Fate::Then : Fate::Else;
    if (!computes_nothing(copy, branch.data) || !computes_nothing(copy, branch.data + 1)) return Fate::Kept;
    // HLSL selects between scalars and vectors only.
    const auto values = yielded(copy.from, branch.data);
    const bool can_select = std::all_of(values.begin(), values.end(), [&](Value v) {
        return copy.from[v].type.is_numeric() && !copy.from[v].type.is_matrix();
    });
    return can_select ? Fate::Selects : Fate::Kept;
}

bool has_no_trip(const Copy& copy, const Inst& loop) {
    const auto args = copy.from.args(loop);
    const auto begin = copy.to.constant_of(copy.map[args[0].index]);
    const auto end = copy.to.constant_of(copy.map[args[1].index]);
    return !begin.empty() && !end.empty() && begin[0] >= end[0];
}

bool is_live(const Copy& copy, const Inst& yield, std::uint32_t index) {
    return copy.live == nullptr || copy.live->operands[yield.first_operand + index] != 0;
}

// True if no round of the loop changes the carried value.
bool is_unchanged(const Function& from, std::uint32_t body, std::uint32_t index) {
    return yielded(from, body)[index] == from.blocks[body].insts[index + 1];
}

// True if the copy of the If or For yields this value, too.
bool keeps(const Copy& copy, const Inst& structure, std::uint32_t index) {
    // What decides whether a round begins is the last one.
    if (structure.is_while && index + 3 == structure.operand_count) return true;
    if (structure.op == Op::For && is_unchanged(copy.from, structure.data, index)) return false;
    return is_live(copy, yield_of(copy.from, structure.data), index);
}

std::vector<Value> kept_yields(const Copy& copy, const Inst& structure, std::uint32_t block) {
    std::vector<Value> values;
    const auto all = yielded(copy.from, block);
    for (std::uint32_t i = 0; i < all.size(); i++) {
        if (keeps(copy, structure, i)) values.push_back(copy.map[all[i].index]);
    }
    return values;
}

std::uint32_t kept_index(const Copy& copy, const Inst& structure, std::uint32_t index) {
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < index; i++) kept += keeps(copy, structure, i) ? 1 : 0;
    return kept;
}

// These are not inlined into copy_plain(): their arrays on the stack are guarded, and the guard costs as much as
// copying an instruction.

[[gnu::noinline]] void copy_if(Copy& copy, Value value) {
    const Inst& inst = copy.from[value];
    const Fate fate = fate_of(copy, inst);
    if (fate == Fate::Then || fate == Fate::Selects) copy_block(copy, inst.data);
    if (fate == Fate::Else || fate == Fate::Selects) copy_block(copy, inst.data + 1);
    if (fate != Fate::Kept) return;
    const Value structure = copy.to.begin_if(copy.map[copy.from.args(inst)[0].index]);
    copy_block(copy, inst.data);
    copy.to.begin_else();
    copy_block(copy, inst.data + 1);
    copy.to.end_if(kept_yields(copy, inst, inst.data), kept_yields(copy, inst, inst.data + 1));
    copy.map[value.index] = structure;
}

[[gnu::noinline]] void copy_for(Copy& copy, Value value) {
    const Inst& inst = copy.from[value];
    if (has_no_trip(copy, inst)) return;
    const auto args = copy.from.args(inst);
    const std::vector<Value>& body = copy.from.blocks[inst.data].insts;
    std::vector<Value> initial;
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i + 2 < args.size(); i++) {
        const Value first = copy.map[args[i + 2].index];
        if (keeps(copy, inst, i)) {
            initial.push_back(first);
            kept.push_back(i);
        } else {
            copy.map[body[i + 1].index] = first;
            copy.changed[body[i + 1].index] = 1;
        }
    }
    const Value structure =
        copy.to.begin_for(copy.map[args[0].index], copy.map[args[1].index], initial, inst.is_light_loop, inst.is_while);
    copy.map[body[0].index] = copy.to.loop_index();
    for (std::uint32_t i = 0; i < kept.size(); i++) copy.map[body[kept[i] + 1].index] = copy.to.loop_carried(i);
    copy_block(copy, inst.data);
    copy.to.end_for(kept_yields(copy, inst, inst.data));
    copy.map[value.index] = structure;
}

// Not inlined into copy_plain(), as the next function is not inlined into copy_inst(): their arrays on the stack are
// guarded, and the guard costs as much as copying an instruction.
[[gnu::noinline]] Value copy_result(Copy& copy, const Inst& inst) {
    const Value old = copy.from.args(inst)[0];
    const Inst& structure = copy.from[old];
    const std::uint32_t index = inst.data;
    const auto of_block = [&](std::uint32_t block) { return copy.map[yielded(copy.from, block)[index].index]; };
    if (structure.op == Op::If) {
        const Fate fate = fate_of(copy, structure);
        if (fate == Fate::Then) return of_block(structure.data);
        if (fate == Fate::Else) return of_block(structure.data + 1);
        if (fate == Fate::Selects) {
            const Value condition = copy.map[copy.from.args(structure)[0].index];
            return copy.to.emit(Op::Select, inst.type,
                                {condition, of_block(structure.data), of_block(structure.data + 1)});
        }
    } else if (has_no_trip(copy, structure) || is_unchanged(copy.from, structure.data, index)) {
        return copy.map[copy.from.args(structure)[index + 2].index];
    }
    return copy.to.result(copy.map[old.index], kept_index(copy, structure, index));
}

}  // namespace

std::span<const Value> yielded(const Function& function, std::uint32_t block) {
    return function.args(function.blocks[block].insts.back());
}

Function take_shell(Function& from) {
    Function made = std::move(from);
    from.insts = std::exchange(made.insts, {});
    from.operands = std::exchange(made.operands, {});
    from.blocks = std::exchange(made.blocks, {});
    made.insts.reserve(from.insts.size());
    made.operands.reserve(from.operands.size());
    made.blocks.reserve(from.blocks.size());
    made.blocks.emplace_back().insts.reserve(from.blocks[0].insts.size());
    return made;
}

Function shell(const Function& from) {
    Function copy = from;
    return take_shell(copy);
}

void copy_plain(Copy& copy, Value value) {
    const Inst& inst = copy.from[value];
    copy.to.set_origin(inst.origin ? inst.origin : copy.origin);
    if (inst.op == Op::If) return copy_if(copy, value);
    if (inst.op == Op::For) return copy_for(copy, value);
    if (inst.op == Op::LoopIndex || inst.op == Op::LoopCarried) return;  // the For has mapped them
    Value made;
    if (inst.op == Op::Result) {
        made = copy_result(copy, inst);
        copy.changed[value.index] = 1;
    } else if (inst.op == Op::Return) {
        copy.to.ret(inst.operand_count == 0 ? Value() : copy.map[copy.from.args(inst)[0].index]);
        return;
    } else {
        made = emit_mapped(copy, value);
    }
    copy.to.name(made, inst.name);
    copy.map[value.index] = made;
}

void copy_inst(Copy& copy, const Value& value) {
    if (copy.live != nullptr && copy.live->values[value.index] == 0) return;
    if (copy.rewrite) {
        copy.changed[value.index] = 1;
        if (copy.rewrite(copy, value)) return;
        copy.changed[value.index] = 0;
    }
    copy_plain(copy, value);
}

void copy_block(Copy& copy, std::uint32_t block) {
    for (const Value& value : copy.from.blocks[block].insts) {
        if (copy.from[value].op != Op::Yield) copy_inst(copy, value);
    }
}

void copy_body(Copy& copy) {
    copy.map.resize(copy.from.insts.size());
    copy.changed.resize(copy.from.insts.size());
    copy.scratch.reserve(16);
    copy_block(copy, 0);
}

}  // namespace patina::ir
