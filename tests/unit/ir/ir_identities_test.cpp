// Each identity of the builder alone: both sides are evaluated on random and on awkward numbers (NaN, infinity, -0),
// and must agree; and the builder must make of the left side what the right side says.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "compiler/ir/builder.h"
#include "compiler/ir/dump.h"
#include "compiler/ir/fold/fold.h"
#include "compiler/ir/fold/pattern.h"

namespace patina::ir {
namespace {

using Node = Pattern::Node;
using Kind = Pattern::Kind;
using Numbers = std::vector<double>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The types of the variables, and of a number that has no variable as its neighbour.
struct Typing {
    Type any, integer, boolean, lone_number;
    Type of(const Node& variable) const {
        if (variable.kind == Kind::Integer) return integer;
        return variable.kind == Kind::Bool ? boolean : any;
    }
};

std::vector<Typing> all_typings() {
    std::vector<Typing> all;
    const auto add = [&](Type any, Type integer, Type boolean) {
        for (const Type lone : {any, integer, boolean}) all.push_back({any, integer, boolean, lone});
    };
    for (const unsigned width : {1u, 3u}) {
        for (const Scalar any : {Scalar::Float, Scalar::Half, Scalar::Int, Scalar::Uint, Scalar::Bool}) {
            for (const Scalar integer : {Scalar::Int, Scalar::Uint}) {
                add(Type::vector(any, width), Type::vector(integer, width), kBool);
                add(Type::vector(any, width), Type::vector(integer, width), Type::vector(Scalar::Bool, width));
            }
        }
    }
    add(Type::matrix(Scalar::Float, 3, 2), kInt, kBool);
    add(Type::matrix(Scalar::Float, 2, 2), kInt, kBool);
    return all;
}

const std::vector<Pattern> kAllVariables = {pattern::x, pattern::y, pattern::z, pattern::i, pattern::j, pattern::c,
                                            pattern::d, pattern::k, pattern::l, pattern::m, pattern::n};

// One side of an identity, made bottom up by the three functions of `make`: variable(node), number(type, number) and
// operation(op, operands). A number has the type of an operand beside it; a select's condition stands apart.
template <class Make>
auto make_side(const Node*& node, const Make& make, Type wanted) -> decltype(make.number(wanted, 0)) {
    const Node head = *node++;
    if (head.kind == Kind::Number) return make.number(wanted, head.number);
    if (head.kind != Kind::Operation) return make.variable(head);
    const auto count = static_cast<std::size_t>(info(head.op).arguments);
    std::vector<decltype(make.number(wanted, 0))> operands(count);
    std::vector<const Node*> numbers(count);
    Type beside = wanted;
    for (std::size_t k = 0; k < count; k++) {
        if (node->kind == Kind::Number) {
            numbers[k] = node++;
            continue;
        }
        operands[k] = make_side(node, make, wanted);
        if (head.op != Op::Select || k > 0) beside = make.type(operands[k]);
    }
    for (std::size_t k = 0; k < count; k++) {
        const bool is_condition = head.op == Op::Select && k == 0;
        if (numbers[k]) operands[k] = make.number(is_condition ? kBool : beside, numbers[k]->number);
    }
    return make.operation(head.op, operands);
}
template <class Make>
auto make_side(const Pattern& side, const Make& make, Type wanted) {
    const Node* node = side.nodes.data();
    return make_side(node, make, wanted);
}

struct MakeType {
    const Typing& typing;
    Type variable(const Node& node) const { return typing.of(node); }
    // -1 is not a uint, and 2 is not a bool.
    Type number(Type type, int number) const {
        if (!type.is_numeric()) return Type::error();
        const bool fits = type.is_bool() ? number == 0 || number == 1 : type.scalar != Scalar::Uint || number >= 0;
        return fits ? type : Type::error();
    }
    Type operation(Op op, const std::vector<Type>& types) const { return result_type(op, types); }
    Type type(Type type) const { return type; }
};

struct Operand {
    Type type;
    Numbers numbers;
};
struct MakeNumbers {
    std::vector<Operand> variables;
    Operand variable(const Node& node) const { return variables[static_cast<std::size_t>(node.number)]; }
    Operand number(Type type, int number) const { return {type, Numbers(type.components(), number)}; }
    Operand operation(Op op, const std::vector<Operand>& operands) const {
        std::vector<Type> types;
        std::vector<std::span<const double>> numbers;
        for (const Operand& operand : operands) {
            types.push_back(operand.type);
            numbers.push_back(operand.numbers);
        }
        Operand result{result_type(op, types), {}};
        EXPECT_TRUE(evaluate(op, result.type, types, numbers, 0, result.numbers)) << info(op).text;
        return result;
    }
    Type type(const Operand& operand) const { return operand.type; }
};

struct MakeValue {
    Builder& b;
    std::vector<Value> variables;
    Value variable(const Node& node) const { return variables[static_cast<std::size_t>(node.number)]; }
    Value number(Type type, int number) const { return b.splat_constant(type, number); }
    Value operation(Op op, const std::vector<Value>& operands) const {
        std::vector<Type> types;
        for (const Value operand : operands) types.push_back(b.type(operand));
        return b.emit(op, result_type(op, types), operands);
    }
    Type type(Value value) const { return b.type(value); }
};

// The typings for which both sides have one type. A number on the right is of the left side's type.
std::vector<Typing> typings_of(const Identity& identity) {
    std::vector<Typing> fitting;
    for (const Typing& typing : all_typings()) {
        const Type type = make_side(identity.left, MakeType{typing}, typing.lone_number);
        if (!type.is_error() && make_side(identity.right, MakeType{typing}, type) == type) fitting.push_back(typing);
    }
    return fitting;
}

std::string text(const Pattern& pattern) {
    std::string words;
    for (std::size_t k = 0; k < pattern.size; k++) {
        const Node& node = pattern.nodes[k];
        words += k == 0 ? "" : " ";
        words += node.kind == Kind::Operation ? std::string(info(node.op).text)
                 : node.kind == Kind::Number  ? std::to_string(node.number)
                                              : std::string(1, "xyzijcdklmn"[node.number]);
    }
    return words;
}

Numbers random_numbers(Type type, std::mt19937& random, bool is_finite) {
    static constexpr std::array kAwkward = {0.0, -0.0, 1.0, -1.0, 0.5, 2.0, kNan, kInfinity, -kInfinity, 1e-30};
    std::uniform_real_distribution<double> real(-4, 4);
    std::uniform_int_distribution<std::int64_t> whole(0, 0xffffffff);
    Numbers numbers;
    for (unsigned i = 0; i < type.components(); i++) {
        double number = real(random);
        if (type.is_integer()) {
            number = random() % 2 == 0 ? std::trunc(number) : static_cast<double>(whole(random));
        } else if (type.is_bool()) {
            number = static_cast<double>(random() % 2);
        } else if (!is_finite && random() % 2 == 0) {
            number = kAwkward[random() % kAwkward.size()];
        }
        numbers.push_back(round_to(type.scalar, number));
    }
    return numbers;
}

void expect_equal(const Identity& identity, const Typing& typing, std::mt19937& random) {
    const bool is_exact = identity.holds == Identity::Holds::Exact;
    MakeNumbers make;
    for (const Pattern& variable : kAllVariables) {
        const Type type = typing.of(variable.nodes[0]);
        const bool is_constant = variable.nodes[0].kind == Kind::Constant;
        make.variables.push_back({type, random_numbers(type, random, !is_exact || is_constant)});
    }
    const Operand left = make_side(identity.left, make, typing.lone_number);
    const Operand right = make_side(identity.right, make, left.type);
    ASSERT_EQ(left.type, right.type);
    // Operands lie within -4 and 4: some units in the last place of those.
    const double tolerance = left.type.scalar == Scalar::Half ? 1e-2 : 4e-6;
    for (std::size_t k = 0; k < left.numbers.size(); k++) {
        const double a = left.numbers[k], b = right.numbers[k];
        const bool are_equal =
            a == b || (std::isnan(a) && std::isnan(b)) || (!is_exact && std::fabs(a - b) <= tolerance);
        EXPECT_TRUE(are_equal) << a << " is not " << b;
    }
}

TEST(Identities, BothSidesAreEqual) {
    std::mt19937 random(1);
    for (const Identity& identity : all_identities()) {
        SCOPED_TRACE(text(identity.left) + " = " + text(identity.right));
        const std::vector<Typing> fitting = typings_of(identity);
        EXPECT_FALSE(fitting.empty());
        for (const Typing& typing : fitting) {
            for (int k = 0; k < 50; k++) expect_equal(identity, typing, random);
        }
    }
}

TEST(Identities, TheBuilderAppliesEach) {
    for (const Identity& identity : all_identities()) {
        SCOPED_TRACE(text(identity.left) + " = " + text(identity.right));
        for (const Typing& typing : typings_of(identity)) {
            Module module;
            Function function;
            for (const Pattern& variable : kAllVariables) {
                function.params.push_back({"v", typing.of(variable.nodes[0]), Rate::Pixel});
            }
            Builder b(module, function);
            MakeValue make{b, {}};
            for (std::uint32_t k = 0; k < function.params.size(); k++) {
                const Type type = function.params[k].type;
                const bool is_constant = kAllVariables[k].nodes[0].kind == Kind::Constant;
                // In order, as limits are, and not one of the numbers for which a shorter identity holds.
                const double number = 1.5 + k;
                make.variables.push_back(is_constant ? b.splat_constant(type, type.is_bool() ? 1 : number)
                                                     : b.param(k));
            }
            const Type type = make_side(identity.left, MakeType{typing}, typing.lone_number);
            const Value expected = make_side(identity.right, make, type);
            EXPECT_EQ(make_side(identity.left, make, typing.lone_number), expected) << dump(module, function);
        }
    }
}

TEST(Identities, CommutingOperandsMatchInEitherOrder) {
    Module module;
    Function function{.name = "f", .params = {{"x", kFloat, Rate::Pixel}, {"y", kFloat, Rate::Pixel}}};
    Builder b(module, function);
    const Value x = b.param(0), y = b.param(1), zero = b.constant(kFloat, {0}), one = b.constant(kFloat, {1});
    EXPECT_EQ(b.emit(Op::Add, {zero, x}), x);
    EXPECT_EQ(b.emit(Op::Mul, {one, x}), x);
    EXPECT_EQ(b.emit(Op::Add, {b.emit(Op::Neg, {y}), x}), b.emit(Op::Sub, {x, y}));
}

// What must not be simplified, because NaN or infinity would be lost.
TEST(Identities, KeepsWhatNanWouldChange) {
    Module module;
    Function function{.name = "f", .params = {{"x", kFloat, Rate::Pixel}}};
    Builder b(module, function);
    const Value x = b.param(0), zero = b.constant(kFloat, {0});
    EXPECT_EQ(b[b.emit(Op::Sub, {x, x})].op, Op::Sub);
    EXPECT_EQ(b[b.emit(Op::Div, {x, x})].op, Op::Div);
    EXPECT_EQ(b[b.emit(Op::Equal, {x, x})].op, Op::Equal);
    EXPECT_EQ(b[b.emit(Op::Not, {b.emit(Op::Less, {x, zero})})].op, Op::Not);
}

// What is multiplied by a constant zero is not computed.
TEST(Identities, AZeroRemovesWhatItMultiplies) {
    Module module;
    module.globals = {{.name = "color", .type = kFloat3, .group = Group::Material}};
    Function function{.name = "f", .params = {{"x", kFloat3, Rate::Pixel}}};
    Builder b(module, function);
    const Value color = b.emit(Op::Global, kFloat3, {}, 0), zero = b.constant(kFloat3, {0, 0, 0});
    for (const Value x : {b.param(0), color, b.emit(Op::Div, {color, b.param(0)}), b.emit(Op::Log, {color})}) {
        EXPECT_EQ(b.emit(Op::Mul, {x, zero}), zero);
        EXPECT_EQ(b.emit(Op::Mul, {zero, x}), zero);
        EXPECT_EQ(b.emit(Op::Add, {b.emit(Op::Mul, {zero, x}), color}), color);
    }
}

// What the engine gives is finite, so it minus itself is 0. What a material gives may be infinite, and so may a sum or
// a product of finite numbers.
TEST(Identities, TheEngineGivesFiniteNumbers) {
    Module module;
    module.arrays = {{.element = kFloat3, .count = 9}};
    module.globals = {{.name = "ambientSH", .type = Type::array(0)},
                      {.name = "fog", .type = kFloat},
                      {.name = "color", .type = kFloat, .group = Group::Material}};
    Function function{.name = "f", .params = {{"i", kInt, Rate::Pixel}}};
    Builder b(module, function);
    const Value zero = b.constant(kFloat, {0});
    const auto is_zero = [&](Value value) { return b.is_constant(b.emit(Op::Sub, {value, value}), 0); };
    const Value ambient = b.emit(Op::Global, Type::array(0), {}, 0), fog = b.emit(Op::Global, kFloat, {}, 1);
    EXPECT_TRUE(is_zero(b.extract(ambient, 2)));
    EXPECT_TRUE(is_zero(b.emit(Op::Index, kFloat3, {ambient, b.param(0)})));
    EXPECT_TRUE(is_zero(b.extract(b.extract(ambient, 2), 1)));
    EXPECT_TRUE(is_zero(fog));
    EXPECT_EQ(b.emit(Op::Sub, {fog, fog}), zero);
    EXPECT_FALSE(is_zero(b.emit(Op::Global, kFloat, {}, 2)));
    EXPECT_FALSE(is_zero(b.emit(Op::Add, {fog, fog})));
    EXPECT_FALSE(is_zero(b.emit(Op::Mul, {fog, fog})));
}

// --- folding

Numbers folded(Op op, Type type, std::vector<Operand> operands, std::uint32_t data = 0) {
    std::vector<Type> types;
    std::vector<std::span<const double>> numbers;
    for (const Operand& operand : operands) {
        types.push_back(operand.type);
        numbers.push_back(operand.numbers);
    }
    Numbers out;
    return fold_constant(op, type, types, numbers, data, out) ? out : Numbers();
}

TEST(Fold, ComputesInThePrecisionOfTheType) {
    // 1 + 2^-24 is halfway between two floats and goes to the even one; 2^-23 is a step.
    EXPECT_EQ(folded(Op::Add, kFloat, {{kFloat, {1}}, {kFloat, {0x1p-24}}}), Numbers{1});
    EXPECT_EQ(folded(Op::Add, kFloat, {{kFloat, {1}}, {kFloat, {0x1p-23}}}), Numbers{1 + 0x1p-23});
    // A half has 11 bits of significand, and 2049 lies between 2048 and 2050.
    EXPECT_EQ(folded(Op::Add, kHalf, {{kHalf, {2048}}, {kHalf, {1}}}), Numbers{2048});
    EXPECT_EQ(folded(Op::Add, kHalf, {{kHalf, {2048}}, {kHalf, {3}}}), Numbers{2052});
    EXPECT_EQ(round_to(Scalar::Half, 0.1), 0.0999755859375);
    EXPECT_EQ(round_to(Scalar::Half, 0x1p-24 * 1.4), 0x1p-24);
}

TEST(Fold, ComputesWithTheNumbersThatAreWritten) {
    // In floats alone, these are 0.19999999, 0.010000001 and 0.050000012.
    EXPECT_EQ(folded(Op::Sub, kFloat, {{kFloat, {1}}, {kFloat, {0.8f}}}), Numbers{0.2f});
    EXPECT_EQ(folded(Op::Mul, kFloat, {{kFloat, {0.1f}}, {kFloat, {0.1f}}}), Numbers{0.01f});
    EXPECT_EQ(folded(Op::Sub, kFloat, {{kFloat, {1}}, {kFloat, {0.95f}}}), Numbers{0.05f});
    // A number of more digits than a float is sure of is the float itself.
    const float third = 1.f / 3;
    EXPECT_EQ(folded(Op::Sub, kFloat, {{kFloat, {1}}, {kFloat, {third}}}), Numbers{1 - third});
    EXPECT_EQ(folded(Op::Add, kFloat, {{kFloat, {0x1p-24}}, {kFloat, {0x1p-24}}}), Numbers{0x1p-23});
}

TEST(Fold, WrapsIntegersTo32Bits) {
    EXPECT_EQ(folded(Op::Add, kInt, {{kInt, {2147483647}}, {kInt, {1}}}), Numbers{-2147483648.0});
    EXPECT_EQ(folded(Op::Sub, kUint, {{kUint, {0}}, {kUint, {1}}}), Numbers{4294967295.0});
    EXPECT_EQ(folded(Op::Mul, kInt, {{kInt, {65537}}, {kInt, {65537}}}), Numbers{131073});
    EXPECT_EQ(folded(Op::Mul, kUint, {{kUint, {4294967295.0}}, {kUint, {4294967295.0}}}), Numbers{1});
    EXPECT_EQ(folded(Op::Div, kInt, {{kInt, {-7}}, {kInt, {2}}}), Numbers{-3});
    EXPECT_EQ(folded(Op::Mod, kInt, {{kInt, {-7}}, {kInt, {2}}}), Numbers{-1});
    EXPECT_EQ(folded(Op::BitNot, kUint, {{kUint, {0}}}), Numbers{4294967295.0});
    EXPECT_EQ(folded(Op::ShiftRight, kInt, {{kInt, {-8}}, {kInt, {1}}}), Numbers{-4});
    EXPECT_EQ(folded(Op::ShiftLeft, kInt, {{kInt, {1}}, {kInt, {31}}}), Numbers{-2147483648.0});
}

TEST(Fold, LeavesWhatIsNotANumberToTheGpu) {
    EXPECT_EQ(folded(Op::Div, kFloat, {{kFloat, {1}}, {kFloat, {0}}}), Numbers{});
    EXPECT_EQ(folded(Op::Sqrt, kFloat, {{kFloat, {-1}}}), Numbers{});
    EXPECT_EQ(folded(Op::Exp, kFloat, {{kFloat, {100}}}), Numbers{});
    EXPECT_EQ(folded(Op::Mul, kHalf, {{kHalf, {300}}, {kHalf, {300}}}), Numbers{});
    EXPECT_EQ(folded(Op::Div, kInt, {{kInt, {1}}, {kInt, {0}}}), Numbers{});
    EXPECT_EQ(folded(Op::Mod, kInt, {{kInt, {1}}, {kInt, {0}}}), Numbers{});
    EXPECT_EQ(folded(Op::ShiftLeft, kInt, {{kInt, {1}}, {kInt, {32}}}), Numbers{});
    EXPECT_EQ(folded(Op::Convert, kInt, {{kFloat, {3e9}}}), Numbers{});
    EXPECT_EQ(folded(Op::Convert, kUint, {{kFloat, {-1}}}), Numbers{});
    EXPECT_EQ(folded(Op::Normalize, kFloat3, {{kFloat3, {0, 0, 0}}}), Numbers{});
}

TEST(Fold, KnowsVectorsAndMatrices) {
    const Type kMatrix = Type::matrix(Scalar::Float, 3, 3);
    const Operand m{kMatrix, {1, 2, 3, 4, 5, 6, 7, 8, 9}};
    const Operand v{kFloat3, {1, 2, 3}};
    EXPECT_EQ(folded(Op::MatMul, kFloat3, {m, v}), (Numbers{14, 32, 50}));
    EXPECT_EQ(folded(Op::MatMul, kFloat3, {v, m}), (Numbers{30, 36, 42}));
    EXPECT_EQ(folded(Op::Transpose, kMatrix, {m}), (Numbers{1, 4, 7, 2, 5, 8, 3, 6, 9}));
    EXPECT_EQ(folded(Op::Extract, kFloat3, {m}, 1), (Numbers{4, 5, 6}));
    EXPECT_EQ(folded(Op::Determinant, kFloat, {{kMatrix, {2, 0, 1, 1, 3, 2, 1, 1, 4}}}), Numbers{18});
    EXPECT_EQ(folded(Op::Cross, kFloat3, {{kFloat3, {1, 0, 0}}, {kFloat3, {0, 1, 0}}}), (Numbers{0, 0, 1}));
    EXPECT_EQ(folded(Op::Reflect, kFloat3, {{kFloat3, {1, -1, 0}}, {kFloat3, {0, 1, 0}}}), (Numbers{1, 1, 0}));
    EXPECT_EQ(folded(Op::Refract, kFloat3, {{kFloat3, {0, -1, 0}}, {kFloat3, {0, 1, 0}}, {kFloat, {0.5}}}),
              (Numbers{0, -1, 0}));
    EXPECT_EQ(folded(Op::Length, kFloat, {{kFloat2, {3, 4}}}), Numbers{5});
    EXPECT_EQ(folded(Op::Distance, kFloat, {{kFloat2, {3, 4}}, {kFloat2, {0, 0}}}), Numbers{5});
    EXPECT_EQ(folded(Op::Swizzle, kFloat2, {v}, 2 | 0 << 2), (Numbers{3, 1}));
    EXPECT_EQ(folded(Op::Index, kFloat, {v, {kInt, {7}}}), Numbers{3});
    EXPECT_EQ(folded(Op::Insert, kFloat3, {v, {kFloat, {9}}}, 1), (Numbers{1, 9, 3}));
    EXPECT_EQ(folded(Op::Bitcast, kUint, {{kFloat, {1}}}), Numbers{0x3f800000});
    EXPECT_EQ(folded(Op::Round, kFloat, {{kFloat, {2.5}}}), Numbers{2});
    EXPECT_EQ(folded(Op::Mod, kFloat, {{kFloat, {-7.5}}, {kFloat, {2}}}), Numbers{-1.5});
}

// --- composites

class Composites : public testing::Test {
protected:
    Composites() {
        module_.structs.push_back({"Pair", {{"first", kFloat3}, {"second", kFloat}}});
        for (const Type type : {kFloat3, kFloat4, kFloat, kFloat, Type::structure(0)}) {
            function_.params.push_back({"v", type, Rate::Pixel});
        }
        for (std::uint32_t i = 0; i < 5; i++) values_[i] = b_.param(i);
    }
    Value swizzle(Value v, std::vector<unsigned> components) { return b_.swizzle(v, components); }
    Value construct(Type type, std::vector<Value> parts) { return b_.construct(type, parts); }

