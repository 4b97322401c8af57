#include <algorithm>
#include <array>
#include <utility>

#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

// A side of a choice: the Select, and which of its two values.
struct Side {
    Value choice{};
    std::uint32_t index = 0;
    friend bool operator==(const Side&, const Side&) = default;
};

class Brancher {
public:
    Brancher(const Module& module, const Function& from)
        : from_(from),
          depends_(keyword_values(module, from)),
          uses_(from.insts.size()),
          block_of_(from.insts.size()),
          side_(from.insts.size()),
          in_side_(from.insts.size()) {
        for (std::uint32_t i = 0; i < from.insts.size(); ++i) {
            const auto args = from.args(from.insts[i]);
            for (std::uint32_t k = 0; k < args.size(); ++k) uses_[args[k].index].push_back({{i}, k});
        }
        for (std::uint32_t b = 0; b < from.blocks.size(); ++b) {
            for (const Value v : from.blocks[b].insts) block_of_[v.index] = b;
        }
        for (std::uint32_t b = 0; b < from.blocks.size(); ++b) find_sides(b);
    }

    bool has_any() const { return has_any_; }

    bool rewrite(Copy& copy, Value v) {
        if (side_[v.index].choice && !(side_[v.index] == open_)) return true;  // its side has it
        if (!is_choice(v)) return false;
        const Side outer = open_;
        const auto args = from_.args(v);
        copy.to.set_origin(from_[v].origin);
        std::array<Value, 2> results;
        const Value structure = copy.to.begin_if(copy.map[args[0].index]);
        for (std::uint32_t side = 0; side < 2; ++side) {
            if (side == 1) copy.to.begin_else();
            open_ = {v, side + 1};
            const std::vector<Value>& inside = in_side_[v.index][side];
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
    struct Use {
        Value by{};
        std::uint32_t operand = 0;
    };

    bool is_choice(Value v) const {
        return from_[v].op == Op::Select && from_[v].type.is_numeric() && depends_[from_.args(v)[0].index] != 0;
    }

    // From the last instruction to the first: all that use a value have their side by then.
    void find_sides(std::uint32_t block) {
        const std::vector<Value>& insts = from_.blocks[block].insts;
        for (auto v = insts.rbegin(); v != insts.rend(); ++v) {
            if (is_choice(*v)) has_any_ = true;
            const Op op = from_[*v].op;
            const bool may_move = !has(op, Effect) && !has(op, Structure) && op != Op::Result && op != Op::Constant &&
                                  op != Op::Param && op != Op::Global && op != Op::Semantic && depends_[v->index] == 0;
            const Side side = may_move ? only_side(*v) : Side{};
            if (!side.choice) continue;
            side_[v->index] = side;
            in_side_[side.choice.index][side.index - 1].push_back(*v);  // the last first
        }
    }

    // The side that an operand is needed in, and those around it.
    std::vector<Side> sides_of(const Use& use) const {
        std::vector<Side> sides;
        Side side = is_choice(use.by) && use.operand > 0 ? Side{use.by, use.operand} : side_[use.by.index];
        for (; side.choice; side = side_[side.choice.index]) sides.push_back(side);
        return sides;
    }

    // The innermost side that all uses of a value are in, or none.
    Side only_side(Value v) const {
        std::vector<Side> common;
        bool is_first = true;
        for (const Use& use : uses_[v.index]) {
            if (block_of_[use.by.index] != block_of_[v.index]) return {};
            const std::vector<Side> sides = sides_of(use);
            if (std::exchange(is_first, false)) common = sides;
            std::erase_if(common, [&](const Side& side) { return std::ranges::count(sides, side) == 0; });
        }
        return common.empty() ? Side{} : common.front();
    }

    const Function& from_;
    std::vector<std::uint8_t> depends_;
    std::vector<std::vector<Use>> uses_;
    std::vector<std::uint32_t> block_of_;
    std::vector<Side> side_;                                  // by value; no choice: it stays where it is
    std::vector<std::array<std::vector<Value>, 2>> in_side_;  // by choice
    Side open_{};
    bool has_any_ = false;
};

}  // namespace

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
        Function old = function;
        Brancher brancher(module, old);
        if (!brancher.has_any()) continue;
        Function made = shell(old);
        Builder builder(module, made);
        Copy copy{.from = old, .to = builder, .rewrite = [&](Copy& c, Value v) { return brancher.rewrite(c, v); }};
        copy_body(copy);
        function = std::move(made);
    }
    return module;
}

}  // namespace patina::ir
