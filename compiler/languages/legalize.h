// Rewrites operations that a language lacks into operations that it has. A rule looks at one instruction. Instructions
// to which no rule applies stay as they are, and a function without any is not changed. Rules that all languages share
// are in legalize.cpp; rules of one language are in its folder.
//
//   constexpr Rule kRules[] = {{{ir::Op::Saturate}, is_of_vectors, clamp_to_one}};
//   std::optional<ir::Module> rewritten = legalize(module, kRules);
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>

#include "compiler/ir/rebuild.h"

namespace patina::languages {

// A set of ops, made by the compiler.
class OpSet {
public:
    constexpr OpSet(std::initializer_list<ir::Op> ops) {
        for (const ir::Op op : ops) add(op);
    }
    // All of a type rule.
    constexpr explicit OpSet(ir::TypeRule rule) {
        for (std::size_t i = 0; i < ir::kOpCount; ++i)
            if (ir::kOps[i].rule == rule) add(static_cast<ir::Op>(i));
    }
    constexpr bool has(ir::Op op) const {
        const auto index = static_cast<std::size_t>(op);
        return (words_[index / 64] >> index % 64 & 1) != 0;
    }

private:
    constexpr void add(ir::Op op) {
        const auto index = static_cast<std::size_t>(op);
        words_[index / 64] |= std::uint64_t{1} << index % 64;
    }

    std::array<std::uint64_t, ir::kOpCount / 64 + 1> words_{};
};

struct Rule {
    OpSet ops;  // that it is for
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
