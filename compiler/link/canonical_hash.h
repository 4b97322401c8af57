// Hashes what a shader computes. Two shaders have the same hash if they differ only in names, in the order of nodes, or
// in the layout of the graph's text. Properties and the engine's values count by name and place; node ids and the names
// of locals, functions and interpolated values do not.
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

namespace patina::link {

struct CanonicalHash {
    std::uint64_t high = 0, low = 0;
    friend auto operator<=>(const CanonicalHash&, const CanonicalHash&) = default;
    std::string text() const;  // 32 hexadecimal digits
};

// Hashes two tidied stages. An interpolated value counts as the computation in the vertex stage.
CanonicalHash hash_pass(const ir::Module& vertex, const ir::Module& fragment);
// Hashes one stage alone: interpolated values count by their locations.
CanonicalHash hash_stage(const ir::Module& stage);

// The hashes of a stage's outputs.
std::vector<CanonicalHash> hash_outputs(const ir::Module& stage);

// The hash of a text that lists several hashes.
CanonicalHash hash_text(std::string_view text);

}  // namespace patina::link
