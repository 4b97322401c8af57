// Copies a function through a Builder: what all passes stand on. While it copies, the builder folds and numbers, an If
// with a known condition becomes its branch, an If that computes nothing becomes Selects, a For without a trip goes
// away and what a loop carries unchanged is carried no more. A pass says what it does differently by `rewrite` and
// `live`.
//
//   Function made = shell(old);
//   Builder b(module, made);
//   Copy copy{.from = old, .to = b, .rewrite = [&](Copy& c, Value v) { ...; return true; }};
//   copy_body(copy);
#pragma once

#include <functional>

#include "compiler/ir/builder.h"

namespace patina::ir {

// What a function needs of itself. A structure's yielded value is kept if its place in its Yield is.
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
    // Asked before each instruction: true if it has been dealt with (and mapped, unless nothing reads it).
    std::function<bool(Copy&, Value)> rewrite{};
    std::vector<Value> scratch{};
    // By old value: 1 if the new one may be of another make, so that what reads it is worth simplifying anew. After
    // `rewrite` has dealt with a value, 1 unless it says otherwise.
    std::vector<std::uint8_t> changed{};
};

// A function without a body, otherwise like `from`.
Function shell(const Function& from);
// The same for a function of which only the body is needed afterwards.
Function take_shell(Function& from);

// The body, with its Return.
void copy_body(Copy& copy);
// The instructions of a block but for its Yield.
void copy_block(Copy& copy, std::uint32_t block);
// One instruction with all that it holds: as `rewrite` does it, or plainly.
void copy_inst(Copy& copy, Value value);
void copy_plain(Copy& copy, Value value);

// The operands of the Yield that ends a block.
std::span<const Value> yielded(const Function& function, std::uint32_t block);

}  // namespace patina::ir
