// Rewrites of what a target language cannot say into what it can. A rule looks at one instruction; those that no rule
// applies to stay as they are, and a function that needs none is not touched. What all targets share is listed here,
// what only one needs is in its folder.
//
//   constexpr Rule kRules[] = {{is_saturate, clamp_to_one}};
//   std::optional<ir::Module> rewritten = legalize(module, kRules);
#pragma once

#include <optional>

#include "compiler/ir/rebuild.h"

namespace patina::targets {

struct Rule {
    bool (*applies)(const ir::Module& module, const ir::Function& function, ir::Value value);
    // Makes what stands for the instruction. Operands come from `copy.map`.
    ir::Value (*rewrite)(ir::Copy& copy, ir::Value value);
};

// The shared rules, then these. None if no rule applies.
std::optional<ir::Module> legalize(const ir::Module& module, std::span<const Rule> rules);

// An operand of an instruction of the old function, in the new one.
inline ir::Value operand(const ir::Copy& copy, ir::Value value, std::uint32_t index) {
    return copy.map[copy.from.args(value)[index].index];
}

}  // namespace patina::targets
