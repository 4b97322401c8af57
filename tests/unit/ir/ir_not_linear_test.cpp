// What is not affine is refused, with the reason and the place.
#include <cmath>
#include <functional>

#include "tests/unit/ir/ir_linear_testing.h"

namespace patina::ir {
namespace {

struct Refusal {
    const char* name;
    Body body;  // makes the culprit with origin 1, everything else with origin 0
    const char* reason;
};

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

}  // namespace
}  // namespace patina::ir
