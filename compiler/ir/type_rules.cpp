// result_type(): which operands each TypeRule accepts, and the type of the result.
#include <algorithm>
#include <array>
#include <initializer_list>

#include "compiler/ir/ir.h"
#include "compiler/ir/texture_kinds.h"

namespace patina::ir {
namespace {

enum Operands : std::uint8_t {
    Bools = 1,
    Ints = 2,
    Uints = 4,
    Floats = 8,
    Integers = Ints | Uints,
    Signed = Ints | Floats,
    Numbers = Integers | Floats,
    Everything = Numbers | Bools
};

struct Demand {
    Op op;
    std::uint8_t operands;
};

// What the component-wise ops accept; those that are not listed take floats.
constexpr Demand kDemands[] = {
    {Op::Add, Numbers},         {Op::Sub, Numbers},         {Op::Mul, Numbers},          {Op::Div, Numbers},
    {Op::Mod, Numbers},         {Op::Neg, Numbers},         {Op::Abs, Signed},           {Op::Sign, Signed},
    {Op::Min, Numbers},         {Op::Max, Numbers},         {Op::Clamp, Numbers},        {Op::Less, Numbers},
    {Op::LessEqual, Numbers},   {Op::Greater, Numbers},     {Op::GreaterEqual, Numbers}, {Op::Equal, Everything},
    {Op::NotEqual, Everything}, {Op::And, Operands::Bools}, {Op::Or, Operands::Bools},   {Op::Not, Operands::Bools},
    {Op::BitAnd, Integers},     {Op::BitOr, Integers},      {Op::BitXor, Integers},      {Op::BitNot, Integers},
    {Op::ShiftLeft, Integers},  {Op::ShiftRight, Integers},
};

constexpr auto kAccepted = [] {
    std::array<std::uint8_t, kOpCount> accepted{};
    accepted.fill(Floats);
    for (const Demand& demand : kDemands) accepted[static_cast<std::size_t>(demand.op)] = demand.operands;
    return accepted;
}();

bool accepts(Op op, Type type) {
    if (!type.is_numeric()) return false;
    constexpr std::array<std::uint8_t, 5> kKinds = {Operands::Bools, Ints, Uints, Floats, Floats};  // by Scalar
    return (kAccepted[static_cast<std::size_t>(op)] & kKinds[static_cast<std::size_t>(type.scalar)]) != 0;
}

bool all_equal(std::span<const Type> types) {
    return std::all_of(types.begin(), types.end(), [&](Type t) { return t == types[0]; });
}

bool is_float_vector(Type type) {
    return type.is_floating() && type.is_vector();
}

Type same(Op op, std::span<const Type> types) {
    if (!all_equal(types) || !accepts(op, types[0])) return Type::error();
    if (op == Op::Normalize && !types[0].is_vector()) return Type::error();
    if (op == Op::Cross && (!types[0].is_vector() || types[0].width() != 3)) return Type::error();
    return types[0];
}

Type select(std::span<const Type> types) {
    const Type condition = types[0];
    if (!condition.is_bool() || condition.is_matrix() || types[1] != types[2]) return Type::error();
    const bool fits = condition.is_scalar() ||
                      (types[1].is_numeric() && !types[1].is_matrix() && condition.width() == types[1].width());
    return fits ? types[1] : Type::error();
}

Type compare(Op op, std::span<const Type> types) {
    if (!all_equal(types) || !accepts(op, types[0]) || types[0].is_matrix()) return Type::error();
    return types[0].with_scalar(Scalar::Bool);
}

Type scalar(Op op, std::span<const Type> types) {
    if (!all_equal(types) || !types[0].is_floating()) return Type::error();
    const bool fits =
        op == Op::Determinant ? types[0].is_matrix() && types[0].rows == types[0].cols : !types[0].is_matrix();
    return fits ? types[0].with_width(1) : Type::error();
}

Type product(Type a, Type b) {
    if (!a.is_floating() || !b.is_floating() || a.scalar != b.scalar) return Type::error();
    if (a.is_matrix() && b.is_matrix()) {
        return a.cols == b.rows ? Type::matrix(a.scalar, a.rows, b.cols) : Type::error();
    }
    if (a.is_matrix() && b.is_vector()) return a.cols == b.rows ? a.with_width(a.rows) : Type::error();
    if (a.is_vector() && b.is_matrix()) return a.rows == b.rows ? a.with_width(b.cols) : Type::error();
    return Type::error();
}

Type first(Op op, std::span<const Type> types) {
    // Insert's value is checked by the verifier, which knows the module's structs.
    if (op == Op::Insert) return types[0];
    const bool fits = is_float_vector(types[0]) && types[1] == types[0] && types[2] == types[0].with_width(1);
    return fits ? types[0] : Type::error();
}

Type texel(Op op, std::span<const Type> types) {
    const TextureKind* texture = texture_kind(types[0].kind);
    if (!texture) return Type::error();
    if (op == Op::TexelLoad) {
        return texture->kind == Kind::Texture2D && types[1] == Type::vector(Scalar::Int, 2) && types[2] == kInt
                   ? kFloat4
                   : Type::error();
    }
    const Type coordinate = Type::vector(Scalar::Float, texture->coordinates);
    if (types[1].kind != Kind::Sampler || types[2] != coordinate) return Type::error();
    const Type further = op == Op::SampleGrad ? Type::vector(Scalar::Float, texture->derivatives) : kFloat;
    const auto rest = types.subspan(3);
    return std::all_of(rest.begin(), rest.end(), [&](Type t) { return t == further; }) ? kFloat4 : Type::error();
}

}  // namespace

Type result_type(Op op, std::span<const Type> types) {
    const OpInfo& row = info(op);
    if (row.arguments >= 0 && types.size() != static_cast<std::size_t>(row.arguments)) return Type::error();
    switch (row.rule) {
        case TypeRule::Declared: return Type::error();
        case TypeRule::Void: return Type::none();
        case TypeRule::First: return first(op, types);
        case TypeRule::Second: return select(types);
        case TypeRule::Same: return same(op, types);
        case TypeRule::Compare: return compare(op, types);
        case TypeRule::Bools: return types[0].is_floating() ? types[0].with_scalar(Scalar::Bool) : Type::error();
        case TypeRule::Bool: return types[0].is_bool() ? kBool : Type::error();
        case TypeRule::Scalar: return scalar(op, types);
        case TypeRule::Product: return product(types[0], types[1]);
        case TypeRule::Transposed:
            return types[0].is_matrix() ? Type::matrix(types[0].scalar, types[0].cols, types[0].rows) : Type::error();
        case TypeRule::Texel: return texel(op, types);
    }
    return Type::error();
}

}  // namespace patina::ir
