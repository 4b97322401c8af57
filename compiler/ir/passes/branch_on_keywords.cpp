#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

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

// Where the sides of choices between keywords are, and which of them need a value.
class Sides {
public:
    Sides(const Module& module, const Function& function)
        : from_(function),
          depends_(keyword_values(module, function)),
          uses_(function.insts.size()),
          results_(function.insts.size()),
          block_of_(function.insts.size()),
          owner_(function.blocks.size()),
          side_(function.insts.size()),
          in_side_(function.insts.size()) {
        for (std::uint32_t i = 0; i < from_.insts.size(); ++i) {
            const auto args = from_.args(from_.insts[i]);
            for (std::uint32_t k = 0; k < args.size(); ++k) uses_[args[k].index].push_back({{i}, k});
            if (from_.insts[i].op == Op::Result) results_[args[0].index].push_back({i});
        }
        for (std::uint32_t b = 0; b < from_.blocks.size(); ++b) {
            for (const Value v : from_.blocks[b].insts) {
                block_of_[v.index] = b;
                const Op op = from_[v].op;
                if (op == Op::If || op == Op::For) owner_[from_[v].data] = v;
                if (op == Op::If) owner_[from_[v].data + 1] = v;
            }
        }
        for (std::uint32_t b = 0; b < from_.blocks.size(); ++b) find_sides(b);
    }

    bool has_any() const { return has_any_; }
    bool is_choice(Value v) const {
        return from_[v].op == Op::Select && from_[v].type.is_numeric() && depends_[from_.args(v)[0].index] != 0;
    }
    // The one that alone needs the value; no choice: it stays where it is.
    Side of(Value v) const { return side_[v.index]; }
    // What moves there, the last first.
    const std::vector<Value>& values_in(Side side) const { return in_side_[side.choice.index][side.index - 1]; }

    // Of each use of a value the sides that it is in, from the innermost on; of a part of it, the part's uses.
    std::vector<std::vector<Side>> around_uses(Value v, bool of_parts) const {
        std::vector<std::vector<Side>> around;
        for (const Use& use : uses_of(v)) {
            around.push_back(sides_of(use, block_of_[v.index]));
            const Inst& by = from_[use.by];
            const bool is_part =
                by.op == Op::Extract || by.op == Op::Swizzle || (by.op == Op::Construct && by.operand_count == 1);
            if (!of_parts || !is_part || !around.back().empty()) continue;
            around.pop_back();
            for (std::vector<Side>& each : around_uses(use.by, true)) around.push_back(std::move(each));
        }
        return around;
    }

private:
    struct Use {
        Value by{};
        std::uint32_t operand = 0;
    };

    // Of an If or For those of its results.
    std::vector<Use> uses_of(Value v) const {
        if (!has(from_[v].op, Structure)) return uses_[v.index];
        std::vector<Use> uses;
        for (const Value result : results_[v.index])
            uses.insert(uses.end(), uses_[result.index].begin(), uses_[result.index].end());
        return uses;
    }

    bool has_effect(std::uint32_t block) const {
        return std::ranges::any_of(from_.blocks[block].insts, [&](Value v) {
            const Inst& inst = from_[v];
            if (inst.op == Op::If) return has_effect(inst.data) || has_effect(inst.data + 1);
            return inst.op == Op::For ? has_effect(inst.data) : inst.op != Op::Yield && has(inst.op, Effect);
        });
    }
    bool may_move(Value v) const {
        const Inst& inst = from_[v];
        if (inst.op == Op::If || inst.op == Op::For)
            return !has_effect(inst.data) && (inst.op == Op::For || !has_effect(inst.data + 1));
        return !has(inst.op, Effect) && !has(inst.op, Structure) && inst.op != Op::Result && inst.op != Op::Constant &&
               inst.op != Op::Param && inst.op != Op::Global && inst.op != Op::Semantic && depends_[v.index] == 0;
    }

    // From the last instruction to the first: all that use a value have their side by then.
    void find_sides(std::uint32_t block) {
        const std::vector<Value>& insts = from_.blocks[block].insts;
        for (auto v = insts.rbegin(); v != insts.rend(); ++v) {
            if (is_choice(*v)) has_any_ = true;
            const Side side = may_move(*v) ? only_side(*v) : Side{};
            if (!side.choice) continue;
            std::vector<Value>& inside = in_side_[side.choice.index][side.index - 1];
            for (const Value result : results_[v->index]) {
                side_[result.index] = side;
                inside.push_back(result);
            }
            side_[v->index] = side;
            inside.push_back(*v);
        }
    }

    // What stands in the block and holds the value.
    Value holder(Value v, std::uint32_t block) const {
        while (v && block_of_[v.index] != block) v = owner_[block_of_[v.index]];
        return v;
    }

    // The side that an operand is needed in, and those around it.
    std::vector<Side> sides_of(const Use& use, std::uint32_t block) const {
        std::vector<Side> sides;
        const Value by = holder(use.by, block);
        if (!by) return {};
        Side side = by == use.by && is_choice(by) && use.operand > 0 ? Side{by, use.operand} : side_[by.index];
        for (; side.choice; side = side_[side.choice.index]) sides.push_back(side);
        return sides;
    }

