// The table of ops.def as code: one enumerator and one row for each operation.
#pragma once

#include <array>
#include <string_view>

#include "compiler/ir/types.h"

namespace patina::ir {

enum class Op : std::uint8_t {
#define OP(name, text, arguments, rule, traits, relative, absolute) name,
#include "compiler/ir/ops.def"
#undef OP
};

// How an op's result type follows from its operands.
enum class TypeRule : std::uint8_t {
    Declared,    // the caller of emit sets the type; declared_types.cpp has a rule for each op
    Void,        // no value
    First,       // type of operand 0
    Second,      // type of operand 1
    Same,        // all operands have one type, which is the result's
    Compare,     // two operands of one scalar or vector type; bool(s) of that width
    Bools,       // bool(s) of operand 0's width
    Bool,        // one bool
    Scalar,      // the scalar of operand 0's scalar kind
    Product,     // matrix product
    Transposed,  // rows and columns exchanged
    Texel,       // float4
};

enum Traits : std::uint8_t { None = 0, Effect = 1, Derivative = 2, Commutes = 4, Structure = 8 };

struct OpInfo {
    std::string_view text;
    int arguments;
    TypeRule rule;
    std::uint8_t traits;
    double relative;  // how far a GPU's result may be from the exact one
    double absolute;
};

inline constexpr std::size_t kOpCount = 0
#define OP(name, text, arguments, rule, traits, relative, absolute) +1
#include "compiler/ir/ops.def"
#undef OP
    ;
inline constexpr std::array<OpInfo, kOpCount> kOps = {{
#define OP(name, text, arguments, rule, traits, relative, absolute) \
    {text, arguments, TypeRule::rule, static_cast<std::uint8_t>(traits), relative, absolute},
#include "compiler/ir/ops.def"
#undef OP
}};

constexpr const OpInfo& info(Op op) {
    return kOps[static_cast<std::size_t>(op)];
}
constexpr bool has(Op op, Traits trait) {
    return (info(op).traits & trait) != 0;
}

}  // namespace patina::ir
