#include "compiler/validate/spirv.h"

#include <spirv-tools/libspirv.h>

#include <algorithm>
#include <memory>

namespace patina::spirv {
namespace {

bool is_id_read(spv_operand_type_t type) {
    return type == SPV_OPERAND_TYPE_ID || type == SPV_OPERAND_TYPE_MEMORY_SEMANTICS_ID ||
           type == SPV_OPERAND_TYPE_SCOPE_ID;
}

struct Reading {
    Spirv& module;
    std::size_t at;  // word of the next instruction
    std::uint32_t line = 0, call_line = 0;
};

spv_result_t add(void* data, const spv_parsed_instruction_t* parsed) {
    Reading& reading = *static_cast<Reading*>(data);
    Instruction made{.op = static_cast<spv::Op>(parsed->opcode),
                     .type = parsed->type_id,
                     .result = parsed->result_id,
                     .words = std::span(reading.module.words).subspan(reading.at, parsed->num_words)};
    reading.at += parsed->num_words;
    for (const spv_parsed_operand_t& operand : std::span(parsed->operands, parsed->num_operands))
        if (is_id_read(operand.type)) made.reads.push_back(operand.offset);
    // A line holds until the next one, or until the block ends.
    if (made.op == spv::OpLine) {
        reading.line = made.words[2];
        reading.call_line = made.words[3];
    } else if (made.op == spv::OpNoLine || made.op == spv::OpLabel || made.op == spv::OpFunction) {
        reading.line = reading.call_line = 0;
    }
    made.line = reading.line;
    made.call_line = reading.call_line;
    reading.module.instructions.push_back(std::move(made));
    return SPV_SUCCESS;
}

std::vector<std::uint32_t> successors(const Instruction& last) {
    const std::span<const std::uint32_t> words = last.operands();
    if (last.op == spv::OpBranch) return {words[0]};
    if (last.op == spv::OpBranchConditional) return {words[1], words[2]};
    if (last.op != spv::OpSwitch) return {};
    std::vector<std::uint32_t> labels = {words[1]};
    for (std::size_t i = 3; i < words.size(); i += 2) labels.push_back(words[i]);  // of 32-bit literals
    return labels;
}

}  // namespace

Spirv parse(std::vector<std::uint32_t> words) {
    constexpr std::size_t kHeaderWords = 5;
    Spirv module{.words = std::move(words)};
    const std::unique_ptr<spv_context_t, void (*)(spv_context)> context(spvContextCreate(SPV_ENV_VULKAN_1_3),
                                                                        spvContextDestroy);
    Reading reading{.module = module, .at = kHeaderWords};
    if (spvBinaryParse(context.get(), &reading, module.words.data(), module.words.size(), nullptr, add, nullptr) !=
        SPV_SUCCESS)
        module.instructions.clear();
    return module;
}

std::vector<Function> functions_of(const Spirv& module) {
    std::vector<Function> functions;
    for (std::size_t i = 0; i < module.instructions.size(); ++i) {
        const Instruction& at = module.instructions[i];
        if (at.op == spv::OpFunction) functions.push_back({.id = at.result, .begin = i});
        if (functions.empty()) continue;
        Function& function = functions.back();
        function.end = i + 1;
        if (at.op == spv::OpLabel) function.blocks.push_back({.label = at.result, .begin = i});
        if (function.blocks.empty() || at.op == spv::OpFunctionEnd) continue;
        Block& block = function.blocks.back();
        block.end = i + 1;
        if (at.op == spv::OpLoopMerge) block.loop_end = at.operands()[0];
        if (std::vector<std::uint32_t> next = successors(at); !next.empty()) block.successors = std::move(next);
    }
    return functions;
}

std::uint32_t entry_of(const Spirv& module) {
    const auto entry = std::ranges::find(module.instructions, spv::OpEntryPoint, &Instruction::op);
    return entry == module.instructions.end() ? 0 : entry->words[2];
}

}  // namespace patina::spirv
