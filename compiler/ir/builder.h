// Makes the instructions of one function. Emission and passes make all instructions here (ir.h names two exceptions).
// So folding, identities and value numbering happen once, when an instruction is made: emit() returns an existing value
// when it can. If BuildOptions::fold is off, emit() makes exactly the instruction that was asked for; the interpreter
// runs such functions.
//
//   Builder b(module, function, {});
//   Value two = b.constant(kFloat, {2.0});
//   Value x = b.emit(Op::Mul, kFloat, {a, two});
//   b.begin_if(cond);  ...  b.begin_else();  ...  b.end_if({x}, {y});   // then b.result(if_value, 0)
#pragma once

#include <initializer_list>
#include <vector>

#include "compiler/ir/ir.h"
#include "compiler/ir/value_table.h"

namespace patina::ir {

struct BuildOptions {
    bool fold = true;  // constant folding, identities, value numbering
};

class Builder {
public:
    Builder(Module& module, Function& function, BuildOptions options = {});
    ~Builder();
    Builder(const Builder&) = delete;

    Module& module() { return module_; }
    Function& function() { return function_; }
    const BuildOptions& options() const { return options_; }

    // --- values. `type` is checked against the op's rule in debug builds.
    Value emit(Op op, Type type, std::span<const Value> args, std::uint32_t data = 0);
    // As emit(), for an instruction that cannot be simplified any more: it is only compared with existing ones.
    Value emit_settled(Op op, Type type, std::span<const Value> args, std::uint32_t data) {
        return emit_numbered(op, type, args, data, true);
    }
    Value emit(Op op, Type type, std::initializer_list<Value> args, std::uint32_t data = 0) {
        return emit(op, type, std::span<const Value>(args.begin(), args.size()), data);
    }
    // Result type by the op's rule; operands must fit it.
    Value emit(Op op, std::initializer_list<Value> args);

    Value constant(Type type, std::span<const double> components);
    Value constant(Type type, std::initializer_list<double> components) {
        return constant(type, std::span<const double>(components.begin(), components.size()));
    }
    // Every component the same.
    Value splat_constant(Type type, double value);
    Value param(std::uint32_t index);
    Value extract(Value composite, std::uint32_t index);
    // Every number in it 0.
    Value zero(Type type);
    Value construct(Type type, std::span<const Value> parts) { return emit(Op::Construct, type, parts); }
    Value splat(Value scalar, unsigned width);
    Value swizzle(Value vector, std::span<const unsigned> components);
    Value convert(Value value, Scalar to);
    Value call(FunctionId callee, std::span<const Value> args);

    // --- structure
    Value begin_if(Value condition);  // now in the then block
    void begin_else();
    // Both lists have the same types; returns the If.
    Value end_if(std::span<const Value> then_values, std::span<const Value> else_values);
    // `is_while`: see Inst.
    Value begin_for(Value begin, Value end, std::span<const Value> initial, bool is_light_loop = false,
                    bool is_while = false);
    Value loop_index() const;
    Value loop_carried(std::uint32_t index) const;
    Value end_for(std::span<const Value> next);
    Value result(Value structure, std::uint32_t index);
    void ret(Value value);                              // a null value: return nothing
    std::size_t depth() const { return open_.size(); }  // how many If and For are open

    // --- what new instructions carry
    void set_origin(OriginId origin) { origin_ = origin; }
    OriginId origin() const { return origin_; }
    // Gives the value a name hint, unless it has one or is a leaf.
    void name(Value value, NameId name);
    // Replaces the value's name hint, if it has one, unless the value is a leaf.
    void rename(Value value, NameId name);

    // --- looking at what is there
    const Inst& operator[](Value v) const { return function_.insts[v.index]; }
    Type type(Value v) const { return function_.insts[v.index].type; }
    std::span<const Value> args(Value v) const { return function_.args(v); }
    // The constant's components if `v` is a Constant, or an empty span.
    std::span<const double> constant_of(Value v) const;
    bool is_constant(Value v, double every_component) const;

private:
    struct Open {
        Value structure;
        BlockId outer;
        Value loop_index;  // of a For
        std::vector<Value> carried;
        std::size_t scope;  // size of `numbered` when it was opened
    };
    Value emit_numbered(Op op, Type type, std::span<const Value> args, std::uint32_t data, bool is_settled = false);
    Value emit_leaf(Op op, Type type, std::uint32_t data);
    Value emit_constant(Type type, std::span<const double> components, std::uint32_t data);
    Value append(Inst inst, std::span<const Value> args, std::vector<Value>& where);
    std::vector<Value>& current() { return function_.blocks[block_.index].insts; }
    BlockId add_block();
    void yield(BlockId block, std::span<const Value> values);
    const Open& innermost_loop() const;
    void check_rule(Op op, Type type, std::span<const Value> args) const;

    // A function is rebuilt by several passes, so a builder leaves its tables, emptied, for the next builder.
    struct Tables {
        ValueTable numbered;  // what the current block can see
        ValueTable leaves;    // constants, params, globals, semantics: once in a function
        // While folding, leaves are collected here. ret() puts them at the head of the body, where every block sees
        // them.
        std::vector<Value> head;
    };
    static std::vector<Tables>& spare_tables();

    Module& module_;
    Function& function_;
    BuildOptions options_;
    BlockId block_{0};
    OriginId origin_;
    std::vector<Open> open_;
    Tables tables_;
};

// An existing or newly made value that equals op(args), or null (identities.cpp).
Value simplify(Builder& b, Op op, Type type, std::span<const Value> args, std::uint32_t data);

// The components of op applied to constant operands. False if it must not be folded: the op has an effect, or the
// result is NaN, infinite or not defined (fold.cpp).
bool fold_constant(Op op, Type type, std::span<const Type> operand_types,
                   std::span<const std::span<const double>> operands, std::uint32_t data, std::vector<double>& out);

}  // namespace patina::ir
