// A function without one of its inputs: a true zero wherever that input is a factor.
#include <cmath>
#include <limits>

#include "tests/unit/ir/ir_linear_testing.h"

namespace patina::ir {
namespace {

struct Rest {
    const char* name;
    Body body;
    double left;  // in each component
};

// Params: 0 x, 1 k. What x is multiplied by is infinite or no number: nothing but what is taken out whole survives
// that.
std::vector<Rest> rests(FunctionId product) {
    static const auto x = [](Builder& b) { return b.param(0); };
    static const auto k = [](Builder& b) { return b.param(1); };
    static const auto xk = [](Builder& b) { return b.emit(Op::Mul, {x(b), k(b)}); };
    static const auto with = [](Builder& b, Value value, double more) {
        return b.emit(Op::Add, {value, numbers(b, {more, more, more})});
    };
    return {
        {"x k", [](Builder& b) { return xk(b); }, 0},
        {"k x + 3",
         [](Builder& b) {
             return with(b, b.emit(Op::Mul, {k(b), x(b)}), 3);
         },
         3},
        {"(0 + x / 0 - x k) k + 3",
         [](Builder& b) {
             const Value quotient = b.emit(Op::Div, {with(b, x(b), 0), numbers(b, {0, 0, 0})});
             return with(b, b.emit(Op::Mul, {b.emit(Op::Sub, {quotient, xk(b)}), k(b)}), 3);
         },
         3},
        {"dot(k, x) + 3",
         [](Builder& b) {
             return with(b, b.splat(b.emit(Op::Dot, {k(b), x(b)}), 3), 3);
         },
         3},
        {"cross(x, k) + 3",
         [](Builder& b) {
             return with(b, b.emit(Op::Cross, {x(b), k(b)}), 3);
         },
         3},
        {"reflect(x, k) + 3",
         [](Builder& b) {
             return with(b, b.emit(Op::Reflect, {x(b), k(b)}), 3);
         },
         3},
        {"float3x3(x, 0, -x) k + 3",
         [](Builder& b) {
             const std::vector rows = {x(b), numbers(b, {0, 0, 0}), b.emit(Op::Neg, {x(b)})};
             const Value matrix = b.construct(Type::matrix(Scalar::Float, 3, 3), rows);
             return with(b, b.emit(Op::MatMul, {matrix, k(b)}), 3);
         },
         3},
        {"lerp(0, k, x) + 3",
         [](Builder& b) {
             return with(b, b.emit(Op::Lerp, {numbers(b, {0, 0, 0}), k(b), x(b)}), 3);
         },
         3},
        {"lerp(x, 0, k) + 3",
         [](Builder& b) {
             return with(b, b.emit(Op::Lerp, {x(b), numbers(b, {0, 0, 0}), k(b)}), 3);
         },
         3},
        // One part of a struct is x, another is not.
        {"{ color x, roughness 3, normal k }: color normal + roughness",
         [](Builder& b) {
             const Value whole = b.construct(surface(b.module()), std::vector{x(b), numbers(b, {3}), k(b)});
             const Value first = b.emit(Op::Mul, {b.extract(whole, 0), b.extract(whole, 2)});
             return b.emit(Op::Add, {first, b.splat(b.extract(whole, 1), 3)});
         },
         3},
        {"k.x > 0 ? (x k) k : x, + 3",
         [](Builder& b) {
             const Value above = b.emit(Op::Greater, {b.extract(k(b), 0), numbers(b, {0})});
             return with(b, b.emit(Op::Select, {above, b.emit(Op::Mul, {xk(b), k(b)}), x(b)}), 3);
         },
         3},
        {"if (k.x > 0) { x k, 3 } else { x, k }: [0] k + [1]",
         [](Builder& b) {
             const Value branch = b.begin_if(b.emit(Op::Greater, {b.extract(k(b), 0), numbers(b, {0})}));
             const std::vector one = {xk(b), numbers(b, {3, 3, 3})};
             b.begin_else();
             const std::vector other = {x(b), k(b)};
             b.end_if(one, other);
             return b.emit(Op::Add, {b.emit(Op::Mul, {b.result(branch, 0), k(b)}), b.result(branch, 1)});
         },
         3},
        // s = s + x k from 0 and n = n + 1 from 0, three times: s k + n
        {"sums over a loop",
         [](Builder& b) {
             const Value none = numbers(b, {0, 0, 0});
             const Value loop = b.begin_for(b.constant(kInt, {0}), b.constant(kInt, {3}), std::vector{none, none});
             b.end_for(std::vector{b.emit(Op::Add, {b.loop_carried(0), xk(b)}), with(b, b.loop_carried(1), 1)});
             return b.emit(Op::Add, {b.emit(Op::Mul, {b.result(loop, 0), k(b)}), b.result(loop, 1)});
         },
         3},
        // f(x, k) = { x k, 3 }
        {"f(x, k)[0] k + f(x, k)[1]",
         [product](Builder& b) {
             const Value both = b.call(product, std::vector{x(b), k(b)});
             return b.emit(Op::Add, {b.emit(Op::Mul, {b.extract(both, 0), k(b)}), b.extract(both, 1)});
         },
         3},
        // The function is not affine in x: instructions that use x are removed, and the rest has its value at zero.
        {"max(x k, 3) + sin(x)",
         [](Builder& b) {
             const Value most = b.emit(Op::Max, {xk(b), numbers(b, {3, 3, 3})});
             return b.emit(Op::Add, {most, b.emit(Op::Sin, {x(b)})});
         },
         3},
        {"x x + cos(x)",
         [](Builder& b) {
             return b.emit(Op::Add, {b.emit(Op::Mul, {x(b), x(b)}), b.emit(Op::Cos, {x(b)})});
         },
         1},
    };
}

TEST(Without, TakesOutWhateverIsMultipliedByX) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const bool fold : {true, false}) {
        Module module;
        const Type pair = module.array_of(kFloat3, 2);
        const FunctionId product = add(
            module, "product", {kXyz, kK}, pair,
            [&](Builder& b) {
                const Value first = b.emit(Op::Mul, {b.param(0), b.param(1)});
                return b.construct(pair, std::vector{first, numbers(b, {3, 3, 3})});
            },
            fold);
        for (const Rest& test : rests(product)) {
            SCOPED_TRACE(test.name);
            const FunctionId f = add(module, "f", {kXyz, kK}, kFloat3, test.body, fold);
            const FunctionId rest = push(module, without(module, f, kFirst, {.fold = fold}));
            const Numbers k = {infinity, std::numeric_limits<double>::quiet_NaN(), -infinity};
            const Numbers left = evaluate(module, rest, {{2, 3, 5}, k});
            EXPECT_EQ(left, (Numbers{test.left, test.left, test.left})) << dump(module, module[rest]);
            for (const Op op : {Op::Mul, Op::Div, Op::Dot, Op::Cross, Op::Reflect, Op::MatMul, Op::Lerp, Op::Call})
                EXPECT_EQ(fold ? count(module[rest], op) : 0, 0u) << dump(module, module[rest]);
        }
    }
}

// What x does not multiply stays as it is, NaN and all, where nothing is folded.
TEST(Without, KeepsProductsWithOtherZeros) {
    Module module;
    const FunctionId f = add(
        module, "f", {kXyz, kK}, kFloat3,
        [](Builder& b) {
            const Value none = b.emit(Op::Mul, {numbers(b, {0, 0, 0}), b.param(1)});
            const Value both = b.emit(Op::Mul, {b.emit(Op::Add, {b.param(0), b.param(1)}), numbers(b, {0, 0, 0})});
            return b.emit(Op::Add, {b.emit(Op::Add, {b.param(0), none}), both});
        },
        false);
    const FunctionId rest = push(module, without(module, f, kFirst, {.fold = false}));
    EXPECT_EQ(count(module[rest], Op::Mul), 2u) << dump(module, module[rest]);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double left : evaluate(module, rest, {{2, 3, 5}, {infinity, infinity, infinity}}))
        EXPECT_TRUE(std::isnan(left));
}

}  // namespace
}  // namespace patina::ir
