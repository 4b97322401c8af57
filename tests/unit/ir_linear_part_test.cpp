// Linear parts against closed forms, op by op; what is not affine is refused at its own place; and random functions,
// for which f(x) - f(0) says what the linear part must be.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "compiler/interpret/interpret.h"
#include "compiler/ir/dump.h"
#include "compiler/ir/linear_part.h"
#include "tests/unit/ir_testing.h"

namespace patina::ir {
namespace {

using interpret::Flat;
using Numbers = std::vector<double>;

const Param kXyz{"x", kFloat3, Rate::Pixel}, kK{"k", kFloat3, Rate::Pixel};
const Seed kFirst = Seed::of_member(0, 0);

Numbers evaluate(const Module& module, FunctionId f, const std::vector<Flat>& arguments) {
    return interpret::run(module, f, {arguments, arguments, arguments, arguments}, {}, Precision::Double).lanes[2];
}

FunctionId push(Module& module, Function function) {
    module.functions.push_back(std::move(function));
    EXPECT_EQ(verify(module), "");
    return {static_cast<std::uint32_t>(module.functions.size() - 1)};
}

void expect_near(const Numbers& got, const Numbers& wanted, const std::string& text) {
    ASSERT_EQ(got.size(), wanted.size()) << text;
    for (std::size_t i = 0; i < got.size(); i++)
        EXPECT_NEAR(got[i], wanted[i], 1e-9 * std::max(1.0, std::abs(wanted[i]))) << text << "\ncomponent " << i;
}

Value numbers(Builder& b, const Numbers& components) {
    const Type type = components.size() == 1 ? kFloat : kFloat.with_width(static_cast<unsigned>(components.size()));
    return b.constant(type, components);
}

// Surface { float3 color, float roughness, float3 normal }; its color is x.
Type surface(Module& module) {
    if (module.structs.empty())
        module.structs.push_back({"Surface", {{"color", kFloat3}, {"roughness", kFloat}, {"normal", kFloat3}}});
    return Type::structure(0);
}

// --- each op, in closed form. x = (2, 3, 5), k = (0.5, -1, 4), c = true.

struct Case {
    const char* name;
    Type result;
    Body body;
    Numbers linear;  // A x
    bool is_diagonal;
};

// Params: 0 x, 1 k, 2 c.
const std::vector<Case>& cases() {
    static const auto x = [](Builder& b) { return b.param(0); };
    static const auto k = [](Builder& b) { return b.param(1); };
    static const auto c = [](Builder& b) { return b.param(2); };
    static const auto scalar = [](Builder& b) { return b.extract(b.param(1), 2); };
    static const std::vector<Case> all = {
        {"x", kFloat3, [](Builder& b) { return x(b); }, {2, 3, 5}, true},
        {"k", kFloat3, [](Builder& b) { return k(b); }, {0, 0, 0}, true},
        {"x + k",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Add, {x(b), k(b)});
         },
         {2, 3, 5},
         true},
        {"k - x",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Sub, {k(b), x(b)});
         },
         {-2, -3, -5},
         true},
        {"-x", kFloat3, [](Builder& b) { return b.emit(Op::Neg, {x(b)}); }, {-2, -3, -5}, true},
        {"k * x",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Mul, {k(b), x(b)});
         },
         {1, -3, 20},
         true},
        {"x / k",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Div, {x(b), k(b)});
         },
         {4, -3, 1.25},
         true},
        {"sin(k) * (x + exp(k))",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Mul, {b.emit(Op::Sin, {k(b)}), b.emit(Op::Add, {x(b), b.emit(Op::Exp, {k(b)})})});
         },
         {2 * std::sin(0.5), 3 * std::sin(-1.0), 5 * std::sin(4.0)},
         true},
        {"radians(x)",
         kFloat3,
         [](Builder& b) { return b.emit(Op::Radians, {x(b)}); },
         {2 * std::acos(-1) / 180, 3 * std::acos(-1) / 180, 5 * std::acos(-1) / 180},
         true},
        {"degrees(x)",
         kFloat3,
         [](Builder& b) { return b.emit(Op::Degrees, {x(b)}); },
         {360 / std::acos(-1), 540 / std::acos(-1), 900 / std::acos(-1)},
         true},
        {"lerp(x, k, k)",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Lerp, {x(b), k(b), k(b)});
         },
         {1, 6, -15},
         true},
        {"lerp(k, x, k)",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Lerp, {k(b), x(b), k(b)});
         },
         {1, -3, 20},
         true},
        {"lerp(k, 1, x)",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Lerp, {k(b), numbers(b, {1, 1, 1}), x(b)});
         },
         {1, 6, -15},
         true},
        {"c ? x : k",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Select, {c(b), x(b), k(b)});
         },
         {2, 3, 5},
         true},
        {"c ? k : x",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Select, {c(b), k(b), x(b)});
         },
         {0, 0, 0},
         true},
        {"k > 0 ? x : -x",
         kFloat3,
         [](Builder& b) {
             const Value zero = numbers(b, {0, 0, 0});
             return b.emit(Op::Select, {b.emit(Op::Greater, {k(b), zero}), x(b), b.emit(Op::Neg, {x(b)})});
         },
         {2, -3, 5},
         true},
        {"half(x)",
         kFloat3,
         [](Builder& b) { return b.convert(b.convert(x(b), Scalar::Half), Scalar::Float); },
         {2, 3, 5},
         true},
        {"x.zxy",
         kFloat3,
         [](Builder& b) {
             return b.swizzle(x(b), std::vector{2u, 0u, 1u});
         },
         {5, 2, 3},
         false},
        {"x.zxy.yzx",
         kFloat3,
         [](Builder& b) {
             const Value turned =
                 b.swizzle(b.emit(Op::Mul, {b.swizzle(x(b), std::vector{2u, 0u, 1u}), k(b)}), std::vector{1u, 2u, 0u});
             return b.emit(Op::Mul, {turned, k(b)});
         },
         // (5 * 0.5, 2 * -1, 3 * 4) turned to (-2, 12, 2.5), times k
         {-1, -12, 10},
         true},
        {"float3(x.x, k.y, x.z)",
         kFloat3,
         [](Builder& b) {
             return b.construct(kFloat3, std::vector{b.extract(x(b), 0), b.extract(k(b), 1), b.extract(x(b), 2)});
         },
         {2, 0, 5},
         true},
        {"float3(x.z)", kFloat3, [](Builder& b) { return b.splat(b.extract(x(b), 2), 3); }, {5, 5, 5}, false},
        {"float4(x, k.z).wxy",
         kFloat3,
         [](Builder& b) {
             const Value four = b.construct(kFloat4, std::vector{x(b), scalar(b)});
             return b.swizzle(four, std::vector{3u, 0u, 1u});
         },
         {0, 2, 3},
         false},
        // The fourth component is independent, so its square is no harm.
        {"x * float4(x, k.z).w^2",
         kFloat3,
         [](Builder& b) {
             const Value w = b.extract(b.construct(kFloat4, std::vector{x(b), scalar(b)}), 3);
             return b.emit(Op::Mul, {x(b), b.splat(b.emit(Op::Mul, {w, w}), 3)});
         },
         {32, 48, 80},
         true},
        // Both sides depend on x, but no component of both.
        {"float3(x.x, k.yz) * float3(k.x, x.y, k.z)",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Mul, {b.emit(Op::Insert, kFloat3, {k(b), b.extract(x(b), 0)}, 0),
                                     b.emit(Op::Insert, kFloat3, {k(b), b.extract(x(b), 1)}, 1)});
         },
         {1, -3, 0},
         true},
        {"insert(k, x.y, 1)",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Insert, kFloat3, {k(b), b.extract(x(b), 1)}, 1);
         },
         {0, 3, 0},
         true},
        {"insert(x, 1, 0)",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Insert, kFloat3, {x(b), numbers(b, {1})}, 0);
         },
         {0, 3, 5},
         true},
        {"x[int(k.x)]",
         kFloat,
         [](Builder& b) {
             return b.emit(Op::Index, kFloat, {x(b), b.convert(b.emit(Op::Floor, {scalar(b)}), Scalar::Int)});
         },
         {5},
         false},  // clamped to the last
        {"dot(x, k)",
         kFloat,
         [](Builder& b) {
             return b.emit(Op::Dot, {x(b), k(b)});
         },
         {1 - 3 + 20},
         false},
        {"dot(k, x)",
         kFloat,
         [](Builder& b) {
             return b.emit(Op::Dot, {k(b), x(b)});
         },
         {1 - 3 + 20},
         false},
        {"cross(x, k)",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Cross, {x(b), k(b)});
         },
         {3 * 4 - 5 * -1, 5 * 0.5 - 2 * 4, 2 * -1 - 3 * 0.5},
         false},
        {"cross(k, x)",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Cross, {k(b), x(b)});
         },
         {-17, 5.5, 3.5},
         false},
        // i - 2 n (n . i) of n = (0, 1, 0), scaled to be no unit vector
        {"reflect(x, n)",
         kFloat3,
         [](Builder& b) {
             return b.emit(Op::Reflect, {x(b), numbers(b, {0, 1, 0})});
         },
         {2, -3, 5},
         false},
        {"float3x3(x, k, x) * k",
         kFloat3,
         [](Builder& b) {
             const Value rows = b.construct(Type::matrix(Scalar::Float, 3, 3), std::vector{x(b), k(b), x(b)});
             return b.emit(Op::MatMul, {rows, k(b)});
         },
         {18, 0, 18},
         false},
        {"k * transpose(float3x3(k, x, k))",
         kFloat3,
         [](Builder& b) {
             const Value rows = b.construct(Type::matrix(Scalar::Float, 3, 3), std::vector{k(b), x(b), k(b)});
             return b.emit(Op::MatMul, {k(b), b.emit(Op::Transpose, {rows})});
         },
         {0, 18, 0},
         false},
        // What the result does not need may be crooked.
        {"unused x * x",
         kFloat3,
         [](Builder& b) {
             b.emit(Op::Mul, {x(b), x(b)});
             return x(b);
         },
         {2, 3, 5},
         true},
        // sum of k * x over i = 0..2, each i + 1 times: (1 + 2 + 3) k x
        {"sum over a loop",
         kFloat3,
         [](Builder& b) {
             const Value loop =
                 b.begin_for(b.constant(kInt, {0}), b.constant(kInt, {3}), std::vector{numbers(b, {1, 1, 1}), k(b)});
             const Value weight = b.emit(Op::Add, {b.convert(b.loop_index(), Scalar::Float), numbers(b, {1})});
             const Value term = b.emit(Op::Mul, {b.emit(Op::Mul, {x(b), k(b)}), b.splat(weight, 3)});
             b.end_for(std::vector{b.emit(Op::Add, {b.loop_carried(0), term}), b.emit(Op::Sin, {b.loop_carried(1)})});
             return b.result(loop, 0);
         },
         {6, -18, 120},
         true},
        // y = k y + x, three times from y = 1: k^2 x + k x + x
        {"Horner in a loop",
         kFloat3,
         [](Builder& b) {
             const Value loop =
                 b.begin_for(b.constant(kInt, {0}), b.constant(kInt, {3}), std::vector{numbers(b, {1, 1, 1})});
             const Value scaled = b.emit(Op::Mul, {b.loop_carried(0), k(b)});
             b.end_for(std::vector{b.emit(Op::Add, {scaled, x(b)})});
             return b.result(loop, 0);
         },
         {3.5, 3, 105},
         true},
        {"if (k.z > 0) { sin(k) x, k } else { k, x }",
         kFloat3,
         [](Builder& b) {
             const Value branch = b.begin_if(b.emit(Op::Greater, {scalar(b), numbers(b, {0})}));
             const std::vector one = {b.emit(Op::Mul, {x(b), b.emit(Op::Sin, {k(b)})}), k(b)};
             b.begin_else();
             const std::vector other = {b.emit(Op::Exp, {k(b)}), x(b)};
             b.end_if(one, other);
             return b.emit(Op::Add, {b.result(branch, 1), b.result(branch, 0)});
         },
         {2 * std::sin(0.5), 3 * std::sin(-1.0), 5 * std::sin(4.0)},
         true},
        {"array[int(k.z)]",
         kFloat3,
         [](Builder& b) {
             const Type array = b.module().array_of(kFloat3, 3);
             const Value three = b.construct(array, std::vector{k(b), x(b), b.emit(Op::Neg, {x(b)})});
             return b.emit(Op::Index, kFloat3, {three, b.convert(b.extract(k(b), 0), Scalar::Int)});
         },
         {0, 0, 0},
         true},  // element 0 is k
    };
    return all;
}

