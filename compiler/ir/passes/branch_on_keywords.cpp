#include "compiler/ir/passes/keyword_sides.h"

namespace patina::ir {
namespace {

class Brancher {
public:
    Brancher(const Function& from, const Sides& sides) : from_(from), sides_(sides) {}

    bool rewrite(Copy& copy, Value v) {
        if (sides_.of(v).choice && !(sides_.of(v) == open_)) return true;  // its side has it
        if (!sides_.is_choice(v)) return false;
        const Side outer = open_;
        const auto args = from_.args(v);
        copy.to.set_origin(from_[v].origin);
        std::array<Value, 2> results;
        const Value structure = copy.to.begin_if(copy.map[args[0].index]);
        for (std::uint32_t side = 0; side < 2; ++side) {
            if (side == 1) copy.to.begin_else();
            open_ = {v, side + 1};
            const std::vector<Value>& inside = sides_.values_in(open_);
            std::for_each(inside.rbegin(), inside.rend(), [&](Value each) { copy_inst(copy, each); });
            results[side] = copy.map[args[side + 1].index];
        }
        open_ = outer;
        copy.to.set_origin(from_[v].origin);
        copy.to.end_if(std::span(&results[0], 1), std::span(&results[1], 1));
        copy.map[v.index] = copy.to.result(structure, 0);
        copy.to.name(copy.map[v.index], from_[v].name);
        return true;
    }

private:
    const Function& from_;
    const Sides& sides_;
    Side open_{};
};

}  // namespace

Function rewritten(Module& module, const Function& old, const std::function<bool(Copy&, const Value&)>& rewrite) {
    Function made = shell(old);
    Builder builder(module, made);
    Copy copy{.from = old, .to = builder, .rewrite = rewrite};
    copy_body(copy);
    return made;
}

std::vector<std::uint8_t> keyword_values(const Module& module, const Function& function) {
    std::vector<std::uint8_t> marks(function.insts.size(), 0);
    if (module.keywords.empty()) return marks;
    // 1: constant, 2: made of keywords
    for (const Block& block : function.blocks) {
        for (const Value v : block.insts) {
            const Inst& inst = function[v];
            if (inst.op == Op::Constant) marks[v.index] = 1;
            if (inst.op == Op::Global && module.globals[inst.data].is_keyword()) marks[v.index] = 2;
            const bool is_logic = inst.op == Op::Equal || inst.op == Op::NotEqual || inst.op == Op::Not ||
                                  inst.op == Op::And || inst.op == Op::Or;
            const auto args = function.args(inst);
            if (!is_logic || !inst.type.is_scalar()) continue;
            const bool all = std::all_of(args.begin(), args.end(), [&](Value arg) { return marks[arg.index] != 0; });
            const bool any = std::any_of(args.begin(), args.end(), [&](Value arg) { return marks[arg.index] == 2; });
            if (all && any) marks[v.index] = 2;
        }
    }
    for (std::uint8_t& mark : marks) mark = mark == 2 ? 1 : 0;
    return marks;
}

Module branch_on_keywords(Module module) {
    if (module.keywords.empty()) return module;
    for (Function& function : module.functions) {
        const Function old = function;
        const Sides sides(module, old);
        if (!sides.has_any()) continue;
        const Function chosen = guarded(module, old, sides);
        const Sides all(module, chosen);
        Brancher brancher(chosen, all);
        function = rewritten(module, chosen, [&](Copy& c, Value v) { return brancher.rewrite(c, v); });
    }
    return module;
}

}  // namespace patina::ir
