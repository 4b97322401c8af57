// Declarations of variables, and assignments to them or to parts of them.
#include <algorithm>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/emit/constant_value.h"
#include "compiler/emit/conversion.h"
#include "compiler/emit/operations/operations.h"
#include "compiler/emit/statements/statements.h"
#include "compiler/emit/types.h"

namespace patina::emit {

using ir::Op;
using ir::Type;
using ir::Value;

namespace {

// Each name is searched among them, and each branch compares all of them.
constexpr std::size_t kMostVariables = 4096;

// HLSL: assigns to an element whose index is known only when the shader runs. Each element is the new value or stays.
[[gnu::noinline]] bool store_at(Emitter& emitter, const Expr& target, const Typed& object, Typed value, Scope& scope) {
    ir::Builder& b = *scope.builder;
    const Typed at = expression_as(emitter, *target.args[1], ir::kInt, scope, "the index");
    const bool is_indexable = object.type.kind == ir::Kind::Array || object.type.is_vector() || object.type.is_matrix();
    if (at.ok() && !is_indexable)
        emitter.diagnostics.report(Code::BadOperand, target.span, "[]", emitter.module.type_name(object.type));
    if (!at.ok() || !is_indexable) return false;
    const Type part = ir::part_type(emitter.module, object.type, 0);
    value = convert(emitter, value, part, scope, target.span, "the value");
    if (!value.ok()) return false;
    if (!part.is_numeric() || part.is_matrix()) {
        emitter.diagnostics.report(Code::NotConstant, target.args[1]->span, "the index of an assignment");
        return false;
    }
    const std::uint32_t count = ir::part_count(emitter.module, object.type);
    expect_growth(emitter, 3.0 * count, target.span, "an index that is not a constant writes to every element");
    std::vector<Value> parts;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Value is_here = b.emit(Op::Equal, ir::kBool, {at.value, b.constant(ir::kInt, {static_cast<double>(i)})});
        parts.push_back(b.emit(Op::Select, part, {is_here, value.value, b.extract(object.value, i)}));
    }
    return store(emitter, *target.args[0], {.value = b.construct(object.type, parts), .type = object.type}, scope);
}

}  // namespace

// The composites between the part and the variable are made anew.
bool store(Emitter& emitter, const Expr& target, Typed value, Scope& scope) {
    ir::Builder& b = *scope.builder;
    if (target.kind == Expr::Kind::Name) {
        for (auto local = scope.locals.rbegin(); local != scope.locals.rend(); ++local) {
            if (local->name != target.text) continue;
            if (local->is_const) break;
            if (!local->value.ok()) return false;
            value = convert(emitter, value, local->value.type, scope, target.span,
                            fmt::format("the value for '{}'", target.text));
            if (!value.ok()) return false;
            b.name(value.value, emitter.module.intern(target.text));
            local->value.value = value.value;
            local->constant.reset();
            return true;
        }
        const bool is_constant = std::any_of(scope.locals.begin(), scope.locals.end(),
                                             [&](const Local& local) { return local.name == target.text; }) ||
                                 scope.declarations->variable(target.text);
        if (is_constant) {
            emitter.diagnostics.report(Code::NotAssignable, target.span, fmt::format("'{}'", target.text))
                .note("it is a constant");
        } else {
            (void)expression(emitter, target, scope);  // reports that there is no such variable
        }
        return false;
    }
    if (target.kind != Expr::Kind::Member && target.kind != Expr::Kind::Index) {
        emitter.diagnostics.report(Code::NotAssignable, target.span, "a computed value");
        return false;
    }
    const Typed object = expression(emitter, *target.args[0], scope);
    if (!object.ok()) return false;
    const auto insert = [&](std::uint32_t part) {
        const Typed fitted =
            convert(emitter, value, ir::part_type(emitter.module, object.type, part), scope, target.span, "the value");
        if (!fitted.ok()) return false;
        if (object.type.kind == ir::Kind::Struct) b.name(fitted.value, emitter.module.intern(target.text));
        const Value whole = b.emit(Op::Insert, object.type, {object.value, fitted.value}, part);
        return store(emitter, *target.args[0], {.value = whole, .type = object.type}, scope);
    };
    if (target.kind == Expr::Kind::Index) {
        const std::optional<double> at = constant_value(emitter.known, *target.args[1], scope);
        if (!at && scope.hlsl) return store_at(emitter, target, object, value, scope);
        if (!at || *at < 0 || *at >= ir::part_count(emitter.module, object.type)) {
            emitter.diagnostics.report(Code::NotConstant, target.args[1]->span, "the index of an assignment");
            return false;
        }
        return insert(static_cast<std::uint32_t>(*at));
    }
    if (object.type.kind == ir::Kind::Struct) {
        const auto& members = emitter.module.structs[object.type.ref].members;
        const auto found =
            std::find_if(members.begin(), members.end(), [&](const ir::Member& m) { return m.name == target.text; });
        if (found != members.end()) return insert(static_cast<std::uint32_t>(found - members.begin()));
    }
    if (scope.hlsl && object.type.is_matrix()) {
        const std::vector<MatrixElement> elements = matrix_elements(target.text, object.type);
        const Type part_type =
            Type::vector(object.type.scalar, static_cast<unsigned>(std::max<std::size_t>(1, elements.size())));
        if (!elements.empty()) value = convert(emitter, value, part_type, scope, target.span, "the value");
        if (!value.ok()) return false;
        Value whole = object.value;
        for (std::uint32_t i = 0; i < elements.size(); ++i) {
            const Value part = elements.size() == 1 ? value.value : b.extract(value.value, i);
            const Type row_type = ir::part_type(emitter.module, object.type, 0);
            const Value row =
                b.emit(Op::Insert, row_type, {b.extract(whole, elements[i].row), part}, elements[i].column);
            whole = b.emit(Op::Insert, object.type, {whole, row}, elements[i].row);
        }
        if (!elements.empty()) return store(emitter, *target.args[0], {.value = whole, .type = object.type}, scope);
    }
    if (object.type.is_vector()) {
        const std::string_view letters = target.text;
        std::vector<std::uint32_t> parts;
        for (char letter : letters) {
            std::size_t at = std::string_view("xyzw").find(letter);
            if (at == std::string_view::npos) at = std::string_view("rgba").find(letter);
            if (at >= object.type.width()) break;
            if (std::find(parts.begin(), parts.end(), at) != parts.end()) break;
            parts.push_back(static_cast<std::uint32_t>(at));
        }
        if (parts.size() == letters.size()) {
            if (parts.size() == 1) return insert(parts[0]);
            const Type part_type = object.type.with_width(static_cast<unsigned>(parts.size()));
            value = convert(emitter, value, part_type, scope, target.span, "the value");
            if (!value.ok()) return false;
            Value whole = object.value;
            for (std::uint32_t i = 0; i < parts.size(); ++i) {
                whole = b.emit(Op::Insert, object.type, {whole, b.extract(value.value, i)}, parts[i]);
            }
            return store(emitter, *target.args[0], {.value = whole, .type = object.type}, scope);
        }
    }
    emitter.diagnostics.report(Code::UnknownSwizzle, target.name_span, target.text,
                               emitter.module.type_name(object.type));
    return false;
}

