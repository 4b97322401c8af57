#include "compiler/emit/calls.h"

#include <algorithm>
#include <array>

#include "compiler/base/text.h"
#include "compiler/emit/arguments.h"
#include "compiler/emit/constant_value.h"
#include "compiler/emit/functions.h"
#include "compiler/emit/operations/operations.h"
#include "compiler/emit/statements/statements.h"
#include "compiler/emit/types.h"
#include "compiler/nodelang/other_names.h"

namespace patina::emit {

using ir::Op;
using ir::Type;
using ir::Value;

namespace {

bool takes_texture(const FunctionDecl& function) {
    return std::any_of(function.params.begin(), function.params.end(),
                       [](const ParamDecl& param) { return param.type.name.starts_with("Texture"); });
}

// choices[chooser]; structs are chosen member by member.
Typed choose(Emitter& emitter, Value chooser, std::span<const Typed> choices, Scope& scope) {
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
        for (std::uint32_t part = 0; part < ir::part_count(emitter.module, result.type); ++part) {
            parts.push_back(select(ir::part_type(emitter.module, result.type, part), b.extract(choices[i].value, part),
                                   b.extract(result.value, part)));
        }
        result.value = b.construct(result.type, parts);
    }
    return result;
}

void note_slot_quad(Scope& scope) {
    bool* const noted = scope.slot_needs_quad ? scope.slot_needs_quad : scope.needs_quad;
    if (noted) *noted = true;
}

// Emits the body in the place of the call, for functions marked [inline], so that the caller reads as one text.
Typed spelled_out(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                  std::span<const Argument> gathered, std::span<const Value> arguments, const Scope& border,
                  Scope& scope, Span span) {
    if (std::find(emitter.active.begin(), emitter.active.end(), &function) != emitter.active.end()) {
        emitter.diagnostics.report(Code::Recursion, span, function.name);
        return {};
    }
    bool needs_quad = false, slot_needs_quad = false;
    Scope inner = border;
    inner.function = &function;
    inner.needs_quad = &needs_quad;
    inner.slot_needs_quad = &slot_needs_quad;
    auto next = arguments.begin();
    const Outputs* outputs = begin_body(emitter, function, home, gathered, std::string(function.name), inner,
                                        [&](const ParamDecl&, Type) { return *next++; });
    if (inner.result.is_error()) return {};
    Value returned;
    const std::size_t errors = emitter.diagnostics.error_count();
    emitter.active.push_back(&function);
    const bool returns = statements(emitter, sound_body_of(emitter, function), 0, inner, returned);
    emitter.active.pop_back();
    if (emitter.diagnostics.error_count() != errors) return {};
    if (!returns && function.result.name != "void") {
        emitter.diagnostics.report(Code::MissingReturn, function.name_span, function.name);
        return {};
    }
    if (!returns) returned = return_value(emitter, nullptr, inner);
    if (needs_quad) need_quad(emitter, scope, span, function.name, takes_texture(function));
    if (slot_needs_quad) note_slot_quad(scope);
    if (inner.rounds > 0) count_rounds(emitter, inner.rounds, scope, span);
    return {.value = returned, .type = inner.result, .outputs = outputs};
}

// If the value of a const parameter is known only when the shader runs, emits a call for each value and chooses between
// the results.
Typed call_gathered(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                    std::span<const Expr* const> arguments, std::vector<Argument>& gathered, Scope& scope, Span span,
                    bool half) {
    for (Argument& argument : gathered) {
        if (argument.choices.empty()) continue;
        const std::vector<double> choices = std::move(argument.choices);
        argument.choices.clear();
        std::vector<Typed> results;
        for (const double choice : choices) {
            argument.constant = choice;
            std::vector<Argument> rest = gathered;
            results.push_back(call_gathered(emitter, function, home, arguments, rest, scope, span, half));
            if (!results.back().ok()) return {};
        }
        return choose(emitter, argument.value.value, results, scope);
    }
    const unsigned width = deduce_width(function, gathered);
    Scope border{.builder = scope.builder,
                 .declarations = &home,
                 .generic_width = width,
                 .half = half,
                 .hlsl = function.is_hlsl};
    std::vector<Value> values;
    values.reserve(function.params.size());
    bool good = true;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const ParamDecl& param = function.params[i];
        if (!param.is_input() || param.is_const) continue;
        const Span at = arguments[i] ? arguments[i]->span : span;
        const Type wanted = type(emitter, param.type, border);
        Typed value = gathered[i].value;
        if (value.type != wanted && !is_view_of(emitter, value.type, wanted)) {
            value = convert(emitter, value, wanted, scope, at,
                            fmt::format("the input '{}' of {}", param.name, function.name));
        }
        good = good && value.ok();
        values.push_back(value.value);
    }
    if (!good) return {};
    if (function.marks.is_inlined) return spelled_out(emitter, function, home, gathered, values, border, scope, span);
    const Instance& instance = instantiate(emitter, function, home, gathered, width, half, span);
    if (instance.result.is_error()) return {};
    if (instance.needs_quad) need_quad(emitter, scope, span, function.name, takes_texture(function));
    count_rounds(emitter, 1 + instance.rounds, scope, span);
    return {.value = scope.builder->call(instance.id, values), .type = instance.result, .outputs = instance.outputs};
}

