#include "compiler/emit/conversion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/base/text.h"

namespace patina::emit {

using ir::Scalar;
using ir::Type;
using ir::Value;

bool joins(Scalar a, Scalar b) {
    return a == b || (a == Scalar::Half && b == Scalar::Float) || (a == Scalar::Float && b == Scalar::Half);
}

std::string_view swizzle_prefix(unsigned width) {
    return std::string_view("xyzw").substr(0, width);
}

Typed at_border(Typed value, const Scope& scope) {
    if (!scope.environment || !value.ok() || value.outputs || value.literal || !value.type.is_numeric()) return value;
    const Scalar wanted = scope.half ? Scalar::Half : Scalar::Float;
    if (value.type.scalar == wanted || !joins(value.type.scalar, wanted)) return value;
    return {.value = scope.builder->convert(value.value, wanted), .type = value.type.with_scalar(wanted)};
}

Typed literal_as(Emitter& emitter, Typed value, Scalar scalar, Scope& scope, Span span) {
    const std::span<const double> number = scope.builder->constant_of(value.value);
    const Type type = value.type.with_scalar(scalar);
    if (scalar == Scalar::Half && !number.empty() && std::abs(number[0]) >= kHalfLimit) {
        emitter.diagnostics.report(Code::BadNumber, span, shortest(number[0]), "16-bit half");
    }
    if (number.empty()) return {.value = scope.builder->convert(value.value, scalar), .type = type, .literal = true};
    return {.value = scope.builder->constant(type, number), .type = type, .literal = true};
}

// Apart from convert(), whose frame is on the stack of every expression.
[[gnu::noinline]] Typed hlsl_cast(const Typed& value, Type wanted, Scope& scope) {
    if (!value.ok() || !value.type.is_numeric() || !wanted.is_numeric()) return {};
    constexpr std::array kFirst = {0u, 1u, 2u, 3u};
    ir::Builder& b = *scope.builder;
    const Type have = value.type;
    if (have.is_matrix() != wanted.is_matrix()) {
        if (!have.is_scalar()) return {};
        const Value one = b.convert(value.value, wanted.scalar);
        const std::vector<Value> rows(wanted.rows, b.splat(one, wanted.cols));
        return {.value = b.construct(wanted, rows), .type = wanted};
    }
    Value v = value.value;
    if (have.is_matrix()) {
        if (have.rows < wanted.rows || have.cols < wanted.cols) return {};
        const Type cut = wanted.with_scalar(have.scalar);
        if (have != cut) {
            std::vector<Value> rows;
            for (unsigned row = 0; row < wanted.rows; ++row) {
                const Value whole = b.extract(v, row);
                rows.push_back(have.cols == wanted.cols ? whole
                                                        : b.swizzle(whole, std::span(kFirst).first(wanted.cols)));
            }
            v = b.construct(cut, rows);
        }
        return {.value = b.convert(v, wanted.scalar), .type = wanted};
    }
    const unsigned width = wanted.width();
    if (have.width() > width) {
        v = width == 1 ? b.extract(v, 0) : b.swizzle(v, std::span(kFirst).first(width));
    } else if (have.width() < width && have.width() > 1) {
        return {};
    }
    v = b.convert(v, wanted.scalar);
    if (have.width() == 1 && width > 1) v = b.splat(v, width);
    return {.value = v, .type = wanted};
}

Typed convert(Emitter& emitter, Typed value, Type wanted, Scope& scope, Span span, std::string_view what) {
    if (!value.ok() || wanted.is_error()) return {};
    if (value.type == wanted) return {.value = value.value, .type = wanted};
    ir::Builder& b = *scope.builder;
    if (value.literal && value.type.scalar == Scalar::Int && wanted.is_numeric() && !wanted.is_bool()) {
        value = literal_as(emitter, value, wanted.scalar, scope, span);
    }
    if (value.type.is_matrix() && joins(value.type.scalar, wanted.scalar) &&
        value.type.with_scalar(wanted.scalar) == wanted) {
        return {.value = b.convert(value.value, wanted.scalar), .type = wanted};
    }
    const bool plain = value.type.is_numeric() && !value.type.is_matrix() && wanted.is_numeric() && !wanted.is_matrix();
    if (plain && joins(value.type.scalar, wanted.scalar)) {
        const unsigned have = value.type.width();
        const bool shape = have == wanted.width() || have == 1 || (have == 4 && wanted.width() == 3);
        if (shape) {
            Value v = value.value;
            if (have == 4 && wanted.width() == 3) v = b.swizzle(v, std::array{0u, 1u, 2u});
            if (value.type.scalar != wanted.scalar) v = b.convert(v, wanted.scalar);
            if (have == 1 && wanted.width() > 1) v = b.splat(v, wanted.width());
            return {.value = v, .type = wanted};
        }
    }
    if (scope.hlsl) {
        if (Typed made = hlsl_cast(value, wanted, scope); made.ok()) return made;
    }
    DiagnosticRecord& record = emitter.diagnostics.report(
        Code::TypeMismatch, span, what, emitter.module.type_name(value.type), emitter.module.type_name(wanted));
    if (plain && value.type.width() > wanted.width()) {
        record.note(fmt::format("take a part of it: .{}", swizzle_prefix(wanted.width())));
    } else if (plain && value.type.width() < wanted.width() && value.type.width() > 1) {
        record.note(fmt::format("extend it: {}(..., 0)", emitter.module.type_name(wanted)));
    } else if (plain && value.type.is_bool()) {
        record.note("write '... ? 1 : 0' to convert a bool to a number");
    } else if (plain && wanted.is_bool()) {
        record.note("compare it: '... > 0.5'");
    } else if (plain) {
        record.note(fmt::format("convert it: {}(...)", emitter.module.type_name(wanted)));
    }
    return {};
}

Typed expression_as(Emitter& emitter, const Expr& expr, Type wanted, Scope& scope, std::string_view what) {
    Typed value = primary(emitter, expression(emitter, expr, scope), scope, expr.span);
    // A colour without alpha, "#ff8800", is opaque where a float4 is wanted.
    if (expr.kind == Expr::Kind::Color && value.ok() && value.type.width() == 3 && wanted == ir::kFloat4) {
        const Value opaque = scope.builder->constant(ir::kFloat, {1});
        value = {.value = scope.builder->construct(ir::kFloat4, std::array{value.value, opaque}), .type = ir::kFloat4};
    }
    if (expr.kind == Expr::Kind::Color && value.ok() && value.type.width() == 4 && wanted == ir::kFloat3)
        emitter.diagnostics.report(Code::NoEffect, expr.name_span, "alpha", "a colour without alpha is wanted");
    return convert(emitter, value, wanted, scope, expr.span, what);
}

namespace {

[[gnu::noinline]] bool hlsl_unify(std::span<Typed> operands, Scope& scope) {
    const auto firm_half = [&] {
        return std::any_of(operands.begin(), operands.end(),
                           [](const Typed& t) { return t.type.scalar == Scalar::Half; }) &&
               std::none_of(operands.begin(), operands.end(),
                            [](const Typed& t) { return t.type.scalar == Scalar::Float && !t.literal; });
    };
    Scalar scalar = Scalar::Bool;
    unsigned width = 1, rows = 0, cols = 0;
    for (const Typed& operand : operands) {
        scalar = std::max(scalar, operand.type.scalar);  // they are in this order
        if (operand.type.is_matrix()) {
            rows = rows == 0 ? operand.type.rows : std::min<unsigned>(rows, operand.type.rows);
            cols = cols == 0 ? operand.type.cols : std::min<unsigned>(cols, operand.type.cols);
        } else if (operand.type.width() > 1) {
            width = width == 1 ? operand.type.width() : std::min(width, operand.type.width());
        }
    }
    // A literal does not make a half a float.
    if (firm_half()) scalar = Scalar::Half;
    if (rows > 0 && width > 1) return false;
    const Type wanted = rows > 0 ? Type::matrix(scalar, rows, cols) : Type::vector(scalar, width);
    for (Typed& operand : operands) {
        const bool literal = operand.literal && wanted.is_scalar();
        if (operand.type != wanted) operand = hlsl_cast(operand, wanted, scope);
        operand.literal = literal;
        operand.is_whole = false;
    }
    return true;
}

}  // namespace

bool unify(Emitter& emitter, std::span<Typed> operands, Scope& scope, Span span, std::string_view op) {
    for (const Typed& operand : operands) {
        if (!operand.ok()) return false;
        if (!operand.type.is_numeric()) {
            DiagnosticRecord& record =
                emitter.diagnostics.report(Code::BadOperand, span, op, emitter.module.type_name(operand.type));
            if (operand.type.kind == ir::Kind::Sampler && op == "?:")
                record.note("read the texture with each of the samplers, and choose between the two texels");
            return false;
        }
    }
    if (scope.hlsl && hlsl_unify(operands, scope)) return true;
    const auto firm = std::find_if(operands.begin(), operands.end(), [](const Typed& t) { return !t.literal; });
    Scalar scalar = firm != operands.end() ? firm->type.scalar : operands[0].type.scalar;
    bool any_matrix = false;
    for (const Typed& operand : operands) {
        const bool is_real = joins(operand.type.scalar, Scalar::Float);
        if (is_real && !joins(scalar, Scalar::Float) && firm == operands.end()) scalar = operand.type.scalar;
        if (operand.type.scalar == Scalar::Float && joins(scalar, Scalar::Float) && !operand.literal) {
            scalar = Scalar::Float;
        }
        // A fraction cannot become an int: the message below names the types.
        any_matrix = any_matrix || operand.type.is_matrix();
    }
    unsigned width = 1;
    for (Typed& operand : operands) {
        if (operand.literal && operand.type.scalar != scalar && scalar != Scalar::Bool) {
            const std::span<const double> number = scope.builder->constant_of(operand.value);
            const bool whole = !number.empty() && number[0] == std::floor(number[0]);
            if (operand.type.scalar == Scalar::Int || scalar == Scalar::Half || scalar == Scalar::Float ||
                (whole && operand.type.scalar == Scalar::Int)) {
                operand = literal_as(emitter, operand, scalar, scope, span);
            }
        }
        width = std::max(width, operand.type.is_matrix() ? 1 : operand.type.width());
    }
    for (Typed& operand : operands) {
        const bool same_kind = joins(operand.type.scalar, scalar);
        const bool same_shape =
            any_matrix ? operand.type == operands[0].type : operand.type.is_scalar() || operand.type.width() == width;
        if (same_kind && same_shape) {
            if (operand.type.scalar != scalar) {
                operand.value = scope.builder->convert(operand.value, scalar);
                operand.type = operand.type.with_scalar(scalar);
            }
            if (operand.type.is_scalar() && width > 1) {
                operand.value = scope.builder->splat(operand.value, width);
                operand.type = operand.type.with_width(width);
            }
            continue;
        }
        const Typed& other = &operand == &operands[0] ? operands[1] : operands[0];
        DiagnosticRecord& record =
            emitter.diagnostics.report(Code::BadOperands, span, op, emitter.module.type_name(operands[0].type),
                                       emitter.module.type_name((&operand == &operands[0] ? other : operand).type));
        if (!same_kind && operand.type.is_bool() != other.type.is_bool()) {
            record.note("write '... ? 1 : 0' to convert a bool to a number");
        } else if (!same_kind && operand.type.is_integer() != other.type.is_integer()) {
            record.note("write float(...) around the whole number, or int(...) around the other");
        } else if (!same_shape && !any_matrix) {
            unsigned narrow = width;
            for (const Typed& t : operands) {
                if (!t.type.is_scalar()) narrow = std::min(narrow, t.type.width());
            }
            record.note(fmt::format("write .{} on the wider one", swizzle_prefix(narrow)));
        }
        return false;
    }
    return true;
}

}  // namespace patina::emit
