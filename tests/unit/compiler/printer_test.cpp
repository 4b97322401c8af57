// What the printers write for expressions, literals and statements. That it compiles is validate_test's matter.
#include <limits>

#include "tests/unit/compiler/printer_fixture.h"

namespace patina::languages {
namespace {

constexpr Type kFloat3x3 = Type::matrix(Scalar::Float, 3, 3);

// --- expressions

TEST(Expressions, ParenthesesOnlyWhereTheyAreNeeded) {
    Fixture f;
    Value a = f.b->param(0), b = f.b->param(1), c = f.b->param(2);
    const Value product = f.b->emit(Op::Mul, {f.b->emit(Op::Add, {a, b}), c});
    const Value difference = f.b->emit(Op::Sub, {a, f.b->emit(Op::Sub, {b, c})});
    const Value sum = f.b->emit(Op::Add, {f.b->emit(Op::Mul, {a, b}), f.b->emit(Op::Div, {a, c})});
    const Value all = f.b->emit(Op::Max, {f.b->emit(Op::Min, {product, difference}), sum});
    EXPECT_EQ(f.glsl(all), "return max(min((a + b) * c, a - (b - c)), a * b + a / c);\n");
}

TEST(Expressions, SignsDoNotMeet) {
    Fixture f;
    const Value a = f.b->param(0), b = f.b->param(1);
    const Value twice = f.b->emit(Op::Neg, {f.b->emit(Op::Neg, {a})});
    const Value less = f.b->emit(Op::Add, {twice, f.number(-0.5)});
    const Value more = f.b->emit(Op::Sub, {less, f.number(-2)});
    EXPECT_EQ(f.glsl(f.b->emit(Op::Mul, {more, f.b->emit(Op::Neg, {b})})), "return (-(-a) - 0.5 + 2.0) * -b;\n");
}

TEST(Expressions, ConditionsAndChoices) {
    Fixture f;
    const Value a = f.b->param(0), b = f.b->param(1), c = f.b->param(2);
    const Value both = f.b->emit(
        Op::And,
        {f.b->emit(Op::Less, {a, b}), f.b->emit(Op::Or, {f.b->emit(Op::Less, {b, c}), f.b->emit(Op::Less, {a, c})})});
    const Value inner = f.b->emit(Op::Select, kFloat, {f.b->emit(Op::Not, {f.b->emit(Op::Equal, {a, c})}), b, c});
    EXPECT_EQ(f.glsl(f.b->emit(Op::Select, kFloat, {both, a, inner})),
              "return a < b && (b < c || a < c) ? a : (!(a == c) ? b : c);\n");
}

TEST(Expressions, ScalarsStandForSplats) {
    Fixture f({kFloat3, kFloat, kFloat3});
    const Value v = f.b->param(0), s = f.b->splat(f.b->param(1), 3), w = f.b->param(2);
    const Value one = f.b->splat_constant(kFloat3, 1), zero = f.b->splat_constant(kFloat3, 0);
    const Value product = f.b->emit(Op::Mul, {s, f.b->emit(Op::Add, {v, one})});
    const Value limited = f.b->emit(Op::Max, {zero, product});
    f.finish(f.b->emit(Op::Lerp, {f.b->emit(Op::Clamp, {limited, zero, one}), w, s}));
    EXPECT_EQ(f.body("glsl"), "return mix(clamp(max(b * (a + 1.0), 0.0), 0.0, 1.0), c, b);\n");
    EXPECT_EQ(f.body("hlsl"), "return lerp(clamp(max(b * (a + 1.0), 0.0), 0.0, 1.0), c, b);\n");
}

TEST(Expressions, SplatsThatMustBeVectors) {
    Fixture f({kFloat3, kFloat});
    const Value s = f.b->splat(f.b->param(1), 3), two = f.b->splat_constant(kFloat3, 2);
    f.finish(f.b->emit(Op::Add, {f.b->emit(Op::Pow, {f.b->param(0), s}), f.b->emit(Op::Pow, {f.b->param(0), two})}));
    EXPECT_EQ(f.body("glsl"),
              "return pow(mix(a, vec3(1.0), equal(vec3(b), vec3(0.0))), vec3(b)) + pow(a, vec3(2.0));\n");
    EXPECT_EQ(f.body("hlsl"),
              "return pow(b.xxx == 0.0 ? float3(1.0, 1.0, 1.0) : a, b.xxx) + pow(a, float3(2.0, 2.0, 2.0));\n");
}

// Zero to the power of zero does not matter where it is not read; elsewhere it does.
TEST(Expressions, PowersThatOnlyCountAboveZero) {
    const auto printed = [](Op comparison, double limit, bool is_read_twice) {
        Fixture f;
        const Value a = f.b->param(0), power = f.b->emit(Op::Pow, {a, f.b->param(1)});
        const Value chosen =
            f.b->emit(Op::Select, kFloat, {f.b->emit(comparison, {a, f.number(limit)}), power, f.number(0)});
        return f.glsl(is_read_twice ? f.b->emit(Op::Add, {chosen, power}) : chosen);
    };
    EXPECT_EQ(printed(Op::Greater, 0, false), "return a > 0.0 ? pow(a, b) : 0.0;\n");
    const std::string guarded = "pow(b == 0.0 ? 1.0 : a, b)";
    EXPECT_NE(printed(Op::Greater, -1, false).find(guarded), std::string::npos);
    EXPECT_NE(printed(Op::Less, 0, false).find(guarded), std::string::npos);
    EXPECT_NE(printed(Op::Greater, 0, true).find(guarded), std::string::npos);
}

TEST(Expressions, ComponentsJoinToSwizzles) {
    Fixture f({kFloat4, kFloat});
    const Value v = f.b->param(0);
    const Value parts[] = {f.b->extract(v, 1), f.b->extract(v, 0), f.b->param(1), f.b->extract(v, 3)};
    EXPECT_EQ(f.glsl(f.b->construct(kFloat4, parts)), "return vec4(a.yx, b, a.w);\n");

    Fixture whole({kFloat3});
    const Value w = whole.b->param(0);
    const Value same[] = {whole.b->extract(w, 0), whole.b->extract(w, 1), whole.b->extract(w, 2)};
    EXPECT_EQ(whole.glsl(whole.b->construct(kFloat3, same)), "return a;\n");
}

TEST(Expressions, ComparisonsOfVectors) {
    Fixture f({kFloat3, kFloat3});
    const Value less = f.b->emit(Op::Less, {f.b->param(0), f.b->param(1)});
    const Value more = f.b->emit(Op::Greater, {f.b->param(0), f.b->splat_constant(kFloat3, 1)});
    const Value both = f.b->emit(Op::And, {less, f.b->emit(Op::Not, {more})});
    f.finish(f.b->emit(Op::Select, kFloat3, {both, f.b->param(0), f.b->param(1)}));
    EXPECT_EQ(f.body("glsl"),
              "return mix(b, a, bvec3(uvec3(lessThan(a, b)) & uvec3(not(greaterThan(a, vec3(1.0))))));\n");
    EXPECT_EQ(f.body("hlsl"), "return a < b && !(a > 1.0) ? a : b;\n");
}

TEST(Expressions, MatricesAreMadeOfRows) {
    Fixture f({kFloat3, kFloat3, kFloat3, kFloat3});
    const Value rows[] = {f.b->param(0), f.b->param(1), f.b->param(2)};
    const Value m = f.b->construct(kFloat3x3, rows);
    f.finish(f.b->emit(Op::MatMul, kFloat3, {m, f.b->param(3)}));
    EXPECT_EQ(f.body("glsl"), "return d * mat3(a, b, c);\n");
    EXPECT_EQ(f.body("hlsl"), "return mul(float3x3(a, b, c), d);\n");

    Fixture g({kFloat3x3, kFloat3});
    const Value row = g.b->extract(g.b->param(0), 1);
    const Value product = g.b->emit(Op::MatMul, kFloat3, {g.b->param(1), g.b->param(0)});
    g.finish(g.b->emit(
        Op::Add, {g.b->emit(Op::Mul, {product, row}), g.b->splat(g.b->extract(g.b->extract(g.b->param(0), 2), 0), 3)}));
    EXPECT_EQ(g.body("glsl"), "return b * a * transpose(a)[1] + a[0][2];\n");
    EXPECT_EQ(g.body("hlsl"), "return mul(b, a) * a[1] + a[2].x;\n");
}

TEST(Expressions, ConstantMatricesAreStoredByRows) {
    Fixture f({Type::vector(Scalar::Float, 2)});
    const Type m2 = Type::matrix(Scalar::Float, 2, 2);
    f.finish(f.b->emit(Op::MatMul, kFloat2, {f.b->constant(m2, {1, 2, 3, 4}), f.b->param(0)}));
    EXPECT_EQ(f.body("glsl"), "return mat2(1.0, 3.0, 2.0, 4.0) * a;\n");
    EXPECT_EQ(f.body("hlsl"), "return mul(float2x2(1.0, 2.0, 3.0, 4.0), a);\n");
}

// --- literals

std::string float_literal(std::string_view target, Type type, double value) {
    Fixture f;
    f.finish(f.b->constant(type, {value}));
    const std::string line = f.body(target);
    return line.substr(7, line.size() - 9);  // "return " ... ";\n"
}

TEST(Literals, FloatsAreShortAndFloats) {
    EXPECT_EQ(float_literal("glsl", kFloat, 1), "1.0");
    EXPECT_EQ(float_literal("glsl", kFloat, 0.1), "0.1");
    EXPECT_EQ(float_literal("glsl", kFloat, -0.0), "-0.0");
    EXPECT_EQ(float_literal("hlsl", kFloat, 1e-20), "1e-20");
    EXPECT_EQ(float_literal("hlsl", kFloat, 3.14159265358979), "3.1415927");
    EXPECT_EQ(std::stof(float_literal("glsl", kFloat, 16777216)), 16777216.0f);
    EXPECT_EQ(std::stof(float_literal("glsl", kFloat, std::numeric_limits<float>::max())),
              std::numeric_limits<float>::max());
}

TEST(Literals, NumbersThatHaveNoLiteral) {
    // IEEE 754: +inf is 0x7f800000, -inf has the sign bit too.
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(float_literal("glsl", kFloat, infinity), "uintBitsToFloat(0x7f800000u)");
    EXPECT_EQ(float_literal("hlsl", kFloat, -infinity), "asfloat(0xff800000u)");
    EXPECT_EQ(float_literal("glsl", kHalf, infinity), "float16_t(uintBitsToFloat(0x7f800000u))");
    EXPECT_TRUE(
        contains(float_literal("hlsl", kFloat, std::numeric_limits<double>::quiet_NaN()), "asfloat(0x7fc00000u)"));
}

TEST(Literals, OtherScalars) {
    EXPECT_EQ(float_literal("glsl", kInt, -7), "-7");
    EXPECT_EQ(float_literal("glsl", kInt, -2147483648.0), "-2147483647 - 1");
    EXPECT_EQ(float_literal("hlsl", kUint, 4294967295.0), "4294967295u");
    EXPECT_EQ(float_literal("hlsl", kBool, 1), "true");
    EXPECT_EQ(float_literal("glsl", kHalf, 0.5), "0.5hf");
    EXPECT_EQ(float_literal("hlsl", kHalf, 0.5), "0.5h");
}

// --- statements

TEST(Statements, AValueThatIsReadTwiceGetsAName) {
    Fixture f;
    const Value d = f.b->emit(Op::Dot, {f.b->splat(f.b->param(0), 3), f.b->splat(f.b->param(1), 3)});
    EXPECT_EQ(f.glsl(f.b->emit(Op::Mul, {d, d})),
              "float projection = dot(vec3(a), vec3(b));\n"
              "return projection * projection;\n");
}

TEST(Statements, HintsNameValuesAndClashesAreNumbered) {
    Fixture f;
    const Value x = f.named(f.b->emit(Op::Sin, {f.b->param(0)}), "texture");
    const Value y = f.named(f.b->emit(Op::Cos, {f.b->param(0)}), "a");
    EXPECT_EQ(f.glsl(f.b->emit(Op::Add, {x, y})),
              "float texture_ = sin(a);\n"
              "float a2 = cos(a);\n"
              "return texture_ + a2;\n");
}

TEST(Statements, AnAssignmentOfTheAuthorStaysOne) {
    Fixture f;
    const Value x = f.named(f.b->emit(Op::Sin, {f.b->param(0)}), "x");
    const Value y = f.named(f.b->emit(Op::Mul, {x, f.b->param(1)}), "x");
    const Value z = f.named(f.b->emit(Op::Sub, {f.b->param(2), y}), "x");
    EXPECT_EQ(f.glsl(f.b->emit(Op::Mul, {z, z})),
              "float x = sin(a);\n"
              "x *= b;\n"
              "x = c - x;\n"
              "return x * x;\n");
}

TEST(Statements, AnOldValueThatIsStillReadKeepsItsVariable) {
    Fixture f;
    const Value x = f.named(f.b->emit(Op::Sin, {f.b->param(0)}), "x");
    const Value y = f.named(f.b->emit(Op::Mul, {x, f.b->param(1)}), "x");
    EXPECT_EQ(f.glsl(f.b->emit(Op::Add, {x, y})),
              "float x = sin(a);\n"
              "float x2 = x * b;\n"
              "return x + x2;\n");
}

TEST(Statements, StructsAreFilledMemberByMember) {
    SurfaceFixture f;
    Value s = f.named(f.made(0), "s");
    s = f.b->emit(Op::Insert, f.surface, {s, f.b->param(1)}, 1);
    EXPECT_EQ(f.glsl(s),
              "Surface s;\n"
              "s.baseColor = a;\n"
              "s.metallic = 0.0;\n"
              "s.metallic = b;\n"
              "return s;\n");
}

TEST(Statements, AStructThatIsStillReadIsCopied) {
    SurfaceFixture f;
    const Value s = f.named(f.made(0), "s");
    const Value t = f.named(f.b->emit(Op::Insert, f.surface, {s, f.b->param(1)}, 1), "t");
    EXPECT_EQ(f.glsl(f.b->emit(Op::Add, {f.b->extract(s, 1), f.b->extract(t, 1)})),
              "Surface s;\n"
              "s.baseColor = a;\n"
              "s.metallic = 0.0;\n"
              "Surface t = s;\n"
              "t.metallic = b;\n"
              "return s.metallic + t.metallic;\n");
}

// What is read later of the struct before is another member, which the change leaves as it is.
TEST(Statements, AStructOfWhichAnotherMemberIsReadIsChanged) {
    SurfaceFixture f;
    const Value s = f.named(f.made(0), "s");
    const Value t = f.b->emit(Op::Insert, f.surface, {s, f.b->param(1)}, 1);
    const Value shade = f.b->emit(Op::Length, {f.b->extract(s, 0)});
    EXPECT_EQ(f.glsl(f.b->emit(Op::Add, {shade, f.b->extract(t, 1)})),
              "Surface s;\n"
              "s.baseColor = a;\n"
              "s.metallic = 0.0;\n"
              "s.metallic = b;\n"
              "return length(s.baseColor) + s.metallic;\n");
}

// The first change may use the variable; the second would change what is still read of the first struct.
TEST(Statements, AMemberThatIsReadLaterOutlivesAllChanges) {
    SurfaceFixture f;
    const Value s = f.named(f.made(0), "s");
    const Value t = f.b->emit(Op::Insert, f.surface, {s, f.b->param(1)}, 1);
    const Value u = f.named(f.b->emit(Op::Insert, f.surface, {t, f.b->emit(Op::Neg, {f.b->extract(s, 0)})}, 0), "u");
    const Value before = f.b->emit(Op::Length, {f.b->extract(s, 0)});
    const Value after = f.b->emit(Op::Add, {f.b->emit(Op::Length, {f.b->extract(u, 0)}), f.b->extract(u, 1)});
    EXPECT_EQ(f.glsl(f.b->emit(Op::Add, {before, after})),
              "Surface s;\n"
              "s.baseColor = a;\n"
              "s.metallic = 0.0;\n"
              "s.metallic = b;\n"
              "Surface u = s;\n"
              "u.baseColor = -s.baseColor;\n"
              "return length(s.baseColor) + (length(u.baseColor) + u.metallic);\n");
}

// The branch would change what is read after it of the struct before.
TEST(Statements, AMemberThatIsReadLaterOutlivesABranch) {
    SurfaceFixture f;
    const Value s = f.named(f.made(0), "s");
    const Value t = f.b->emit(Op::Insert, f.surface, {s, f.b->param(1)}, 1);
    f.b->begin_if(f.b->param(2));
    const Value then = f.b->emit(Op::Insert, f.surface, {t, f.b->emit(Op::Neg, {f.b->param(0)})}, 0);
    f.b->begin_else();
    const Value structure = f.b->end_if({&then, 1}, {&t, 1});
    const Value u = f.named(f.b->result(structure, 0), "u");
    const Value before = f.b->emit(Op::Length, {f.b->extract(s, 0)});
    const Value after = f.b->emit(Op::Add, {f.b->emit(Op::Length, {f.b->extract(u, 0)}), f.b->extract(u, 1)});
    EXPECT_EQ(f.glsl(f.b->emit(Op::Add, {before, after})),
              "Surface s;\n"
              "s.baseColor = a;\n"
              "s.metallic = 0.0;\n"
              "s.metallic = b;\n"
              "Surface u = s;\n"
              "if (c) {\n"
              "    u = s;\n"
              "    u.baseColor = -a;\n"
              "}\n"
              "return length(s.baseColor) + (length(u.baseColor) + u.metallic);\n");
}

TEST(Statements, StructsAreNotSelectedByOperator) {
    SurfaceFixture f;
    f.finish(f.b->emit(Op::Select, f.surface, {f.b->param(2), f.named(f.made(0), "s"), f.named(f.made(1), "t")}));
    EXPECT_TRUE(contains(f.body("hlsl"), "Surface surface = t;\nif (c) surface = s;\nreturn surface;\n"))
        << f.body("hlsl");
}

TEST(Statements, IfWithBothBranches) {
    Fixture f;
    f.b->begin_if(f.b->emit(Op::Less, {f.b->param(0), f.b->param(1)}));
    const Value then = f.b->emit(Op::Sin, {f.b->param(0)});
    f.b->begin_else();
    const Value otherwise = f.b->emit(Op::Cos, {f.b->param(0)});
    const Value structure = f.b->end_if({&then, 1}, {&otherwise, 1});
    EXPECT_EQ(f.glsl(f.named(f.b->result(structure, 0), "wave")),
              "float wave;\n"
              "if (a < b) {\n"
              "    wave = sin(a);\n"
              "} else {\n"
              "    wave = cos(a);\n"
              "}\n"
              "return wave;\n");
}

TEST(Statements, IfThatChangesAVariable) {
    Fixture f;
    const Value x = f.named(f.b->emit(Op::Sin, {f.b->param(0)}), "x");
    f.b->begin_if(f.b->emit(Op::Less, {f.b->param(0), f.b->param(1)}));
    const Value then = f.b->emit(Op::Mul, {x, f.b->param(2)});
    f.b->begin_else();
    const Value structure = f.b->end_if({&then, 1}, {&x, 1});
    EXPECT_EQ(f.glsl(f.b->result(structure, 0)),
              "float x = sin(a);\n"
              "if (a < b) {\n"
              "    x *= c;\n"
              "}\n"
              "return x;\n");
}

TEST(Statements, LoopsCarryVariables) {
    Fixture f;
    const Value zero = f.number(0), begin = f.b->constant(kInt, {0}), end = f.b->constant(kInt, {4});
    const Value hoisted = f.b->emit(Op::Exp, {f.b->param(0)});  // read once, but in every round
    f.b->begin_for(begin, end, {&zero, 1});
    const Value index = f.b->convert(f.b->loop_index(), Scalar::Float);
    const Value next = f.b->emit(Op::Add, {f.b->loop_carried(0), f.b->emit(Op::Mul, {index, hoisted})});
    const Value loop = f.b->end_for({&next, 1});
    EXPECT_EQ(f.glsl(f.named(f.b->result(loop, 0), "total")),
              "float expA = exp(a);\n"
              "float total = 0.0;\n"
              "for (int i = 0; i < 4; ++i) {\n"
              "    total += float(i) * expA;\n"
              "}\n"
              "return total;\n");
}

TEST(Statements, CarriedValuesChangeAtOnce) {
    Fixture f;
    const Value initial[] = {f.b->param(0), f.b->param(1)};
    f.b->begin_for(f.b->constant(kInt, {0}), f.b->constant(kInt, {3}), initial);
    const Value x = f.named(f.b->loop_carried(0), "x"), y = f.named(f.b->loop_carried(1), "y");
    const Value next[] = {y, f.b->emit(Op::Add, {x, y})};
    const Value loop = f.b->end_for(next);
    EXPECT_EQ(f.glsl(f.b->emit(Op::Sub, {f.b->result(loop, 0), f.b->result(loop, 1)})),
              "float x = a;\n"
              "float y = b;\n"
              "for (int i = 0; i < 3; ++i) {\n"
              "    float nextX = y;\n"
              "    y = x + y;\n"
              "    x = nextX;\n"
              "}\n"
              "return x - y;\n");
}

TEST(Statements, ALimitIsComputedOnce) {
    Fixture f({kInt});
    const Value end = f.b->emit(Op::Min, {f.b->param(0), f.b->constant(kInt, {16})});
    const Value zero = f.number(0);
    f.b->begin_for(f.b->constant(kInt, {0}), end, {&zero, 1});
    const Value next = f.b->emit(Op::Add, {f.b->loop_carried(0), f.number(1)});
    const Value loop = f.b->end_for({&next, 1});
    EXPECT_TRUE(contains(f.glsl(f.b->result(loop, 0)),
                         "int limited = min(a, 16);\nfloat sum = 0.0;\nfor (int i = 0; i < limited;"));
}

TEST(Statements, ArraysOfConstants) {
    Fixture f({kInt});
    const Type k3 = f.module.array_of(kFloat, 3);
    const Value parts[] = {f.number(0.25), f.number(0.5), f.number(0.25)};
    const Value kernel = f.named(f.b->construct(k3, parts), "kernel");
    f.finish(f.b->emit(Op::Index, kFloat, {kernel, f.b->param(0)}));
    EXPECT_EQ(f.body("glsl"), "const float kernel[3] = float[3](0.25, 0.5, 0.25);\nreturn kernel[clamp(a, 0, 2)];\n");
    EXPECT_EQ(f.body("hlsl"), "static const float kernel[3] = { 0.25, 0.5, 0.25 };\nreturn kernel[clamp(a, 0, 2)];\n");
}

TEST(Statements, IndicesInRangeAreNotClamped) {
    Fixture f({kFloat4});
    const Value zero = f.number(0);
    f.b->begin_for(f.b->constant(kInt, {0}), f.b->constant(kInt, {4}), {&zero, 1});
    const Value element = f.b->emit(Op::Index, kFloat, {f.b->param(0), f.b->loop_index()});
    const Value next = f.b->emit(Op::Add, {f.b->loop_carried(0), element});
    const Value loop = f.b->end_for({&next, 1});
    EXPECT_TRUE(contains(f.glsl(f.b->result(loop, 0)), "sum += a[i];"));
}

}  // namespace
}  // namespace patina::languages
