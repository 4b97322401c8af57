// Says of each instruction which owner it works for, a node of the graph for example, before the module is optimised.
// The optimiser keeps line numbers with the instructions that it moves and inlines. So the owner is written as a line
// number: 2 x owner, and 1 more where a loop over lights begins.
//
// A function of the library has no owner of its own: it works for its callers. Each owner gets a copy of it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace patina {

struct LineOwner {
    std::optional<std::uint32_t> owner{};  // nothing: that of the caller
    bool is_light_loop = false;            // a loop over lights begins here
};

// `lines`: by line of the text, from 0; the module must have been made with lines. Of the entry point, what has no
// owner belongs to owner 0. If the words are not a module, they are returned as they are.
std::vector<std::uint32_t> with_owners(const std::vector<std::uint32_t>& spirv, const std::vector<LineOwner>& lines);

constexpr std::uint32_t owner_of_line(std::uint32_t line) {
    return line / 2;
}
constexpr bool is_light_loop_line(std::uint32_t line) {
    return line % 2 != 0;
}

}  // namespace patina
