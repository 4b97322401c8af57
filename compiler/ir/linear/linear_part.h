// The room `ir/linear` finds and makes linear parts of functions. It changes no function that is there.
//
// Is a function f(x, ...) affine in one of its inputs: f = A x + B, where neither A nor B depends on x? If so, this
// makes functions of its linear part A x and of B, with the same signature. A rendering path needs them if one pass
// computes with one x, and a later pass multiplies by another x. x is a member of a parameter, or the result of all
// calls of some function.
//
// The linear part is found like a derivative in forward mode: each value that depends on x has a tangent. An op that is
// not linear in such a value has none, and the reason is kept. What does not reach the function's result may be
// anything. Only the form counts: x * x - x * x is not affine here.
//
//   LinearPart made = linear_part(module, direct, Seed::of_member(0, 0), {.componentwise = true});
//   if (!made.function) say(made.reason, module.origins[made.origin.index].span);
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/ir/builder.h"

namespace patina::ir {

// Which values of a function are x.
struct Seed {
    std::uint32_t param = 0;
    std::uint32_t member = 0;  // of the parameter's struct; a parameter of another type is x as a whole
    FunctionId callee{};       // if set: the results of its calls, also in functions that the function calls

    static Seed of_member(std::uint32_t param, std::uint32_t member) {
        return {.param = param, .member = member, .callee = {}};
    }
    static Seed of_calls(FunctionId callee) { return {.param = 0, .member = 0, .callee = callee}; }
};

struct LinearOptions {
    bool componentwise = false;  // A must be diagonal: component i of the result depends on component i of x only
    BuildOptions build{};
};

struct LinearPart {
    std::optional<Function> function{};  // A x; none if the function is not affine in x
    bool depends = false;                // false: x is not read, and A x is zero
    std::string reason{};                // what is not affine: "'max' is not linear, in FresnelSchlick"
    OriginId origin{};                   // the graph node where that is, if it has one
};

// The module gets the constants that the new function needs and is otherwise not changed. Calls with arguments that
// depend on x, and calls of functions that call the seed's callee, are inlined in the new function. Probes are not
// kept.
LinearPart linear_part(Module& module, FunctionId function, const Seed& seed, const LinearOptions& options = {});

// B: the function with zero in the place of x. A product such as k x becomes zero completely, and k is not computed for
// it. Parts that are not affine are computed for x = 0. Functions that call the seed's callee are inlined, however many
// they are, so call linear_part() first.
Function without(Module& module, FunctionId function, const Seed& seed, BuildOptions build = {});

// A member that is read, and by which graph node first.
struct MemberRead {
    std::uint32_t member = 0;
    OriginId origin{};
};
// The members of a struct parameter that the function's result depends on, in their order. Where the whole struct is an
// argument of a call, the callee's members count; any other use of the whole struct reads all members.
std::vector<MemberRead> members_read(const Module& module, FunctionId function, std::uint32_t param);

}  // namespace patina::ir
