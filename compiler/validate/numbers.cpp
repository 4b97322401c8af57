#include "compiler/validate/numbers.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace patina::spirv {
namespace {

using Ids = std::unordered_set<std::uint32_t>;

// How many numbers a value of each type is. A type is declared after those that it is made of.
class Sizes {
public:
    explicit Sizes(const Spirv& module) {
        std::unordered_map<std::uint32_t, std::uint32_t> constants;
        for (const Instruction& at : module.instructions) {
            if (at.op == spv::OpConstant) constants[at.result] = at.operands()[0];
            if (at.op == spv::OpFunction) return;
            const std::span<const std::uint32_t> operands = at.operands();
            if (at.op == spv::OpTypeInt || at.op == spv::OpTypeFloat || at.op == spv::OpTypeBool) of_[at.result] = 1;
            if (at.op == spv::OpTypeVector || at.op == spv::OpTypeMatrix)
                of_[at.result] = of_[operands[0]] * operands[1];
            if (at.op == spv::OpTypeArray) of_[at.result] = of_[operands[0]] * std::max(constants[operands[1]], 1u);
            if (at.op == spv::OpTypeStruct)
                for (const std::uint32_t member : operands) of_[at.result] += of_[member];
            if (at.op == spv::OpTypePointer) pointees_[at.result] = operands[1];
        }
    }
    std::uint32_t of(std::uint32_t type) const {
        const auto found = of_.find(type);
        return found == of_.end() ? 0 : found->second;
    }
    std::uint32_t of_variable(std::uint32_t pointer) const {
        const auto found = pointees_.find(pointer);
        return found == pointees_.end() ? 0 : of(found->second);
    }

private:
    std::unordered_map<std::uint32_t, std::uint32_t> of_, pointees_;
};

class Liveness {
public:
    explicit Liveness(const Spirv& module) : module_(module) {
        const Sizes sizes(module);
        for (Function& function : functions_of(module)) {
            for (std::size_t i = function.begin; i < function.end; ++i) {
                const Instruction& at = module.instructions[i];
                if (at.op == spv::OpVariable)
                    variables_[function.id] += sizes.of_variable(at.type);
                else if (at.op != spv::OpFunction && sizes.of(at.type) > 0)
                    numbers_[at.result] = sizes.of(at.type);
            }
            functions_.emplace(function.id, std::move(function));
        }
    }

    // SPIR-V has no recursion.
    std::uint32_t most(std::uint32_t id) const {
        const auto found = functions_.find(id);
        if (found == functions_.end()) return 0;
        const Function& function = found->second;
        const LiveIn live_in = find_live_in(function);
        std::uint32_t most = 0;
        for (const Block& block : function.blocks) {
            Ids live = live_out(function, block, live_in);
            most = std::max(most, sum(live));
            for (std::size_t i = block.end; i-- > block.begin;) {
                const Instruction& at = module_.instructions[i];
                live.erase(at.result);
                if (at.op == spv::OpFunctionCall) most = std::max(most, sum(live) + this->most(at.words[3]));
                read(at, live);
                most = std::max(most, sum(live));
            }
        }
        const auto variables = variables_.find(id);
        return most + (variables == variables_.end() ? 0 : variables->second);
    }

private:
    using LiveIn = std::unordered_map<std::uint32_t, Ids>;  // by label

    LiveIn find_live_in(const Function& function) const {
        LiveIn live_in;
        for (bool changes = true; changes;) {
            changes = false;
            for (auto block = function.blocks.rbegin(); block != function.blocks.rend(); ++block) {
                Ids live = live_out(function, *block, live_in);
                for (std::size_t i = block->end; i-- > block->begin;) {
                    live.erase(module_.instructions[i].result);
                    read(module_.instructions[i], live);
                }
                if (live.size() == live_in[block->label].size()) continue;  // it only grows
                live_in[block->label] = std::move(live);
                changes = true;
            }
        }
        return live_in;
    }

    // What the blocks after it need: their own needs, and the operands of their phis that come from this block.
    Ids live_out(const Function& function, const Block& block, const LiveIn& live_in) const {
        Ids live;
        for (const std::uint32_t label : block.successors) {
            const auto found = live_in.find(label);
            if (found != live_in.end()) live.insert(found->second.begin(), found->second.end());
            const auto next = std::ranges::find(function.blocks, label, &Block::label);
            if (next == function.blocks.end()) continue;
            for (std::size_t i = next->begin; i < next->end; ++i) {
                const Instruction& at = module_.instructions[i];
                if (at.op != spv::OpPhi) continue;
                const std::span<const std::uint32_t> pairs = at.operands();
                for (std::size_t k = 0; k + 1 < pairs.size(); k += 2)
                    if (pairs[k + 1] == block.label && numbers_.contains(pairs[k])) live.insert(pairs[k]);
            }
        }
        return live;
    }

    // The operands of a phi are alive at the ends of other blocks.
    void read(const Instruction& at, Ids& live) const {
        if (at.op == spv::OpPhi) return;
        for (const std::uint16_t word : at.reads)
            if (numbers_.contains(at.words[word])) live.insert(at.words[word]);
    }

    std::uint32_t sum(const Ids& live) const {
        std::uint32_t all = 0;
        for (const std::uint32_t id : live) all += numbers_.at(id);
        return all;
    }

    const Spirv& module_;
    std::unordered_map<std::uint32_t, Function> functions_;
    std::unordered_map<std::uint32_t, std::uint32_t> numbers_;    // by value of a function
    std::unordered_map<std::uint32_t, std::uint32_t> variables_;  // by function
};

}  // namespace

std::uint32_t live_numbers(const Spirv& module) {
    return Liveness(module).most(entry_of(module));
}

std::uint32_t interface_numbers(const Spirv& module, spv::StorageClass storage) {
    const Sizes sizes(module);
    Ids located;
    std::uint32_t numbers = 0;
    for (const Instruction& at : module.instructions) {
        if (at.op == spv::OpFunction) break;
        if (at.op == spv::OpDecorate && at.words[2] == spv::DecorationLocation) located.insert(at.words[1]);
        if (at.op == spv::OpVariable && at.operands()[0] == std::uint32_t(storage) && located.contains(at.result))
            numbers += sizes.of_variable(at.type);
    }
    return numbers;
}

}  // namespace patina::spirv