TEST(LinearPart, OfEachOp) {
    const Numbers x = {2, 3, 5}, k = {0.5, -1, 4};
    for (const Case& test : cases()) {
        for (const bool fold : {true, false}) {
            for (const bool componentwise : {false, true}) {
                Module module;
                const FunctionId f = add(module, "f", {kXyz, kK, kC}, test.result, test.body, fold);
                const LinearOptions options{.componentwise = componentwise, .build = {.fold = fold}};
                const LinearPart made = linear_part(module, f, kFirst, options);
                const std::string text = std::string(test.name) + "\n" + dump(module);
                if (componentwise && !test.is_diagonal) {
                    EXPECT_FALSE(made.function) << text;
                    continue;
                }
                ASSERT_TRUE(made.function) << text << made.reason;
                const bool is_zero =
                    std::all_of(test.linear.begin(), test.linear.end(), [](double v) { return v == 0; });
                EXPECT_TRUE(made.depends || is_zero) << text;
                expect_near(evaluate(module, push(module, *made.function), {x, k, {1}}), test.linear, text);
                const Numbers constant = evaluate(module, f, {{0, 0, 0}, k, {1}});
                const FunctionId rest = push(module, without(module, f, kFirst, options.build));
                expect_near(evaluate(module, rest, {x, k, {1}}), constant, text);
            }
        }
    }
}

