#include "compiler/ir/passes/dependence.h"

#include <algorithm>
#include <array>

#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

class Walk {
public:
    Walk(const Function& function, std::uint64_t params, Globals globals)
        : function_(function), params_(params), globals_(globals), settled_(function.insts.size()) {}

    std::vector<std::uint8_t> run() {
        block(0);
        return std::move(settled_);
    }

private:
    void block(std::uint32_t index) {
        for (const Value value : function_.blocks[index].insts) {
            const Inst& inst = function_[value];
            if (inst.op == Op::If) {
                block(inst.data);
                block(inst.data + 1);
            } else if (inst.op == Op::For) {
                block(inst.data);
            }
            settled_[value.index] = is_settled(inst) ? 1 : 0;
        }
    }

    bool is_settled(const Inst& inst) const {
        const auto args = function_.args(inst);
        const bool operands = std::all_of(args.begin(), args.end(), [&](Value v) { return settled_[v.index] != 0; });
        if (inst.op == Op::Param) return inst.data < kMaxSettledParams && (params_ >> inst.data & 1u) != 0;
        if (inst.op == Op::Global) return globals_ == Globals::Settled;
        if (inst.op == Op::Semantic || inst.op == Op::LoopIndex || inst.op == Op::LoopCarried) return false;
        if (inst.op != Op::Result) return operands;
        // The result of an If is settled if both values are; the result of a loop is not.
        const Inst& structure = function_[args[0]];
        return operands && structure.op == Op::If && yields(structure.data, inst.data) &&
               yields(structure.data + 1, inst.data);
    }

    bool yields(std::uint32_t block, std::uint32_t index) const {
        return settled_[yielded(function_, block)[index].index] != 0;
    }

    const Function& function_;
    const std::uint64_t params_;
    const Globals globals_;
    std::vector<std::uint8_t> settled_;
};

}  // namespace

std::vector<std::uint8_t> settled(const Function& function, std::uint64_t params, Globals globals) {
    return Walk(function, params, globals).run();
}

bool is_work(Op op) {
    constexpr auto kIsFree = [] {
        std::array<bool, kOpCount> is_free{};
        for (const Op free :
             {Op::Constant, Op::Param, Op::Global, Op::Semantic, Op::Construct, Op::Extract, Op::Insert, Op::Swizzle,
              Op::Convert, Op::LoopIndex, Op::LoopCarried, Op::Result, Op::Yield, Op::Return, Op::Neg}) {
            is_free[static_cast<std::size_t>(free)] = true;
        }
        return is_free;
    }();
    return !kIsFree[static_cast<std::size_t>(op)];
}

bool is_follower(const Module& module, const Function& function) {
    return std::any_of(module.globals.begin(), module.globals.end(), [&](const Global& global) {
        return !global.follower.empty() && global.follower == function.name;
    });
}

}  // namespace patina::ir
