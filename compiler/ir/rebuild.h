// Copies a function through a Builder, which is how passes change functions. The copy is simplified. The builder folds
// and finds equal values. An If with a known condition becomes one of its branches, and an If that computes nothing
// becomes Selects. A For that never runs is dropped, and a loop no longer carries values that it does not change. A
// pass says by `rewrite` and `live` what it does differently.
//
//   Function made = shell(old);
//   Builder b(module, made);
//   Copy copy{.from = old, .to = b, .rewrite = [&](Copy& c, Value v) { ...; return true; }};
//   copy_body(copy);
#pragma once

#include <functional>

#include "compiler/ir/builder.h"

namespace patina::ir {

// Which values a function needs for its own result. A value that an If or For yields is in the copy if its operand of
// the Yield is needed.
struct Liveness {
    std::vector<std::uint8_t> values;    // by Value
    std::vector<std::uint8_t> operands;  // by index into Function::operands; only those of Yields count
};

struct Copy {
    const Function& from;
    Builder& to;
    std::vector<Value> map{};        // old value -> new value; null while it has none
    OriginId origin{};               // for instructions that have none of their own
    const Liveness* live = nullptr;  // null: everything is kept
    // Called before each instruction is copied. Returns true if it has emitted the instruction itself, and set its
    // entry in `map` unless nothing reads it.
    std::function<bool(Copy&, const Value&)> rewrite{};
    std::vector<Value> scratch{};
    // By old value: 1 if another instruction may compute the new one, so that its readers may be simpler now. After
    // `rewrite` returned true it is 1, unless `rewrite` has set it to 0.
    std::vector<std::uint8_t> changed{};
};

// A function without a body, otherwise like `from`.
Function shell(const Function& from);
// The same, by moving: afterwards only the body of `from` may be used.
Function take_shell(Function& from);

// The body, with its Return.
void copy_body(Copy& copy);
// The instructions of a block but for its Yield.
void copy_block(Copy& copy, std::uint32_t block);
// One instruction, with the blocks of an If or For: by `rewrite`, or as it is.
// By reference, as `rewrite` is: a value on the stack would have to be guarded.
void copy_inst(Copy& copy, const Value& value);
void copy_plain(Copy& copy, Value value);

// The operands of the Yield that ends a block.
std::span<const Value> yielded(const Function& function, std::uint32_t block);

// Sets which function each Call calls: `moved(old index)` is the new one. For functions that have moved in the module;
// nothing else of a finished function is edited in place (ir.h).
template <class Moved>
void renumber_calls(Function& function, const Moved& moved) {
    for (Inst& inst : function.insts) {
        if (inst.op == Op::Call) inst.data = moved(inst.data);
    }
}

}  // namespace patina::ir
