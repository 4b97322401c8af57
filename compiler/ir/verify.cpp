#include "compiler/ir/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "compiler/ir/declared_types.h"
#include "compiler/ir/dump.h"

namespace patina::ir {
namespace {

// Walks one function in the order of execution. Stops at the first thing that is wrong.
class Verifier {
public:
    Verifier(const Module& module, const Function& function, bool may_discard)
        : module_(module),
          function_(function),
          may_discard_(may_discard),
          visible_(function.insts.size()),
          placed_(function.insts.size()),
          entered_(function.blocks.size()) {}

    std::string run() {
        if (!is_possible(module_, function_.result)) fail({}, "the result's type does not exist");
        for (const Param& param : function_.params) {
            if (!is_possible(module_, param.type) || param.type.kind == Kind::Void) {
                fail({}, fmt::format("the type of '{}' does not exist", param.name));
            }
        }
        block(0, nullptr);
        return reason_.empty() ? "" : dump(module_, function_, Mark{.value = at_, .reason = reason_});
    }

private:
    bool fail(Value at, std::string reason) {
        if (reason_.empty()) {
            at_ = at;
            reason_ = std::move(reason);
        }
        return false;
    }
    bool ok() const { return reason_.empty(); }

    // The block of `owner`, or the function's body.
    void block(std::uint32_t index, const Inst* owner) {
        if (index >= function_.blocks.size()) return void(fail(current_, fmt::format("there is no block {}", index)));
        if (entered_[index]) return void(fail(current_, fmt::format("block {} has two owners", index)));
        entered_[index] = true;
        const std::vector<Value>& insts = function_.blocks[index].insts;
        if (insts.empty()) return void(fail(current_, "a block is empty"));
        for (std::size_t i = 0; i < insts.size() && ok(); i++) {
            if (place(insts[i])) instruction(insts[i], i, i + 1 == insts.size(), owner);
        }
        // The values of a block are not visible behind it.
        for (const Value value : insts) {
            if (value.index < visible_.size()) visible_[value.index] = false;
        }
    }

    bool place(Value value) {
        if (value.index >= function_.insts.size())
            return fail(current_, fmt::format("there is no instruction {}", value.index));
        current_ = value;
        if (placed_[value.index]) return fail(value, "the instruction is in two blocks or twice in one");
        placed_[value.index] = true;
        return true;
    }

    void instruction(Value value, std::size_t position, bool is_last, const Inst* owner) {
        const Inst& inst = function_[value];
        if (!operands(value) || !types(value)) return;
        end_of_block(value, is_last, owner);
        loop_values(value, position, owner);
        if (inst.op == Op::If) branch(value);
        if (inst.op == Op::For) loop(value);
        if (inst.op == Op::Result) result(value);
        if (inst.op == Op::DiscardIf && (owner != nullptr || !may_discard_)) {
            fail(value, "a discard may only be in the top block of the entry function");
        }
        visible_[value.index] = true;
    }

    bool operands(Value value) {
        const Inst& inst = function_[value];
        if (std::size_t{inst.first_operand} + inst.operand_count > function_.operands.size()) {
            return fail(value, "the operands are not in the function");
        }
        const int wanted = info(inst.op).arguments;
        if (wanted >= 0 && inst.operand_count != static_cast<std::uint32_t>(wanted)) {
            return fail(value, fmt::format("{} operands, not {}", inst.operand_count, wanted));
        }
        for (const Value arg : function_.args(inst)) {
            if (arg.index >= visible_.size() || !visible_[arg.index]) {
                return fail(value, fmt::format("%{} is not visible here", arg.index));
            }
            const bool is_structure = function_[arg].op == Op::If || function_[arg].op == Op::For;
            if (is_structure != (inst.op == Op::Result))
                return fail(value, fmt::format("%{} is no operand of this", arg.index));
            if (!is_structure && function_[arg].type.kind == Kind::Void)
                return fail(value, fmt::format("%{} is no value", arg.index));
        }
        return true;
    }

    bool types(Value value) {
        const Inst& inst = function_[value];
        if (!is_possible(module_, inst.type)) return fail(value, "the type does not exist");
        if (info(inst.op).rule == TypeRule::Declared) {
            const std::string error = declared_type_error(module_, function_, inst);
            return error.empty() || fail(value, error);
        }
        std::vector<Type> operand_types;
        std::string names;
        for (const Value arg : function_.args(inst)) {
            operand_types.push_back(function_[arg].type);
            names += (names.empty() ? "" : ", ") + module_.type_name(function_[arg].type);
        }
        if (result_type(inst.op, operand_types) != inst.type) {
            return fail(value,
                        fmt::format("{} of ({}) is not a {}", info(inst.op).text, names, module_.type_name(inst.type)));
        }
        // An Insert's rule gives a type, but not whether the part fits.
        const std::string error = declared_type_error(module_, function_, inst);
        return error.empty() || fail(value, error);
    }

    void end_of_block(Value value, bool is_last, const Inst* owner) {
        const Inst& inst = function_[value];
        const bool is_return = inst.op == Op::Return;
        const bool is_end = is_return || inst.op == Op::Yield;
        if (is_end != is_last) return void(fail(value, is_end ? "this ends a block" : "the block has no end"));
        if (!is_end) return;
        if (is_return != (owner == nullptr)) {
            return void(
                fail(value, is_return ? "only a function's body returns" : "a function's body ends in a return"));
        }
        if (!is_return) return;
        const Type type = inst.operand_count == 0 ? Type::none() : function_[function_.args(inst)[0]].type;
        if (inst.operand_count > 1 || type != function_.result) {
            fail(value, fmt::format("the function returns a {}", module_.type_name(function_.result)));
        }
    }

