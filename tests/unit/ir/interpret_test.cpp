// The CPU reference against closed forms: each op in float, double and half, integers at their limits, lanes that go
// different ways, and derivatives over the quad.
#include "compiler/interpret/interpret.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "compiler/interpret/kernels.h"
#include "compiler/interpret/rounding.h"
#include "compiler/ir/builder.h"
#include "compiler/ir/verify.h"

using namespace patina;
using namespace patina::ir;
using interpret::Flat;
using interpret::QuadResult;
using interpret::Resources;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// One function, built without folding.
struct Body {
    Module module;
    Function function;
    std::unique_ptr<Builder> b;

    explicit Body(std::vector<Type> params) {
        for (Type type : params) function.params.push_back({.name = "p", .type = type});
        b = std::make_unique<Builder>(module, function, BuildOptions{.fold = false});
    }
    FunctionId finish(Value result) {
        function.result = b->type(result);
        b->ret(result);
        module.functions.push_back(std::move(function));
        EXPECT_EQ(verify(module), "");
        return {static_cast<std::uint32_t>(module.functions.size() - 1)};
    }
};

using Lanes = std::array<std::vector<Flat>, 4>;
Lanes everywhere(const std::vector<Flat>& arguments) {
    return {arguments, arguments, arguments, arguments};
}

// The op's result for these operands, the same in all lanes. The operands are arguments: nothing is known beforehand.
Flat compute(Precision precision, Op op, Type type, std::vector<Type> types, std::vector<Flat> operands,
             std::uint32_t data = 0) {
    Body body(types);
    std::vector<Value> args;
    for (std::uint32_t i = 0; i < types.size(); ++i) args.push_back(body.b->param(i));
    const FunctionId f = body.finish(body.b->emit(op, type, args, data));
    const QuadResult result = interpret::run(body.module, f, everywhere(operands), {}, precision);
    for (const Flat& lane : result.lanes) EXPECT_EQ(lane.size(), interpret::flat_size(body.module, type));
    return result.lanes[3];
}

double compute1(Precision precision, Op op, Scalar scalar, std::vector<double> operands) {
    std::vector<Flat> flat;
    for (double x : operands) flat.push_back({x});
    const Type type = Type::scalar_of(scalar);
    const std::vector<Type> types(operands.size(), type);
    const TypeRule rule = info(op).rule;
    const bool is_bool = rule == TypeRule::Compare || rule == TypeRule::Bools;
    return compute(precision, op, is_bool ? kBool : type, types, flat).at(0);
}
double in_double(Op op, std::vector<double> operands) {
    return compute1(Precision::Double, op, Scalar::Float, std::move(operands));
}
double in_float(Op op, std::vector<double> operands) {
    return compute1(Precision::Float, op, Scalar::Float, std::move(operands));
}
double in_half(Op op, std::vector<double> operands) {
    return compute1(Precision::Double, op, Scalar::Half, std::move(operands));
}
double in_int(Op op, std::vector<double> operands) {
    return compute1(Precision::Float, op, Scalar::Int, std::move(operands));
}
double in_uint(Op op, std::vector<double> operands) {
    return compute1(Precision::Float, op, Scalar::Uint, std::move(operands));
}

void expect_near(const Flat& actual, const Flat& expected, double tolerance = 1e-15) {
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "at " << i;
}

}  // namespace

// --- component by component

TEST(InterpretOps, EveryOpThatComputesHasAMeaning) {
    for (std::size_t i = 0; i < kOpCount; ++i) {
        const Op op = static_cast<Op>(i);
        const TypeRule rule = info(op).rule;
        if (rule == TypeRule::Declared || rule == TypeRule::Void || op == Op::Insert) continue;
        bool found = interpret::sampling_kernel(op, Kind::Texture2D) != nullptr;
        for (Precision p : {Precision::Float, Precision::Double}) {
            found = found || interpret::vector_kernel(op, Scalar::Float, p);
            for (Scalar s : {Scalar::Float, Scalar::Int}) found = found || interpret::arithmetic_kernel(op, s, p);
        }
        EXPECT_TRUE(found) << info(op).text;
    }
}

