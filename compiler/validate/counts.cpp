#include "compiler/validate/counts.h"

#include <glslang/SPIRV/GLSL.std.450.h>

#include <algorithm>
#include <glslang/SPIRV/spirv.hpp>
#include <iterator>
#include <set>
#include <span>

#include "compiler/validate/owners.h"

namespace patina {
namespace {

using Id = std::uint32_t;

template <std::size_t count>
bool is_one_of(std::uint32_t op, const std::uint32_t (&ops)[count]) {
    return std::find(std::begin(ops), std::end(ops), op) != std::end(ops);
}
bool is_between(std::uint32_t op, std::uint32_t first, std::uint32_t last) {
    return op >= first && op <= last;
}

// The ranges are those of the SPIR-V specification's sections: conversion, arithmetic, bit, relational and logical.
bool is_arithmetic(std::uint32_t op) {
    return is_between(op, spv::OpConvertFToU, spv::OpQuantizeToF16) || op == spv::OpBitcast ||
           is_between(op, spv::OpSNegate, spv::OpSMulExtended) ||
           is_between(op, spv::OpAny, spv::OpFUnordGreaterThanEqual) ||
           is_between(op, spv::OpShiftRightLogical, spv::OpBitCount) || op == spv::OpTranspose;
}
bool is_derivative(std::uint32_t op) {
    return is_between(op, spv::OpDPdx, spv::OpFwidthCoarse);
}
bool reads_texture(std::uint32_t op) {
    return is_between(op, spv::OpImageSampleImplicitLod, spv::OpImageRead);
}

// Of GLSL.std.450; its other instructions are arithmetic.
constexpr std::uint32_t kTranscendental[] = {
    GLSLstd450Sin,    GLSLstd450Cos,      GLSLstd450Tan,       GLSLstd450Asin,   GLSLstd450Acos,
    GLSLstd450Atan,   GLSLstd450Sinh,     GLSLstd450Cosh,      GLSLstd450Tanh,   GLSLstd450Asinh,
    GLSLstd450Acosh,  GLSLstd450Atanh,    GLSLstd450Atan2,     GLSLstd450Pow,    GLSLstd450Exp,
    GLSLstd450Log,    GLSLstd450Exp2,     GLSLstd450Log2,      GLSLstd450Sqrt,   GLSLstd450InverseSqrt,
    GLSLstd450Length, GLSLstd450Distance, GLSLstd450Normalize, GLSLstd450Refract};

CostCounts cost_of(const SpirvInst& inst) {
    CostCounts cost{.instructions = 1};
    if (inst.op == spv::OpExtInst)
        ++(is_one_of(inst.word(4), kTranscendental) ? cost.transcendental : cost.arithmetic);
    else if (reads_texture(inst.op))
        cost.textures = 1;
    else if (is_derivative(inst.op))
        cost.derivatives = 1;
    else if (is_arithmetic(inst.op))
        cost.arithmetic = 1;
    return cost;
}

CostCounts times(CostCounts cost, std::uint32_t factor) {
    for (const CostFigure& figure : kCostFigures) cost.*figure.count *= factor;
    return cost;
}

struct Counted {
    const SpirvInst* inst = nullptr;
    std::uint32_t line = 0;
    bool in_light_loop = false;
};
struct Function {
    std::vector<Counted> insts{};
    std::uint32_t once = 0, per_light = 0;  // how often it is called
};

class Counter {
public:
    Counter(const SpirvModule& module, std::size_t owners) : module_(module) { counts_.shares.resize(owners); }

    SpirvCounts run(Stage stage) {
        read_functions();
        for (auto& [id, function] : functions_) find_light_loops(function);
        for (const SpirvInst& inst : module_.insts)
            if (inst.op == spv::OpEntryPoint) count_calls(inst.word(2));
        for (const auto& [id, function] : functions_) add(function);
        for (const SpirvCounts::Share& share : counts_.shares) {
            counts_.total.once += share.once;
            counts_.total.per_light += share.per_light;
        }
        counts_.total.varyings = varyings(stage);
        counts_.total.registers = live_registers(module_);
        return std::move(counts_);
    }

private:
    void read_functions() {
        Function* function = nullptr;
        std::uint32_t line = 0;
        for (const SpirvInst& inst : module_.insts) {
            if (inst.op == spv::OpFunction) function = &functions_[inst.result];
            if (inst.op == spv::OpFunction) line = 0;
            if (inst.op == spv::OpLine) line = inst.word(2);
            if (function && inst.op != spv::OpLine && inst.op != spv::OpNoLine)
                function->insts.push_back({.inst = &inst, .line = line});
            if (inst.op == spv::OpFunctionEnd) function = nullptr;
        }
    }

    // A block: its instructions, and where it goes.
    struct Block {
        std::span<Counted> insts{};
        std::vector<Id> successors{};
        Id after_light_loop = 0;  // if it begins one
    };

