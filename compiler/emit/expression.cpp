// Expressions other than calls and operators: literals, names, members, conversions, and what is known beforehand.
#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/emit/emit.h"

namespace patina::nodelang {

using ir::Op;
using ir::Scalar;
using ir::Type;
using ir::Value;

Typed Emitter::expression(const Expr& expr, Scope& scope) {
    switch (expr.kind) {
        case Expr::Kind::Number: return number(expr, scope);
        case Expr::Kind::Bool: {
            return {.value = scope.builder->constant(ir::kBool, {expr.number}), .type = ir::kBool};
        }
        case Expr::Kind::List:
        case Expr::Kind::Color: return list(expr, scope);
        case Expr::Kind::Name: return at_border(name(expr, scope), scope);
        case Expr::Kind::Property:
            if (scope.environment) return at_border(scope.environment->property(expr, scope), scope);
            diagnostics_.report(Code::UnknownName, expr.span, "name", expr.text);
            return {};
        case Expr::Kind::Semantic:
            if (scope.environment) return at_border(scope.environment->semantic(expr.text, expr.span, scope), scope);
            diagnostics_.report(Code::UnknownName, expr.span, "name", expr.text);
            return {};
        case Expr::Kind::Member:
            return at_border(member(expression(*expr.args[0], scope), expr.text, expr.name_span, scope), scope);
        case Expr::Kind::Index: return index(expr, scope);
        case Expr::Kind::Call: return call_expression(expr, scope);
        case Expr::Kind::Method: return method(expr, scope);
        case Expr::Kind::Unary: return unary(expr, scope);
        case Expr::Kind::Binary: return binary(expr, scope);
        case Expr::Kind::Ternary: return ternary(expr, scope);
        case Expr::Kind::File:
            if (scope.environment) return scope.environment->file(expr, scope);
            diagnostics_.report(Code::UnknownName, expr.span, "file", expr.text);
            return {};
    }
    return {};
}

Typed Emitter::number(const Expr& expr, Scope& scope) {
    const std::array<Type, 4> types = {ir::kInt, ir::kUint, scope.half ? ir::kHalf : ir::kFloat, ir::kHalf};
    const Type type = types[static_cast<std::size_t>(expr.number_kind)];
    const bool literal = expr.number_kind == NumberKind::Int || expr.number_kind == NumberKind::Float;
    constexpr double kFloatLimit = 3.4028235677973366e38;  // from here on infinite
    const double limit = type.scalar == Scalar::Int    ? 2147483648.0
                         : type.scalar == Scalar::Uint ? 4294967296.0
                         : type.scalar == Scalar::Half ? kHalfLimit
                                                       : kFloatLimit;
    if (!std::isfinite(expr.number) || std::abs(expr.number) >= limit) {
        // A whole number beyond int's range still makes a good float literal.
        if (type == ir::kInt && std::abs(expr.number) < kFloatLimit) {
            return {.value = scope.builder->constant(ir::kFloat, {expr.number}), .type = ir::kFloat, .literal = true};
        }
        diagnostics_.report(Code::BadNumber, expr.span, shortest(expr.number),
                            (type.scalar == Scalar::Half ? "16-bit " : "32-bit ") + module_.type_name(type));
        return {};
    }
    return {.value = scope.builder->constant(type, {expr.number}), .type = type, .literal = literal};
}

// A JSON array or colour: a vector of two to four floats. ({...} for arrays is read where the array is declared.)
Typed Emitter::list(const Expr& expr, Scope& scope) {
    std::vector<double> components;
    bool good = expr.args.size() >= 2 && expr.args.size() <= 4;
    for (const Expr* element : expr.args) {
        const std::optional<double> value = constant_value(*element, scope);
        if (!value) {
            diagnostics_.report(Code::NotConstant, element->span, "an element of a list");
            return {};
        }
        if (!(std::abs(*value) < 3.4028235677973366e38)) {
            diagnostics_.report(Code::BadNumber, element->span, shortest(*value), "32-bit float");
            return {};
        }
        components.push_back(*value);
    }
    if (!good) {
        diagnostics_.report(Code::TypeMismatch, expr.span, fmt::format("a list of {}", expr.args.size()), "no vector",
                            "a list of two to four numbers");
        return {};
    }
    const Type type = Type::vector(Scalar::Float, static_cast<unsigned>(components.size()));
    return {.value = scope.builder->constant(type, components), .type = type};
}

Typed Emitter::name(const Expr& expr, Scope& scope) {
    for (auto local = scope.locals.rbegin(); local != scope.locals.rend(); ++local) {
        if (local->name == expr.text) return local->value;
    }
    const VariableDecl* variable = scope.declarations->variable(expr.text);
    if (variable && !(scope.environment && scope.environment->hides(expr.text))) {
        if (variable->is_const) return file_constant(*variable, scope);
        if (const std::optional<double> known = static_value(variable))
            return {.value = scope.builder->constant(ir::kBool, {*known}), .type = ir::kBool};
        if (externs_.contains(variable) && !scope.environment) return extern_value(*variable, scope);
    }
    if (scope.environment) return scope.environment->name(expr, scope);
    std::vector<std::string_view> known;
    for (const Local& local : scope.locals) known.push_back(local.name);
    diagnostics_.report(Code::UnknownName, expr.span, "variable", expr.text)
        .note(Diagnostics::suggestion(expr.text, known));
    return {};
}

std::optional<double> Emitter::static_value(const VariableDecl* variable) const {
    if (const auto known = statics_.find(variable); known != statics_.end()) return known->second;
    return static_maker_ ? static_maker_(*variable) : std::nullopt;
}

Typed Emitter::extern_value(const VariableDecl& variable, Scope& scope) {
    const auto global = externs_.find(&variable);
    if (global == externs_.end()) return {};
    const auto read = [&](std::uint32_t index) {
        return scope.builder->emit(Op::Global, module_.globals[index].type, {}, index);
    };
    const Type type = module_.globals[global->second.index].type;
    const Value value = read(global->second.index);
    if (!type.is_opaque()) return {.value = value, .type = type};
    const Value sampler = read(global->second.index + 1);  // declared with its texture
    if (type.kind == ir::Kind::TextureCube) return make_cube(value, sampler, scope);
    const Value untiled = scope.builder->constant(ir::kFloat4, {1, 1, 0, 0});
    return make_texture(value, sampler, texel_size(value, scope), untiled, scope);
}

Typed Emitter::file_constant(const VariableDecl& variable, Scope& scope) {
    Scope file{.builder = scope.builder, .declarations = scope.declarations, .half = scope.half};
    if (!variable.value) return {};
    return expression_as(*variable.value, type(variable.type, file), file, fmt::format("'{}'", variable.name));
}

// What a graph's expression reads has the precision of the node that reads it, whoever made it.
Typed Emitter::at_border(Typed value, const Scope& scope) {
    if (!scope.environment || !value.ok() || value.outputs || value.literal || !value.type.is_numeric()) return value;
    const Scalar wanted = scope.half ? Scalar::Half : Scalar::Float;
    if (value.type.scalar == wanted || !joins(value.type.scalar, wanted)) return value;
    return {.value = scope.builder->convert(value.value, wanted), .type = value.type.with_scalar(wanted)};
}

// --- members

Typed Emitter::primary(Typed value, Scope& scope, Span span) {
    if (!value.outputs || !value.ok()) return value;
    if (!value.outputs->has_primary) {
        std::vector<std::string_view> names(value.outputs->names.begin(), value.outputs->names.end());
        diagnostics_.report(Code::AmbiguousOutput, span).note(fmt::format("its outputs are {}", enumerate(names)));
        return {};
    }
    const Value part = scope.builder->extract(value.value, 0);
    return at_border({.value = part, .type = scope.builder->type(part)}, scope);
}

Typed Emitter::member(Typed object, std::string_view name, Span span, Scope& scope) {
    if (!object.ok()) return {};
    if (object.outputs) {
        const auto& names = object.outputs->names;
        const auto found = std::find(names.begin(), names.end(), name);
        if (found != names.end()) {
            const Value part = scope.builder->extract(object.value, static_cast<std::uint32_t>(found - names.begin()));
            return {.value = part, .type = scope.builder->type(part)};
        }
        if (!object.outputs->has_primary) {
            std::vector<std::string_view> known(names.begin(), names.end());
            diagnostics_.report(Code::UnknownPort, span, "this node", "output", name)
                .note(Diagnostics::suggestion(name, known));
            return {};
        }
        object = primary(object, scope, span);
    } else if (name == "out" && !(object.type.kind == ir::Kind::Struct)) {
        return object;
    }
    if (object.type.kind == ir::Kind::Struct) {
        const ir::Struct& structure = module_.structs[object.type.ref];
        for (std::uint32_t i = 0; i < structure.members.size(); ++i) {
            if (structure.members[i].name != name) continue;
            const Value part = scope.builder->extract(object.value, i);
            return {.value = part, .type = structure.members[i].type};
        }
        const FunctionDecl* function = scope.declarations->function(name);
        if (function && function->attribute("member") && !function->params.empty() &&
            function->params[0].type.name == structure.name) {
            const Declarations& home = scope.declarations->home_of(name);
            const Argument self{.value = object, .constant = {}};
            const Instance& instance = instantiate(*function, home, std::span(&self, 1), 0, false, span);
            if (instance.result.is_error()) return {};
            const Value value = scope.builder->call(instance.id, std::array{object.value});
            scope.builder->name(value, module_.intern(name));
            return {.value = value, .type = instance.result};
        }
        std::vector<std::string_view> known;
        for (const ir::Member& m : structure.members) known.push_back(m.name);
        diagnostics_.report(Code::UnknownSwizzle, span, name, structure.name)
            .note(Diagnostics::suggestion(name, known));
        return {};
    }
    Typed part = swizzle(object, name, scope);
    if (!part.ok()) {
        DiagnosticRecord& record =
            diagnostics_.report(Code::UnknownSwizzle, span, name, module_.type_name(object.type));
        if (object.type.is_scalar()) record.note("a scalar has no members");
        if (object.type.is_vector()) {
            record.note(fmt::format("its members are {} and {}", swizzle_prefix(object.type.width()),
                                    std::string_view("rgba").substr(0, object.type.width())));
        }
    }
    return part;
}

Typed Emitter::swizzle(Typed object, std::string_view letters, Scope& scope) {
    if (!(object.type.is_vector() || object.type.is_scalar()) || letters.empty() || letters.size() > 4) return {};
    std::array<unsigned, 4> components{};
    for (const std::string_view set : {std::string_view("xyzw"), std::string_view("rgba")}) {
        bool good = true;
        for (std::size_t i = 0; good && i < letters.size(); ++i) {
            const std::size_t at = set.find(letters[i]);
            good = at < object.type.width();
            if (good) components[i] = static_cast<unsigned>(at);
        }
        if (!good) continue;
        if (object.type.is_scalar()) {
            if (letters.size() == 1) return object;
            return {.value = scope.builder->splat(object.value, static_cast<unsigned>(letters.size())),
                    .type = object.type.with_width(static_cast<unsigned>(letters.size()))};
        }
        const Value value = letters.size() == 1
                                ? scope.builder->extract(object.value, components[0])
                                : scope.builder->swizzle(object.value, std::span(components.data(), letters.size()));
        return {.value = value, .type = object.type.with_width(static_cast<unsigned>(letters.size()))};
    }
    return {};
}

Typed Emitter::index(const Expr& expr, Scope& scope) {
    const Typed object = primary(expression(*expr.args[0], scope), scope, expr.args[0]->span);
    Typed at = primary(expression(*expr.args[1], scope), scope, expr.args[1]->span);
    if (!object.ok() || !at.ok()) return {};
    if (!at.type.is_scalar() || !at.type.is_integer()) {
        diagnostics_.report(Code::TypeMismatch, expr.args[1]->span, "the index", module_.type_name(at.type), "int");
        return {};
    }
    const bool indexable = object.type.kind == ir::Kind::Array || object.type.is_vector() || object.type.is_matrix();
    if (!indexable) {
        diagnostics_.report(Code::BadOperand, expr.span, "[]", module_.type_name(object.type));
        return {};
    }
    const std::uint32_t count = ir::part_count(module_, object.type);
    const Type part = ir::part_type(module_, object.type, 0);
    if (const std::optional<double> constant = constant_value(*expr.args[1], scope)) {
        if (*constant < 0 || *constant >= count) {
            diagnostics_.report(Code::OutOfRange, expr.args[1]->span, shortest(*constant), 0, count - 1, "index");
            return {};
        }
        return {.value = scope.builder->extract(object.value, static_cast<std::uint32_t>(*constant)), .type = part};
    }
    return {.value = scope.builder->emit(Op::Index, part, {object.value, at.value}), .type = part};
}

// --- conversions

Typed Emitter::expression_as(const Expr& expr, Type wanted, Scope& scope, std::string_view what) {
    Typed value = primary(expression(expr, scope), scope, expr.span);
    // "#ff8800" where a float4 is wanted: a colour without alpha is opaque.
    if (expr.kind == Expr::Kind::Color && value.ok() && value.type.width() == 3 && wanted == ir::kFloat4) {
        const Value opaque = scope.builder->constant(ir::kFloat, {1});
        value = {.value = scope.builder->construct(ir::kFloat4, std::array{value.value, opaque}), .type = ir::kFloat4};
    }
    return convert(value, wanted, scope, expr.span, what);
}

Typed Emitter::convert(Typed value, Type wanted, Scope& scope, Span span, std::string_view what) {
    if (!value.ok() || wanted.is_error()) return {};
    if (value.type == wanted) return {.value = value.value, .type = wanted};
    ir::Builder& b = *scope.builder;
    if (value.literal && value.type.scalar == Scalar::Int && wanted.is_numeric() && !wanted.is_bool()) {
        value = literal_as(value, wanted.scalar, scope, span);
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
    DiagnosticRecord& record =
        diagnostics_.report(Code::TypeMismatch, span, what, module_.type_name(value.type), module_.type_name(wanted));
    if (plain && value.type.width() > wanted.width()) {
        record.note(fmt::format("take a part of it: .{}", swizzle_prefix(wanted.width())));
    } else if (plain && value.type.width() < wanted.width() && value.type.width() > 1) {
        record.note(fmt::format("fill it up: {}(..., 0)", module_.type_name(wanted)));
    } else if (plain && value.type.is_bool()) {
        record.note("write '... ? 1 : 0' to make a number of a bool");
    } else if (plain && wanted.is_bool()) {
        record.note("compare it: '... > 0.5'");
    } else if (plain) {
        record.note(fmt::format("convert it: {}(...)", module_.type_name(wanted)));
    }
    return {};
}

// --- what is known without running anything

std::optional<double> Emitter::constant_value(const Expr& expr, const Scope& scope) {
    const auto of = [&](std::size_t i) { return constant_value(*expr.args[i], scope); };
    switch (expr.kind) {
        case Expr::Kind::Number:
        case Expr::Kind::Bool: return expr.number;
        case Expr::Kind::Name: {
            for (auto local = scope.locals.rbegin(); local != scope.locals.rend(); ++local) {
                if (local->name == expr.text) return local->constant;
            }
            const VariableDecl* variable = scope.declarations->variable(expr.text);
            if (variable && variable->is_const && variable->value && !variable->type.array_size) {
                return constant_value(*variable->value, scope);
            }
            return variable ? static_value(variable) : std::nullopt;
        }
        case Expr::Kind::Unary: {
            const std::optional<double> a = of(0);
            if (!a) return {};
            if (expr.text == "-") return -*a;
            if (expr.text == "!") return *a == 0 ? 1 : 0;
            return expr.text == "+" ? a : std::nullopt;
        }
        case Expr::Kind::Ternary: {
            const std::optional<double> condition = of(0);
            if (!condition) return {};
            return of(*condition != 0 ? 1 : 2);
        }
        case Expr::Kind::Binary: {
            // An enumeration's value against a word: the word is looked up in that enumeration.
            if (expr.text == "==" || expr.text == "!=") {
                for (std::size_t side : {0u, 1u}) {
                    if (expr.args[side]->kind != Expr::Kind::Name) continue;
                    for (const Local& local : scope.locals) {
                        if (local.name != expr.args[side]->text || !local.value.enumerators || !local.constant)
                            continue;
                        const Expr& word = *expr.args[1 - side];
                        const auto& words = *local.value.enumerators;
                        const auto found = std::find(words.begin(), words.end(), word.text);
                        if (word.kind != Expr::Kind::Name || found == words.end()) continue;
                        const bool same = *local.constant == static_cast<double>(found - words.begin());
                        return same == (expr.text == "==") ? 1 : 0;
                    }
                }
            }
            const std::optional<double> a = of(0), b = of(1);
            // One side may decide alone.
            if (expr.text == "&&" && ((a && *a == 0) || (b && *b == 0))) return 0;
            if (expr.text == "||" && ((a && *a != 0) || (b && *b != 0))) return 1;
            if (!a || !b) return {};
            if (expr.text == "+") return *a + *b;
            if (expr.text == "-") return *a - *b;
            if (expr.text == "*") return *a * *b;
            if (expr.text == "/" && *b != 0) return *a / *b;
            if (expr.text == "<") return *a < *b;
            if (expr.text == "<=") return *a <= *b;
            if (expr.text == ">") return *a > *b;
            if (expr.text == ">=") return *a >= *b;
            if (expr.text == "==") return *a == *b;
            if (expr.text == "!=") return *a != *b;
            if (expr.text == "&&") return *a != 0 && *b != 0;
            if (expr.text == "||") return *a != 0 || *b != 0;
            return {};
        }
        case Expr::Kind::List:
        case Expr::Kind::Color:
        case Expr::Kind::Property:
        case Expr::Kind::Semantic:
        case Expr::Kind::Member:
        case Expr::Kind::Index:
        case Expr::Kind::Call:
        case Expr::Kind::Method:
        case Expr::Kind::File: return {};
    }
    return {};
}

}  // namespace patina::nodelang