TEST(LinearPart, OfWhatDoesNotReadXIsZero) {
    Module module;
    const FunctionId f =
        add(module, "f", {kXyz, kK}, kFloat3, [](Builder& b) { return b.emit(Op::Sin, {b.param(1)}); });
    const LinearPart made = linear_part(module, f, kFirst);
    ASSERT_TRUE(made.function);
    EXPECT_FALSE(made.depends);
    EXPECT_EQ(made.function->insts.size(), 2u) << dump(module, *made.function);  // a constant and its return
}

// --- what is left without x

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
        // Not affine in x: what leads there goes, and the rest is what it is at zero.
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

// What x does not multiply stays as it is, NaN and all: the builder knows no 0 k = 0.
TEST(Without, KeepsProductsWithOtherZeros) {
    Module module;
    const FunctionId f = add(module, "f", {kXyz, kK}, kFloat3, [](Builder& b) {
        const Value none = b.emit(Op::Mul, {numbers(b, {0, 0, 0}), b.param(1)});
        const Value both = b.emit(Op::Mul, {b.emit(Op::Add, {b.param(0), b.param(1)}), numbers(b, {0, 0, 0})});
        return b.emit(Op::Add, {b.emit(Op::Add, {b.param(0), none}), both});
    });
    const FunctionId rest = push(module, without(module, f, kFirst));
    EXPECT_EQ(count(module[rest], Op::Mul), 1u) << dump(module, module[rest]);  // 0 k, which both have come to
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double left : evaluate(module, rest, {{2, 3, 5}, {infinity, infinity, infinity}}))
        EXPECT_TRUE(std::isnan(left));
}