// A pass file may declare a slot and a struct of the library's again. A function of the library then calls the slot
// with the library's struct.
bool takes(Emitter& emitter, const Slot& slot, const FunctionDecl& function, std::span<const Value> values,
           const Expr& expr, const Scope& scope) {
    const std::vector<ir::Param>& params = emitter.module[slot.function].params;
    for (std::size_t i = 0; i < values.size() && i < params.size(); ++i) {
        const ir::Type type = scope.builder->type(values[i]);
        if (params[i].type == type) continue;
        const std::string name = emitter.module.type_name(type);
        emitter.diagnostics
            .report(Code::TypeMismatch, expr.args[i]->span, fmt::format("the argument '{}'", function.params[i].name),
                    fmt::format("the {} of another file", name),
                    fmt::format("that of the file which declares '{}'", function.name))
            .note(
                "the called function is one of the library, and the pass file does not declare it again: give the "
                "struct another name");
        return false;
    }
    return true;
}

Typed call_slot(Emitter& emitter, const FunctionDecl& function, const Expr& expr, Scope& scope) {
    if (expr.args.size() != function.params.size()) {
        emitter.diagnostics.report(Code::ArgumentCount, expr.name_span, function.name, function.params.size(),
                                   expr.args.size());
        return {};
    }
    const std::size_t errors = emitter.diagnostics.error_count();
    const Slot* slot = find_slot(emitter.known, function.name);
    if (!slot && emitter.known.make_slot) slot = emitter.known.make_slot(function, expr.name_span);
    if (!slot) {
        if (emitter.diagnostics.error_count() == errors)
            emitter.diagnostics.report(Code::Internal, expr.span, fmt::format("the slot '{}' is empty", function.name));
        return {};
    }
    std::vector<Value> values;
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        const Typed value =
            expression_as(emitter, *expr.args[i], type(emitter, function.params[i].type, scope), scope, function.name);
        if (!value.ok()) return {};
        values.push_back(value.value);
    }
    if (!takes(emitter, *slot, function, values, expr, scope)) return {};
    if (slot->needs_quad) note_slot_quad(scope);
    return {.value = scope.builder->call(slot->function, values), .type = slot->result};
}

}  // namespace

Typed call(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
           std::span<const Expr* const> arguments, Scope& scope, Span span, bool half) {
    std::vector<Argument> gathered;
    gathered.reserve(function.params.size());
    if (!gather_arguments(emitter, function, home, arguments, scope, span, gathered)) return {};
    half = half && !function.marks.is_in_float;
    return call_gathered(emitter, function, home, arguments, gathered, scope, span, half);
}