    // The innermost side that all uses of a value are in, or none.
    Side only_side(Value v) const {
        const std::vector<std::vector<Side>> around = around_uses(v, false);
        if (around.empty()) return {};
        std::vector<Side> common = around.front();
        for (const std::vector<Side>& sides : around)
            std::erase_if(common, [&](const Side& side) { return std::ranges::count(sides, side) == 0; });
        return common.empty() ? Side{} : common.front();
    }

    const Function& from_;
    std::vector<std::uint8_t> depends_;
    std::vector<std::vector<Use>> uses_;
    std::vector<std::vector<Value>> results_;  // by structure
    std::vector<std::uint32_t> block_of_;
    std::vector<Value> owner_;  // by block: its If or For
    std::vector<Side> side_;
    std::vector<std::array<std::vector<Value>, 2>> in_side_;  // by choice
    bool has_any_ = false;
};

// --- values that several sides need, and nothing else

// What must hold where a value is needed: a condition, or that it does not.
struct Guard {
    Value condition{};
    bool holds = true;
    friend bool operator==(const Guard&, const Guard&) = default;
};

class Guards {
public:
    Guards(const Function& from, const Sides& sides) : from_(from), sides_(sides) {}

    bool rewrite(Copy& copy, Value v) {
        if (!is_worth_it(v)) return false;
        const std::vector<Guard> guards = guards_of(v);
        if (guards.empty()) return false;
        copy_plain(copy, v);
        const Value made = copy.map[v.index];
        Value needed;
        for (const Guard& guard : guards) {
            Value one = repeated(copy, guard.condition);
            if (!guard.holds) one = copy.to.emit(Op::Not, {one});
            needed = needed ? copy.to.emit(Op::Or, {needed, one}) : one;
        }
        const Type type = copy.to.type(made);
        copy.map[v.index] = copy.to.emit(Op::Select, type, {needed, made, copy.to.zero(type)});
        copy.to.name(copy.map[v.index], from_[v].name);
        return true;
    }

private:
    bool is_worth_it(Value v) const {
        const Inst& inst = from_[v];
        const bool is_loop = inst.op == Op::Result && from_[from_.args(v)[0]].op == Op::For;
        const bool is_work = inst.op == Op::Call || info(inst.op).rule == TypeRule::Texel || is_loop;
        return is_work && inst.type.is_numeric() && !inst.type.is_matrix() && !sides_.of(v).choice;
    }

    std::vector<Guard> guards_of(Value v) const {
        std::vector<std::vector<Guard>> ways;
        for (const std::vector<Side>& around : sides_.around_uses(v, true)) {
            ways.emplace_back();
            for (const Side& side : around) ways.back().push_back({from_.args(side.choice)[0], side.index == 1});
            if (around.empty()) return {};
        }
        if (ways.size() < 2) return {};
        // A condition that all have in common, or that of each.
        for (const Guard& guard : ways.front()) {
            const bool is_common =
                std::ranges::all_of(ways, [&](const auto& way) { return std::ranges::count(way, guard) > 0; });
            if (is_common) return {guard};
        }
        std::vector<Guard> any;
        for (const std::vector<Guard>& way : ways) {
            if (std::ranges::count(any, way.back()) == 0) any.push_back(way.back());
        }
        std::erase_if(any, [&](const Guard& guard) {
            return std::ranges::any_of(any, [&](const Guard& other) { return is_a_part_of(guard, other); });
        });
        return any.size() <= kMostGuards ? any : std::vector<Guard>{};
    }

    // `a` of `a || b`
    bool is_a_part_of(const Guard& guard, const Guard& other) const {
        if (!guard.holds || !other.holds || from_[other.condition].op != Op::Or) return false;
        return std::ranges::count(from_.args(other.condition), guard.condition) > 0;
    }

    // A condition of keywords, where it may not have been computed yet.
    Value repeated(Copy& copy, Value condition) const {
        const Inst& inst = from_[condition];
        std::vector<Value> operands;
        for (const Value arg : from_.args(inst)) operands.push_back(repeated(copy, arg));
        if (inst.op == Op::Constant) {
            const auto numbers = copy.to.module().numbers_of(copy.to.module().constants[inst.data]);
            return copy.to.constant(inst.type, std::vector<double>(numbers.begin(), numbers.end()));
        }
        return copy.to.emit(inst.op, inst.type, operands, inst.data);
    }

    static constexpr std::size_t kMostGuards = 3;
    const Function& from_;
    const Sides& sides_;
};

// --- the branches

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

Function rewritten(Module& module, const Function& old, const std::function<bool(Copy&, Value)>& rewrite) {
    Function made = shell(old);
    Builder builder(module, made);
    Copy copy{.from = old, .to = builder, .rewrite = rewrite};
    copy_body(copy);
    return made;
}

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
        const Function old = function;
        const Sides sides(module, old);
        if (!sides.has_any()) continue;
        Guards guards(old, sides);
        const Function guarded = rewritten(module, old, [&](Copy& c, Value v) { return guards.rewrite(c, v); });
        const Sides all(module, guarded);
        Brancher brancher(guarded, all);
        function = rewritten(module, guarded, [&](Copy& c, Value v) { return brancher.rewrite(c, v); });
    }
    return module;
}

}  // namespace patina::ir
