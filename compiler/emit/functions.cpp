#include "compiler/emit/functions.h"

#include <algorithm>
#include <array>

#include "compiler/base/bits.h"
#include "compiler/emit/constant_value.h"
#include "compiler/emit/statements/statements.h"
#include "compiler/emit/types.h"
#include "compiler/nodelang/parse.h"

namespace patina::emit {

using ir::Type;
using ir::Value;

namespace {

// How deep functions may call one another.
constexpr std::size_t kMaxCallDepth = 64;

// What each member of the result is: the function's comment describes the primary one. Empty if that is all.
std::vector<std::string> result_docs(const FunctionDecl& function, const std::string& comment) {
    std::vector<std::string> docs;
    if (function.result.name != "void") docs.push_back(comment);
    for (const ParamDecl& param : function.params) {
        if (param.is_out) docs.emplace_back(param.doc);
    }
    if (docs.size() == 1 && function.result.name != "void") docs.clear();
    return docs;
}

Instance emit_function(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                       std::span<const Argument> arguments, unsigned width, bool half, std::string name) {
    Instance instance;
    const std::size_t errors = emitter.diagnostics.error_count();
    ir::Function made{};
    made.name = std::move(name);
    made.comment = nodelang::first_sentence(function.doc);
    made.result_docs = result_docs(function, made.comment);
    ir::Builder builder(emitter.module, made, emitter.options);
    Scope scope{.builder = &builder,
                .declarations = &home,
                .generic_width = width,
                .half = half,
                .hlsl = function.is_hlsl,
                .function = &function,
                .needs_quad = &instance.needs_quad};
    made.params.reserve(function.params.size());
    const auto next_param = [&](const ParamDecl& param, Type of) {
        made.params.push_back({std::string(param.name), of, ir::Rate::Pixel});
        return builder.param(static_cast<std::uint32_t>(made.params.size() - 1));
    };
    instance.outputs = begin_body(emitter, function, home, arguments, made.name, scope, next_param);
    instance.result = scope.result;
    if (instance.result.is_error()) return {.id = {}, .result = Type::error()};
    made.result = instance.result;
    if (function.marks.is_foreign) {
        made.linkage = function.has_body ? ir::Linkage::Verbatim : ir::Linkage::Foreign;
        if (function.has_body) {
            std::vector<Type> types;
            for (const Local& local : scope.locals) types.push_back(local.value.type);
            made.code = foreign_code(emitter, function, home, types);
            instance.needs_quad = needs_quad(made.code);
        }
        if (emitter.diagnostics.error_count() != errors) return {.id = {}, .result = Type::error()};
        made.spelling = function.marks.spelling;
        made.is_of_object = function.marks.is_of_object;
        builder.ret(builder.zero(made.result));
        emitter.module.functions.push_back(std::move(made));
        instance.id = {static_cast<std::uint32_t>(emitter.module.functions.size() - 1)};
        return instance;
    }
    Value returned;
    const bool returns = statements(emitter, sound_body_of(emitter, function), 0, scope, returned);
    if (emitter.diagnostics.error_count() != errors) return {.id = {}, .result = Type::error()};
    instance.rounds = scope.rounds;
    if (!returns) {
        if (function.result.name != "void") {
            emitter.diagnostics.report(Code::MissingReturn, function.name_span, function.name);
            return {.id = {}, .result = Type::error()};
        }
        returned = return_value(emitter, nullptr, scope);
    }
    builder.ret(returned);
    emitter.module.functions.push_back(std::move(made));
    instance.id = {static_cast<std::uint32_t>(emitter.module.functions.size() - 1)};
    return instance;
}

// A function whose parameters have semantics as their defaults.
ir::FunctionId outer_function(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                              Environment& environment, Scope scope, bool may_take, bool* needs_quad) {
    ir::Function made{};
    made.name = function.name;
    made.always_inline = true;
    ir::Builder builder(emitter.module, made, emitter.options);
    bool quad = false;
    scope.builder = &builder;
    scope.hlsl = function.is_hlsl;
    scope.needs_quad = &quad;
    for (const ParamDecl& param : function.params) {
        const Type param_type = type(emitter, param.type, scope);
        if (!param.initial && may_take) {
            made.params.push_back({std::string(param.name), param_type, ir::Rate::Pixel});
            const Value value = builder.param(static_cast<std::uint32_t>(made.params.size() - 1));
            scope.locals.push_back(
                {.name = param.name, .value = {.value = value, .type = param_type}, .is_const = false, .constant = {}});
            continue;
        }
        if (!param.initial) {
            emitter.diagnostics.report(Code::MissingInput, param.span, param.name, function.name)
                .note(
                    "nothing calls it with arguments: give each parameter a semantic as its default, 'float3 position "
                    "= positionWS'");
            return {};
        }
        Scope outside{.builder = &builder, .declarations = &home, .environment = &environment};
        outside.in_vertex_stage = scope.in_vertex_stage;
        const Typed value = convert(emitter, default_value(emitter, *param.initial, home, outside, param_type),
                                    param_type, outside, param.initial->span, "the default");
        if (!value.ok()) return {};
        scope.locals.push_back({.name = param.name, .value = value, .is_const = false, .constant = {}});
        if (param.is_const) scope.locals.back().constant = constant_value(emitter.known, *param.initial, outside);
    }
    const bool is_void = function.result.name == "void";
    if (is_void) emitter.module.structs.push_back({.name = made.name + "Result", .members = {}});
    made.result = scope.result = is_void
                                     ? Type::structure(static_cast<std::uint32_t>(emitter.module.structs.size() - 1))
                                     : type(emitter, function.result, scope);
    Value returned;
    const std::size_t errors = emitter.diagnostics.error_count();
    emitter.active.push_back(&function);
    const bool returns = statements(emitter, sound_body_of(emitter, function), 0, scope, returned);
    emitter.active.pop_back();
    if (emitter.diagnostics.error_count() != errors) return {};
    if (!returns && !is_void) {
        emitter.diagnostics.report(Code::MissingReturn, function.name_span, function.name);
        return {};
    }
    if (!returns) returned = return_value(emitter, nullptr, scope);
    builder.ret(returned);
    if (needs_quad) *needs_quad = quad;
    emitter.module.functions.push_back(std::move(made));
    return {static_cast<std::uint32_t>(emitter.module.functions.size() - 1)};
}

// The author's name, and after it the words that were chosen for drop-downs and the precision.
std::string instance_name(const FunctionDecl& function, const Declarations& home, std::span<const Argument> arguments,
                          bool half) {
    std::string name(function.name);
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const ParamDecl& param = function.params[i];
        const EnumDecl* enumeration = param.is_const ? home.enumeration(param.type.name) : nullptr;
        if (enumeration) name += enumeration->values[static_cast<std::size_t>(*arguments[i].constant)];
    }
    // A foreign function is known by one name.
    if (half && !function.marks.is_foreign) name += "Half";
    return name;
}

}  // namespace