// --- what is not affine

struct Refusal {
    const char* name;
    Body body;  // makes the culprit with origin 1, everything else with origin 0
    const char* reason;
};

Value blamed(Builder& b, const std::function<Value()>& make) {
    b.set_origin({1});
    const Value value = make();
    b.set_origin({0});
    return value;
}

std::vector<Refusal> refusals() {
    static const auto x = [](Builder& b) { return b.param(0); };
    static const auto k = [](Builder& b) { return b.param(1); };
    std::vector<Refusal> all = {
        {"x * x", [](Builder& b) { return blamed(b, [&] {
                                       return b.emit(Op::Mul, {x(b), x(b)});
                                   }); },
         "'mul' is given two values that depend on it"},
        {"k / x", [](Builder& b) { return blamed(b, [&] {
                                       return b.emit(Op::Div, {k(b), x(b)});
                                   }); },
         "'div' is not linear"},
        {"lerp(x, k, x)", [](Builder& b) { return blamed(b, [&] {
                                               return b.emit(Op::Lerp, {x(b), k(b), x(b)});
                                           }); },
         "'lerp' is given two values that depend on it"},
        {"dot(x, x)",
         [](Builder& b) {
             return b.splat(blamed(b, [&] { return b.emit(Op::Dot, {x(b), x(b)}); }), 3);
         },
         "'dot' is given two values that depend on it"},
        {"pow(x, k)", [](Builder& b) { return blamed(b, [&] {
                                           return b.emit(Op::Pow, {x(b), k(b)});
                                       }); },
         "'pow' is not linear"},
        {"max(x, 0) + x",
         [](Builder& b) {
             const Value most = blamed(b, [&] { return b.emit(Op::Max, {x(b), k(b)}); });
             return b.emit(Op::Add, {b.emit(Op::Mul, {most, k(b)}), x(b)});
         },
         "'max' is not linear"},
        // The first that breaks it is named, not what follows.
        {"sqrt(saturate(x))",
         [](Builder& b) { return b.emit(Op::Sqrt, {blamed(b, [&] { return b.emit(Op::Saturate, {x(b)}); })}); },
         "'saturate' is not linear"},
        {"any(x > k) ? 1 : 0",
         [](Builder& b) {
             const Value above = blamed(b, [&] { return b.emit(Op::Greater, {x(b), k(b)}); });
             return b.emit(Op::Select, {b.emit(Op::Any, {above}), k(b), x(b)});
         },
         "'greater' is not linear"},
        {"if (x.x > k.x)",
         [](Builder& b) {
             const Value above = blamed(b, [&] {
                 return b.emit(Op::Greater, {b.extract(x(b), 0), b.extract(k(b), 0)});
             });
             const Value branch = b.begin_if(above);
             const Value one = b.emit(Op::Sin, {k(b)});
             b.begin_else();
             const Value other = k(b);
             b.end_if(std::vector{one}, std::vector{other});
             return b.result(branch, 0);
         },
         "'greater' is not linear"},
        {"for (i < int(x.x))",
         [](Builder& b) {
             const Value end = blamed(b, [&] { return b.convert(b.extract(x(b), 0), Scalar::Int); });
             const Value loop = b.begin_for(b.constant(kInt, {0}), end, std::vector{k(b)});
             b.end_for(std::vector{b.emit(Op::Sin, {b.loop_carried(0)})});
             return b.result(loop, 0);
         },
         "'convert' is not linear"},
        {"y = x y in a loop",
         [](Builder& b) {
             const Value loop = b.begin_for(b.constant(kInt, {0}), b.constant(kInt, {3}), std::vector{k(b)});
             b.end_for(std::vector{blamed(b, [&] { return b.emit(Op::Mul, {b.loop_carried(0), x(b)}); })});
             return b.result(loop, 0);
         },
         "'mul' is given two values that depend on it"},
        {"k[int(x.x)]",
         [](Builder& b) {
             const Value at = blamed(b, [&] { return b.convert(b.extract(x(b), 0), Scalar::Int); });
             return b.splat(b.emit(Op::Index, kFloat, {k(b), at}), 3);
         },
         "'convert' is not linear"},
        {"reflect(k, x)", [](Builder& b) { return blamed(b, [&] {
                                               return b.emit(Op::Reflect, {k(b), x(b)});
                                           }); },
         "'reflect' is not linear"},
        {"ddx(x)", [](Builder& b) { return blamed(b, [&] { return b.emit(Op::Ddx, {x(b)}); }); },
         "'ddx' is not linear"},
    };
    return all;
}