TEST(InterpretReal, FunctionsInDoubleAndInFloat) {
    const double pi = std::numbers::pi, e = std::numbers::e, r2 = std::numbers::sqrt2;
    struct Case {
        Op op;
        std::vector<double> operands;
        double expected;
    };
    const Case cases[] = {
        {Op::Add, {1.5, 2}, 3.5},
        {Op::Sub, {1.5, 2}, -0.5},
        {Op::Mul, {1.5, -2}, -3},
        {Op::Div, {3, 8}, 0.375},
        {Op::Mod, {-7.5, 2}, -1.5},
        {Op::Mod, {7.5, -2}, 1.5},
        {Op::Neg, {2}, -2},
        {Op::Abs, {-2.5}, 2.5},
        {Op::Sign, {-0.1}, -1},
        {Op::Sign, {0}, 0},
        {Op::Sign, {3}, 1},
        {Op::Floor, {-1.5}, -2},
        {Op::Ceil, {-1.5}, -1},
        {Op::Trunc, {-1.5}, -1},
        {Op::Round, {2.5}, 2},
        {Op::Round, {3.5}, 4},
        {Op::Round, {-0.75}, -1},
        {Op::Frac, {-1.25}, 0.75},
        {Op::Saturate, {1.5}, 1},
        {Op::Saturate, {-1}, 0},
        {Op::Saturate, {0.25}, 0.25},
        {Op::Sqrt, {2}, r2},
        {Op::Rsqrt, {2}, 1 / r2},
        {Op::Exp, {1}, e},
        {Op::Exp2, {0.5}, r2},
        {Op::Log, {e}, 1},
        {Op::Log2, {8}, 3},
        {Op::Sin, {pi / 6}, 0.5},
        {Op::Cos, {pi / 3}, 0.5},
        {Op::Tan, {pi / 4}, 1},
        {Op::Asin, {0.5}, pi / 6},
        {Op::Acos, {0.5}, pi / 3},
        {Op::Atan, {1}, pi / 4},
        {Op::Sinh, {1}, (e - 1 / e) / 2},
        {Op::Cosh, {1}, (e + 1 / e) / 2},
        {Op::Tanh, {0.5}, (e - 1) / (e + 1)},
        {Op::Radians, {180}, pi},
        {Op::Degrees, {pi}, 180},
        {Op::Min, {1, 2}, 1},
        {Op::Max, {1, 2}, 2},
        {Op::Pow, {2, 0.5}, r2},
        {Op::Pow, {0, 3}, 0},
        {Op::Atan2, {1, -1}, 3 * pi / 4},
        {Op::Step, {0.5, 0.5}, 1},
        {Op::Step, {0.5, 0.4}, 0},
        {Op::Clamp, {3, 0, 2}, 2},
        {Op::Clamp, {-1, 0, 2}, 0},
        {Op::Lerp, {10, 20, 0.25}, 12.5},
        {Op::Smoothstep, {0, 2, 0.5}, 0.15625},
        {Op::Smoothstep, {0, 2, 5}, 1},
        {Op::Smoothstep, {2, 0, 0.5}, 0.84375},
    };
    for (const Case& c : cases) {
        const double scale = std::max(1.0, std::fabs(c.expected));
        EXPECT_NEAR(in_double(c.op, c.operands), c.expected, 4e-16 * scale) << info(c.op).text;
        const double single = in_float(c.op, c.operands);
        EXPECT_NEAR(single, c.expected, 3e-7 * scale) << info(c.op).text;
        EXPECT_EQ(single, static_cast<double>(static_cast<float>(single))) << info(c.op).text;
    }
}

TEST(InterpretReal, Comparisons) {
    const auto all = [](double x, double y) {
        std::string signs;
        for (Op op : {Op::Less, Op::LessEqual, Op::Greater, Op::GreaterEqual, Op::Equal, Op::NotEqual}) {
            signs += in_double(op, {x, y}) != 0 ? '1' : '0';
        }
        return signs;
    };
    EXPECT_EQ(all(1, 2), "110001");
    EXPECT_EQ(all(2, 2), "010110");
    EXPECT_EQ(all(2, 1), "001101");
    EXPECT_EQ(all(kNan, 1), "000001");
    EXPECT_EQ(all(0.0, -0.0), "010110");
}

TEST(InterpretReal, NanAndInfinity) {
    EXPECT_EQ(in_double(Op::Min, {kNan, 1}), 1);
    EXPECT_EQ(in_double(Op::Max, {1, kNan}), 1);
    EXPECT_EQ(in_double(Op::Clamp, {kNan, 2, 3}), 2);
    EXPECT_EQ(in_double(Op::Saturate, {kNan}), 0);
    EXPECT_EQ(in_double(Op::IsNan, {kNan}), 1);
    EXPECT_EQ(in_double(Op::IsNan, {kInf}), 0);
    EXPECT_EQ(in_double(Op::IsInf, {-kInf}), 1);
    EXPECT_EQ(in_double(Op::IsInf, {1}), 0);
    EXPECT_TRUE(std::isnan(in_double(Op::Pow, {-2, 2})));
    EXPECT_TRUE(std::isnan(in_double(Op::Sqrt, {-1})));
    EXPECT_EQ(in_double(Op::Div, {1, 0}), kInf);
    EXPECT_EQ(in_double(Op::Rsqrt, {0}), kInf);
}

