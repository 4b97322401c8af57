#include "compiler/emit/arguments.h"

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/emit/constant_value.h"
#include "compiler/emit/operations/operations.h"
#include "compiler/emit/operations/textures.h"

namespace patina::emit {

using ir::Type;

namespace {

// In the default of a parameter, a name alone is a semantic.
class DefaultEnvironment : public Environment {
public:
    explicit DefaultEnvironment(Environment& outer) : outer_(outer) {}
    Typed name(const Expr& expr, Scope& scope) override { return outer_.semantic(expr.text, expr.span, scope); }
    Typed property(const Expr& expr, Scope& scope) override { return outer_.property(expr, scope); }
    Typed semantic(std::string_view name, Span span, Scope& scope) override {
        return outer_.semantic(name, span, scope);
    }
    Typed file(const Expr& expr, Scope& scope) override { return outer_.file(expr, scope); }
    void tell_reader(DiagnosticRecord& record) const override { outer_.tell_reader(record); }

private:
    Environment& outer_;
};

// A property is the value of a drop-down port: each value of the property must be one of the port's.
Argument choosing_argument(Emitter& emitter, const ParamDecl& param, const EnumDecl* enumeration, const Expr& expr,
                           Scope& scope) {
    const Typed value = expression(emitter, expr, scope);
    if (!value.ok()) return {};
    std::vector<double> choices = {0, 1};
    if (enumeration ? !value.enumerators : value.type != ir::kBool) {
        emitter.diagnostics.report(
            Code::TypeMismatch, expr.span, fmt::format("'{}'", expr.text), emitter.module.type_name(value.type),
            enumeration ? fmt::format("an enum of {}", enumerate(enumeration->values)) : "a bool");
        return {};
    }
    if (enumeration) {
        choices.clear();
        for (const std::string_view word : *value.enumerators) {
            const auto found = std::find(enumeration->values.begin(), enumeration->values.end(), word);
            if (found == enumeration->values.end()) {
                emitter.diagnostics.report(Code::UnknownEnumerator, expr.span, word, fmt::format("'{}'", param.name))
                    .note(Diagnostics::suggestion(word, enumeration->values))
                    .note(fmt::format("'{}' can have this value", expr.text));
                return {};
            }
            choices.push_back(static_cast<double>(found - enumeration->values.begin()));
        }
    }
    if (const std::span<const double> known = scope.builder->constant_of(value.value); !known.empty())
        return {.value = {}, .constant = choices[static_cast<std::size_t>(known[0])]};
    return {.value = value, .constant = choices[0], .choices = std::move(choices)};
}

}  // namespace

Argument const_argument(Emitter& emitter, const ParamDecl& param, const Declarations& home, const Expr& expr,
                        Scope& scope) {
    if (const EnumDecl* enumeration = home.enumeration(param.type.name)) {
        const auto found = std::find(enumeration->values.begin(), enumeration->values.end(), expr.text);
        if (expr.kind == Expr::Kind::Name && found != enumeration->values.end()) {
            return {.value = {}, .constant = static_cast<double>(found - enumeration->values.begin())};
        }
        // A const parameter of the calling function may be the argument.
        for (const Local& local : scope.locals) {
            if (expr.kind == Expr::Kind::Name && local.name == expr.text && local.constant) {
                return {.value = {}, .constant = local.constant};
            }
        }
        if (expr.kind == Expr::Kind::Name) {
            emitter.diagnostics.report(Code::UnknownEnumerator, expr.span, expr.text, fmt::format("'{}'", param.name))
                .note(Diagnostics::suggestion(expr.text, enumeration->values));
        } else if (expr.kind == Expr::Kind::Property) {
            return choosing_argument(emitter, param, enumeration, expr, scope);
        } else {
            emitter.diagnostics.report(Code::NotConstant, expr.span, fmt::format("'{}'", param.name))
                .note(fmt::format("write one of {}", enumerate(enumeration->values)));
        }
        return {};
    }
    const std::optional<double> value = constant_value(emitter.known, expr, scope);
    if (!value && expr.kind == Expr::Kind::Property && param.type.name == "bool")
        return choosing_argument(emitter, param, nullptr, expr, scope);
    if (!value) emitter.diagnostics.report(Code::NotConstant, expr.span, fmt::format("'{}'", param.name));
    return {.value = {}, .constant = value};
}

Typed default_value(Emitter& emitter, const Expr& expr, const Declarations& home, Scope& scope, Type wanted,
                    const OpenPort* port) {
    Scope outside{.builder = scope.builder, .declarations = &home, .half = scope.half};
    if (!scope.environment) return expression_as(emitter, expr, wanted, outside, "the default");
    DefaultEnvironment environment(*scope.environment);
    outside.environment = &environment;
    outside.in_vertex_stage = scope.in_vertex_stage;
    outside.open_port = scope.open_port ? scope.open_port : port;
    return convert(emitter, primary(emitter, expression(emitter, expr, outside), outside, expr.span), wanted, outside,
                   expr.span, "the default");
}

namespace {

// "SamplerState sampler = texture.sampler": the index of the parameter before it that is the texture.
std::optional<std::size_t> texture_of_default(const FunctionDecl& function, std::size_t param) {
    const Expr* const initial = function.params[param].initial;
    const bool is_sampler = initial && initial->kind == Expr::Kind::Member && initial->text == "sampler" &&
                            initial->args[0]->kind == Expr::Kind::Name;
    for (std::size_t i = 0; is_sampler && i < param; ++i) {
        if (function.params[i].name == initial->args[0]->text) return i;
    }
    return {};
}

}  // namespace

bool gather_arguments(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                      std::span<const Expr* const> arguments, Scope& scope, Span span,
                      std::vector<Argument>& gathered) {
    bool good = true;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const ParamDecl& param = function.params[i];
        Argument& argument = gathered.emplace_back();
        if (!param.is_input()) continue;
        const Expr* given = arguments[i];
        if (!given && !param.initial) {
            emitter.diagnostics.report(Code::MissingInput, span, param.name, function.name);
            good = false;
            continue;
        }
        Scope outside{.builder = scope.builder, .declarations = &home, .half = scope.half};
        if (param.is_const) {
            argument = const_argument(emitter, param, home, given ? *given : *param.initial, given ? scope : outside);
            good = good && argument.constant.has_value();
        } else if (const std::optional<std::size_t> texture = given ? std::nullopt : texture_of_default(function, i)) {
            // An argument that is no texture is reported when it is converted.
            const Typed& read = gathered[*texture].value;
            if (is_texture(emitter, read.type))
                argument.value = member(emitter, read, "sampler", param.initial->span, scope);
            continue;
        } else if (given) {
            argument.value = param.type.name == "SamplerState"
                                 ? sampler_value(emitter, *given, scope)
                                 : primary(emitter, expression(emitter, *given, scope), scope, given->span);
        } else {
            const bool generic = param.type.name == "floatN";
            const OpenPort port{.call = span, .function = function.name, .port = param.name};
            argument.value = default_value(emitter, *param.initial, home, scope,
                                           generic ? ir::kFloat : type(emitter, param.type, outside), &port);
            if (generic) argument.value.literal = true;
        }
        good = good && (param.is_const || argument.value.ok());
    }
    return good;
}

// The width of the widest vector; but 3 if there is a float4 and a float3.
unsigned deduce_width(const FunctionDecl& function, std::span<const Argument> arguments) {
    unsigned widest = 1, narrowest = 4;
    bool generic = false;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        if (function.params[i].type.name != "floatN" || !function.params[i].is_input()) continue;
        generic = true;
        const Type type = arguments[i].value.type;
        if (!type.is_vector()) continue;
        widest = std::max(widest, type.width());
        narrowest = std::min(narrowest, type.width());
    }
    if (!generic) return 0;
    return widest == 4 && narrowest == 3 ? 3 : widest;
}

}  // namespace patina::emit