void add_origins(Module& module) {
    module.origins = {{.label = "", .id = "innocent", .span = {}}, {.label = "", .id = "culprit", .span = {}}};
}

TEST(LinearPart, OfWhatIsNotAffineIsRefusedAtItsPlace) {
    for (const Refusal& test : refusals()) {
        for (const bool fold : {true, false}) {
            Module module;
            add_origins(module);
            const FunctionId f = add(
                module, "f", {kXyz, kK}, kFloat3,
                [&](Builder& b) {
                    b.set_origin({0});
                    return test.body(b);
                },
                fold);
            const LinearPart made = linear_part(module, f, kFirst, {.componentwise = false, .build = {.fold = fold}});
            EXPECT_FALSE(made.function) << test.name;
            EXPECT_TRUE(made.depends) << test.name;
            EXPECT_EQ(made.reason, test.reason) << test.name;
            ASSERT_TRUE(made.origin) << test.name;
            EXPECT_EQ(module.origins[made.origin.index].id, "culprit") << test.name;
        }
    }
}

// An op that is in no rule of this file is refused rather than taken for constant.
TEST(LinearPart, OfEveryOtherFunctionOfOneTypeIsRefused) {
    int refused = 0;
    for (std::size_t i = 0; i < kOpCount; i++) {
        const Op op = static_cast<Op>(i);
        if (info(op).rule != TypeRule::Same || info(op).arguments < 1) continue;
        if (std::ranges::count(std::vector{Op::Add, Op::Sub, Op::Mul, Op::Div, Op::Neg, Op::Lerp, Op::Radians,
                                           Op::Degrees, Op::Cross, Op::Reflect},
                               op) > 0)
            continue;
        const bool is_bitwise = op >= Op::And && op <= Op::ShiftRight;
        if (is_bitwise) continue;
        Module module;
        const FunctionId f = add(
            module, "f", {kXyz, kK}, kFloat3,
            [&](Builder& b) {
                const std::vector<Value> args(static_cast<std::size_t>(info(op).arguments), b.param(0));
                return b.emit(op, kFloat3, args);
            },
            false);
        const LinearPart made = linear_part(module, f, kFirst);
        EXPECT_FALSE(made.function) << info(op).text;
        EXPECT_EQ(made.reason, "'" + std::string(info(op).text) + "' is not linear");
        refused++;
    }
    EXPECT_GT(refused, 30);
}

TEST(LinearPart, SaysWhatMixesComponents) {
    Module module;
    add_origins(module);
    const FunctionId f = add(module, "f", {kXyz, kK}, kFloat3, [](Builder& b) {
        b.set_origin({0});
        const Value scaled = b.emit(Op::Mul, {b.param(0), b.param(1)});
        const Value gray = blamed(b, [&] { return b.emit(Op::Dot, {scaled, b.param(1)}); });
        return b.emit(Op::Add, {scaled, b.splat(gray, 3)});
    });
    EXPECT_TRUE(linear_part(module, f, kFirst).function);
    const LinearPart made = linear_part(module, f, kFirst, {.componentwise = true, .build = {}});
    EXPECT_FALSE(made.function);
    EXPECT_EQ(made.reason, "'dot' mixes its components");
    ASSERT_TRUE(made.origin);
    EXPECT_EQ(module.origins[made.origin.index].id, "culprit");
    // A component in the wrong place that nothing has mixed.
    const FunctionId g = add(module, "g", {kXyz}, kFloat, [](Builder& b) { return b.extract(b.param(0), 1); });
    EXPECT_FALSE(linear_part(module, g, kFirst, {.componentwise = true, .build = {}}).function);
}

// --- structs, calls

TEST(LinearPart, OfAMemberOfAStruct) {
    for (const bool fold : {true, false}) {
        Module module;
        add_origins(module);
        const Param lit{"lit", surface(module), Rate::Pixel};
        // A function that is given the struct and does not look at x: it stays a call.
        const FunctionId smooth = add(
            module, "smoothness", {lit}, kFloat,
            [](Builder& b) {
                return b.emit(Op::Sub, {numbers(b, {1}), b.extract(b.param(0), 1)});
            },
            fold);
        // One that makes a new struct of it, with x and the normal in each other's places.
        const FunctionId swap = add(
            module, "swap", {lit}, lit.type,
            [&](Builder& b) {
                const Value whole = b.param(0);
                const Value sine = b.emit(Op::Sin, {b.extract(whole, 1)});
                return b.construct(lit.type, std::vector{b.extract(whole, 2), sine, b.extract(whole, 0)});
            },
            fold);
        // 2 color + sin(normal), taken from the swapped struct, times (1 - roughness)
        const FunctionId f = add(
            module, "f", {lit}, kFloat3,
            [&](Builder& b) {
                const Value whole = b.param(0);
                const Value swapped = b.call(swap, std::vector{whole});
                const Value sine = b.emit(Op::Sin, {b.extract(swapped, 0)});
                const Value color = b.extract(swapped, 2);
                const Value sum = b.emit(Op::Add, {b.emit(Op::Add, {color, color}), sine});
                return b.emit(Op::Mul, {sum, b.splat(b.call(smooth, std::vector{whole}), 3)});
            },
            fold);
        const LinearOptions options{.componentwise = true, .build = {.fold = fold}};
        const LinearPart made = linear_part(module, f, Seed::of_member(0, 0), options);
        ASSERT_TRUE(made.function) << made.reason;
        EXPECT_EQ(count(*made.function, Op::Call), 1u) << dump(module, *made.function);
        EXPECT_EQ(count(*made.function, Op::Sin), 0u) << dump(module, *made.function);  // nothing that A does not need
        const Flat argument = {2, 3, 5, 0.25, 0.1, 0.2, 0.3};
        expect_near(evaluate(module, push(module, *made.function), {argument}), {3, 4.5, 7.5}, dump(module));
        const FunctionId rest = push(module, without(module, f, Seed::of_member(0, 0), options.build));
        expect_near(evaluate(module, rest, {argument}),
                    {0.75 * std::sin(0.1), 0.75 * std::sin(0.2), 0.75 * std::sin(0.3)}, dump(module));
        EXPECT_FALSE(linear_part(module, f, Seed::of_member(0, 2), options).function);  // the normal's sine
        EXPECT_FALSE(linear_part(module, f, Seed::of_member(0, 1), {}).depends == false);
    }
}

