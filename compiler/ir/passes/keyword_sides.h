// Where a function chooses between two values by keywords, and which values only one side of such a choice needs.
// Private to branch_on_keywords.cpp and keyword_guards.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {

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
    // The side that alone needs the value; if its choice is null, the value stays where it is.
    Side of(Value v) const { return side_[v.index]; }
    // The values that move to the side, the last one first.
    const std::vector<Value>& values_in(Side side) const { return in_side_[side.choice.index][side.index - 1]; }

    // For each use of a value, the sides that it is in, from the innermost on. A part of the value counts by its uses.
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

    // True if only `reader` uses the value.
    bool is_only_for(Value v, Value reader) const {
        const std::vector<Use> uses = uses_of(v);
        return std::all_of(uses.begin(), uses.end(), [&](const Use& use) { return use.by == reader; });
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
        const auto& insts = from_.blocks[block].insts;
        return std::any_of(insts.begin(), insts.end(), [&](Value v) {
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

    // The instruction of the block that is the value, or that contains it.
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
            std::erase_if(common, [&](const Side& side) { return std::count(sides.begin(), sides.end(), side) == 0; });
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

// Moves costly values that only several sides need under the narrowest of the sides' conditions, or of a few of these
// together. Elsewhere the value is zero. `from` is a function of `module`.
Function guarded(Module& module, const Function& from, const Sides& sides);

// A copy through `rewrite` (rebuild.h).
Function rewritten(Module& module, const Function& old, const std::function<bool(Copy&, const Value&)>& rewrite);

}  // namespace patina::ir
