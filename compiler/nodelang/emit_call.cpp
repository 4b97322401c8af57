// Calls of declared functions and slots, and what happens at a function's border: defaults, constant arguments, the
// width of floatN. What is built in is emit_intrinsic.cpp.
#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/ir/fold.h"
#include "compiler/nodelang/emit.h"
#include "compiler/nodelang/parse.h"

namespace patina::nodelang {

using ir::Op;
using ir::Scalar;
using ir::Type;
using ir::Value;

namespace {

// In a parameter's default a bare name is a semantic.
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

bool takes_texture(const FunctionDecl& function) {
    return std::any_of(function.params.begin(), function.params.end(),
                       [](const ParamDecl& param) { return param.type.name.starts_with("Texture"); });
}

}  // namespace

Typed Emitter::call_expression(const Expr& expr, Scope& scope) {
    bool found = false;
    const Typed built_in = intrinsic(expr.text, expr, scope, found);
    if (found) return built_in;
    const TypeName type_name{.name = expr.text, .span = expr.name_span};
    if (const FunctionDecl* function = scope.declarations->function(expr.text)) {
        if (function->attribute("slot")) return call_slot(*function, expr, scope);
        const auto inputs = static_cast<std::size_t>(std::count_if(function->params.begin(), function->params.end(),
                                                                   [](const ParamDecl& p) { return !p.is_out; }));
        if (expr.args.size() > inputs) {
            diagnostics_.report(Code::ArgumentCount, expr.name_span, expr.text, inputs, expr.args.size());
            return {};
        }
        std::vector<const Expr*> arguments(function->params.size(), nullptr);
        std::size_t next = 0;
        for (std::size_t i = 0; i < function->params.size() && next < expr.args.size(); ++i) {
            if (!function->params[i].is_out) arguments[i] = expr.args[next++];
        }
        return call(*function, scope.declarations->home_of(expr.text), arguments, scope, expr.span, scope.half);
    }
    if (expr.text == "floatN" || expr.text.find_first_of("1234") != std::string_view::npos || expr.text == "float" ||
        expr.text == "half" || expr.text == "int" || expr.text == "uint" || expr.text == "bool") {
        const Type wanted = type(type_name, scope);
        return wanted.is_error() ? Typed{} : constructor(wanted, expr, scope);
    }
    std::vector<std::string_view> known = intrinsic_names();
    for (std::string_view name : scope.declarations->function_names()) known.push_back(name);
    DiagnosticRecord& record = diagnostics_.report(Code::UnknownName, expr.name_span, "function", expr.text);
    const std::string_view near = nearest(expr.text, known);
    if (!near.empty()) record.note(fmt::format("did you mean '{}'?", near));
    return {};
}

// --- functions of the language

Typed Emitter::call(const FunctionDecl& function, const Declarations& home, std::span<const Expr* const> arguments,
                    Scope& scope, Span span, bool half) {
    std::vector<Argument> gathered;
    gathered.reserve(function.params.size());
    if (!gather_arguments(function, home, arguments, scope, span, gathered)) return {};
    half = half && !function.attribute("inFloat");
    return call_gathered(function, home, arguments, gathered, scope, span, half);
}

// A const parameter whose value is known only later is a call for each of its values, and a choice between them.
Typed Emitter::call_gathered(const FunctionDecl& function, const Declarations& home,
                             std::span<const Expr* const> arguments, std::vector<Argument>& gathered, Scope& scope,
                             Span span, bool half) {
    for (Argument& argument : gathered) {
        if (argument.choices.empty()) continue;
        const std::vector<double> choices = std::move(argument.choices);
        argument.choices.clear();
        std::vector<Typed> results;
        for (const double choice : choices) {
            argument.constant = choice;
            std::vector<Argument> rest = gathered;
            results.push_back(call_gathered(function, home, arguments, rest, scope, span, half));
            if (!results.back().ok()) return {};
        }
        return choose(argument.value.value, results, scope);
    }
    const unsigned width = deduce_width(function, gathered);
    Scope border{.builder = scope.builder, .declarations = &home, .generic_width = width, .half = half};
    std::vector<Value> values;
    values.reserve(function.params.size());
    bool good = true;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const ParamDecl& param = function.params[i];
        if (param.is_out || param.is_const) continue;
        const Span at = arguments[i] ? arguments[i]->span : span;
        const Type wanted = type(param.type, border);
        Typed value = gathered[i].value;
        if (value.type != wanted) {
            value = convert(value, wanted, scope, at, fmt::format("the input '{}' of {}", param.name, function.name));
        }
        good = good && value.ok();
        values.push_back(value.value);
    }
    if (!good) return {};
    if (function.attribute("inline")) return spelled_out(function, values, border, scope, span);
    const Instance& instance = instantiate(function, home, gathered, width, half, span);
    if (instance.result.is_error()) return {};
    if (instance.needs_quad) need_quad(scope, span, function.name, takes_texture(function));
    if (instance.rounds > 0) count_rounds(instance.rounds, scope, span);
    return {.value = scope.builder->call(instance.id, values), .type = instance.result, .outputs = instance.outputs};
}

