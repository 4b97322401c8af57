// Rewrites operations that a language lacks into operations that it has. A rule looks at one instruction. Instructions
// to which no rule applies stay as they are, and a function without any is not changed. Rules that all languages share
// are in legalize.cpp; those of one language are in its folder.
//
//   constexpr Rule kRules[] = {{is_saturate, clamp_to_one}};
//   std::optional<ir::Module> rewritten = legalize(module, kRules);
#pragma once

#include <optional>

#include "compiler/ir/rebuild.h"

namespace patina::languages {

struct Rule {
    bool (*applies)(const ir::Module& module, const ir::Function& function, ir::Value value);
    // Makes the replacement of the instruction. Operands come from `copy.map`.
    ir::Value (*rewrite)(ir::Copy& copy, ir::Value value);
};

// Applies the shared rules, then these. Nothing if no rule applies.
std::optional<ir::Module> legalize(const ir::Module& module, std::span<const Rule> rules);

// An operand of an instruction of the old function, as a value of the new one.
inline ir::Value operand(const ir::Copy& copy, ir::Value value, std::uint32_t index) {
    return copy.map[copy.from.args(value)[index].index];
}

}  // namespace patina::languages
