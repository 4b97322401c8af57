// How many instructions a stage has when all calls are replaced by the called functions, as spirv-opt and drivers do.
// Functions that each call the next one twice are short, but have an exponential number of instructions. Nothing is
// inlined here.
#pragma once

#include "compiler/validate/spirv_module.h"
#include "patina/validate.h"

namespace patina {

struct CodeSize {
    double instructions = 0, blocks = 0;
};
// Materials have some hundreds or thousands of instructions, and some tens of blocks. Drivers and spirv-opt need some
// seconds for code of this size; their time grows faster than the number of blocks.
inline constexpr CodeSize kMostCode{.instructions = 200'000, .blocks = 4'096};
bool exceeds(const CodeSize& size, const CodeSize& most);

struct Inlined {
    CodeSize size{};
    int line = 0;  // of the text: the innermost call that is too much by itself; 0: there is none
};
// Of the function that nothing calls.
Inlined inlined(const SpirvModule& module, const CodeSize& most = kMostCode);

// The function that has most blocks, as it is written.
struct Branching {
    std::size_t blocks = 0;
    std::vector<int> lines{};  // of the text: its last branch, a call of it, a call of that caller; 0: not known
};
Branching most_branching(const std::vector<std::uint32_t>& spirv);

}  // namespace patina