// choices[chooser], part by part where they have parts.
Typed Emitter::choose(Value chooser, std::span<const Typed> choices, Scope& scope) {
    ir::Builder& b = *scope.builder;
    const bool is_bool = b.type(chooser) == ir::kBool;
    const auto is_chosen = [&](std::size_t i) {
        return is_bool ? b.emit(Op::Not, ir::kBool, {chooser})
                       : b.emit(Op::Equal, ir::kBool, {chooser, b.constant(ir::kInt, {static_cast<double>(i)})});
    };
    Typed result = choices.back();
    for (std::size_t i = choices.size() - 1; i-- > 0;) {
        const Value condition = is_chosen(i);
        const auto select = [&](Type type, Value yes, Value no) {
            return b.emit(Op::Select, type, {condition, yes, no});
        };
        if (result.type.kind != ir::Kind::Struct) {
            result.value = select(result.type, choices[i].value, result.value);
            continue;
        }
        std::vector<Value> parts;
        for (std::uint32_t part = 0; part < ir::part_count(module_, result.type); ++part) {
            parts.push_back(select(ir::part_type(module_, result.type, part), b.extract(choices[i].value, part),
                                   b.extract(result.value, part)));
        }
        result.value = b.construct(result.type, parts);
    }
    return result;
}

// The body in the place of the call: what a pass is made of should read as one text. Such functions have one result and
// no const parameters.
Typed Emitter::spelled_out(const FunctionDecl& function, std::span<const Value> arguments, const Scope& border,
                           Scope& scope, Span span) {
    if (std::find(active_.begin(), active_.end(), &function) != active_.end()) {
        diagnostics_.report(Code::Recursion, span, function.name);
        return {};
    }
    bool needs_quad = false;
    Scope inner = border;
    inner.function = &function;
    inner.needs_quad = &needs_quad;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const Typed value{.value = arguments[i], .type = type(function.params[i].type, border)};
        inner.locals.push_back({.name = function.params[i].name, .value = value, .is_const = false, .constant = {}});
    }
    inner.result = type(function.result, border);
    Value returned;
    const std::size_t errors = diagnostics_.error_count();
    active_.push_back(&function);
    const bool returns = statements(body_of(function), 0, inner, returned);
    active_.pop_back();
    if (diagnostics_.error_count() != errors) return {};
    if (!returns) {
        diagnostics_.report(Code::MissingReturn, function.name_span, function.name);
        return {};
    }
    if (needs_quad) need_quad(scope, span, function.name, takes_texture(function));
    if (inner.rounds > 0) count_rounds(inner.rounds, scope, span);
    return {.value = returned, .type = inner.result};
}

bool Emitter::gather_arguments(const FunctionDecl& function, const Declarations& home,
                               std::span<const Expr* const> arguments, Scope& scope, Span span,
                               std::vector<Argument>& gathered) {
    bool good = true;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const ParamDecl& param = function.params[i];
        Argument& argument = gathered.emplace_back();
        if (param.is_out) continue;
        const Expr* given = arguments[i];
        if (!given && !param.initial) {
            diagnostics_.report(Code::MissingInput, span, function.name, param.name);
            good = false;
            continue;
        }
        Scope outside{.builder = scope.builder, .declarations = &home, .half = scope.half};
        if (param.is_const) {
            argument = const_argument(param, home, given ? *given : *param.initial, given ? scope : outside);
            good = good && argument.constant.has_value();
        } else if (given) {
            argument.value = primary(expression(*given, scope), scope, given->span);
        } else {
            const bool generic = param.type.name == "floatN";
            const OpenPort port{.call = span, .function = function.name, .port = param.name};
            argument.value =
                default_value(*param.initial, home, scope, generic ? ir::kFloat : type(param.type, outside), &port);
            if (generic) argument.value.literal = true;
        }
        good = good && (param.is_const || argument.value.ok());
    }
    return good;
}

