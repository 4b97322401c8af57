// Functions and constructors of the language itself, and their requirements for the place of the call.
#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/emit/conversion.h"
#include "compiler/emit/operations/operations.h"
#include "compiler/ir/fold/fold.h"
#include "compiler/nodelang/other_names.h"

namespace patina::emit {

using ir::Op;
using ir::Scalar;
using ir::Type;
using ir::Value;

namespace {

// What operands an intrinsic takes.
enum class Takes {
    Floats,    // any width, one type
    Numbers,   // integers too
    Vectors,   // floats of at least two components
    Vectors3,  // float3
    Unlike,    // refract: two vectors and a scalar
    Bools,     // any, all
    Product,   // mul
    Matrix,    // transpose, determinant
    Floating,  // isnan, isinf: result is bool
    Pixels,    // derivatives
};
struct Intrinsic {
    std::string_view name;
    Op op;
    std::size_t arguments;
    Takes takes;
};
constexpr Intrinsic kIntrinsics[] = {
    {"abs", Op::Abs, 1, Takes::Numbers},
    {"acos", Op::Acos, 1, Takes::Floats},
    {"all", Op::All, 1, Takes::Bools},
    {"any", Op::Any, 1, Takes::Bools},
    {"asin", Op::Asin, 1, Takes::Floats},
    {"atan", Op::Atan, 1, Takes::Floats},
    {"atan2", Op::Atan2, 2, Takes::Floats},
    {"ceil", Op::Ceil, 1, Takes::Floats},
    {"clamp", Op::Clamp, 3, Takes::Numbers},
    {"cos", Op::Cos, 1, Takes::Floats},
    {"cosh", Op::Cosh, 1, Takes::Floats},
    {"cross", Op::Cross, 2, Takes::Vectors3},
    {"ddx", Op::Ddx, 1, Takes::Pixels},
    {"ddy", Op::Ddy, 1, Takes::Pixels},
    {"degrees", Op::Degrees, 1, Takes::Floats},
    {"determinant", Op::Determinant, 1, Takes::Matrix},
    {"distance", Op::Distance, 2, Takes::Vectors},
    {"dot", Op::Dot, 2, Takes::Vectors},
    {"exp", Op::Exp, 1, Takes::Floats},
    {"exp2", Op::Exp2, 1, Takes::Floats},
    {"floor", Op::Floor, 1, Takes::Floats},
    {"fmod", Op::Mod, 2, Takes::Floats},
    {"frac", Op::Frac, 1, Takes::Floats},
    {"fwidth", Op::Fwidth, 1, Takes::Pixels},
    {"isinf", Op::IsInf, 1, Takes::Floating},
    {"isnan", Op::IsNan, 1, Takes::Floating},
    {"length", Op::Length, 1, Takes::Vectors},
    {"lerp", Op::Lerp, 3, Takes::Floats},
    {"log", Op::Log, 1, Takes::Floats},
    {"log2", Op::Log2, 1, Takes::Floats},
    {"max", Op::Max, 2, Takes::Numbers},
    {"min", Op::Min, 2, Takes::Numbers},
    {"mul", Op::MatMul, 2, Takes::Product},
    {"normalize", Op::Normalize, 1, Takes::Vectors},
    {"pow", Op::Pow, 2, Takes::Floats},
    {"radians", Op::Radians, 1, Takes::Floats},
    {"reflect", Op::Reflect, 2, Takes::Vectors},
    {"refract", Op::Refract, 3, Takes::Unlike},
    {"round", Op::Round, 1, Takes::Floats},
    {"rsqrt", Op::Rsqrt, 1, Takes::Floats},
    {"saturate", Op::Saturate, 1, Takes::Floats},
    {"sign", Op::Sign, 1, Takes::Floats},
    {"sin", Op::Sin, 1, Takes::Floats},
    {"sinh", Op::Sinh, 1, Takes::Floats},
    {"smoothstep", Op::Smoothstep, 3, Takes::Floats},
    {"sqrt", Op::Sqrt, 1, Takes::Floats},
    {"step", Op::Step, 2, Takes::Floats},
    {"tan", Op::Tan, 1, Takes::Floats},
    {"tanh", Op::Tanh, 1, Takes::Floats},
    {"transpose", Op::Transpose, 1, Takes::Matrix},
    {"trunc", Op::Trunc, 1, Takes::Floats},
};
static_assert(std::is_sorted(std::begin(kIntrinsics), std::end(kIntrinsics),
                             [](const Intrinsic& a, const Intrinsic& b) { return a.name < b.name; }),
              "find_intrinsic() searches by halves");
constexpr std::pair<std::string_view, Scalar> kBitcasts[] = {
    {"asfloat", Scalar::Float}, {"asint", Scalar::Int}, {"asuint", Scalar::Uint}};

const Intrinsic* find_intrinsic(std::string_view name) {
    const auto found = std::lower_bound(std::begin(kIntrinsics), std::end(kIntrinsics), name,
                                        [](const Intrinsic& row, std::string_view n) { return row.name < n; });
    return found != std::end(kIntrinsics) && found->name == name ? found : nullptr;
}

// What HLSL converts before an intrinsic function takes its operands.
[[gnu::noinline]] void hlsl_arguments(Takes takes, std::span<Typed> operands, Scope& scope) {
    const auto cast_to = [&](Typed& operand, Type wanted) {
        if (const Typed made = hlsl_cast(operand, wanted, scope); made.ok()) operand = made;
    };
    const Scalar floating = scope.half ? Scalar::Half : Scalar::Float;
    for (Typed& operand : operands) {
        if (!operand.type.is_numeric()) continue;
        if (takes == Takes::Bools) {
            cast_to(operand, operand.type.with_scalar(Scalar::Bool));
        } else if (takes == Takes::Numbers) {
            if (operand.type.is_bool()) cast_to(operand, operand.type.with_scalar(Scalar::Int));
        } else if (!operand.type.is_floating() && !operand.literal) {
            cast_to(operand, operand.type.with_scalar(floating));
        } else if (takes == Takes::Product && operand.literal) {
            cast_to(operand, operand.type.with_scalar(floating));
        }
        if (takes == Takes::Vectors3 && operand.type.width() == 4) cast_to(operand, operand.type.with_width(3));
    }
    if (takes != Takes::Product) return;
    // A vector that is too long for the matrix is cut.
    for (const std::size_t i : {0u, 1u}) {
        const Type matrix = operands[1 - i].type;
        const unsigned size = i == 0 ? matrix.rows : matrix.cols;
        if (matrix.is_matrix() && operands[i].type.is_vector() && operands[i].type.width() > size)
            cast_to(operands[i], operands[i].type.with_width(size));
    }
}

}  // namespace

std::vector<std::string_view> intrinsic_names() {
    std::vector<std::string_view> names;
    for (const Intrinsic& row : kIntrinsics) names.push_back(row.name);
    return names;
}

void need_quad(Emitter& emitter, Scope& scope, Span span, std::string_view what, bool samples) {
    if (scope.in_vertex_stage) {
        DiagnosticRecord& record =
            emitter.diagnostics.report(Code::WrongStage, span, what, "it uses screen-space derivatives");
        if (samples) record.note("in the vertex stage, sample with SampleLevel, or with a node that takes a mip level");
        if (scope.environment) scope.environment->tell_reader(record);
    } else if (!scope.flow.empty()) {
        emitter.diagnostics.report(Code::DerivativeInFlow, span, what, scope.flow, "it uses screen-space derivatives")
            .note("compute it before, or sample with SampleLevel or SampleGrad");
    }
    if (scope.needs_quad) *scope.needs_quad = true;
}

void warn_unless_finite(Emitter& emitter, Op op, Type type, std::span<const Value> values, const Scope& scope,
                        Span span, std::string_view what) {
    const auto is_constant = [&](Value value) { return !scope.builder->constant_of(value).empty(); };
    if (!std::all_of(values.begin(), values.end(), is_constant)) return;
    std::vector<Type> types;
    std::vector<std::span<const double>> numbers;
    for (const Value value : values) {
        types.push_back(scope.builder->type(value));
        numbers.push_back(scope.builder->constant_of(value));
    }
    std::vector<double> made;
    if (!ir::evaluate(op, type, types, numbers, 0, made)) return;
    if (std::all_of(made.begin(), made.end(), [](double number) { return std::isfinite(number); })) return;
    emitter.diagnostics.report(Code::NotFinite, span, fmt::format("'{}'", what));
}

Typed intrinsic(Emitter& emitter, std::string_view name, const Expr& expr, Scope& scope, bool& found) {
    const auto bitcast =
        std::find_if(std::begin(kBitcasts), std::end(kBitcasts), [&](const auto& row) { return row.first == name; });
    const Intrinsic* row = find_intrinsic(name);
    found = row || bitcast != std::end(kBitcasts);
    if (!found) return {};
    const std::size_t wanted = row ? row->arguments : 1;
    if (expr.args.size() != wanted) {
        emitter.diagnostics.report(Code::ArgumentCount, expr.name_span, name, wanted, expr.args.size())
            .note(nodelang::word_advice(fmt::format("{}/{}", name, expr.args.size())));
        return {};
    }
    std::vector<Typed> operands;
    operands.reserve(expr.args.size());
    bool good = true;
    for (const Expr* argument : expr.args) {
        operands.push_back(primary(emitter, expression(emitter, *argument, scope), scope, argument->span));
        good = good && operands.back().ok();
    }
    if (!good) return {};
    ir::Builder& b = *scope.builder;
    if (scope.hlsl && row) hlsl_arguments(row->takes, operands, scope);
    const auto refuse = [&](const Typed& operand) {
        emitter.diagnostics.report(Code::BadOperand, expr.span, name, emitter.module.type_name(operand.type));
        return Typed{};
    };
    for (const Typed& operand : operands) {
        if (!operand.type.is_numeric()) return refuse(operand);
    }
    const Scalar floating = scope.half ? Scalar::Half : Scalar::Float;
    if (!row) {
        if (operands[0].literal && operands[0].type.is_integer() && bitcast->second != Scalar::Float)
            return operands[0];
        const Type type = operands[0].type.with_scalar(bitcast->second);
        if (operands[0].type.is_bool() || operands[0].type.scalar == Scalar::Half) return refuse(operands[0]);
        return {.value = b.emit(Op::Bitcast, type, {operands[0].value}), .type = type};
    }
    if (row->takes == Takes::Product) {
        // A half operand becomes float if the other one is float.
        for (std::size_t i : {0u, 1u}) {
            Typed& half = operands[i];
            if (half.type.scalar != Scalar::Half || operands[1 - i].type.scalar != Scalar::Float) continue;
            half = {.value = b.convert(half.value, Scalar::Float), .type = half.type.with_scalar(Scalar::Float)};
        }
        const Type left = operands[0].type, right = operands[1].type;
        const std::array types{left, right};
        if (left.is_matrix() || right.is_matrix()) {
            const Type type = ir::result_type(Op::MatMul, types);
            if (type.is_error()) {
                emitter.diagnostics.report(Code::BadOperands, expr.span, name, emitter.module.type_name(left),
                                           emitter.module.type_name(right));
                return {};
            }
            return {.value = b.emit(Op::MatMul, type, {operands[0].value, operands[1].value}), .type = type};
        }
        if (!scope.hlsl) return refuse(operands[0]);
        // Of two vectors, mul is their dot product; a scalar scales the other side.
        if (!unify(emitter, operands, scope, expr.span, name)) return {};
        const Type type = operands[0].type;
        if (left.is_scalar() || right.is_scalar())
            return {.value = b.emit(Op::Mul, type, {operands[0].value, operands[1].value}), .type = type};
        const Type scalar = Type::scalar_of(type.scalar);
        return {.value = b.emit(Op::Dot, scalar, {operands[0].value, operands[1].value}), .type = scalar};
    }
    if (row->takes == Takes::Matrix) {
        if (!operands[0].type.is_matrix()) return refuse(operands[0]);
        const Value value = b.emit(row->op, {operands[0].value});
        return {.value = value, .type = b.type(value)};
    }
    if (row->takes == Takes::Bools) {
        if (!operands[0].type.is_bool()) return refuse(operands[0]);
        if (operands[0].type.is_scalar()) return operands[0];
        return {.value = b.emit(row->op, ir::kBool, {operands[0].value}), .type = ir::kBool};
    }
    // Whole literals are floats here, unless another operand is an integer. In HLSL they are integers.
    const bool integers =
        row->takes == Takes::Numbers && std::any_of(operands.begin(), operands.end(), [&](const Typed& t) {
            return t.type.is_integer() && (!t.literal || scope.hlsl);
        });
    for (Typed& operand : operands) {
        if (!integers && operand.literal && operand.type.is_integer())
            operand = literal_as(emitter, operand, floating, scope, expr.span);
        if (operand.type.is_bool() || (operand.type.is_integer() && !integers) || operand.type.is_matrix()) {
            return refuse(operand);
        }
    }
    const std::size_t joined = row->takes == Takes::Unlike ? 2 : operands.size();
    if (joined > 1 && !unify(emitter, std::span(operands).subspan(0, joined), scope, expr.span, name)) return {};
    const Type type = operands[0].type;
    // The IR's abs takes numbers with a sign.
    if (row->op == Op::Abs && type.scalar == Scalar::Uint) return {.value = operands[0].value, .type = type};
    // A vector of one component, which floatN may be.
    if (row->takes == Takes::Vectors && type.is_scalar() && ir::info(row->op).rule == ir::TypeRule::Scalar) {
        const Value first = operands[0].value;
        if (row->op == Op::Dot) return {.value = b.emit(Op::Mul, type, {first, operands[1].value}), .type = type};
        const Value difference = row->op == Op::Distance ? b.emit(Op::Sub, type, {first, operands[1].value}) : first;
        return {.value = b.emit(Op::Abs, type, {difference}), .type = type};
    }
    if (row->takes == Takes::Vectors || row->takes == Takes::Vectors3 || row->takes == Takes::Unlike) {
        if (!type.is_vector() || (row->takes == Takes::Vectors3 && type.width() != 3)) return refuse(operands[0]);
    }
    if (row->takes == Takes::Unlike) {
        operands[2] =
            convert(emitter, operands[2], Type::scalar_of(type.scalar), scope, expr.args[2]->span, "the ratio");
        if (!operands[2].ok()) return {};
    }
    if (row->takes == Takes::Pixels) need_quad(emitter, scope, expr.span, name, false);
    std::vector<Value> values;
    for (const Typed& operand : operands) values.push_back(operand.value);
    const ir::TypeRule rule = ir::info(row->op).rule;
    const Type result = rule == ir::TypeRule::Scalar  ? Type::scalar_of(type.scalar)
                        : rule == ir::TypeRule::Bools ? Type::vector(Scalar::Bool, type.width())
                                                      : type;
    warn_unless_finite(emitter, row->op, result, values, scope, expr.span, name);
    return {.value = b.emit(row->op, result, values), .type = result, .is_whole = scope.hlsl && row->op == Op::Sign};
}

Typed constructor(Emitter& emitter, Type wanted, const Expr& expr, Scope& scope) {
    ir::Builder& b = *scope.builder;
    std::vector<Value> parts;
    unsigned count = 0;
    for (const Expr* argument : expr.args) {
        Typed part = primary(emitter, expression(emitter, *argument, scope), scope, argument->span);
        if (!part.ok()) return {};
        if (scope.hlsl && expr.args.size() == 1) {
            if (const Typed made = hlsl_cast(part, wanted, scope); made.ok()) return made;
        }
        if (scope.hlsl && part.type.is_matrix()) {
            for (unsigned row = 0; row < part.type.rows; ++row)
                parts.push_back(b.convert(b.extract(part.value, row), wanted.scalar));
            count += part.type.components();
            continue;
        }
        if (!part.type.is_numeric() || part.type.is_matrix()) {
            emitter.diagnostics.report(Code::BadOperand, argument->span, expr.text,
                                       emitter.module.type_name(part.type));
            return {};
        }
        if (part.literal && !wanted.is_bool()) part = literal_as(emitter, part, wanted.scalar, scope, argument->span);
        if (part.type.scalar != wanted.scalar) part.value = b.convert(part.value, wanted.scalar);
        parts.push_back(part.value);
        count += part.type.width();
    }
    const unsigned needed = wanted.components();
    if (wanted.is_matrix()) {
        // As in HLSL: one vector for each row, or every component row by row.
        std::vector<Value> rows;
        if (parts.size() == wanted.rows && count == needed) {
            rows = parts;
        } else if (parts.size() == needed) {
            for (unsigned r = 0; r < wanted.rows; ++r) {
                rows.push_back(b.construct(Type::vector(wanted.scalar, wanted.cols),
                                           std::span(parts).subspan(r * wanted.cols, wanted.cols)));
            }
        } else if (scope.hlsl && count == needed) {
            std::vector<Value> numbers;
            for (const Value part : parts) {
                const unsigned width = b.type(part).width();
                for (unsigned i = 0; i < width; ++i) numbers.push_back(width == 1 ? part : b.extract(part, i));
            }
            for (unsigned r = 0; r < wanted.rows; ++r)
                rows.push_back(b.construct(Type::vector(wanted.scalar, wanted.cols),
                                           std::span(numbers).subspan(r * wanted.cols, wanted.cols)));
        } else {
            emitter.diagnostics.report(Code::ArgumentCount, expr.name_span, expr.text, needed, count);
            return {};
        }
        return {.value = b.construct(wanted, rows), .type = wanted};
    }
    if (parts.size() == 1 && count == needed) return {.value = parts[0], .type = wanted};
    if (parts.size() == 1 && count == 1) return {.value = b.splat(parts[0], needed), .type = wanted};
    if (count != needed) {
        DiagnosticRecord& record =
            emitter.diagnostics.report(Code::ArgumentCount, expr.name_span, expr.text, needed, count);
        if (count > needed && parts.size() == 1) {
            record.note(fmt::format("take a part: .{}", std::string_view("xyzw").substr(0, needed)));
        }
        return {};
    }
    return {.value = b.construct(wanted, parts), .type = wanted};
}

}  // namespace patina::emit