TEST(InterpretReal, FloatIsRoundedAtEveryStep) {
    EXPECT_EQ(in_float(Op::Add, {16777216, 1}), 16777216);
    EXPECT_EQ(in_double(Op::Add, {16777216, 1}), 16777217);
    EXPECT_EQ(in_float(Op::Add, {0.1, 0.2}), static_cast<double>(0.1f + 0.2f));
    EXPECT_EQ(in_float(Op::Mul, {3e38, 10}), kInf);
    EXPECT_EQ(in_double(Op::Mul, {3e38, 10}), 3e39);
    // Inside an op too: the square of 1e20 is beyond a float.
    const Flat v = {1e20, 0, 0};
    EXPECT_EQ(compute(Precision::Float, Op::Length, kFloat, {kFloat3}, {v}).at(0), kInf);
    EXPECT_EQ(compute(Precision::Double, Op::Length, kFloat, {kFloat3}, {v}).at(0), 1e20);
}

TEST(InterpretReal, ConstantsKeepTheirDigitsInDouble) {
    Body body({});
    const FunctionId f = body.finish(body.b->constant(kFloat, {0.1}));
    EXPECT_EQ(interpret::run(body.module, f, {}, {}, Precision::Double).lanes[0], Flat{0.1});
    EXPECT_EQ(interpret::run(body.module, f, {}, {}, Precision::Float).lanes[0], Flat{static_cast<double>(0.1f)});
}

// --- half

TEST(InterpretHalf, OperationsRound) {
    EXPECT_EQ(in_half(Op::Add, {0.1, 0}), 0.0999755859375);
    EXPECT_EQ(in_half(Op::Add, {1, 0x1p-11}), 1);                     // a tie goes to the even 1
    EXPECT_EQ(in_half(Op::Add, {1 + 0x1p-10, 0x1p-11}), 1 + 0x1p-9);  // and here up, to the even one
    EXPECT_EQ(in_half(Op::Mul, {60000, 2}), kInf);
    EXPECT_EQ(in_half(Op::Mul, {-60000, 2}), -kInf);
    EXPECT_EQ(in_half(Op::Div, {0x1p-14, 1024}), 0x1p-24);
    EXPECT_EQ(in_half(Op::Div, {0x1p-14, 2048}), 0);
    EXPECT_EQ(compute1(Precision::Float, Op::Sqrt, Scalar::Half, {2}), 1.4140625);
}

// Every half stands for itself, and the middle of two neighbours goes to the one whose last bit is 0. The reference
// is the definition of the format.
TEST(InterpretHalf, RoundingIsExactForAllHalves) {
    const auto value = [](int bits) {
        const int exponent = bits >> 10, fraction = bits & 1023;
        return exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
    };
    constexpr int kLargest = 0x7bff;
    for (int bits = 0; bits < kLargest; ++bits) {
        const double low = value(bits), high = value(bits + 1), middle = (low + high) / 2;
        ASSERT_EQ(interpret::to_half(low), low);
        ASSERT_EQ(interpret::to_half(-low), -low);
        ASSERT_EQ(interpret::to_half(middle), bits % 2 == 0 ? low : high) << bits;
        ASSERT_EQ(interpret::to_half(std::nextafter(middle, 0)), low) << bits;
        ASSERT_EQ(interpret::to_half(std::nextafter(middle, kInf)), high) << bits;
    }
    EXPECT_EQ(interpret::to_half(65504), 65504);
    EXPECT_EQ(interpret::to_half(65519.999), 65504);
    EXPECT_EQ(interpret::to_half(65520), kInf);
    EXPECT_EQ(interpret::to_half(-1e300), -kInf);
    EXPECT_TRUE(std::isnan(interpret::to_half(kNan)));
    EXPECT_TRUE(std::signbit(interpret::to_half(-0.0)));
}

// --- integers and bools

TEST(InterpretWhole, Arithmetic) {
    EXPECT_EQ(in_int(Op::Add, {2147483647, 1}), -2147483648.0);
    EXPECT_EQ(in_int(Op::Mul, {2147483647, 3}), 2147483645);
    EXPECT_EQ(in_uint(Op::Mul, {4294967295, 4294967295}), 1);
    EXPECT_EQ(in_uint(Op::Sub, {0, 1}), 4294967295);
    EXPECT_EQ(in_int(Op::Neg, {-2147483648.0}), -2147483648.0);
    EXPECT_EQ(in_int(Op::Abs, {-5}), 5);
    EXPECT_EQ(in_int(Op::Sign, {-5}), -1);
    EXPECT_EQ(in_int(Op::Div, {-7, 2}), -3);
    EXPECT_EQ(in_int(Op::Mod, {-7, 2}), -1);
    EXPECT_EQ(in_uint(Op::Div, {4294967295, 2}), 2147483647);
    EXPECT_EQ(in_int(Op::Div, {5, 0}), -1);
    EXPECT_EQ(in_uint(Op::Mod, {5, 0}), 4294967295);
    EXPECT_EQ(in_int(Op::Div, {-2147483648.0, -1}), -2147483648.0);
    EXPECT_EQ(in_int(Op::Min, {-2, 3}), -2);
    EXPECT_EQ(in_uint(Op::Max, {2, 4294967295}), 4294967295);
    EXPECT_EQ(in_int(Op::Clamp, {9, -1, 4}), 4);
    EXPECT_EQ(in_uint(Op::Less, {2147483648, 1}), 0);
    EXPECT_EQ(in_int(Op::Equal, {16777217, 16777216}), 0);
}

