#include <algorithm>

#include "compiler/ir/passes/passes.h"

namespace patina::ir {
namespace {

Rate leaf_rate(const Module& module, const Function& function, const Inst& inst) {
    if (inst.op == Op::Param) return function.params[inst.data].rate;
    if (inst.op == Op::Semantic) return module.semantics[inst.data].rate;
    return inst.op == Op::Global ? Rate::Uniform : Rate::Constant;
}

// By function: the rate of the values that it reads, without its parameters.
std::vector<Rate> own_rates(const Module& module) {
    std::vector<Rate> own;
    for (const Function& function : module.functions) {
        Rate rate = Rate::Constant;
        for (const Inst& inst : function.insts) {
            if (inst.op == Op::Global || inst.op == Op::Semantic)
                rate = std::max(rate, leaf_rate(module, function, inst));
            if (inst.op == Op::Call && inst.data < own.size()) rate = std::max(rate, own[inst.data]);
        }
        own.push_back(rate);
    }
    return own;
}

class Walk {
public:
    Walk(const Module& module, const Function& function)
        : module_(module), function_(function), rates_(function.insts.size()), within_(function.insts.size()) {}

    // The values that a loop carries depend on the end of its body, so this is repeated until no rate rises.
    // Each loop has one rate, so this takes a few rounds for each level of nesting.
    std::vector<Rate> run() {
        do {
            has_risen_ = false;
            Rate within = Rate::Constant;
            block(0, Value(), within);
        } while (has_risen_);
        return rates_;
    }

private:
    // `within` gathers the highest rate below Light that the block makes or reads.
    void block(std::uint32_t index, Value loop, Rate& within) {
        const auto gather = [&](Value v) {
            if (rates_[v.index] < Rate::Light) within = std::max(within, rates_[v.index]);
        };
        for (const Value value : function_.blocks[index].insts) {
            raise(value, rate(value, loop, within));
            gather(value);
            for (const Value arg : function_.args(value)) gather(arg);
        }
    }

    Rate rate(Value value, Value loop, Rate& within) {
        const Inst& inst = function_[value];
        Rate highest = leaf_rate(module_, function_, inst);
        for (const Value arg : function_.args(inst)) highest = std::max(highest, rates_[arg.index]);
        if (inst.op == Op::If) return branch(inst, loop, highest, within);
        if (inst.op == Op::For) return this->loop(value, highest, within);
        if (inst.op == Op::LoopIndex || inst.op == Op::LoopCarried) return rates_[loop.index];
        if (inst.op == Op::Call) return std::max(highest, own(inst.data));
        // A result of the loop over lights is the same for all lights.
        const bool leaves_lights = inst.op == Op::Result && function_[function_.args(inst)[0]].is_light_loop;
        return leaves_lights ? within_[function_.args(inst)[0].index] : highest;
    }

    Rate branch(const Inst& inst, Value loop, Rate highest, Rate& within) {
        for (const std::uint32_t index : {inst.data, inst.data + 1}) {
            block(index, loop, within);
            highest = std::max(highest, yield_rate(index));
        }
        return highest;
    }

    Rate loop(Value value, Rate highest, Rate& within) {
        const Inst& inst = function_[value];
        raise(value, inst.is_light_loop ? Rate::Light : highest);
        Rate inside = std::min(highest, Rate::Pixel);
        block(inst.data, value, inside);
        within_[value.index] = inside;
        within = std::max(within, inside);
        return std::max(rates_[value.index], yield_rate(inst.data));
    }

    Rate yield_rate(std::uint32_t index) const { return rates_[function_.blocks[index].insts.back().index]; }

    Rate own(std::uint32_t callee) {
        if (own_.empty()) own_ = own_rates(module_);
        return own_[callee];
    }

    void raise(Value value, Rate rate) {
        if (rate <= rates_[value.index]) return;
        rates_[value.index] = rate;
        has_risen_ = true;
    }

    const Module& module_;
    const Function& function_;
    std::vector<Rate> rates_;
    std::vector<Rate> within_;  // of light loops: what their results have
    std::vector<Rate> own_;
    bool has_risen_ = false;
};

}  // namespace

std::vector<Rate> rates(const Module& module, const Function& function) {
    return Walk(module, function).run();
}

}  // namespace patina::ir
