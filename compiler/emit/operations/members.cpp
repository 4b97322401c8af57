// What a dot or a bracket selects: outputs, members of structs, member functions, swizzles, elements.
#include <algorithm>
#include <array>

#include "compiler/base/text.h"
#include "compiler/emit/constant_value.h"
#include "compiler/emit/conversion.h"
#include "compiler/emit/functions.h"
#include "compiler/emit/operations/operations.h"

namespace patina::emit {

using ir::Op;
using ir::Type;
using ir::Value;

namespace {

Typed swizzle(Typed object, std::string_view letters, Scope& scope) {
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

}  // namespace

std::vector<MatrixElement> matrix_elements(std::string_view word, Type matrix) {
    std::vector<MatrixElement> made;
    const bool from_zero = word.starts_with("_m");
    while (word.starts_with("_")) {
        word.remove_prefix(from_zero && word.starts_with("_m") ? 2 : 1);
        if (word.size() < 2) return {};
        const int first = from_zero ? '0' : '1', row = word[0] - first, column = word[1] - first;
        if (row < 0 || row >= matrix.rows || column < 0 || column >= matrix.cols) return {};
        made.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column)});
        word.remove_prefix(2);
    }
    return word.empty() && made.size() <= 4 ? made : std::vector<MatrixElement>();
}

Typed primary(Emitter& emitter, Typed value, Scope& scope, Span span) {
    if (!value.outputs || !value.ok()) return value;
    if (!value.outputs->has_primary) {
        std::vector<std::string_view> names(value.outputs->names.begin(), value.outputs->names.end());
        emitter.diagnostics.report(Code::AmbiguousOutput, span)
            .note(fmt::format("its outputs are {}", enumerate(names)));
        return {};
    }
    const Value part = scope.builder->extract(value.value, 0);
    return at_border({.value = part, .type = scope.builder->type(part)}, scope);
}

Typed member(Emitter& emitter, Typed object, std::string_view name, Span span, Scope& scope) {
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
            emitter.diagnostics.report(Code::UnknownPort, span, "this node", "output", name)
                .note(Diagnostics::suggestion(name, known));
            return {};
        }
        object = primary(emitter, object, scope, span);
    } else if (name == "out" && !(object.type.kind == ir::Kind::Struct)) {
        return object;
    }
    if (object.type.kind == ir::Kind::Struct) {
        const ir::Struct& structure = emitter.module.structs[object.type.ref];
        for (std::uint32_t i = 0; i < structure.members.size(); ++i) {
            if (structure.members[i].name != name) continue;
            const Value part = scope.builder->extract(object.value, i);
            return {.value = part, .type = structure.members[i].type};
        }
        const FunctionDecl* function = scope.declarations->function(name);
        if (function && function->marks.is_member && !function->params.empty() &&
            function->params[0].type.name == structure.name) {
            const Declarations& home = scope.declarations->home_of(name);
            const Argument self{.value = object, .constant = {}};
            const Instance& instance = instantiate(emitter, *function, home, std::span(&self, 1), 0, false, span);
            if (instance.result.is_error()) return {};
            const Value value = scope.builder->call(instance.id, std::array{object.value});
            scope.builder->name(value, emitter.module.intern(name));
            return {.value = value, .type = instance.result};
        }
        std::vector<std::string_view> known;
        for (const ir::Member& m : structure.members) known.push_back(m.name);
        emitter.diagnostics.report(Code::UnknownSwizzle, span, name, structure.name)
            .note(Diagnostics::suggestion(name, known));
        return {};
    }
    if (scope.hlsl && object.type.is_matrix()) {
        const std::vector<MatrixElement> elements = matrix_elements(name, object.type);
        std::vector<Value> parts;
        for (const MatrixElement& each : elements)
            parts.push_back(scope.builder->extract(scope.builder->extract(object.value, each.row), each.column));
        const Type type = Type::vector(object.type.scalar, static_cast<unsigned>(parts.size()));
        if (parts.size() == 1) return {.value = parts[0], .type = type};
        if (!parts.empty()) return {.value = scope.builder->construct(type, parts), .type = type};
    }
    Typed part = swizzle(object, name, scope);
    if (!part.ok()) {
        DiagnosticRecord& record =
            emitter.diagnostics.report(Code::UnknownSwizzle, span, name, emitter.module.type_name(object.type));
        if (object.type.is_scalar()) record.note("a scalar has no members");
        if (object.type.is_vector()) {
            record.note(fmt::format("its members are {} and {}", swizzle_prefix(object.type.width()),
                                    std::string_view("rgba").substr(0, object.type.width())));
        }
    }
    return part;
}

Typed element(Emitter& emitter, const Expr& expr, Scope& scope) {
    const Typed object = primary(emitter, expression(emitter, *expr.args[0], scope), scope, expr.args[0]->span);
    Typed at = primary(emitter, expression(emitter, *expr.args[1], scope), scope, expr.args[1]->span);
    if (!object.ok() || !at.ok()) return {};
    if (scope.hlsl && at.type.is_scalar() && !at.type.is_integer()) at = hlsl_cast(at, ir::kInt, scope);
    if (!at.type.is_scalar() || !at.type.is_integer()) {
        emitter.diagnostics.report(Code::TypeMismatch, expr.args[1]->span, "the index",
                                   emitter.module.type_name(at.type), "int");
        return {};
    }
    const bool indexable = object.type.kind == ir::Kind::Array || object.type.is_vector() || object.type.is_matrix();
    if (!indexable) {
        emitter.diagnostics.report(Code::BadOperand, expr.span, "[]", emitter.module.type_name(object.type));
        return {};
    }
    const std::uint32_t count = ir::part_count(emitter.module, object.type);
    const Type part = ir::part_type(emitter.module, object.type, 0);
    if (const std::optional<double> constant = constant_value(emitter.known, *expr.args[1], scope)) {
        if (*constant < 0 || *constant >= count) {
            emitter.diagnostics.report(Code::OutOfRange, expr.args[1]->span, shortest(*constant), 0, count - 1,
                                       "index");
            return {};
        }
        return {.value = scope.builder->extract(object.value, static_cast<std::uint32_t>(*constant)), .type = part};
    }
    return {.value = scope.builder->emit(Op::Index, part, {object.value, at.value}), .type = part};
}

}  // namespace patina::emit
