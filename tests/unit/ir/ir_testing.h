// What the tests of the IR's passes share: functions made in a line or two, and questions about what became of them.
// Not a framework: each test still reads from top to bottom.
//
//   FunctionId main = add(module, "main", {kX}, kFloat, [](Builder& b) { return b.emit(Op::Sin, {b.param(0)}); });
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "compiler/ir/builder.h"
#include "compiler/ir/verify.h"

namespace patina::ir {

using Body = std::function<Value(Builder&)>;

// Adds a function whose body returns what `body` makes.
inline FunctionId add(Module& module, std::string name, std::vector<Param> params, Type result, const Body& body,
                      bool fold = true) {
    Function function;
    function.name = std::move(name);
    function.params = std::move(params);
    function.result = result;
    Builder b(module, function, {.fold = fold});
    b.ret(body(b));
    module.functions.push_back(std::move(function));
    return {static_cast<std::uint32_t>(module.functions.size() - 1)};
}

inline void set_entry(Module& module, FunctionId entry) {
    module.stage.entry = entry;
    for (const Param& param : module[entry].params) {
        module.stage.inputs.push_back({.name = param.name, .type = param.type});
    }
    if (module[entry].result.kind != Kind::Struct) return;
    for (const Member& member : module.structs[module[entry].result.ref].members) {
        module.stage.outputs.push_back({.name = member.name, .type = member.type});
    }
}

// What stands in the blocks, loops and branches included.
inline std::size_t count(const Function& function, Op op) {
    std::size_t n = 0;
    for (const Block& block : function.blocks) {
        for (const Value value : block.insts) n += function[value].op == op ? 1 : 0;
    }
    return n;
}

inline Module checked(Module module) {
    EXPECT_EQ(verify(module), "");
    return module;
}

inline const Param kX{"x", kFloat, Rate::Pixel}, kY{"y", kFloat, Rate::Pixel}, kZ{"z", kFloat, Rate::Pixel};
inline const Param kC{"c", kBool, Rate::Pixel}, kRoughness{"roughness", kFloat, Rate::Uniform};

// A body long enough not to be inlined for its size.
inline Value long_chain(Builder& b, Value v) {
    for (const Op op : {Op::Sin, Op::Cos, Op::Exp, Op::Sqrt, Op::Tan}) v = b.emit(op, {v});
    return v;
}

// f(x, mode): a branch on mode.
inline FunctionId add_switch(Module& module) {
    return add(module, "f", {kX, {"mode", kInt, Rate::Uniform}}, kFloat, [](Builder& b) {
        const Value x = b.param(0), one = b.constant(kInt, {1});
        const Value branch = b.begin_if(b.emit(Op::Equal, {b.param(1), one}));
        const Value a = long_chain(b, x);
        b.begin_else();
        const Value c = b.emit(Op::Log, {x});
        b.end_if(std::vector{a}, std::vector{c});
        return b.result(branch, 0);
    });
}

}  // namespace patina::ir