Emitter::Argument Emitter::const_argument(const ParamDecl& param, const Declarations& home, const Expr& expr,
                                          Scope& scope) {
    if (const EnumDecl* enumeration = home.enumeration(param.type.name)) {
        const auto found = std::find(enumeration->values.begin(), enumeration->values.end(), expr.text);
        if (expr.kind == Expr::Kind::Name && found != enumeration->values.end()) {
            return {.value = {}, .constant = static_cast<double>(found - enumeration->values.begin())};
        }
        // A const parameter of the same enumeration may be handed on.
        for (const Local& local : scope.locals) {
            if (expr.kind == Expr::Kind::Name && local.name == expr.text && local.constant) {
                return {.value = {}, .constant = local.constant};
            }
        }
        if (expr.kind == Expr::Kind::Name) {
            diagnostics_.report(Code::UnknownEnumerator, expr.span, expr.text, fmt::format("'{}'", param.name))
                .note(Diagnostics::suggestion(expr.text, enumeration->values));
        } else if (expr.kind == Expr::Kind::Property) {
            return choosing_argument(param, enumeration, expr, scope);
        } else {
            diagnostics_.report(Code::NotConstant, expr.span, fmt::format("'{}'", param.name))
                .note(fmt::format("write one of {}", enumerate(enumeration->values)));
        }
        return {};
    }
    const std::optional<double> value = constant_value(expr, scope);
    if (!value && expr.kind == Expr::Kind::Property && param.type.name == "bool")
        return choosing_argument(param, nullptr, expr, scope);
    if (!value) diagnostics_.report(Code::NotConstant, expr.span, fmt::format("'{}'", param.name));
    return {.value = {}, .constant = value};
}

// A property at a port that is chosen from a list: each of its values must be one of the port's.
Emitter::Argument Emitter::choosing_argument(const ParamDecl& param, const EnumDecl* enumeration, const Expr& expr,
                                             Scope& scope) {
    const Typed value = expression(expr, scope);
    if (!value.ok()) return {};
    std::vector<double> choices = {0, 1};
    if (enumeration ? !value.enumerators : value.type != ir::kBool) {
        diagnostics_.report(Code::TypeMismatch, expr.span, fmt::format("'{}'", expr.text),
                            module_.type_name(value.type),
                            enumeration ? fmt::format("an enum of {}", enumerate(enumeration->values)) : "a bool");
        return {};
    }
    if (enumeration) {
        choices.clear();
        for (const std::string_view word : *value.enumerators) {
            const auto found = std::find(enumeration->values.begin(), enumeration->values.end(), word);
            if (found == enumeration->values.end()) {
                diagnostics_.report(Code::UnknownEnumerator, expr.span, word, fmt::format("'{}'", param.name))
                    .note(Diagnostics::suggestion(word, enumeration->values))
                    .note(fmt::format("'{}' can be it", expr.text));
                return {};
            }
            choices.push_back(static_cast<double>(found - enumeration->values.begin()));
        }
    }
    if (const std::span<const double> known = scope.builder->constant_of(value.value); !known.empty())
        return {.value = {}, .constant = choices[static_cast<std::size_t>(known[0])]};
    return {.value = value, .constant = choices[0], .choices = std::move(choices)};
}

Typed Emitter::default_value(const Expr& expr, const Declarations& home, Scope& scope, Type wanted,
                             const OpenPort* port) {
    Scope outside{.builder = scope.builder, .declarations = &home, .half = scope.half};
    if (!scope.environment) return expression_as(expr, wanted, outside, "the default");
    DefaultEnvironment environment(*scope.environment);
    outside.environment = &environment;
    outside.in_vertex_stage = scope.in_vertex_stage;
    outside.open_port = scope.open_port ? scope.open_port : port;
    return convert(primary(expression(expr, outside), outside, expr.span), wanted, outside, expr.span, "the default");
}

// floatN: the widest vector, but float3 where a float4 and a float3 meet.
unsigned Emitter::deduce_width(const FunctionDecl& function, std::span<const Argument> arguments) {
    unsigned widest = 1, narrowest = 4;
    bool generic = false;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        if (function.params[i].type.name != "floatN" || function.params[i].is_out) continue;
        generic = true;
        const Type type = arguments[i].value.type;
        if (!type.is_vector()) continue;
        widest = std::max(widest, type.width());
        narrowest = std::min(narrowest, type.width());
    }
    if (!generic) return 0;
    return widest == 4 && narrowest == 3 ? 3 : widest;
}

Typed Emitter::call_slot(const FunctionDecl& function, const Expr& expr, Scope& scope) {
    if (expr.args.size() != function.params.size()) {
        diagnostics_.report(Code::ArgumentCount, expr.name_span, function.name, function.params.size(),
                            expr.args.size());
        return {};
    }
    const std::size_t errors = diagnostics_.error_count();
    const Slot* slot = find_slot(function.name);
    if (!slot && slot_maker_) slot = slot_maker_(function, expr.name_span);
    if (!slot) {
        if (diagnostics_.error_count() == errors)
            diagnostics_.report(Code::Internal, expr.span, fmt::format("the slot '{}' is empty", function.name));
        return {};
    }
    std::vector<Value> values;
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        const Typed value = expression_as(*expr.args[i], type(function.params[i].type, scope), scope, function.name);
        if (!value.ok()) return {};
        values.push_back(value.value);
    }
    if (slot->needs_quad && scope.needs_quad) *scope.needs_quad = true;
    return {.value = scope.builder->call(slot->function, values), .type = slot->result};
}

// --- what the language itself offers

}  // namespace patina::nodelang
