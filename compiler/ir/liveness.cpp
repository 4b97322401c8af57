#include "compiler/ir/liveness.h"

#include <utility>

namespace patina::ir {
namespace {

class Search {
public:
    explicit Search(const Function& function)
        : function_(function),
          live_{.values = std::vector<std::uint8_t>(function.insts.size()),
                .operands = std::vector<std::uint8_t>(function.operands.size())},
          owners_(function.insts.size()) {
        for (std::uint32_t i = 0; i < function.insts.size(); i++) {
            if (function.insts[i].op != Op::For) continue;
            const std::vector<Value>& body = function.blocks[function.insts[i].data].insts;
            for (std::uint32_t k = 0; k + 1 < function.insts[i].operand_count; k++) owners_[body[k].index] = {i};
        }
    }

    Liveness run() {
        for (const Value value : function_.blocks[0].insts) {
            if (has(function_[value].op, Effect)) need(value);
        }
        while (!work_.empty()) {
            const Value value = work_.back();
            work_.pop_back();
            visit(value);
        }
        return std::move(live_);
    }

private:
    void need(Value value) {
        if (std::exchange(live_.values[value.index], std::uint8_t{1}) == 0) work_.push_back(value);
    }

    void need_yielded(std::uint32_t block, std::uint32_t index) {
        const Inst& yield = function_[function_.blocks[block].insts.back()];
        live_.operands[yield.first_operand + index] = 1;
        need(function_.args(yield)[index]);
    }

    void need_carried(const Inst& loop, std::uint32_t index) {
        need(function_.args(loop)[index + 2]);
        need_yielded(loop.data, index);
    }

    void visit(Value value) {
        const Inst& inst = function_[value];
        const auto args = function_.args(inst);
        if (inst.op == Op::LoopIndex || inst.op == Op::LoopCarried) {
            need(owners_[value.index]);
            if (inst.op == Op::LoopCarried) need_carried(function_[owners_[value.index]], inst.data);
            return;
        }
        if (inst.op == Op::Result) {
            need(args[0]);
            const Inst& structure = function_[args[0]];
            if (structure.op == Op::For) return need_carried(structure, inst.data);
            need_yielded(structure.data, inst.data);
            return need_yielded(structure.data + 1, inst.data);
        }
        // A loop's initial values are needed by what is carried.
        const std::size_t count = inst.op == Op::For ? 2 : args.size();
        for (std::size_t i = 0; i < count; i++) need(args[i]);
        if (inst.is_while) need_carried(inst, inst.operand_count - 3);
    }

    const Function& function_;
    Liveness live_;
    std::vector<Value> owners_;  // of LoopIndex and LoopCarried: the For
    std::vector<Value> work_;
};

}  // namespace

Liveness live_in(const Function& function) {
    return Search(function).run();
}

}  // namespace patina::ir
