#include "compiler/validate/owners.h"

#include <glslang/SPIRV/spirv.hpp>
#include <map>
#include <span>

#include "compiler/validate/spirv_module.h"

namespace patina {
namespace {

using Id = std::uint32_t;
using Insts = std::vector<SpirvInst>;

class Owners {
public:
    Owners(const SpirvModule& module, const std::vector<LineOwner>& lines)
        : module_(module), lines_(lines), next_id_(module.header[3]) {}

    SpirvModule run() {
        find_functions();
        for (const SpirvInst& inst : module_.insts)
            if (inst.op == spv::OpEntryPoint) function_for(inst.word(2), 0);
        SpirvModule made{.header = module_.header};
        made.header[3] = next_id_;
        for (const SpirvInst& inst : module_.insts) {
            if (inst.op == spv::OpFunction) break;
            if (inst.op == spv::OpLine || inst.op == spv::OpNoLine) continue;
            made.insts.push_back(inst);
            if (inst.op == spv::OpDecorate) add_decorations(inst, made.insts);
        }
        for (Insts& function : made_) made.insts.insert(made.insts.end(), function.begin(), function.end());
        return made;
    }

private:
    void find_functions() {
        for (std::size_t i = 0; i < module_.insts.size(); ++i) {
            const SpirvInst& inst = module_.insts[i];
            if (inst.op == spv::OpLine && file_ == 0) file_ = inst.word(1);
            if (inst.op == spv::OpFunction) begin_ = i;
            if (inst.op != spv::OpFunctionEnd) continue;
            functions_[module_.insts[begin_].result] = std::span(module_.insts).subspan(begin_, i + 1 - begin_);
        }
    }

    // The copy of a function that works for an owner.
    Id function_for(Id function, std::uint32_t owner) {
        const auto found = copies_.find({function, owner});
        if (found != copies_.end()) return found->second;
        const auto body = functions_.find(function);
        if (body == functions_.end()) return function;
        std::map<Id, Id> names;  // of the copy; empty for the first one
        if (is_copied_[function])
            for (const SpirvInst& inst : body->second)
                if (inst.result != 0) copied_[inst.result].push_back(names[inst.result] = next_id_++);
        is_copied_[function] = true;
        const Id made = names.empty() ? function : names[function];
        copies_[{function, owner}] = made;
        Insts copy = copy_of(body->second, owner, names);
        made_.push_back(std::move(copy));
        return made;
    }

    Insts copy_of(std::span<const SpirvInst> body, std::uint32_t caller, const std::map<Id, Id>& names) {
        Insts made;
        LineOwner here;
        bool after_merge = false;
        for (const SpirvInst& inst : body) {
            if (inst.op == spv::OpLine) {
                here = inst.word(2) < lines_.size() ? lines_[inst.word(2)] : LineOwner{};
                continue;
            }
            if (inst.op == spv::OpNoLine) continue;
            const std::uint32_t owner = here.owner.value_or(caller);
            // A merge and the branch after it belong together.
            if (!after_merge && file_ != 0) made.push_back(line(2 * owner + (here.is_light_loop ? 1 : 0)));
            after_merge = inst.op == spv::OpLoopMerge || inst.op == spv::OpSelectionMerge;
            SpirvInst& copy = made.emplace_back(inst);
            const auto rename = [&](Id& id) {
                if (const auto name = names.find(id); name != names.end()) id = name->second;
            };
            for (const std::uint16_t at : inst.ids) rename(copy.words[at]);
            if (inst.result != 0) rename(copy.words[inst.type != 0 ? 2 : 1]);
            rename(copy.result);
            if (inst.op == spv::OpFunctionCall) copy.words[3] = function_for(inst.word(3), owner);
        }
        return made;
    }

    SpirvInst line(std::uint32_t number) const {
        return {.op = spv::OpLine, .words = {4u << spv::WordCountShift | spv::OpLine, file_, number, 0}};
    }

    void add_decorations(const SpirvInst& inst, Insts& to) const {
        const auto found = copied_.find(inst.word(1));
        if (found == copied_.end()) return;
        for (const Id copy : found->second) to.emplace_back(inst).words[1] = copy;
    }

    const SpirvModule& module_;
    const std::vector<LineOwner>& lines_;
    Id next_id_;
    Id file_ = 0;
    std::size_t begin_ = 0;
    std::map<Id, std::span<const SpirvInst>> functions_{};
    std::map<std::pair<Id, std::uint32_t>, Id> copies_{};
    std::map<Id, bool> is_copied_{};
    std::map<Id, std::vector<Id>> copied_{};  // the names in copies of what a function defines
    std::vector<Insts> made_{};
};

}  // namespace

std::vector<std::uint32_t> with_owners(const std::vector<std::uint32_t>& spirv, const std::vector<LineOwner>& lines) {
    const std::optional<SpirvModule> module = read_module(spirv);
    return module ? words_of(Owners(*module, lines).run()) : spirv;
}

}  // namespace patina
