// expression() hands each kind of expression to the function that emits it. Literals and names are emitted here.
#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/emit/calls.h"
#include "compiler/emit/constant_value.h"
#include "compiler/emit/conversion.h"
#include "compiler/emit/operations/operations.h"
#include "compiler/emit/operations/textures.h"
#include "compiler/emit/statements/statements.h"
#include "compiler/nodelang/other_names.h"

namespace patina::emit {

using ir::Op;
using ir::Scalar;
using ir::Type;
using ir::Value;

namespace {

Typed number_literal(Emitter& emitter, const Expr& expr, Scope& scope) {
    const std::array<Type, 4> types = {ir::kInt, ir::kUint, scope.half ? ir::kHalf : ir::kFloat, ir::kHalf};
    const Type type = types[static_cast<std::size_t>(expr.number_kind)];
    const bool literal = expr.number_kind == NumberKind::Int || expr.number_kind == NumberKind::Float;
    constexpr double kFloatLimit = 3.4028235677973366e38;  // from here on infinite
    const double limit = type.scalar == Scalar::Int    ? 2147483648.0
                         : type.scalar == Scalar::Uint ? 4294967296.0
                         : type.scalar == Scalar::Half ? kHalfLimit
                                                       : kFloatLimit;
    if (!std::isfinite(expr.number) || std::abs(expr.number) >= limit) {
        // A whole number beyond the range of int is a float literal.
        if (type == ir::kInt && std::abs(expr.number) < kFloatLimit) {
            return {.value = scope.builder->constant(ir::kFloat, {expr.number}), .type = ir::kFloat, .literal = true};
        }
        emitter.diagnostics.report(
            Code::BadNumber, expr.span, shortest(expr.number),
            (type.scalar == Scalar::Half ? "16-bit " : "32-bit ") + emitter.module.type_name(type));
        return {};
    }
    return {.value = scope.builder->constant(type, {expr.number}), .type = type, .literal = literal};
}

// A JSON array or a colour is a vector of two to four floats. (The {...} of an array is read in declare().)
Typed vector_of_list(Emitter& emitter, const Expr& expr, Scope& scope);

// A JSON array of rows is a matrix.
Typed matrix_of_list(Emitter& emitter, const Expr& expr, Scope& scope) {
    const auto size = static_cast<unsigned>(expr.args.size());
    std::vector<Value> rows;
    for (const Expr* row : expr.args) {
        const Typed value = vector_of_list(emitter, *row, scope);
        if (!value.ok()) return {};
        rows.push_back(value.value);
    }
    const Type type = Type::matrix(Scalar::Float, size, size);
    return {.value = scope.builder->construct(type, rows), .type = type};
}

Typed vector_of_list(Emitter& emitter, const Expr& expr, Scope& scope) {
    if (!expr.args.empty() && expr.args[0]->kind == Expr::Kind::List) return matrix_of_list(emitter, expr, scope);
    std::vector<double> components;
    bool good = expr.args.size() >= 2 && expr.args.size() <= 4;
    for (const Expr* element : expr.args) {
        const std::optional<double> value = constant_value(emitter.known, *element, scope);
        if (!value) {
            emitter.diagnostics.report(Code::NotConstant, element->span, "an element of a list");
            return {};
        }
        if (!(std::abs(*value) < 3.4028235677973366e38)) {
            emitter.diagnostics.report(Code::BadNumber, element->span, shortest(*value), "32-bit float");
            return {};
        }
        components.push_back(*value);
    }
    if (!good) {
        emitter.diagnostics.report(Code::TypeMismatch, expr.span, fmt::format("a list of {}", expr.args.size()),
                                   "not a vector", "a list of two to four numbers");
        return {};
    }
    const Type type = Type::vector(Scalar::Float, static_cast<unsigned>(components.size()));
    return {.value = scope.builder->constant(type, components), .type = type};
}

// A struct of the library, of the values of its members.
Typed object_value(Emitter& emitter, const Expr& expr, Scope& scope) {
    const Type wanted = type(emitter, {.name = expr.text, .span = expr.span}, scope);
    if (wanted.is_error()) return {};
    std::vector<Value> members;
    for (std::uint32_t i = 0; i < expr.args.size(); ++i) {
        const Type member = ir::part_type(emitter.module, wanted, i);
        const Typed value = array_or_value(emitter, *expr.args[i], member, scope, "a member");
        if (!value.ok()) return {};
        members.push_back(value.value);
    }
    return {.value = scope.builder->construct(wanted, members), .type = wanted};
}

Typed file_constant(Emitter& emitter, const VariableDecl& variable, Scope& scope) {
    Scope file{
        .builder = scope.builder, .declarations = scope.declarations, .half = scope.half, .hlsl = variable.is_hlsl};
    if (!variable.value) return {};
    return array_or_value(emitter, *variable.value, type(emitter, variable.type, file), file,
                          fmt::format("'{}'", variable.name));
}

Typed named_value(Emitter& emitter, const Expr& expr, Scope& scope) {
    for (auto local = scope.locals.rbegin(); local != scope.locals.rend(); ++local) {
        if (local->name == expr.text) return local->value;
    }
    const VariableDecl* variable = scope.declarations->variable(expr.text);
    if (variable && !(scope.environment && scope.environment->hides(expr.text))) {
        if (variable->is_const) return file_constant(emitter, *variable, scope);
        const StaticValue known = static_value(emitter.known, *variable, scope.builder);
        if (known.constant) return {.value = scope.builder->constant(ir::kBool, {*known.constant}), .type = ir::kBool};
        if (known.emitted) return {.value = known.emitted, .type = ir::kBool};
        if (emitter.known.externs.contains(variable) && !scope.environment)
            return extern_value(emitter, *variable, scope);
    }
    if (scope.environment) return scope.environment->name(expr, scope);
    std::vector<std::string_view> known;
    for (const Local& local : scope.locals) known.push_back(local.name);
    const std::string advice = nodelang::word_advice(expr.text);
    DiagnosticRecord& record = emitter.diagnostics.report(Code::UnknownName, expr.span, "variable", expr.text);
    record.note(advice.empty() ? Diagnostics::suggestion(expr.text, known) : advice);
    if (advice.find("'@") != std::string::npos)
        record.note("a function reads a semantic as the default of a parameter, without the @");
    return {};
}

}  // namespace

Typed array_or_value(Emitter& emitter, const Expr& expr, Type wanted, Scope& scope, std::string_view what) {
    if (scope.hlsl && expr.kind == Expr::Kind::List && wanted.is_numeric())
        return constructor(emitter, wanted, expr, scope);
    if (scope.hlsl && expr.kind == Expr::Kind::List && wanted.kind == ir::Kind::Struct) {
        std::vector<Value> members;
        for (std::uint32_t i = 0; i < expr.args.size() && i < ir::part_count(emitter.module, wanted); ++i)
            members.push_back(
                array_or_value(emitter, *expr.args[i], ir::part_type(emitter.module, wanted, i), scope, "a member")
                    .value);
        if (members.size() != ir::part_count(emitter.module, wanted) || members.size() != expr.args.size()) {
            emitter.diagnostics.report(Code::TypeMismatch, expr.span, what,
                                       fmt::format("a list of {}", expr.args.size()),
                                       fmt::format("a list of {}", ir::part_count(emitter.module, wanted)));
            return {};
        }
        if (std::any_of(members.begin(), members.end(), [](Value member) { return !member; })) return {};
        return {.value = scope.builder->construct(wanted, members), .type = wanted};
    }
    if (wanted.kind != ir::Kind::Array || expr.kind != Expr::Kind::List)
        return view_as(emitter, expr, wanted, scope, what);
    const ir::Array array = emitter.module.arrays[wanted.ref];
    if (expr.args.size() != array.count) {
        emitter.diagnostics.report(Code::TypeMismatch, expr.span, what, fmt::format("a list of {}", expr.args.size()),
                                   fmt::format("a list of {}", array.count));
        return {};
    }
    std::vector<Value> elements;
    for (const Expr* element : expr.args) {
        const Typed value = expression_as(emitter, *element, array.element, scope, "an element");
        if (value.ok()) elements.push_back(value.value);
    }
    if (elements.size() != array.count) return {};
    return {.value = scope.builder->construct(wanted, elements), .type = wanted};
}

Typed extern_value(Emitter& emitter, const VariableDecl& variable, Scope& scope) {
    const std::optional<ir::GlobalId> global = find_extern(emitter.known, variable);
    if (!global) return {};
    const auto read = [&](std::uint32_t index) {
        return scope.builder->emit(Op::Global, emitter.module.globals[index].type, {}, index);
    };
    const Type type = emitter.module.globals[global->index].type;
    const Value value = read(global->index);
    if (!type.is_opaque()) return {.value = value, .type = type};
    const Value sampler = read(global->index + 1);  // declared with its texture
    return make_texture(emitter, {.texture = value, .sampler = sampler}, scope);
}

void check_growth(Emitter& emitter, Span where) {
    Cancellation::step(kMadePerCheck);
    const Growth& growth = *emitter.growth;
    if (growth.made <= growth.most) return;
    emitter.diagnostics.report(Code::OverBudget, where, "instructions", growth.made, growth.most);
    throw Stopped{.is_reported = true};
}

void expect_growth(Emitter& emitter, double more, Span where, std::string_view advice) {
    const Growth* const growth = emitter.growth;
    if (!growth || static_cast<double>(growth->made) + more <= static_cast<double>(growth->most)) return;
    emitter.diagnostics
        .report(Code::OverBudget, where, "instructions",
                fmt::format("{:.0f}", static_cast<double>(growth->made) + more), growth->most)
        .note(std::string(advice));
    throw Stopped{.is_reported = true};
}

Typed expression(Emitter& emitter, const Expr& expr, Scope& scope) {
    grow(emitter, expr.span);
    switch (expr.kind) {
        case Expr::Kind::Number: return number_literal(emitter, expr, scope);
        case Expr::Kind::Bool: {
            return {.value = scope.builder->constant(ir::kBool, {expr.number}), .type = ir::kBool};
        }
        case Expr::Kind::List:
        case Expr::Kind::Color: return vector_of_list(emitter, expr, scope);
        case Expr::Kind::Name: return at_border(named_value(emitter, expr, scope), scope);
        case Expr::Kind::Property:
            if (scope.environment) return at_border(scope.environment->property(expr, scope), scope);
            emitter.diagnostics.report(Code::UnknownName, expr.span, "name", expr.text);
            return {};
        case Expr::Kind::Semantic:
            if (scope.environment) return at_border(scope.environment->semantic(expr.text, expr.span, scope), scope);
            emitter.diagnostics.report(Code::UnknownName, expr.span, "name", expr.text);
            return {};
        case Expr::Kind::Member:
            return at_border(
                member(emitter, expression(emitter, *expr.args[0], scope), expr.text, expr.name_span, scope), scope);
        case Expr::Kind::Index: return element(emitter, expr, scope);
        case Expr::Kind::Call: return call_expression(emitter, expr, scope);
        case Expr::Kind::Method: return method(emitter, expr, scope);
        case Expr::Kind::Unary: return unary(emitter, expr, scope);
        case Expr::Kind::Binary: return binary(emitter, expr, scope);
        case Expr::Kind::Ternary: return ternary(emitter, expr, scope);
        case Expr::Kind::File:
            if (scope.environment) return scope.environment->file(expr, scope);
            emitter.diagnostics.report(Code::UnknownName, expr.span, "file", expr.text);
            return {};
        case Expr::Kind::Object: return object_value(emitter, expr, scope);
        case Expr::Kind::Assign:
        case Expr::Kind::AssignLater: return assignment(emitter, expr, scope);
        case Expr::Kind::Sequence: {
            expression(emitter, *expr.args[0], scope);
            return expression(emitter, *expr.args[1], scope);
        }
    }
    return {};
}

}  // namespace patina::emit