namespace {

// How much an argument changes when a parameter takes it; none: it cannot.
std::optional<unsigned> change_of(Type from, Type to) {
    if (from == to) return 0;
    if (!from.is_numeric() || !to.is_numeric() || from.is_matrix() != to.is_matrix()) return {};
    if (from.is_matrix()) return from.rows >= to.rows && from.cols >= to.cols ? std::optional(100u) : std::nullopt;
    unsigned change = 0;
    if (from.width() > to.width()) change += 100;
    if (from.width() < to.width() && !from.is_scalar()) return {};
    if (from.width() < to.width()) change += 30;
    if (from.scalar != to.scalar) change += from.is_floating() == to.is_floating() ? 1 : to.is_floating() ? 3 : 10;
    return change;
}

// The overload that HLSL would call: the function whose parameters convert the arguments least.
[[gnu::noinline]] const FunctionDecl* overload(Emitter& emitter, const Expr& expr, Scope& scope) {
    const FunctionDecl* const first = scope.declarations->function(expr.text);
    if (!scope.hlsl || !first) return first;
    const Declarations& home = scope.declarations->home_of(expr.text);
    const auto others = home.overloads.find(expr.text);
    if (others == home.overloads.end()) return first;
    std::vector<const FunctionDecl*> fitting = {first};
    fitting.insert(fitting.end(), others->second.begin(), others->second.end());
    std::erase_if(fitting, [&](const FunctionDecl* each) { return each->params.size() != expr.args.size(); });
    if (fitting.size() < 2) return fitting.empty() ? first : fitting[0];
    // The arguments are emitted here for their types, and again for the call: calls in calls are asked once.
    const auto known = emitter.overloads.find({&expr, scope.generic_width, scope.half});
    if (known != emitter.overloads.end()) return known->second;
    // What the arguments assign must happen once, when they are read for the call.
    Scope aside = scope;
    std::vector<Type> types;
    for (const Expr* argument : expr.args)
        types.push_back(primary(emitter, expression(emitter, *argument, aside), aside, argument->span).type);
    const FunctionDecl* best = first;
    std::optional<unsigned> least;
    for (const FunctionDecl* each : fitting) {
        const Scope of{.declarations = &home, .hlsl = true};
        std::optional<unsigned> sum = 0;
        for (std::size_t i = 0; sum && i < types.size(); ++i) {
            const Type wanted = type(emitter, each->params[i].type, of);
            const std::optional<unsigned> change =
                is_view_of(emitter, types[i], wanted) ? 0u : change_of(types[i], wanted);
            sum = change ? std::optional(*sum + *change) : std::nullopt;
        }
        if (!sum || (least && *least <= *sum)) continue;
        least = sum;
        best = each;
    }
    return emitter.overloads[{&expr, scope.generic_width, scope.half}] = best;
}

// HLSL: a call with an argument for each parameter, the outputs included. They are assigned after the call.
[[gnu::noinline]] Typed call_with_outputs(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                                          const Expr& expr, Scope& scope) {
    std::vector<const Expr*> arguments(function.params.size(), nullptr);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (function.params[i].is_input()) arguments[i] = expr.args[i];
    }
    const Typed made = call(emitter, function, home, arguments, scope, expr.span, scope.half);
    if (!made.ok()) return {};
    ir::Builder& b = *scope.builder;
    const bool has_value = function.result.name != "void";
    std::uint32_t part = has_value ? 1 : 0;
    bool good = true;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (!function.params[i].is_out) continue;
        const Value value = b.extract(made.value, part++);
        good = store(emitter, *expr.args[i], {.value = value, .type = b.type(value)}, scope) && good;
    }
    if (!good) return {};
    if (!has_value) return {.value = made.value, .type = made.type};
    const Value value = b.extract(made.value, 0);
    return {.value = value, .type = b.type(value)};
}

