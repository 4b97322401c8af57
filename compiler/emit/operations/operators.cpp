// Operators: which operands each one takes, and the type of the result.
#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/emit/constant_value.h"
#include "compiler/emit/conversion.h"
#include "compiler/emit/operations/operations.h"

namespace patina::emit {

using ir::Op;
using ir::Scalar;
using ir::Type;

namespace {

struct BinaryOperator {
    std::string_view text;
    Op op;
    enum class On { Numbers, Ordered, Bools, Integers } on;
};
constexpr BinaryOperator kBinaryOperators[] = {
    {"+", Op::Add, BinaryOperator::On::Numbers},
    {"-", Op::Sub, BinaryOperator::On::Numbers},
    {"*", Op::Mul, BinaryOperator::On::Numbers},
    {"/", Op::Div, BinaryOperator::On::Numbers},
    {"%", Op::Mod, BinaryOperator::On::Numbers},
    {"<", Op::Less, BinaryOperator::On::Ordered},
    {"<=", Op::LessEqual, BinaryOperator::On::Ordered},
    {">", Op::Greater, BinaryOperator::On::Ordered},
    {">=", Op::GreaterEqual, BinaryOperator::On::Ordered},
    {"==", Op::Equal, BinaryOperator::On::Ordered},
    {"!=", Op::NotEqual, BinaryOperator::On::Ordered},
    {"&&", Op::And, BinaryOperator::On::Bools},
    {"||", Op::Or, BinaryOperator::On::Bools},
    {"&", Op::BitAnd, BinaryOperator::On::Integers},
    {"|", Op::BitOr, BinaryOperator::On::Integers},
    {"^", Op::BitXor, BinaryOperator::On::Integers},
    {"<<", Op::ShiftLeft, BinaryOperator::On::Integers},
    {">>", Op::ShiftRight, BinaryOperator::On::Integers},
};

// One side of == if the other side is an enum: a name alone is one of the enum's values.
Typed enum_operand(Emitter& emitter, const Expr& expr, const std::vector<std::string_view>& enumerators, Scope& scope) {
    if (expr.kind == Expr::Kind::Name) {
        const auto found = std::find(enumerators.begin(), enumerators.end(), expr.text);
        if (found == enumerators.end()) {
            emitter.diagnostics.report(Code::UnknownEnumerator, expr.span, expr.text, "this enumeration")
                .note(Diagnostics::suggestion(expr.text, enumerators));
            return {};
        }
        return {.value = scope.builder->constant(ir::kInt, {static_cast<double>(found - enumerators.begin())}),
                .type = ir::kInt};
    }
    return primary(emitter, expression(emitter, expr, scope), scope, expr.span);
}

// What HLSL converts before the kinds of the two sides are made the same.
// These are not inlined: otherwise each level of an expression would have their variables on the stack.
[[gnu::noinline]] void hlsl_operands(std::string_view op, bool are_bools, std::array<Typed, 2>& sides, Scope& scope) {
    const bool divides = op == "/" || op == "%", both_whole = (sides[0].is_whole || sides[0].type.is_integer()) &&
                                                              (sides[1].is_whole || sides[1].type.is_integer());
    const bool both_bools = sides[0].type.is_bool() && sides[1].type.is_bool();
    const bool compares = op == "==" || op == "!=";
    for (Typed& side : sides) {
        if (!side.ok() || !side.type.is_numeric()) continue;
        const bool is_bool = side.type.is_bool();
        Scalar wanted = side.type.scalar;
        if (are_bools)
            wanted = Scalar::Bool;
        else if (is_bool && !(compares && both_bools))
            wanted = Scalar::Int;
        else if (divides && both_whole && side.is_whole)
            wanted = Scalar::Int;
        if (wanted != side.type.scalar) side = hlsl_cast(side, side.type.with_scalar(wanted), scope);
    }
    // The left operand of a shift keeps its kind.
    if ((op == "<<" || op == ">>") && sides[0].type.is_integer() && sides[1].type.is_integer())
        sides[1] = hlsl_cast(sides[1], sides[1].type.with_scalar(sides[0].type.scalar), scope);
}

bool compares_types(Op op) {
    return ir::info(op).rule == ir::TypeRule::Compare;
}

// Two matrices of one type, element by element.
[[gnu::noinline]] Typed by_rows(Op op, const std::array<Typed, 2>& sides, Scope& scope) {
    ir::Builder& b = *scope.builder;
    const Type type = sides[0].type, row = Type::vector(type.scalar, type.cols);
    std::vector<ir::Value> rows;
    for (unsigned i = 0; i < type.rows; ++i)
        rows.push_back(b.emit(op, row, {b.extract(sides[0].value, i), b.extract(sides[1].value, i)}));
    return {.value = b.construct(type, rows), .type = type};
}

}  // namespace

Typed unary(Emitter& emitter, const Expr& expr, Scope& scope) {
    Typed operand = primary(emitter, expression(emitter, *expr.args[0], scope), scope, expr.args[0]->span);
    if (!operand.ok() || expr.text == "+") return operand;
    if (scope.hlsl && operand.type.is_numeric() && operand.type.is_bool() != (expr.text == "!")) {
        const Typed made =
            hlsl_cast(operand, operand.type.with_scalar(expr.text == "!" ? Scalar::Bool : Scalar::Int), scope);
        if (made.ok()) operand = made;
    }
    const bool good = expr.text == "!"   ? operand.type.is_bool()
                      : expr.text == "~" ? operand.type.is_integer()
                                         : operand.type.is_numeric() && !operand.type.is_bool();
    if (!good) {
        emitter.diagnostics.report(Code::BadOperand, expr.name_span, expr.text, emitter.module.type_name(operand.type));
        return {};
    }
    if (operand.literal && expr.text == "-") {
        std::vector<double> negated(1, -scope.builder->constant_of(operand.value)[0]);
        return {.value = scope.builder->constant(operand.type, negated), .type = operand.type, .literal = true};
    }
    const Op op = expr.text == "!" ? Op::Not : expr.text == "~" ? Op::BitNot : Op::Neg;
    return {.value = scope.builder->emit(op, operand.type, {operand.value}), .type = operand.type};
}

Typed binary(Emitter& emitter, const Expr& expr, Scope& scope) {
    const auto row = std::find_if(std::begin(kBinaryOperators), std::end(kBinaryOperators),
                                  [&](const BinaryOperator& o) { return o.text == expr.text; });
    std::array<Typed, 2> sides;
    const bool equality = row->op == Op::Equal || row->op == Op::NotEqual;
    // The left side is emitted first, unless only the right one says which enumeration is meant.
    if (equality) {
        const auto is_enum_local = [&](const Expr& e) {
            return e.kind == Expr::Kind::Property ||
                   (e.kind == Expr::Kind::Name &&
                    std::any_of(scope.locals.begin(), scope.locals.end(),
                                [&](const Local& l) { return l.name == e.text && l.value.enumerators; }));
        };
        const std::size_t lead = !is_enum_local(*expr.args[0]) && is_enum_local(*expr.args[1]) ? 1 : 0;
        sides[lead] = primary(emitter, expression(emitter, *expr.args[lead], scope), scope, expr.args[lead]->span);
        const Expr& other = *expr.args[1 - lead];
        sides[1 - lead] = sides[lead].enumerators
                              ? enum_operand(emitter, other, *sides[lead].enumerators, scope)
                              : primary(emitter, expression(emitter, other, scope), scope, other.span);
        const auto *a = sides[0].enumerators, *b = sides[1].enumerators;
        if (a && b && *a != *b) {
            emitter.diagnostics.report(Code::TypeMismatch, expr.args[1]->span, "the right side",
                                       fmt::format("one of {}", enumerate(*b)),
                                       fmt::format("one of {}", enumerate(*a)));
            return {};
        }
    } else {
        for (std::size_t i : {0u, 1u}) {
            sides[i] = primary(emitter, expression(emitter, *expr.args[i], scope), scope, expr.args[i]->span);
        }
    }
    if (scope.hlsl) hlsl_operands(row->text, row->on == BinaryOperator::On::Bools, sides, scope);
    const bool literal = sides[0].literal && sides[1].literal;
    // Whole literals are divided as floats: 1 / 2 is 0.5, as an artist means it.
    if (literal && row->op == Op::Div && !scope.hlsl) {
        for (Typed& side : sides) {
            if (side.type.is_integer())
                side = literal_as(emitter, side, scope.half ? Scalar::Half : Scalar::Float, scope, expr.span);
        }
    }
    if (!unify(emitter, sides, scope, expr.name_span, expr.text)) return {};
    const Type type = sides[0].type;
    const bool good = row->on == BinaryOperator::On::Bools      ? type.is_bool()
                      : row->on == BinaryOperator::On::Integers ? type.is_integer()
                      : equality                                ? true
                                                                : !type.is_bool();
    if (scope.hlsl && good && type.is_matrix() && !compares_types(row->op)) return by_rows(row->op, sides, scope);
    if (!good || (type.is_matrix() && row->op != Op::Add && row->op != Op::Sub)) {
        DiagnosticRecord& record =
            emitter.diagnostics.report(Code::BadOperands, expr.name_span, expr.text, emitter.module.type_name(type),
                                       emitter.module.type_name(type));
        if (type.is_matrix()) record.note("matrices are multiplied by mul(a, b)");
        if (type.is_bool()) record.note("write 'condition ? 1 : 0' to convert a bool to a number");
        return {};
    }
    if (row->op == Op::Div && scope.builder->is_constant(sides[1].value, 0)) {
        emitter.diagnostics.report(Code::DivisionByZero, expr.args[1]->span);
    } else {
        warn_unless_finite(emitter, row->op, type, std::array{sides[0].value, sides[1].value}, scope, expr.span,
                           expr.text);
    }
    const bool compares = ir::info(row->op).rule == ir::TypeRule::Compare;
    // Arithmetic of literals is a literal, which takes the type of number that its context needs.
    if (literal && !compares) {
        if (const std::optional<double> known = constant_value(emitter.known, expr, scope)) {
            return {.value = scope.builder->constant(type, {*known}), .type = type, .literal = true};
        }
    }
    const Type result = compares ? Type::vector(Scalar::Bool, type.width()) : type;
    return {.value = scope.builder->emit(row->op, result, {sides[0].value, sides[1].value}), .type = result};
}

Typed ternary(Emitter& emitter, const Expr& expr, Scope& scope) {
    if (const std::optional<double> known = constant_value(emitter.known, *expr.args[0], scope); known && !scope.hlsl) {
        return expression(emitter, *expr.args[*known != 0 ? 1 : 2], scope);
    }
    Typed condition = primary(emitter, expression(emitter, *expr.args[0], scope), scope, expr.args[0]->span);
    std::array<Typed, 2> branches;
    for (std::size_t i : {0u, 1u}) {
        branches[i] = primary(emitter, expression(emitter, *expr.args[i + 1], scope), scope, expr.args[i + 1]->span);
    }
    if (!condition.ok()) return {};
    if (scope.hlsl && condition.type.is_numeric() && !condition.type.is_bool()) {
        const Typed made = hlsl_cast(condition, condition.type.with_scalar(Scalar::Bool), scope);
        if (made.ok()) condition = made;
    }
    if (branches[0].ok() && branches[0].type == branches[1].type && branches[0].type.kind == ir::Kind::Struct) {
        return {.value = scope.builder->emit(Op::Select, branches[0].type,
                                             {condition.value, branches[0].value, branches[1].value}),
                .type = branches[0].type};
    }
    if (!unify(emitter, branches, scope, expr.span, "?:")) return {};
    Type type = branches[0].type;
    if (scope.hlsl && condition.type.is_vector() && type.is_scalar()) {
        type = type.with_width(condition.type.width());
        for (Typed& branch : branches) branch = hlsl_cast(branch, type, scope);
    }
    if (!condition.type.is_bool() || (condition.type.is_vector() && condition.type.width() != type.width())) {
        emitter.diagnostics.report(Code::TypeMismatch, expr.args[0]->span, "the condition",
                                   emitter.module.type_name(condition.type), "bool");
        return {};
    }
    // Two whole literals have no context to adapt to. A choice between them is a float, as the author of a graph means
    // it.
    if (branches[0].literal && type.is_integer() && !scope.hlsl) {
        for (Typed& branch : branches)
            branch = literal_as(emitter, branch, scope.half ? Scalar::Half : Scalar::Float, scope, expr.span);
        type = branches[0].type;
    }
    return {.value = scope.builder->emit(Op::Select, type, {condition.value, branches[0].value, branches[1].value}),
            .type = type};
}

}  // namespace patina::emit