TEST(InterpretWhole, Bits) {
    EXPECT_EQ(in_uint(Op::BitAnd, {0xf0f0f0f0, 0xff00ff00}), 0xf000f000);
    EXPECT_EQ(in_uint(Op::BitOr, {0xf0, 0x0f}), 0xff);
    EXPECT_EQ(in_uint(Op::BitXor, {0xffffffff, 0x0000ffff}), 0xffff0000);
    EXPECT_EQ(in_uint(Op::BitNot, {0}), 4294967295);
    EXPECT_EQ(in_int(Op::BitNot, {5}), -6);
    EXPECT_EQ(in_int(Op::ShiftLeft, {1, 31}), -2147483648.0);
    EXPECT_EQ(in_uint(Op::ShiftLeft, {0x80000001, 1}), 2);
    EXPECT_EQ(in_int(Op::ShiftRight, {-8, 1}), -4);
    EXPECT_EQ(in_uint(Op::ShiftRight, {0x80000000, 31}), 1);
    EXPECT_EQ(in_uint(Op::ShiftLeft, {1, 33}), 2);
}

TEST(InterpretWhole, Bools) {
    for (double x : {0.0, 1.0}) {
        for (double y : {0.0, 1.0}) {
            EXPECT_EQ(compute1(Precision::Float, Op::And, Scalar::Bool, {x, y}), x * y);
            EXPECT_EQ(compute1(Precision::Float, Op::Or, Scalar::Bool, {x, y}), std::max(x, y));
            EXPECT_EQ(compute1(Precision::Float, Op::Equal, Scalar::Bool, {x, y}), x == y ? 1 : 0);
        }
        EXPECT_EQ(compute1(Precision::Float, Op::Not, Scalar::Bool, {x}), 1 - x);
    }
    const Type bool3 = Type::vector(Scalar::Bool, 3);
    EXPECT_EQ(compute(Precision::Float, Op::Any, kBool, {bool3}, {{0, 0, 1}}), Flat{1});
    EXPECT_EQ(compute(Precision::Float, Op::Any, kBool, {bool3}, {{0, 0, 0}}), Flat{0});
    EXPECT_EQ(compute(Precision::Float, Op::All, kBool, {bool3}, {{1, 1, 1}}), Flat{1});
    EXPECT_EQ(compute(Precision::Float, Op::All, kBool, {bool3}, {{1, 0, 1}}), Flat{0});
}

TEST(InterpretConvert, BetweenScalarKinds) {
    const auto convert = [](Scalar from, Scalar to, double value, Precision precision = Precision::Float) {
        return compute(precision, Op::Convert, Type::scalar_of(to), {Type::scalar_of(from)}, {{value}}).at(0);
    };
    EXPECT_EQ(convert(Scalar::Float, Scalar::Int, -1.75), -1);
    EXPECT_EQ(convert(Scalar::Float, Scalar::Int, 1e20), 2147483647);
    EXPECT_EQ(convert(Scalar::Float, Scalar::Int, kNan), 0);
    EXPECT_EQ(convert(Scalar::Float, Scalar::Uint, -3), 0);
    EXPECT_EQ(convert(Scalar::Float, Scalar::Uint, kInf), 4294967295);
    EXPECT_EQ(convert(Scalar::Float, Scalar::Bool, 0.5), 1);
    EXPECT_EQ(convert(Scalar::Bool, Scalar::Float, 1), 1);
    EXPECT_EQ(convert(Scalar::Int, Scalar::Uint, -1), 4294967295);
    EXPECT_EQ(convert(Scalar::Uint, Scalar::Int, 4294967295), -1);
    EXPECT_EQ(convert(Scalar::Int, Scalar::Float, 16777217), 16777216);
    EXPECT_EQ(convert(Scalar::Int, Scalar::Float, 16777217, Precision::Double), 16777217);
    EXPECT_EQ(convert(Scalar::Float, Scalar::Half, 1.0 / 3), 0.333251953125);
    EXPECT_EQ(convert(Scalar::Float, Scalar::Half, 1.0 / 3, Precision::Double), 0.333251953125);
    const auto bits = [](Scalar from, Scalar to, double value) {
        return compute(Precision::Double, Op::Bitcast, Type::scalar_of(to), {Type::scalar_of(from)}, {{value}}).at(0);
    };
    EXPECT_EQ(bits(Scalar::Float, Scalar::Int, 1), 0x3f800000);
    EXPECT_EQ(bits(Scalar::Float, Scalar::Uint, -0.0), 0x80000000);
    EXPECT_EQ(bits(Scalar::Float, Scalar::Int, -0.0), -2147483648.0);
    EXPECT_EQ(bits(Scalar::Uint, Scalar::Float, 0x40490fdb), static_cast<double>(std::numbers::pi_v<float>));
    EXPECT_EQ(bits(Scalar::Int, Scalar::Float, -1082130432), -1);
    EXPECT_EQ(bits(Scalar::Int, Scalar::Uint, -1), 4294967295);
}

