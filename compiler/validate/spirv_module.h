// A SPIR-V module as a list of instructions that know which of their words are ids.
//
//   std::optional<SpirvModule> module = read_module(words);
//   for (const SpirvInst& inst : module->insts) ...
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace patina {

struct SpirvInst {
    std::uint32_t op = 0;                // spv::Op
    std::uint32_t type = 0, result = 0;  // ids; 0: there is none
    std::vector<std::uint32_t> words{};  // the first one has the opcode and the number of words
    std::vector<std::uint16_t> ids{};    // which words are ids of operands

    std::uint32_t word(std::size_t i) const { return i < words.size() ? words[i] : 0; }
};

struct SpirvModule {
    std::vector<std::uint32_t> header{};  // five words; the fourth is above every id
    std::vector<SpirvInst> insts{};
};

// Nothing if the words are not a module.
std::optional<SpirvModule> read_module(const std::vector<std::uint32_t>& words);
std::vector<std::uint32_t> words_of(const SpirvModule& module);

// How many scalars a value of each type has. Textures, samplers and pointers have none.
class ComponentCounts {
public:
    explicit ComponentCounts(const SpirvModule& module);
    std::uint32_t of(std::uint32_t type) const;
    // Of what a pointer type points to.
    std::uint32_t behind(std::uint32_t pointer) const;

private:
    std::map<std::uint32_t, std::uint32_t> counts_{}, behind_{};  // by the id of the type
};

}  // namespace patina