    static std::map<Id, Block> blocks_of(Function& function) {
        std::map<Id, Block> blocks;
        for (std::size_t i = 0; i < function.insts.size(); ++i) {
            if (function.insts[i].inst->op != spv::OpLabel) continue;
            std::size_t end = i + 1;
            while (end < function.insts.size() && function.insts[end].inst->op != spv::OpLabel) ++end;
            Block& block = blocks[function.insts[i].inst->result];
            block.insts = std::span(function.insts).subspan(i, end - i);
            bool begins_light_loop = false;
            for (const Counted& each : block.insts) begins_light_loop |= is_light_loop_line(each.line);
            for (const Counted& each : block.insts) {
                const SpirvInst& inst = *each.inst;
                if (inst.op == spv::OpLoopMerge && begins_light_loop) block.after_light_loop = inst.word(1);
                if (inst.op == spv::OpBranch) block.successors = {inst.word(1)};
                if (inst.op == spv::OpBranchConditional) block.successors = {inst.word(2), inst.word(3)};
                if (inst.op != spv::OpSwitch) continue;
                block.successors = {inst.word(2)};
                for (std::size_t at = 4; at < inst.words.size(); at += 2) block.successors.push_back(inst.word(at));
            }
        }
        return blocks;
    }

    // A loop consists of the blocks that are reached from its header before its end.
    void find_light_loops(Function& function) {
        std::map<Id, Block> blocks = blocks_of(function);
        for (const auto& [label, header] : blocks) {
            if (header.after_light_loop == 0) continue;
            ++counts_.light_loops;
            std::set<Id> reached;
            std::vector<Id> work = {label};
            while (!work.empty()) {
                const Id at = work.back();
                work.pop_back();
                const auto block = blocks.find(at);
                if (at == header.after_light_loop || block == blocks.end() || !reached.insert(at).second) continue;
                for (Counted& each : block->second.insts) each.in_light_loop = true;
                work.insert(work.end(), block->second.successors.begin(), block->second.successors.end());
            }
        }
    }

    // Callers before what they call. SPIR-V has no recursion.
    void sort(Id id, std::vector<Id>& order, std::set<Id>& seen) const {
        const auto found = functions_.find(id);
        if (found == functions_.end() || !seen.insert(id).second) return;
        for (const Counted& each : found->second.insts)
            if (each.inst->op == spv::OpFunctionCall) sort(each.inst->word(3), order, seen);
        order.insert(order.begin(), id);
    }

    void count_calls(Id entry) {
        std::vector<Id> order;
        std::set<Id> seen;
        sort(entry, order, seen);
        if (!order.empty()) functions_[entry].once = 1;
        for (const Id id : order) {
            const Function& caller = functions_[id];
            for (const Counted& each : caller.insts) {
                const auto callee = functions_.find(each.inst->op == spv::OpFunctionCall ? each.inst->word(3) : 0);
                if (callee == functions_.end()) continue;
                callee->second.per_light += caller.per_light + (each.in_light_loop ? caller.once : 0);
                callee->second.once += each.in_light_loop ? 0 : caller.once;
            }
        }
    }

    void add(const Function& function) {
        for (const Counted& each : function.insts) {
            const std::size_t owner = std::min<std::size_t>(owner_of_line(each.line), counts_.shares.size() - 1);
            SpirvCounts::Share& share = counts_.shares[owner];
            const CostCounts cost = cost_of(*each.inst);
            (each.in_light_loop ? share.per_light : share.once) += times(cost, function.once);
            share.per_light += times(cost, function.per_light);
        }
    }

    // Variables with a location: inputs of the fragment stage, or outputs of the vertex stage.
    std::uint32_t varyings(Stage stage) const {
        const std::uint32_t side = stage == Stage::Vertex ? spv::StorageClassOutput : spv::StorageClassInput;
        const ComponentCounts components(module_);
        std::set<Id> located;
        std::uint32_t sum = 0;
        for (const SpirvInst& inst : module_.insts) {
            if (inst.op == spv::OpDecorate && inst.word(2) == spv::DecorationLocation) located.insert(inst.word(1));
            if (inst.op == spv::OpVariable && inst.word(3) == side && located.contains(inst.result))
                sum += components.behind(inst.type);
        }
        return sum;
    }

    const SpirvModule& module_;
    std::map<Id, Function> functions_{};
    SpirvCounts counts_{};
};

}  // namespace

SpirvCounts count(const std::vector<std::uint32_t>& spirv, Stage stage, std::size_t owners) {
    const std::optional<SpirvModule> module = read_module(spirv);
    if (!module) return {.shares = std::vector<SpirvCounts::Share>(owners)};
    return Counter(*module, owners).run(stage);
}

}  // namespace patina