const Outputs* begin_body(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                          std::span<const Argument> arguments, const std::string& name, Scope& scope,
                          const std::function<Value(const ParamDecl&, Type)>& value_of) {
    scope.locals.reserve(function.params.size() + 8);
    Outputs outputs{.names = {}, .has_primary = function.result.name != "void"};
    std::vector<ir::Member> members;
    scope.result = type(emitter, function.result, scope);
    if (outputs.has_primary) {
        outputs.names.push_back("out");
        members.push_back({"value", scope.result});
    }
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const ParamDecl& param = function.params[i];
        Type param_type = type(emitter, param.type, scope);
        if (param_type.is_error()) {
            scope.result = Type::error();
            return nullptr;
        }
        if (is_view_of(emitter, arguments[i].value.type, param_type)) param_type = arguments[i].value.type;
        Local local{.name = param.name, .value = {}, .is_const = param.is_const, .constant = {}};
        if (param.is_out) {
            outputs.names.emplace_back(param.name);
            members.push_back({std::string(param.name), param_type});
            local.value = {.value = param.is_inout ? value_of(param, param_type) : scope.builder->zero(param_type),
                           .type = param_type};
        } else if (param.is_const && !param_type.is_scalar()) {
            emitter.diagnostics.report(Code::TypeMismatch, param.span, fmt::format("the constant '{}'", param.name),
                                       emitter.module.type_name(param_type), "an enum, a bool or a number");
            scope.result = Type::error();
            return nullptr;
        } else if (param.is_const) {
            local.constant = arguments[i].constant;
            local.value = {.value = scope.builder->constant(param_type, {*local.constant}), .type = param_type};
            if (const EnumDecl* enumeration = home.enumeration(param.type.name))
                local.value.enumerators = &enumeration->values;
        } else {
            local.value = {.value = value_of(param, param_type), .type = param_type};
        }
        scope.locals.push_back(std::move(local));
    }
    if (members.size() == 1 && outputs.has_primary) return nullptr;
    emitter.module.structs.push_back({.name = name + "Result", .members = std::move(members)});
    scope.result = Type::structure(static_cast<std::uint32_t>(emitter.module.structs.size() - 1));
    return keep(emitter, std::move(outputs));
}

