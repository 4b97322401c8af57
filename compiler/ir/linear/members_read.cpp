#include <algorithm>
#include <map>

#include "compiler/ir/linear/linear_part.h"
#include "compiler/ir/liveness.h"

namespace patina::ir {
namespace {

class Reads {
public:
    explicit Reads(const Module& module) : module_(module) {}

    std::vector<MemberRead> of(FunctionId id, std::uint32_t param) {
        const auto known = known_.find({id, param});
        if (known != known_.end()) return known->second;
        const Function& function = module_[id];
        const Liveness live = live_in(function);
        std::map<std::uint32_t, OriginId> found;
        for (std::uint32_t i = 0; i < function.insts.size(); i++) {
            const Inst& inst = function.insts[i];
            const auto first = live.operands.begin() + inst.first_operand;
            const bool is_live = inst.op == Op::Yield
                                     ? std::find(first, first + inst.operand_count, 1) != first + inst.operand_count
                                     : live.values[i] != 0;
            if (is_live) look(function, {i}, param, found);
        }
        std::vector<MemberRead> reads;
        for (const auto& [member, origin] : found) reads.push_back({member, origin});
        return known_[{id, param}] = std::move(reads);
    }

private:
    void look(const Function& function, Value value, std::uint32_t param, std::map<std::uint32_t, OriginId>& found) {
        const Inst& inst = function[value];
        const auto args = function.args(inst);
        for (std::uint32_t k = 0; k < args.size(); k++) {
            const Inst& arg = function[args[k]];
            if (arg.op != Op::Param || arg.data != param) continue;
            if (inst.op == Op::Extract) {
                found.try_emplace(inst.data, inst.origin);
            } else if (inst.op == Op::Call) {
                for (const MemberRead& read : of({inst.data}, k))
                    found.try_emplace(read.member, inst.origin ? inst.origin : read.origin);
            } else {
                for (std::uint32_t m = 0; m < part_count(module_, arg.type); m++) found.try_emplace(m, inst.origin);
            }
        }
    }

    const Module& module_;
    std::map<std::pair<FunctionId, std::uint32_t>, std::vector<MemberRead>> known_;
};

}  // namespace

std::vector<MemberRead> members_read(const Module& module, FunctionId function, std::uint32_t param) {
    return Reads(module).of(function, param);
}

}  // namespace patina::ir