// --- vectors and matrices

TEST(InterpretVector, Products) {
    for (Precision p : {Precision::Double, Precision::Float}) {
        EXPECT_EQ(compute(p, Op::Dot, kFloat, {kFloat3, kFloat3}, {{1, 2, 3}, {4, 5, 6}}), Flat{32});
        EXPECT_EQ(compute(p, Op::Length, kFloat, {kFloat2}, {{3, 4}}), Flat{5});
        EXPECT_EQ(compute(p, Op::Length, kFloat, {kFloat}, {{-3}}), Flat{3});
        EXPECT_EQ(compute(p, Op::Distance, kFloat, {kFloat2, kFloat2}, {{1, 1}, {4, 5}}), Flat{5});
        expect_near(compute(p, Op::Normalize, kFloat3, {kFloat3}, {{0, 3, 4}}), {0, 0.6, 0.8}, 1e-7);
        EXPECT_EQ(compute(p, Op::Cross, kFloat3, {kFloat3, kFloat3}, {{1, 2, 3}, {4, 5, 6}}), (Flat{-3, 6, -3}));
        EXPECT_EQ(compute(p, Op::Reflect, kFloat3, {kFloat3, kFloat3}, {{1, -1, 2}, {0, 1, 0}}), (Flat{1, 1, 2}));
    }
}

TEST(InterpretVector, RefractFollowsSnell) {
    const double angle = 0.5, ratio = 1 / 1.5;
    const double bent = std::asin(ratio * std::sin(angle));
    expect_near(compute(Precision::Double, Op::Refract, kFloat2, {kFloat2, kFloat2, kFloat},
                        {{std::sin(angle), -std::cos(angle)}, {0, 1}, {ratio}}),
                {std::sin(bent), -std::cos(bent)});
    // From glass at 60 degrees nothing gets out.
    EXPECT_EQ(compute(Precision::Double, Op::Refract, kFloat2, {kFloat2, kFloat2, kFloat},
                      {{std::sqrt(0.75), -0.5}, {0, 1}, {1.5}}),
              (Flat{0, 0}));
}

TEST(InterpretMatrix, ProductsAreThoseOfHlsl) {
    const Type m33 = Type::matrix(Scalar::Float, 3, 3);
    const Flat m = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    EXPECT_EQ(compute(Precision::Float, Op::MatMul, kFloat3, {m33, kFloat3}, {m, {1, 2, 3}}), (Flat{14, 32, 50}));
    EXPECT_EQ(compute(Precision::Float, Op::MatMul, kFloat3, {kFloat3, m33}, {{1, 2, 3}, m}), (Flat{30, 36, 42}));
    EXPECT_EQ(compute(Precision::Float, Op::MatMul, m33, {m33, m33}, {m, m}),
              (Flat{30, 36, 42, 66, 81, 96, 102, 126, 150}));
    const Type m22 = Type::matrix(Scalar::Float, 2, 2);
    EXPECT_EQ(compute(Precision::Float, Op::MatMul, m22, {m22, m22}, {{1, 2, 3, 4}, {0, 1, 1, 0}}), (Flat{2, 1, 4, 3}));
    EXPECT_EQ(compute(Precision::Float, Op::Transpose, m33, {m33}, {m}), (Flat{1, 4, 7, 2, 5, 8, 3, 6, 9}));
    EXPECT_EQ(compute(Precision::Float, Op::Extract, kFloat3, {m33}, {m}, 1), (Flat{4, 5, 6}));
    EXPECT_EQ(compute(Precision::Float, Op::Construct, m22, {kFloat2, kFloat2}, {{1, 2}, {3, 4}}), (Flat{1, 2, 3, 4}));
    EXPECT_EQ(compute(Precision::Float, Op::Add, m22, {m22, m22}, {{1, 2, 3, 4}, {1, 1, 1, 1}}), (Flat{2, 3, 4, 5}));
}

