// Which values of a function depend on a seed x (linear_part.h), component by component, and whether they are affine in
// x. This is an analysis; linear_part() uses it to make instructions.
#pragma once

#include <map>
#include <memory>

#include "compiler/ir/linear/linear_part.h"

namespace patina::ir {

// Why a value is not affine: the instruction that makes it so.
struct Blame {
    enum class What : std::uint8_t { NotLinear, Product, Condition, SeedArguments, TooLong, Mixes };
    What what = What::NotLinear;
    Op op = Op::Constant;
    FunctionId function{};
    OriginId origin{};
};

inline constexpr std::uint32_t kNoBlame = 0xffffffffu;

// How a value depends on x. Components are counted end to end: of vectors, rows, members and elements.
struct Dependence {
    static constexpr std::uint8_t kBroken = 0x80;  // a flag: not affine
    static constexpr std::uint8_t kOffset = 0x40;  // a flag: has a part that does not depend on x
    // One byte for each component: bit i is component i of x (of one with more than six components: any of i, i + 6,
    // ...). Empty: none depends on x, and each is its offset. A zero byte: nothing but zero.
    std::vector<std::uint8_t> on{};
    std::uint32_t broken_by = kNoBlame;  // into Affine::blames: the first that broke any component
    std::uint32_t mixed_by = kNoBlame;   // the first that put a component of x in another one's place

    bool any() const;
    bool is_homogeneous() const;  // a multiple of x: zero where x is
    std::uint8_t all_of() const;  // of all components together
};

// A function as it is called in one place.
struct Activation {
    std::vector<Dependence> values{};                              // by Value
    std::map<std::uint32_t, std::unique_ptr<Activation>> calls{};  // by Value: calls whose results depend on x
    Dependence result{};
};

struct Affine {
    std::unique_ptr<Activation> root{};
    std::vector<Blame> blames{};
};

Affine affine_in(const Module& module, FunctionId function, const Seed& seed);

// By function: 1 if it is the seed's callee, or calls it directly or through others.
std::vector<std::uint8_t> reaching(const Module& module, FunctionId callee);

// The number of components of a type, and the index of the first component of a part.
std::uint32_t component_count(const Module& module, Type type);
std::uint32_t first_component(const Module& module, Type composite, std::uint32_t part);

// True for ops that are linear in all of their operands.
bool is_linear(Op op);

}  // namespace patina::ir
