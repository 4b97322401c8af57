// live_registers(): a liveness analysis, backwards over the blocks of each function until nothing changes.
#include <algorithm>
#include <glslang/SPIRV/spirv.hpp>
#include <span>

#include "compiler/validate/counts.h"

namespace patina {
namespace {

using Id = std::uint32_t;
using Insts = std::vector<const SpirvInst*>;

struct Block {
    Insts insts{};  // without its label
    std::vector<Id> successors{};
    std::vector<bool> live_in{};  // by value; what its phis make is not among it
};

bool is_phi(const SpirvInst& inst) {
    return inst.op == spv::OpPhi;
}

class Function {
public:
    Function(const ComponentCounts& components, const Insts& insts) : components_(components) {
        Block* block = nullptr;
        for (const SpirvInst* inst : insts) {
            const bool is_variable = inst->op == spv::OpVariable;
            if (is_variable) in_memory_ += components.behind(inst->type);
            if (const std::uint32_t width = components.of(inst->type);
                width > 0 && inst->op != spv::OpFunction && inst->op != spv::OpUndef) {
                index_[inst->result] = widths_.size();
                widths_.push_back(width);
            }
            if (inst->op == spv::OpLabel) {
                order_.push_back(inst->result);
                block = &blocks_[inst->result];
            } else if (block) {
                block->insts.push_back(inst);
                add_successors(*inst, block->successors);
            }
        }
        for (auto& [label, each] : blocks_) each.live_in.resize(widths_.size());
    }

    // `callee`: the registers of a function that is called.
    template <class Callee>
    std::uint32_t most(const Callee& callee) {
        for (bool changes = true; changes;) {
            changes = false;
            for (auto label = order_.rbegin(); label != order_.rend(); ++label) {
                std::vector<bool> live = live_out(*label);
                const Insts& insts = blocks_[*label].insts;
                for (auto inst = insts.rbegin(); inst != insts.rend(); ++inst) step(**inst, live);
                if (live == blocks_[*label].live_in) continue;
                blocks_[*label].live_in = std::move(live);
                changes = true;
            }
        }
        std::uint32_t most = 0;
        for (const Id label : order_) {
            std::vector<bool> live = live_out(label);
            most = std::max(most, width_of(live));
            const Insts& insts = blocks_[label].insts;
            for (auto inst = insts.rbegin(); inst != insts.rend() && !is_phi(**inst); ++inst) {
                const std::uint32_t inside = (*inst)->op == spv::OpFunctionCall ? callee((*inst)->word(3)) : 0;
                step(**inst, live);
                most = std::max(most, width_of(live) + inside);
            }
        }
        return most + in_memory_;
    }

private:
    static void add_successors(const SpirvInst& inst, std::vector<Id>& to) {
        if (inst.op == spv::OpBranch) to = {inst.word(1)};
        if (inst.op == spv::OpBranchConditional) to = {inst.word(2), inst.word(3)};
        if (inst.op != spv::OpSwitch) return;
        to = {inst.word(2)};
        for (std::size_t at = 4; at < inst.words.size(); at += 2) to.push_back(inst.word(at));
    }

    void set(std::vector<bool>& live, Id id, bool value) const {
        if (const auto found = index_.find(id); found != index_.end()) live[found->second] = value;
    }

    std::vector<bool> live_out(Id label) const {
        std::vector<bool> live(widths_.size());
        for (const Id successor : blocks_.at(label).successors) {
            const auto next = blocks_.find(successor);
            if (next == blocks_.end()) continue;
            for (std::size_t i = 0; i < live.size(); ++i)
                if (next->second.live_in[i]) live[i] = true;
            for (const SpirvInst* inst : next->second.insts) {
                if (!is_phi(*inst)) break;
                for (std::size_t at = 3; at + 1 < inst->words.size(); at += 2)
                    if (inst->words[at + 1] == label) set(live, inst->words[at], true);
            }
        }
        return live;
    }

    // From behind an instruction to before it. A phi reads its values where its predecessors end.
    void step(const SpirvInst& inst, std::vector<bool>& live) const {
        set(live, inst.result, false);
        if (is_phi(inst)) return;
        for (const std::uint16_t at : inst.ids) set(live, inst.words[at], true);
    }

    std::uint32_t width_of(const std::vector<bool>& live) const {
        std::uint32_t width = 0;
        for (std::size_t i = 0; i < live.size(); ++i)
            if (live[i]) width += widths_[i];
        return width;
    }

    const ComponentCounts& components_;
    std::map<Id, std::size_t> index_{};    // of values
    std::vector<std::uint32_t> widths_{};  // by index
    std::map<Id, Block> blocks_{};         // by label
    std::vector<Id> order_{};              // of the labels
    std::uint32_t in_memory_ = 0;
};

class Registers {
public:
    explicit Registers(const SpirvModule& module) : components_(module) {
        Insts* function = nullptr;
        for (const SpirvInst& inst : module.insts) {
            if (inst.op == spv::OpEntryPoint) entry_ = inst.word(2);
            if (inst.op == spv::OpFunction) function = &functions_[inst.result];
            if (function) function->push_back(&inst);
            if (inst.op == spv::OpFunctionEnd) function = nullptr;
        }
    }

    std::uint32_t of_entry() { return of(entry_); }

private:
    std::uint32_t of(Id id) {
        const auto known = known_.find(id);
        if (known != known_.end()) return known->second;
        const auto found = functions_.find(id);
        if (found == functions_.end()) return 0;
        return known_[id] = Function(components_, found->second).most([this](Id callee) { return of(callee); });
    }

    ComponentCounts components_;
    std::map<Id, Insts> functions_{};
    std::map<Id, std::uint32_t> known_{};
    Id entry_ = 0;
};

}  // namespace

std::uint32_t live_registers(const SpirvModule& module) {
    return Registers(module).of_entry();
}

}  // namespace patina
