// Linear parts against closed forms, op by op and through structs and calls; and which members of a struct a function
// reads.
#include <cmath>

#include "tests/unit/ir/ir_linear_testing.h"

namespace patina::ir {
namespace {

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
        EXPECT_EQ(refused.reason, "its arguments depend on it");
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
    EXPECT_TRUE(made.reason.starts_with("it calls too many functions to check")) << made.reason;
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

}  // namespace
}  // namespace patina::ir