TEST(InterpretMatrix, Determinants) {
    const auto determinant = [](unsigned size, Flat m) {
        const Type type = Type::matrix(Scalar::Float, size, size);
        return compute(Precision::Double, Op::Determinant, kFloat, {type}, {std::move(m)}).at(0);
    };
    EXPECT_EQ(determinant(2, {1, 2, 3, 4}), -2);
    EXPECT_EQ(determinant(3, {1, 2, 3, 4, 5, 6, 7, 8, 9}), 0);
    EXPECT_EQ(determinant(3, {2, 0, 1, 1, 3, 2, 1, 1, 4}), 18);
    // Triangular: the product of the diagonal. Two rows exchanged: its negative.
    EXPECT_EQ(determinant(4, {2, 5, 7, 1, 0, 3, 8, 2, 0, 0, 5, 4, 0, 0, 0, 7}), 210);
    EXPECT_EQ(determinant(4, {0, 3, 8, 2, 2, 5, 7, 1, 0, 0, 5, 4, 0, 0, 0, 7}), -210);
}

TEST(InterpretComposite, PartsOfVectors) {
    const auto p = Precision::Float;
    EXPECT_EQ(compute(p, Op::Construct, kFloat3, {kFloat}, {{7}}), (Flat{7, 7, 7}));
    EXPECT_EQ(compute(p, Op::Construct, kFloat4, {kFloat, kFloat2, kFloat}, {{1}, {2, 3}, {4}}), (Flat{1, 2, 3, 4}));
    EXPECT_EQ(compute(p, Op::Swizzle, kFloat3, {kFloat4}, {{1, 2, 3, 4}}, 2 | 0 << 2 | 2 << 4), (Flat{3, 1, 3}));
    EXPECT_EQ(compute(p, Op::Swizzle, kFloat2, {kFloat4}, {{1, 2, 3, 4}}, 1 | 2 << 2), (Flat{2, 3}));
    EXPECT_EQ(compute(p, Op::Extract, kFloat, {kFloat3}, {{1, 2, 3}}, 2), Flat{3});
    EXPECT_EQ(compute(p, Op::Insert, kFloat3, {kFloat3, kFloat}, {{1, 2, 3}, {9}}, 1), (Flat{1, 9, 3}));
    for (const auto& [at, expected] : {std::pair(-5.0, 1.0), {0, 1}, {2, 3}, {100, 3}}) {
        EXPECT_EQ(compute(p, Op::Index, kFloat, {kFloat3, kInt}, {{1, 2, 3}, {at}}), Flat{expected});
    }
    const Type bool2 = Type::vector(Scalar::Bool, 2);
    EXPECT_EQ(compute(p, Op::Select, kFloat2, {bool2, kFloat2, kFloat2}, {{1, 0}, {1, 2}, {3, 4}}), (Flat{1, 4}));
    EXPECT_EQ(compute(p, Op::Select, kFloat2, {kBool, kFloat2, kFloat2}, {{0}, {1, 2}, {3, 4}}), (Flat{3, 4}));
}

TEST(InterpretComposite, StructsAndArrays) {
    Body body({kFloat2, kInt});
    Builder& b = *body.b;
    const Type array = body.module.array_of(kFloat2, 3);
    body.module.structs.push_back({.name = "Pair", .members = {{"first", kFloat}, {"all", array}}});
    const Type pair = Type::structure(0);
    const Value v = b.param(0), index = b.param(1);
    const Value doubled = b.emit(Op::Add, {v, v});
    const Value all = b.emit(Op::Construct, array, {v, doubled, v});
    const Value whole = b.emit(Op::Construct, pair, {b.extract(v, 1), all});
    const Value changed = b.emit(Op::Insert, pair, {whole, b.emit(Op::Insert, array, {all, doubled}, 2)}, 1);
    const Value picked = b.emit(Op::Index, kFloat2, {b.extract(changed, 1), index});
    const Value old = b.extract(b.extract(whole, 1), 2);
    const FunctionId f = body.finish(b.emit(Op::Construct, kFloat4, {picked, old}));
    const Lanes lanes = {{{{1, 2}, {0}}, {{1, 2}, {1}}, {{1, 2}, {2}}, {{5, 6}, {-1}}}};
    const QuadResult result = interpret::run(body.module, f, lanes, {}, Precision::Float);
    EXPECT_EQ(result.lanes[0], (Flat{1, 2, 1, 2}));
    EXPECT_EQ(result.lanes[1], (Flat{2, 4, 1, 2}));
    EXPECT_EQ(result.lanes[2], (Flat{2, 4, 1, 2}));
    EXPECT_EQ(result.lanes[3], (Flat{5, 6, 5, 6}));
}

