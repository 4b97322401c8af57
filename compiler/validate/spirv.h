// A SPIR-V module as a list of instructions, each with the line of the text that it comes from, and its functions as
// blocks. It changes nothing: expand_calls.h makes another module.
//
//   const Spirv module = parse(words);
//   for (const Function& function : functions_of(module)) count(function.blocks);
#pragma once

#include <cstdint>
#include <glslang/SPIRV/spirv.hpp>
#include <span>
#include <vector>

namespace patina::spirv {

struct Instruction {
    spv::Op op = spv::OpNop;
    std::uint32_t type = 0, result = 0;    // ids; 0: it has none
    std::span<const std::uint32_t> words;  // of the module, its opcode first
    std::vector<std::uint16_t> reads{};    // which of the words are ids that it reads: operands, not its type
    // Of OpLine. expand_calls() puts the line of the call that the instruction belongs to where a column was.
    std::uint32_t line = 0, call_line = 0;

    // The words after type and result.
    std::span<const std::uint32_t> operands() const { return words.subspan(1 + (type != 0) + (result != 0)); }
};

struct Spirv {
    std::vector<std::uint32_t> words;
    std::vector<Instruction> instructions{};  // spans of `words`; empty: it is not a module
};
Spirv parse(std::vector<std::uint32_t> words);

// Indices of instructions, [begin, end).
struct Block {
    std::uint32_t label = 0;
    std::size_t begin = 0, end = 0;
    std::vector<std::uint32_t> successors{};  // labels
    std::uint32_t loop_end = 0;               // if the block is a loop's header: the label after the loop
};
struct Function {
    std::uint32_t id = 0;
    std::size_t begin = 0, end = 0;
    std::vector<Block> blocks{};
};
std::vector<Function> functions_of(const Spirv& module);

// The function of the first entry point; 0: there is none.
std::uint32_t entry_of(const Spirv& module);

}  // namespace patina::spirv