    void loop_values(Value value, std::size_t position, const Inst* owner) {
        const Inst& inst = function_[value];
        const std::size_t carried = owner && owner->op == Op::For ? owner->operand_count - 2u : 0;
        const bool is_loop = owner && owner->op == Op::For;
        const Op wanted = !is_loop || position > carried ? Op::Constant
                          : position == 0                ? Op::LoopIndex
                                                         : Op::LoopCarried;
        if (wanted == Op::Constant) {
            if (inst.op == Op::LoopIndex || inst.op == Op::LoopCarried)
                fail(value, "this may only be at the head of a loop");
            return;
        }
        if (inst.op != wanted) return void(fail(value, "a loop begins with its index and all that it carries"));
        const std::size_t operand = position == 0 ? 0 : position + 1;
        if (wanted == Op::LoopCarried && inst.data != position - 1)
            return void(fail(value, "carried values are in order"));
        if (inst.type != function_[function_.args(*owner)[operand]].type)
            fail(value, "the type is not the initial value's");
    }

    void branch(Value value) {
        const Inst& inst = function_[value];
        if (function_[function_.args(inst)[0]].type != kBool) return void(fail(value, "the condition is not a bool"));
        block(inst.data, &inst);
        if (ok()) block(inst.data + 1, &inst);
        if (!ok()) return;
        const auto a = yielded(inst.data), b = yielded(inst.data + 1);
        const bool are_equal = std::equal(a.begin(), a.end(), b.begin(), b.end(),
                                          [&](Value x, Value y) { return function_[x].type == function_[y].type; });
        if (!are_equal) fail(value, "the branches yield different types");
    }

    void loop(Value value) {
        const Inst& inst = function_[value];
        const auto args = function_.args(inst);
        if (args.size() < 2) return void(fail(value, "a loop has a begin and an end"));
        const Type counter = function_[args[0]].type;
        if (!counter.is_scalar() || !counter.is_integer() || function_[args[1]].type != counter) {
            return void(fail(value, "a loop counts with ints"));
        }
        if (inst.is_while && (args.size() < 3 || function_[args.back()].type != kBool))
            return void(fail(value, "what decides whether a round begins is not a bool"));
        block(inst.data, &inst);
        if (!ok()) return;
        const auto initial = args.subspan(2), next = yielded(inst.data);
        const bool are_equal = std::equal(initial.begin(), initial.end(), next.begin(), next.end(),
                                          [&](Value x, Value y) { return function_[x].type == function_[y].type; });
        if (!are_equal) fail(value, "what the loop yields is not what it carries");
    }

    void result(Value value) {
        const Inst& inst = function_[value];
        const auto values = yielded(function_[function_.args(inst)[0]].data);
        if (inst.data >= values.size())
            return void(fail(value, fmt::format("there is no yielded value {}", inst.data)));
        if (function_[values[inst.data]].type != inst.type) fail(value, "the type is not the yielded value's");
    }

    std::span<const Value> yielded(std::uint32_t block) const {
        return function_.args(function_.blocks[block].insts.back());
    }

    const Module& module_;
    const Function& function_;
    const bool may_discard_;
    std::vector<bool> visible_, placed_, entered_;
    Value current_, at_;
    std::string reason_;
};

std::string stage_error(const Module& module) {
    const StageInterface& stage = module.stage;
    const Function& entry = module[stage.entry];
    if (stage.inputs.size() != entry.params.size()) return "the stage's inputs are not the entry function's params";
    for (std::size_t i = 0; i < stage.inputs.size(); i++) {
        if (stage.inputs[i].type != entry.params[i].type)
            return fmt::format("the input '{}' has another type", stage.inputs[i].name);
    }
    const bool returns_struct = entry.result.kind == Kind::Struct && entry.result.ref < module.structs.size();
    if (!returns_struct) return stage.outputs.empty() ? "" : "the entry function returns no struct of outputs";
    const std::vector<Member>& members = module.structs[entry.result.ref].members;
    const bool are_equal = std::equal(members.begin(), members.end(), stage.outputs.begin(), stage.outputs.end(),
                                      [](const Member& m, const StageVariable& v) { return m.type == v.type; });
    return are_equal ? "" : "the stage's outputs are not the members of the entry function's result";
}

}  // namespace

std::string verify(const Module& module) {
    for (std::uint32_t i = 0; i < module.functions.size(); i++) {
        // A pass's body is inlined into the entry; before that, the body contains its discards.
        const bool may_discard =
            !module.stage.entry || module.stage.entry.index == i || module.functions[i].always_inline;
        std::string error = Verifier(module, module.functions[i], may_discard).run();
        if (!error.empty()) return error;
    }
    if (!module.stage.entry) return "";
    if (module.stage.entry.index >= module.functions.size()) return "the stage's entry function does not exist\n";
    const std::string error = stage_error(module);
    return error.empty() ? "" : dump(module, module[module.stage.entry], Mark{.value = {}, .reason = error});
}

bool is_verifying() {
#ifdef PATINA_VERIFY
    return true;
#else
    static const bool wanted = [] {
        const char* value = std::getenv("PATINA_VERIFY");
        return value != nullptr && std::string_view(value) == "1";
    }();
    return wanted;
#endif
}

void check(const Module& module, std::string_view stage) {
    const std::string error = verify(module);
    if (error.empty()) return;
    std::fprintf(stderr, "the IR is unsound after %.*s:\n%s", static_cast<int>(stage.size()), stage.data(),
                 error.c_str());
    std::abort();
}

}  // namespace patina::ir