    Module module_;
    Function function_;
    Builder b_{module_, function_};
    std::array<Value, 5> values_;
    Value &v3_ = values_[0], &v4_ = values_[1], &s_ = values_[2], &t_ = values_[3], &pair_ = values_[4];
};

TEST_F(Composites, ExtractOfWhatWasPutTogether) {
    const Value made = construct(kFloat4, {s_, v3_});
    EXPECT_EQ(b_.extract(made, 0), s_);
    EXPECT_EQ(b_.extract(made, 2), b_.extract(v3_, 1));
    EXPECT_EQ(b_.extract(construct(kFloat3, {s_}), 2), s_);
    EXPECT_EQ(b_.extract(construct(Type::structure(0), {v3_, t_}), 1), t_);
    EXPECT_EQ(b_.extract(swizzle(v4_, {3, 1}), 0), b_.extract(v4_, 3));
    const Value changed = b_.emit(Op::Insert, kFloat4, {v4_, s_}, 1);
    EXPECT_EQ(b_.extract(changed, 1), s_);
    EXPECT_EQ(b_.extract(changed, 2), b_.extract(v4_, 2));
}

TEST_F(Composites, InsertIntoWhatWasPutTogether) {
    const Value whole = construct(Type::structure(0), {v3_, t_});
    EXPECT_EQ(b_.emit(Op::Insert, Type::structure(0), {whole, s_}, 1), construct(Type::structure(0), {v3_, s_}));
    const Value once = b_.emit(Op::Insert, kFloat4, {v4_, s_}, 1);
    EXPECT_EQ(b_.emit(Op::Insert, kFloat4, {once, t_}, 1), b_.emit(Op::Insert, kFloat4, {v4_, t_}, 1));
    EXPECT_EQ(b_.emit(Op::Insert, kFloat4, {v4_, b_.extract(v4_, 2)}, 2), v4_);
}

TEST_F(Composites, PuttingTogetherWhatWasTakenApart) {
    EXPECT_EQ(construct(kFloat3, {b_.extract(v3_, 0), b_.extract(v3_, 1), b_.extract(v3_, 2)}), v3_);
    EXPECT_EQ(construct(kFloat2, {b_.extract(v3_, 2), b_.extract(v3_, 0)}), swizzle(v3_, {2, 0}));
    EXPECT_EQ(construct(kFloat4, {swizzle(v4_, {0, 1}), swizzle(v4_, {2, 3})}), v4_);
    EXPECT_EQ(construct(Type::structure(0), {b_.extract(pair_, 0), b_.extract(pair_, 1)}), pair_);
    EXPECT_EQ(construct(kFloat3, {s_, s_, s_}), b_.splat(s_, 3));
    EXPECT_EQ(b_[construct(kFloat2, {b_.extract(v3_, 0), b_.extract(v4_, 1)})].op, Op::Construct);
    EXPECT_EQ(b_[construct(kFloat2, {s_, b_.extract(v3_, 0)})].op, Op::Construct);
}

TEST_F(Composites, Swizzles) {
    EXPECT_EQ(swizzle(v3_, {0, 1, 2}), v3_);
    EXPECT_EQ(swizzle(swizzle(v4_, {3, 2, 1}), {1, 0}), swizzle(v4_, {2, 3}));
    EXPECT_EQ(swizzle(swizzle(v4_, {3, 2, 1, 0}), {3, 2, 1, 0}), v4_);
    EXPECT_EQ(swizzle(construct(kFloat4, {s_, v3_}), {1, 2, 3}), v3_);
    EXPECT_EQ(swizzle(construct(kFloat3, {s_, t_, s_}), {1, 0}), construct(kFloat2, {t_, s_}));
    EXPECT_EQ(swizzle(construct(kFloat3, {s_}), {2, 2}), b_.splat(s_, 2));
    EXPECT_EQ(b_[swizzle(v3_, {2, 1, 0})].op, Op::Swizzle);
    EXPECT_EQ(b_[swizzle(construct(kFloat4, {s_, v3_}), {0, 1})].op, Op::Swizzle);
}

TEST_F(Composites, Conversions) {
    EXPECT_EQ(b_.convert(s_, Scalar::Float), s_);
    const Value half = b_.convert(s_, Scalar::Half);
    EXPECT_EQ(b_.convert(b_.convert(half, Scalar::Float), Scalar::Half), half);
    // A half does not hold every float.
    EXPECT_NE(b_.convert(half, Scalar::Float), s_);
    const Value bits = b_.emit(Op::Bitcast, kUint, {s_});
    EXPECT_EQ(b_.emit(Op::Bitcast, kFloat, {b_.emit(Op::Bitcast, kInt, {bits})}), s_);
    EXPECT_EQ(b_.emit(Op::Index, kFloat, {v3_, b_.constant(kInt, {9})}), b_.extract(v3_, 2));
}

}  // namespace
}  // namespace patina::ir