// --- control flow

namespace {

// f(float x, int n) in four lanes.
std::array<double, 4> run_lanes(Body& body, Value result, std::array<double, 4> x, std::array<double, 4> n = {}) {
    const FunctionId f = body.finish(result);
    Lanes lanes;
    for (std::size_t lane = 0; lane < 4; ++lane) lanes[lane] = {{x[lane]}, {n[lane]}};
    const QuadResult quad = interpret::run(body.module, f, lanes, {}, Precision::Double);
    return {quad.lanes[0].at(0), quad.lanes[1].at(0), quad.lanes[2].at(0), quad.lanes[3].at(0)};
}
using Four = std::array<double, 4>;

}  // namespace

TEST(InterpretFlow, LanesTakeDifferentBranches) {
    Body body({kFloat, kInt});
    Builder& b = *body.b;
    const Value x = b.param(0), ten = b.constant(kFloat, {10});
    b.begin_if(b.emit(Op::Less, {x, b.constant(kFloat, {0})}));
    const Value then_value = b.emit(Op::Neg, {x});
    b.begin_else();
    b.begin_if(b.emit(Op::Greater, {x, ten}));
    b.begin_else();
    const Value inner = b.end_if(std::array{ten}, std::array{x});
    const Value whole = b.end_if(std::array{then_value}, std::array{b.result(inner, 0)});
    EXPECT_EQ(run_lanes(body, b.result(whole, 0), {-3, 4, 40, -1}), (Four{3, 4, 10, 1}));
}

TEST(InterpretFlow, SeveralResults) {
    Body body({kFloat, kInt});
    Builder& b = *body.b;
    const Value x = b.param(0), two = b.constant(kFloat2, {1, 2});
    b.begin_if(b.emit(Op::Less, {x, b.constant(kFloat, {0})}));
    b.begin_else();
    const Value both = b.end_if(std::array{two, x}, std::array{b.splat(x, 2), b.constant(kFloat, {100})});
    const Value sum = b.emit(Op::Add, {b.extract(b.result(both, 0), 1), b.result(both, 1)});
    EXPECT_EQ(run_lanes(body, sum, {-3, 4, -1, 5}), (Four{-1, 104, 1, 105}));
}

TEST(InterpretFlow, EachLaneCountsItsOwnTrips) {
    Body body({kFloat, kInt});
    Builder& b = *body.b;
    b.begin_for(b.constant(kInt, {0}), b.param(1), std::array{b.param(0)});
    const Value index = b.convert(b.loop_index(), Scalar::Float);
    const Value loop = b.end_for(std::array{b.emit(Op::Add, {b.loop_carried(0), index})});
    // x + 0 + 1 + ... + (n - 1)
    EXPECT_EQ(run_lanes(body, b.result(loop, 0), {0.5, 1, 2, 3}, {0, 1, 5, 100}), (Four{0.5, 1, 12, 4953}));
}

TEST(InterpretFlow, CarriedValuesMayChangePlaces) {
    Body body({kFloat, kInt});
    Builder& b = *body.b;
    const Value zero = b.constant(kFloat, {0});
    b.begin_for(b.constant(kInt, {0}), b.param(1), std::array{zero, b.param(0)});
    const Value a = b.loop_carried(0), c = b.loop_carried(1);
    const Value fibonacci = b.end_for(std::array{c, b.emit(Op::Add, {a, c})});
    EXPECT_EQ(run_lanes(body, b.result(fibonacci, 0), {1, 1, 2, 1}, {1, 2, 7, 10}), (Four{1, 1, 26, 55}));

    Body swap({kFloat, kInt});
    Builder& s = *swap.b;
    s.begin_for(s.constant(kInt, {0}), s.param(1), std::array{s.param(0), s.constant(kFloat, {7})});
    const Value first = s.loop_carried(0), second = s.loop_carried(1);
    const Value swapped = s.end_for(std::array{second, first});
    EXPECT_EQ(run_lanes(swap, s.result(swapped, 0), {1, 1, 1, 1}, {0, 1, 2, 3}), (Four{1, 7, 1, 7}));
}

