// What a shader computes, as a number: equal for two shaders that differ only in what things are called, in the order
// of nodes, or in the layout of the graph's text. Properties and what the engine owns count by name and place; node
// ids, names of locals, of functions and of interpolated values do not.
//
//   CanonicalHash a = hash_pass(rust.vertex, rust.fragment), b = hash_pass(renamed.vertex, renamed.fragment);   // a ==
//   b
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/ir/ir.h"

namespace patina::assemble {

struct CanonicalHash {
    std::uint64_t high = 0, low = 0;
    friend auto operator<=>(const CanonicalHash&, const CanonicalHash&) = default;
    std::string text() const;  // 32 hexadecimal digits
};

// Of tidied stages. An interpolated value counts as what the vertex stage computes for it.
CanonicalHash hash_pass(const ir::Module& vertex, const ir::Module& fragment);
// Of one stage, whatever the other one is: interpolated values count by their locations.
CanonicalHash hash_stage(const ir::Module& stage);

// Of what a stage gives, by output.
std::vector<CanonicalHash> hash_outputs(const ir::Module& stage);

// Of several that belong together, written out.
CanonicalHash hash_text(std::string_view text);

}  // namespace patina::assemble