TEST(LinearPart, OfTheResultsOfCalls) {
    for (const bool fold : {true, false}) {
        Module module;
        add_origins(module);
        const FunctionId g = add(
            module, "g", {kXyz}, kFloat3, [](Builder& b) { return b.emit(Op::Exp, {b.param(0)}); }, fold);
        // h calls it: 3 g(k)
        const FunctionId h = add(
            module, "h", {kK}, kFloat3,
            [&](Builder& b) {
                return b.emit(Op::Mul, {b.call(g, std::vector{b.param(0)}), numbers(b, {3, 3, 3})});
            },
            fold);
        // k g(2 k) + h(k) + sin(k)
        const FunctionId f = add(
            module, "f", {kK}, kFloat3,
            [&](Builder& b) {
                const Value k = b.param(0), twice = b.emit(Op::Add, {k, k});
                const Value sum =
                    b.emit(Op::Add, {b.emit(Op::Mul, {k, b.call(g, std::vector{twice})}), b.call(h, std::vector{k})});
                return b.emit(Op::Add, {sum, b.emit(Op::Sin, {k})});
            },
            fold);
        const LinearOptions options{.componentwise = true, .build = {.fold = fold}};
        const LinearPart made = linear_part(module, f, Seed::of_calls(g), options);
        ASSERT_TRUE(made.function) << made.reason;
        EXPECT_EQ(count(*made.function, Op::Call), 2u) << dump(module, *made.function);  // both of g, h is spelled out
        const Numbers k = {0.5, -1, 0.25};
        Numbers linear, constant;
        for (const double at : k) {
            linear.push_back(at * std::exp(2 * at) + 3 * std::exp(at));
            constant.push_back(std::sin(at));
        }
        expect_near(evaluate(module, push(module, *made.function), {k}), linear, dump(module));
        const Function rest = without(module, f, Seed::of_calls(g), options.build);
        EXPECT_EQ(count(rest, Op::Call), 0u) << dump(module, rest);
        expect_near(evaluate(module, push(module, rest), {k}), constant, dump(module));

        // g of g is not affine in what g gives.
        const FunctionId twice = add(
            module, "twice", {kK}, kFloat3,
            [&](Builder& b) {
                const Value inner = b.call(g, std::vector{b.param(0)});
                return blamed(b, [&] { return b.call(g, std::vector{inner}); });
            },
            fold);
        const LinearPart refused = linear_part(module, twice, Seed::of_calls(g), options);
        EXPECT_FALSE(refused.function);
        EXPECT_EQ(refused.reason, "what it is called with depends on it");
        EXPECT_EQ(refused.origin, OriginId{1});
    }
}

TEST(LinearPart, BlamesTheCallOfWhatIsCrookedInside) {
    Module module;
    add_origins(module);
    const FunctionId square = add(module, "square", {kXyz}, kFloat3, [](Builder& b) {
        return b.emit(Op::Mul, {b.param(0), b.param(0)});
    });
    const FunctionId f = add(module, "f", {kXyz}, kFloat3, [&](Builder& b) {
        const Value squared = blamed(b, [&] { return b.call(square, std::vector{b.param(0)}); });
        return b.emit(Op::Add, {squared, b.param(0)});
    });
    const LinearPart made = linear_part(module, f, kFirst);
    EXPECT_EQ(made.reason, "'mul' is given two values that depend on it, in square");
    EXPECT_EQ(made.origin, OriginId{1});
}