// "(Light)0" of HLSL: every number in it is 0.
[[gnu::noinline]] Typed struct_of_zeros(Emitter& emitter, const StructDecl& structure, const Expr& expr, Scope& scope) {
    const Type wanted = type(emitter, {.name = structure.name, .span = expr.name_span}, scope);
    if (wanted.is_error()) return {};
    const Typed given =
        expr.args.size() == 1 ? primary(emitter, expression(emitter, *expr.args[0], scope), scope, expr.span) : Typed{};
    if (given.ok() && given.type == wanted) return given;
    const bool is_zero = expr.args.size() == 1 && constant_value(emitter.known, *expr.args[0], scope) == 0.0;
    if (is_zero) return {.value = scope.builder->zero(wanted), .type = wanted};
    emitter.diagnostics.report(Code::TypeMismatch, expr.span, "what becomes a struct",
                               given.ok() ? emitter.module.type_name(given.type) : "no value", "0");
    return {};
}

}  // namespace

Typed call_expression(Emitter& emitter, const Expr& expr, Scope& scope) {
    bool found = false;
    // A file of HLSL may have a function with the name of one of the language.
    const bool is_own = scope.hlsl && scope.declarations->functions.contains(expr.text);
    const Typed built_in = is_own ? Typed{} : intrinsic(emitter, expr.text, expr, scope, found);
    if (found) return built_in;
    const TypeName type_name{.name = expr.text, .span = expr.name_span};
    const FunctionDecl* const function = overload(emitter, expr, scope);
    if (function && (!function->marks.is_of_hlsl || scope.hlsl)) {
        if (function->marks.is_slot) return call_slot(emitter, *function, expr, scope);
        if (function->marks.is_stage) {
            emitter.diagnostics.report(Code::UnknownName, expr.name_span, "callable function", expr.text)
                .note(function->name_span, "this is a stage of a pass, which no function can call");
            return {};
        }
        const auto inputs = static_cast<std::size_t>(std::count_if(function->params.begin(), function->params.end(),
                                                                   [](const ParamDecl& p) { return p.is_input(); }));
        if (expr.args.size() > inputs && !(scope.hlsl && expr.args.size() == function->params.size())) {
            emitter.diagnostics.report(Code::ArgumentCount, expr.name_span, expr.text, inputs, expr.args.size());
            return {};
        }
        const bool has_outputs =
            std::any_of(function->params.begin(), function->params.end(), [](const ParamDecl& p) { return p.is_out; });
        if (scope.hlsl && has_outputs && expr.args.size() == function->params.size())
            return call_with_outputs(emitter, *function, scope.declarations->home_of(expr.text), expr, scope);
        std::vector<const Expr*> arguments(function->params.size(), nullptr);
        std::size_t next = 0;
        for (std::size_t i = 0; i < function->params.size() && next < expr.args.size(); ++i) {
            if (function->params[i].is_input()) arguments[i] = expr.args[next++];
        }
        return call(emitter, *function, scope.declarations->home_of(expr.text), arguments, scope, expr.span,
                    scope.half);
    }
    constexpr std::string_view kScalars[] = {"float", "half", "int", "uint", "bool"};
    const auto is_type = [&](std::string_view scalar) {
        return expr.text.starts_with(scalar) &&
               expr.text.substr(scalar.size()).find_first_not_of("0123456789xN") == std::string_view::npos;
    };
    if (std::any_of(std::begin(kScalars), std::end(kScalars), is_type)) {
        const Type wanted = type(emitter, type_name, scope);
        return wanted.is_error() ? Typed{} : constructor(emitter, wanted, expr, scope);
    }
    const StructDecl* const structure = scope.hlsl ? scope.declarations->structure(expr.text) : nullptr;
    if (structure) return struct_of_zeros(emitter, *structure, expr, scope);
    std::vector<std::string_view> known = intrinsic_names();
    for (std::string_view name : scope.declarations->function_names()) known.push_back(name);
    DiagnosticRecord& record = emitter.diagnostics.report(Code::UnknownName, expr.name_span, "function", expr.text);
    record.note(nodelang::advice(expr.text, known, *scope.declarations));
    return {};
}

}  // namespace patina::emit
