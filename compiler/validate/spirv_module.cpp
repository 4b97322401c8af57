#include "compiler/validate/spirv_module.h"

#include <glslang/SPIRV/spirv.hpp>
#include <span>
#include <spirv-tools/libspirv.hpp>

namespace patina {
namespace {

constexpr std::size_t kHeaderWords = 5;

bool is_id(spv_operand_type_t type) {
    return type == SPV_OPERAND_TYPE_ID || type == SPV_OPERAND_TYPE_MEMORY_SEMANTICS_ID ||
           type == SPV_OPERAND_TYPE_SCOPE_ID;
}

spv_result_t add(void* to, const spv_parsed_instruction_t* parsed) {
    SpirvInst inst{.op = parsed->opcode, .type = parsed->type_id, .result = parsed->result_id};
    inst.words.assign(parsed->words, parsed->words + parsed->num_words);
    for (const spv_parsed_operand_t& operand : std::span(parsed->operands, parsed->num_operands))
        if (is_id(operand.type)) inst.ids.push_back(operand.offset);
    static_cast<SpirvModule*>(to)->insts.push_back(std::move(inst));
    return SPV_SUCCESS;
}

}  // namespace

std::optional<SpirvModule> read_module(const std::vector<std::uint32_t>& words) {
    if (words.size() < kHeaderWords) return std::nullopt;
    SpirvModule module{.header = {words.begin(), words.begin() + kHeaderWords}};
    const spvtools::Context context(SPV_ENV_VULKAN_1_3);
    const spv_result_t result =
        spvBinaryParse(context.CContext(), &module, words.data(), words.size(), nullptr, add, nullptr);
    return result == SPV_SUCCESS ? std::optional(std::move(module)) : std::nullopt;
}

std::vector<std::uint32_t> words_of(const SpirvModule& module) {
    std::vector<std::uint32_t> words = module.header;
    for (const SpirvInst& inst : module.insts) words.insert(words.end(), inst.words.begin(), inst.words.end());
    return words;
}

ComponentCounts::ComponentCounts(const SpirvModule& module) {
    std::map<std::uint32_t, std::uint32_t> constants;  // lengths of arrays
    for (const SpirvInst& inst : module.insts) {
        switch (inst.op) {
            case spv::OpConstant: constants[inst.result] = inst.word(3); break;
            case spv::OpTypeBool:
            case spv::OpTypeInt:
            case spv::OpTypeFloat: counts_[inst.result] = 1; break;
            case spv::OpTypeVector:
            case spv::OpTypeMatrix: counts_[inst.result] = of(inst.word(2)) * inst.word(3); break;
            case spv::OpTypeArray: counts_[inst.result] = of(inst.word(2)) * constants[inst.word(3)]; break;
            case spv::OpTypeStruct:
                for (std::size_t i = 2; i < inst.words.size(); ++i) counts_[inst.result] += of(inst.words[i]);
                break;
            case spv::OpTypePointer: behind_[inst.result] = of(inst.word(3)); break;
            case spv::OpFunction: return;
            default: break;
        }
    }
}

std::uint32_t ComponentCounts::of(std::uint32_t type) const {
    const auto found = counts_.find(type);
    return found == counts_.end() ? 0 : found->second;
}

std::uint32_t ComponentCounts::behind(std::uint32_t pointer) const {
    const auto found = behind_.find(pointer);
    return found == behind_.end() ? 0 : found->second;
}

}  // namespace patina