TEST(InterpretFlow, LoopsAndBranchesNest) {
    // sum over i < n, j < i of (j odd ? j : x)
    Body body({kFloat, kInt});
    Builder& b = *body.b;
    const Value zero = b.constant(kInt, {0}), none = b.constant(kFloat, {0});
    b.begin_for(zero, b.param(1), std::array{none});
    const Value outer_sum = b.loop_carried(0), i = b.loop_index();
    b.begin_for(zero, i, std::array{outer_sum});
    const Value inner_sum = b.loop_carried(0), j = b.loop_index();
    const Value odd = b.emit(Op::Equal, {b.emit(Op::BitAnd, {j, b.constant(kInt, {1})}), b.constant(kInt, {1})});
    b.begin_if(odd);
    const Value as_float = b.convert(j, Scalar::Float);
    b.begin_else();
    const Value chosen = b.end_if(std::array{as_float}, std::array{b.param(0)});
    const Value inner = b.end_for(std::array{b.emit(Op::Add, {inner_sum, b.result(chosen, 0)})});
    const Value outer = b.end_for(std::array{b.result(inner, 0)});
    const Four x = {0.5, 100, 0.25, 1}, n = {0, 2, 5, 9};
    Four expected{};
    for (std::size_t lane = 0; lane < 4; ++lane) {
        for (int k = 0; k < n[lane]; ++k) {
            for (int l = 0; l < k; ++l) expected[lane] += l % 2 == 1 ? l : x[lane];
        }
    }
    EXPECT_EQ(run_lanes(body, b.result(outer, 0), x, n), expected);
}

TEST(InterpretFlow, CallsInsideBranchesAndLoops) {
    // twice(x) = x + x; result: i < n times  v = v < 10 ? twice(v) : v
    Module module;
    Function twice{.name = "twice", .params = {{.name = "x", .type = kFloat}}, .result = kFloat};
    {
        Builder b(module, twice, {.fold = false});
        const Value x = b.param(0);
        b.ret(b.emit(Op::Add, {x, x}));
    }
    module.functions.push_back(twice);
    Body body({kFloat, kInt});
    body.module = module;
    Builder& b = *body.b;
    b.begin_for(b.constant(kInt, {0}), b.param(1), std::array{b.param(0)});
    const Value v = b.loop_carried(0);
    b.begin_if(b.emit(Op::Less, {v, b.constant(kFloat, {10})}));
    const Value doubled = b.call(FunctionId{0}, std::array{v});
    b.begin_else();
    const Value next = b.end_if(std::array{doubled}, std::array{v});
    const Value loop = b.end_for(std::array{b.result(next, 0)});
    // Two calls of one function in one expression do not disturb each other.
    const Value first = b.call(FunctionId{0}, std::array{b.result(loop, 0)});
    const Value second = b.call(FunctionId{0}, std::array{first});
    EXPECT_EQ(run_lanes(body, b.emit(Op::Sub, {second, first}), {1, 1, 3, 20}, {0, 2, 9, 9}), (Four{2, 8, 24, 40}));
}

// --- neighbours

TEST(InterpretQuad, DerivativesAreFine) {
    // d(xy)/dx = y, exactly, in each row; d(xy)/dy = x in each column.
    Body body({kFloat, kFloat});
    Builder& b = *body.b;
    const Value product = b.emit(Op::Mul, {b.param(0), b.param(1)});
    const FunctionId f = body.finish(b.construct(
        kFloat3, std::array{b.emit(Op::Ddx, {product}), b.emit(Op::Ddy, {product}), b.emit(Op::Fwidth, {product})}));
    const Lanes lanes = {{{{10}, {20}}, {{11}, {20}}, {{10}, {21}}, {{11}, {21}}}};
    for (Precision p : {Precision::Float, Precision::Double}) {
        const QuadResult result = interpret::run(body.module, f, lanes, {}, p);
        EXPECT_EQ(result.lanes[0], (Flat{20, 10, 30}));
        EXPECT_EQ(result.lanes[1], (Flat{20, 11, 31}));
        EXPECT_EQ(result.lanes[2], (Flat{21, 10, 31}));
        EXPECT_EQ(result.lanes[3], (Flat{21, 11, 32}));
    }
}

TEST(InterpretUniforms, AreReadByComponent) {
    Body body({kInt});
    Builder& b = *body.b;
    const Type array = body.module.array_of(kFloat2, 2);
    body.module.blocks.push_back({.name = "Block", .size = 32, .members = {{.name = "k", .type = array}}});
    body.module.globals.push_back({.name = "k", .type = array, .block = 0, .member = 0});
    const Value k = b.emit(Op::Global, array, {}, 0);
    const FunctionId f = body.finish(b.emit(Op::Index, kFloat2, {k, b.param(0)}));
    const Resources resources{.uniforms = {{1, 2, 3, 0.1}}, .textures = {}};
    const QuadResult result = interpret::run(body.module, f, everywhere({{1}}), resources, Precision::Float);
    EXPECT_EQ(result.lanes[0], (Flat{3, static_cast<double>(0.1f)}));
    EXPECT_EQ(interpret::run(body.module, f, everywhere({{1}}), {}, Precision::Float).lanes[0], (Flat{0, 0}));
}