// f_n = f_(n-1) + f_(n-1): two to the power of 40 calls of x, if all were spelled out.
TEST(LinearPart, OfTooMuchIsRefused) {
    Module module;
    FunctionId last = add(module, "f", {kXyz}, kFloat3, [](Builder& b) { return b.param(0); });
    for (int n = 0; n < 25; n++) {
        last = add(module, "f" + std::to_string(n), {kXyz}, kFloat3, [&](Builder& b) {
            const Value x = b.param(0), shifted = b.emit(Op::Add, {x, numbers(b, {1, 1, 1})});
            return b.emit(Op::Add, {b.call(last, std::vector{x}), b.call(last, std::vector{shifted})});
        });
    }
    const LinearPart made = linear_part(module, last, kFirst);
    EXPECT_FALSE(made.function);
    EXPECT_TRUE(made.reason.starts_with("too much is called to look into")) << made.reason;
}

// --- which members are read

TEST(MembersRead, OfAStructParameter) {
    Module module;
    module.origins.resize(9);
    const Param lit{"lit", surface(module), Rate::Pixel};
    const FunctionId smooth = add(
        module, "smoothness", {kXyz, lit}, kFloat, [](Builder& b) { return b.extract(b.param(1), 1); }, false);
    const auto at = [](Builder& b, std::uint32_t origin, Value value) {
        b.set_origin({origin + 1});
        return value;
    };
    const FunctionId f = add(
        module, "f", {kXyz, lit}, kFloat3,
        [&](Builder& b) {
            b.set_origin({0});
            const Value x = b.param(0), whole = at(b, 0, b.param(1));
            at(b, 1, b.extract(whole, 0));                                        // origin 1, not used
            const Value first = at(b, 2, b.call(smooth, std::vector{x, whole}));  // origin 2
            const Value second = at(b, 3, b.extract(whole, 1));                   // origin 3
            return b.splat(b.emit(Op::Add, {first, second}), 3);
        },
        false);
    const std::vector<MemberRead> reads = members_read(module, f, 1);
    ASSERT_EQ(reads.size(), 1u);
    EXPECT_EQ(reads[0].member, 1u);
    EXPECT_EQ(reads[0].origin, OriginId{2});
    // The struct as a whole: given back, chosen, or carried by a loop.
    const FunctionId back = add(
        module, "back", {lit}, lit.type, [](Builder& b) { return b.param(0); }, false);
    EXPECT_EQ(members_read(module, back, 0).size(), 3u);
    const FunctionId branch = add(module, "branch", {lit, kC}, kFloat3, [](Builder& b) {
        const Value structure = b.begin_if(b.param(1));
        const Value changed = b.emit(Op::Insert, b.type(b.param(0)), {b.param(0), numbers(b, {1, 1, 1})}, 0);
        b.begin_else();
        const Value unchanged = b.param(0);
        b.end_if(std::vector{changed}, std::vector{unchanged});
        return b.extract(b.result(structure, 0), 2);
    });
    EXPECT_EQ(members_read(module, branch, 0).size(), 3u);
    const FunctionId none = add(module, "none", {lit}, kFloat, [](Builder& b) { return numbers(b, {1}); });
    EXPECT_TRUE(members_read(module, none, 0).empty());
}

// --- at random