void declare(Emitter& emitter, const Stmt& stmt, Scope& scope) {
    const Type wanted = type(emitter, stmt.type, scope);
    Local local{.name = stmt.name, .value = {}, .is_const = stmt.is_const, .constant = {}};
    // HLSL lets a block hide the variables around it.
    const auto first = scope.locals.begin() + static_cast<std::ptrdiff_t>(scope.hlsl ? scope.block : 0);
    const bool clash = std::any_of(first, scope.locals.end(), [&](const Local& l) { return l.name == stmt.name; });
    if (clash) emitter.diagnostics.report(Code::Redefinition, stmt.name_span, stmt.name);
    if (scope.locals.size() == kMostVariables)
        emitter.diagnostics.report(Code::TooMany, stmt.name_span, scope.locals.size() + 1, "variables of a function",
                                   kMostVariables);
    if (scope.locals.size() >= kMostVariables) return;
    if (!wanted.is_error()) {
        if (!stmt.value) {
            local.value = {.value = scope.builder->zero(wanted), .type = wanted};
        } else {
            local.value = array_or_value(emitter, *stmt.value, wanted, scope, fmt::format("'{}'", stmt.name));
            if (stmt.is_const || (scope.hlsl && wanted.is_scalar()))
                local.constant = constant_value(emitter.known, *stmt.value, scope);
            if (local.constant && wanted.is_integer()) local.constant = std::trunc(*local.constant);
            if (local.constant && wanted.is_bool()) local.constant = *local.constant != 0 ? 1 : 0;
        }
        if (local.value.ok() && stmt.value) {
            scope.builder->name(local.value.value, emitter.module.intern(stmt.name));
        }
    }
    scope.locals.push_back(std::move(local));
}

void assign(Emitter& emitter, const Stmt& stmt, Scope& scope) {
    Typed value;
    if (stmt.op == "=") {
        value = primary(emitter, expression(emitter, *stmt.value, scope), scope, stmt.value->span);
    } else {
        // a += b is a = a + b
        Expr sum{.kind = Expr::Kind::Binary,
                 .span = stmt.span,
                 .name_span = stmt.span,
                 .text = stmt.op.substr(0, stmt.op.size() - 1),
                 .args = {stmt.target, stmt.value}};
        value = binary(emitter, sum, scope);
    }
    if (value.ok()) store(emitter, *stmt.target, value, scope);
}

Typed assignment(Emitter& emitter, const Expr& expr, Scope& scope) {
    const bool is_later = expr.kind == Expr::Kind::AssignLater;
    const Typed before = is_later ? expression(emitter, *expr.args[0], scope) : Typed{};
    const Stmt stmt{.kind = Stmt::Kind::Assign,
                    .span = expr.span,
                    .name_span = expr.name_span,
                    .op = expr.text,
                    .target = expr.args[0],
                    .value = expr.args[1]};
    const std::size_t errors = emitter.diagnostics.error_count();
    assign(emitter, stmt, scope);
    if (emitter.diagnostics.error_count() != errors) return {};
    return is_later ? before : expression(emitter, *expr.args[0], scope);
}

}  // namespace patina::emit
