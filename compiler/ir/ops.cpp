#include "compiler/ir/ops.h"

#include <array>

namespace patina::ir {
namespace {

constexpr std::array<OpInfo, kOpCount> kOps = {{
#define OP(name, text, arguments, rule, traits, relative, absolute) \
    {text, arguments, TypeRule::rule, static_cast<std::uint8_t>(traits), relative, absolute},
#include "compiler/ir/ops.def"
#undef OP
}};

}  // namespace

const OpInfo& info(Op op) {
    return kOps[static_cast<std::size_t>(op)];
}

}  // namespace patina::ir