// Functions of a struct { float3 x, float k } and a float3, of ops that are mostly linear. They call one another.
class RandomFunctions {
public:
    explicit RandomFunctions(unsigned seed, bool fold) : random_(seed) {
        module.structs.push_back({"Pair", {{"x", kFloat3}, {"k", kFloat3}}});
        for (int n = 0; n < 3; n++) {
            visible_.clear();
            const std::vector<Param> params = {{"pair", Type::structure(0), Rate::Pixel}, kK};
            last = add(
                module, "f" + std::to_string(n), params, kFloat3,
                [&](Builder& b) {
                    visible_ = {b.extract(b.param(0), 0), b.extract(b.param(0), 1), b.param(1)};
                    statements(b, 7, 0);
                    return b.emit(Op::Add, {any(), any()});
                },
                fold);
            callable_.push_back(last);
        }
    }
    Module module;
    FunctionId last;

private:
    std::uint32_t pick(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
    // Half of all values are late ones, which depend on more.
    Value any() {
        const auto n = static_cast<std::uint32_t>(visible_.size());
        return visible_[pick(2) == 0 ? pick(n) : n - 1 - pick(std::min(n, 3u))];
    }
    // One of the first values or of their kind: more likely to be independent of x.
    Value factor(Builder& b) { return pick(3) == 0 ? any() : b.emit(Op::Sin, {visible_[1 + pick(2)]}); }

    void statements(Builder& b, int n, int depth) {
        for (int i = 0; i < n; i++) {
            const std::uint32_t kind = pick(12);
            if (kind == 0 && depth < 2) {
                branch(b, depth);
            } else if (kind == 1 && depth < 2) {
                loop(b, depth);
            } else if (kind == 2 && !callable_.empty()) {
                const Value pair = b.construct(Type::structure(0), std::vector{any(), factor(b)});
                visible_.push_back(b.call(callable_[pick(static_cast<std::uint32_t>(callable_.size()))],
                                          std::vector{pair, factor(b)}));
            } else {
                visible_.push_back(arithmetic(b));
            }
        }
    }

    Value arithmetic(Builder& b) {
        const Value x = any();
        switch (pick(12)) {
            case 0: return b.emit(Op::Neg, {x});
            case 1: return b.emit(Op::Sub, {x, any()});
            case 2: return b.emit(Op::Mul, {factor(b), x});
            case 3: return b.emit(Op::Div, {x, b.emit(Op::Exp, {factor(b)})});
            case 4: return b.swizzle(x, std::vector{pick(3), pick(3), pick(3)});
            case 5: return b.splat(b.emit(Op::Dot, {x, factor(b)}), 3);
            case 6: return b.emit(Op::Cross, {factor(b), x});
            case 7: return b.emit(Op::Lerp, {x, any(), factor(b)});
            case 8: return b.emit(Op::Select, {b.emit(Op::Less, {factor(b), factor(b)}), x, any()});
            case 9: return b.emit(Op::Insert, kFloat3, {x, b.extract(any(), pick(3))}, pick(3));
            case 10: return pick(4) == 0 ? b.emit(Op::Max, {x, any()}) : b.emit(Op::Add, {x, any()});
            default:
                return b.construct(
                    kFloat3, std::vector{b.extract(any(), pick(3)), b.swizzle(any(), std::vector{pick(3), pick(3)})});
        }
    }

    void branch(Builder& b, int depth) {
        const Value at = b.extract(factor(b), pick(3));
        const Value structure = b.begin_if(b.emit(Op::Less, {at, numbers(b, {0.3})}));
        const std::size_t before = visible_.size();
        std::vector<Value> values[2];
        for (int side = 0; side < 2; side++) {
            if (side == 1) b.begin_else();
            statements(b, static_cast<int>(pick(3)), depth + 1);
            values[side] = {any(), any(), factor(b)};
            visible_.resize(before);
        }
        b.end_if(values[0], values[1]);
        for (std::uint32_t i = 0; i < 3; i++) visible_.push_back(b.result(structure, i));
    }

    void loop(Builder& b, int depth) {
        const Value begin = b.constant(kInt, {0}), end = b.constant(kInt, {static_cast<double>(pick(4))});
        const std::vector<Value> initial = {any(), factor(b), any()};
        const Value structure = b.begin_for(begin, end, initial, pick(2) == 0);
        const std::size_t before = visible_.size();
        for (std::uint32_t i = 0; i < 3; i++) visible_.push_back(b.loop_carried(i));
        statements(b, 1 + static_cast<int>(pick(3)), depth + 1);
        const std::vector<Value> next = {any(), factor(b), pick(2) == 0 ? b.loop_carried(2) : any()};
        b.end_for(next);
        visible_.resize(before);
        for (std::uint32_t i = 0; i < 3; i++) visible_.push_back(b.result(structure, i));
    }

    std::mt19937 random_;
    std::vector<Value> visible_;
    std::vector<FunctionId> callable_;
};

Numbers combined(const Numbers& a, const Numbers& b, double factor) {
    Numbers made;
    for (std::size_t i = 0; i < a.size(); i++) made.push_back(a[i] + factor * b[i]);
    return made;
}

TEST(LinearPart, OfRandomFunctionsIsWhatTheyAddToTheirValueAtZero) {
    int affine = 0, diagonal = 0, refused = 0;
    for (unsigned seed = 0; seed < 1500; seed++) {
        const bool fold = seed % 2 == 0;
        RandomFunctions random(seed, fold);
        Module& module = random.module;
        ASSERT_EQ(verify(module), "");
        const LinearOptions options{.componentwise = false, .build = {.fold = fold}};
        const LinearPart made = linear_part(module, random.last, Seed::of_member(0, 0), options);
        const FunctionId rest = push(module, without(module, random.last, Seed::of_member(0, 0), options.build));
        const auto f = [&](FunctionId id, double scale) {
            return evaluate(module, id, {{0.7 * scale, -0.4 * scale, 1.3 * scale, 0.6, -0.2, 0.9}, {0.3, 1.1, -0.8}});
        };
        const Numbers at_zero = f(random.last, 0);
        const std::string text = "seed " + std::to_string(seed) + "\n" + dump(module);
        expect_near(f(rest, 1), at_zero, text);
        if (!made.function) {
            refused++;
            EXPECT_FALSE(made.reason.empty());
            continue;
        }
        affine++;
        const FunctionId linear = push(module, *made.function);
        const double size = std::abs(at_zero[0]) + std::abs(at_zero[1]) + std::abs(at_zero[2]);
        if (!(size < 1e3)) continue;  // differences of large numbers show nothing
        for (const double scale : {1.0, 2.0}) {
            expect_near(f(linear, scale), combined(f(random.last, scale), at_zero, -1), text);
        }
        if (!linear_part(module, random.last, Seed::of_member(0, 0), {.componentwise = true, .build = {}}).function)
            continue;
        diagonal++;
        // The second component of x alone moves the second of the result alone.
        const Numbers one = evaluate(module, linear, {{0, 1, 0, 0.6, -0.2, 0.9}, {0.3, 1.1, -0.8}});
        EXPECT_EQ(one[0], 0) << text;
        EXPECT_EQ(one[2], 0) << text;
        if (HasFailure()) return;
    }
    EXPECT_GT(affine, 300);
    EXPECT_GT(diagonal, 50);
    EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace patina::ir