const Statements& sound_body_of(Emitter& emitter, const FunctionDecl& function) {
    const Diagnostics* errors = nodelang::body_errors(function);
    if (errors && errors->has_errors()) {
        emitter.diagnostics.report(Code::Internal, function.name_span,
                                   fmt::format("the body of '{}' is wrong", function.name));
    }
    return nodelang::body_of(function);
}

const Instance& instantiate(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                            std::span<const Argument> arguments, unsigned width, bool half, Span call_span) {
    InstanceKey key{.function = &function, .width = width, .half = half};
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        if (function.params[i].is_const) key.constants.push_back(bits_as<std::uint64_t>(*arguments[i].constant));
        if (is_texture(emitter, arguments[i].value.type)) key.textures.push_back(arguments[i].value.type.ref);
    }
    if (const Instance* made = emitter.instances.find(key)) return *made;
    if (std::find(emitter.active.begin(), emitter.active.end(), &function) != emitter.active.end() ||
        emitter.active.size() >= kMaxCallDepth) {
        std::string chain;
        for (const FunctionDecl* caller : emitter.active) chain += fmt::format("{} > ", caller->name);
        emitter.diagnostics.report(Code::Recursion, call_span, chain + std::string(function.name));
        return emitter.instances.add(key, {.id = {}, .result = Type::error()});
    }
    emitter.active.push_back(&function);
    const unsigned answers = emitter.instances.passing_answers();
    Instance made =
        emit_function(emitter, function, home, arguments, width, half, instance_name(function, home, arguments, half));
    made.is_passing = emitter.instances.passing_answers() != answers;
    emitter.active.pop_back();
    return emitter.instances.add(key, made);
}

ir::FunctionId plain_function(Emitter& emitter, const FunctionDecl& function, const Declarations& home) {
    const std::vector<Argument> arguments(function.params.size());
    const Instance made = emit_function(emitter, function, home, arguments, 0, false, std::string(function.name));
    if (made.id) emitter.module[made.id].always_inline = true;
    return made.id;
}

ir::FunctionId semantic_function(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                                 Environment& environment, bool in_vertex_stage, bool* needs_quad) {
    Scope scope{.declarations = &home, .function = &function};
    scope.in_vertex_stage = in_vertex_stage;
    return outer_function(emitter, function, home, environment, std::move(scope), false, needs_quad);
}

ir::FunctionId given_function(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                              Environment& environment, bool half) {
    return outer_function(emitter, function, home, environment,
                          {.declarations = &home, .half = half, .function = &function}, true, nullptr);
}

const Outputs* keep(Emitter& emitter, Outputs outputs) {
    return &emitter.outputs.emplace_back(std::move(outputs));
}

}  // namespace patina::emit
