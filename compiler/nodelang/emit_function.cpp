// Function bodies: one IR function per combination of width, precision and constant arguments.
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>

#include "compiler/nodelang/emit.h"
#include "compiler/nodelang/parse.h"

namespace patina::nodelang {

using ir::Type;
using ir::Value;

namespace {

// Sub-graphs and functions may be written deep, but not endlessly so.
constexpr std::size_t kMaxCallDepth = 64;

// A body that was read only now must be as sound as one that was read with its file.
const Statements& body_of(const FunctionDecl& function, Diagnostics& diagnostics) {
    const Diagnostics* errors = body_errors(function);
    if (errors && errors->has_errors())
        diagnostics.report(Code::Internal, function.name_span, fmt::format("the body of '{}' is wrong", function.name));
    return nodelang::body_of(function);
}

}  // namespace

// A line at a time: a sentence ends with a full stop at the end of one.
std::string first_sentence(std::string_view doc) {
    std::string sentence;
    while (!doc.empty() && !sentence.ends_with('.')) {
        std::string_view line = doc.substr(0, doc.find('\n'));
        doc.remove_prefix(std::min(line.size() + 1, doc.size()));
        if (const std::size_t marker = line.find("///"); marker != std::string_view::npos)
            line.remove_prefix(marker + 3);
        if (sentence.empty()) line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        sentence += line;
    }
    return sentence;
}

const Emitter::Instance& Emitter::instantiate(const FunctionDecl& function, const Declarations& home,
                                              std::span<const Argument> arguments, unsigned width, bool half,
                                              Span call_span) {
    InstanceKey key{.function = &function, .width = width, .half = half, .constants = {}};
    std::string name(function.name);
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const ParamDecl& param = function.params[i];
        if (!param.is_const) continue;
        key.constants.push_back(std::bit_cast<std::uint64_t>(*arguments[i].constant));
        if (const EnumDecl* enumeration = home.enumeration(param.type.name)) {
            name += enumeration->values[static_cast<std::size_t>(*arguments[i].constant)];
        }
    }
    if (half && !function.attribute("foreign")) name += "Half";  // that is known by one name
    if (const auto found = instances_.find(key); found != instances_.end()) {
        if (found->second.is_passing) answers_for_now();
        return found->second;
    }
    if (std::find(active_.begin(), active_.end(), &function) != active_.end() || active_.size() >= kMaxCallDepth) {
        std::string chain;
        for (const FunctionDecl* caller : active_) chain += fmt::format("{} > ", caller->name);
        diagnostics_.report(Code::Recursion, call_span, chain + std::string(function.name));
        return instances_[key] = {.id = {}, .result = Type::error()};
    }
    active_.push_back(&function);
    const unsigned answers = passing_answers_;
    Instance made = emit_function(function, home, arguments, width, half, std::move(name));
    made.is_passing = passing_answers_ != answers;
    active_.pop_back();
    return instances_[key] = made;
}

void Emitter::forget_answers() {
    std::erase_if(instances_, [](const auto& entry) { return entry.second.is_passing; });
}

Emitter::Instance Emitter::emit_function(const FunctionDecl& function, const Declarations& home,
                                         std::span<const Argument> arguments, unsigned width, bool half,
                                         std::string name) {
    Instance instance;
    const std::size_t errors = diagnostics_.error_count();
    ir::Function made{};
    made.name = std::move(name);
    made.comment = first_sentence(function.doc);
    ir::Builder builder(module_, made, options_);
    Scope scope{.builder = &builder,
                .declarations = &home,
                .generic_width = width,
                .half = half,
                .function = &function,
                .needs_quad = &instance.needs_quad};
    scope.locals.reserve(function.params.size() + 8);
    made.params.reserve(function.params.size());
    Outputs outputs{.names = {}, .has_primary = function.result.name != "void"};
    std::vector<ir::Member> members;
    const Type primary_type = type(function.result, scope);
    if (outputs.has_primary) {
        outputs.names.push_back("out");
        members.push_back({"value", primary_type});
    }
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const ParamDecl& param = function.params[i];
        const Type param_type = type(param.type, scope);
        if (param_type.is_error()) return {.id = {}, .result = Type::error()};
        Local local{.name = param.name, .value = {}, .is_const = param.is_const, .constant = {}};
        if (param.is_out) {
            outputs.names.emplace_back(param.name);
            members.push_back({std::string(param.name), param_type});
            local.value = {.value = scope.builder->zero(param_type), .type = param_type};
        } else if (param.is_const) {
            local.constant = arguments[i].constant;
            local.value = {.value = builder.constant(param_type, {*local.constant}), .type = param_type};
            if (const EnumDecl* enumeration = home.enumeration(param.type.name))
                local.value.enumerators = &enumeration->values;
        } else {
            made.params.push_back({std::string(param.name), param_type, ir::Rate::Pixel});
            local.value = {.value = builder.param(static_cast<std::uint32_t>(made.params.size() - 1)),
                           .type = param_type};
        }
        scope.locals.push_back(std::move(local));
    }
    if (members.size() == 1 && outputs.has_primary) {
        instance.result = primary_type;
    } else {
        module_.structs.push_back({.name = made.name + "Result", .members = std::move(members)});
        instance.result = Type::structure(static_cast<std::uint32_t>(module_.structs.size() - 1));
        instance.outputs = intern(std::move(outputs));
    }
    scope.result = instance.result;
    made.result = instance.result;
    if (const Attribute* foreign = function.attribute("foreign")) {
        made.linkage = ir::Linkage::Foreign;
        made.spelling = attribute_text(*foreign);
        made.is_of_object = function.attribute("perObject") != nullptr;
        builder.ret(builder.zero(made.result));
        module_.functions.push_back(std::move(made));
        instance.id = {static_cast<std::uint32_t>(module_.functions.size() - 1)};
        return instance;
    }
    Value returned;
    const bool returns = statements(body_of(function, diagnostics_), 0, scope, returned);
    if (diagnostics_.error_count() != errors) return {.id = {}, .result = Type::error()};
    instance.rounds = scope.rounds;
    if (!returns) {
        if (function.result.name != "void") {
            diagnostics_.report(Code::MissingReturn, function.name_span, function.name);
            return {.id = {}, .result = Type::error()};
        }
        returned = return_value(nullptr, scope);
    }
    builder.ret(returned);
    module_.functions.push_back(std::move(made));
    instance.id = {static_cast<std::uint32_t>(module_.functions.size() - 1)};
    return instance;
}

ir::FunctionId Emitter::plain_function(const FunctionDecl& function, const Declarations& home) {
    const std::vector<Argument> arguments(function.params.size());
    const Instance made = emit_function(function, home, arguments, 0, false, std::string(function.name));
    if (made.id) module_[made.id].always_inline = true;
    return made.id;
}

ir::FunctionId Emitter::semantic_function(const FunctionDecl& function, const Declarations& home,
                                          Environment& environment, bool in_vertex_stage, bool* needs_quad) {
    Scope scope{.declarations = &home, .function = &function};
    scope.in_vertex_stage = in_vertex_stage;
    return outer_function(function, home, environment, std::move(scope), false, needs_quad);
}

ir::FunctionId Emitter::given_function(const FunctionDecl& function, const Declarations& home, Environment& environment,
                                       bool half) {
    return outer_function(function, home, environment, {.declarations = &home, .half = half, .function = &function},
                          true, nullptr);
}

// A function that can read semantics: they are the defaults of its parameters.
ir::FunctionId Emitter::outer_function(const FunctionDecl& function, const Declarations& home, Environment& environment,
                                       Scope scope, bool may_take, bool* needs_quad) {
    ir::Function made{};
    made.name = function.name;
    made.always_inline = true;
    ir::Builder builder(module_, made, options_);
    bool quad = false;
    scope.builder = &builder;
    scope.needs_quad = &quad;
    for (const ParamDecl& param : function.params) {
        const Type param_type = type(param.type, scope);
        if (!param.initial && may_take) {
            made.params.push_back({std::string(param.name), param_type, ir::Rate::Pixel});
            const Value value = builder.param(static_cast<std::uint32_t>(made.params.size() - 1));
            scope.locals.push_back(
                {.name = param.name, .value = {.value = value, .type = param_type}, .is_const = false, .constant = {}});
            continue;
        }
        if (!param.initial) {
            diagnostics_.report(Code::MissingInput, param.span, function.name, param.name)
                .note(
                    "nothing calls it with arguments: the default of a parameter is a semantic that it reads, "
                    "'float3 position = positionWS'");
            return {};
        }
        Scope outside{.builder = &builder, .declarations = &home, .environment = &environment};
        outside.in_vertex_stage = scope.in_vertex_stage;
        const Typed value = convert(default_value(*param.initial, home, outside, param_type), param_type, outside,
                                    param.initial->span, "the default");
        if (!value.ok()) return {};
        scope.locals.push_back({.name = param.name, .value = value, .is_const = false, .constant = {}});
        if (param.is_const) scope.locals.back().constant = constant_value(*param.initial, outside);
    }
    const bool is_void = function.result.name == "void";
    if (is_void) module_.structs.push_back({.name = made.name + "Result", .members = {}});
    made.result = scope.result = is_void ? Type::structure(static_cast<std::uint32_t>(module_.structs.size() - 1))
                                         : type(function.result, scope);
    Value returned;
    const std::size_t errors = diagnostics_.error_count();
    active_.push_back(&function);
    const bool returns = statements(body_of(function, diagnostics_), 0, scope, returned);
    active_.pop_back();
    if (diagnostics_.error_count() != errors) return {};
    if (!returns && !is_void) {
        diagnostics_.report(Code::MissingReturn, function.name_span, function.name);
        return {};
    }
    if (!returns) returned = return_value(nullptr, scope);
    builder.ret(returned);
    if (needs_quad) *needs_quad = quad;
    module_.functions.push_back(std::move(made));
    return {static_cast<std::uint32_t>(module_.functions.size() - 1)};
}

std::vector<InstanceInfo> Emitter::instances_of(const FunctionDecl& function) const {
    std::vector<InstanceInfo> made;
    for (const auto& [key, instance] : instances_) {
        if (key.function == &function && instance.id) made.push_back({.id = instance.id, .half = key.half});
    }
    return made;
}

const Slot* Emitter::find_slot(std::string_view name) const {
    const auto found = slots_.find(std::string(name));
    return found == slots_.end() ? nullptr : &found->second;
}

std::string_view Emitter::slot_name(ir::FunctionId function) const {
    for (const auto& [name, slot] : slots_) {
        if (slot.function == function) return name;
    }
    return {};
}

}  // namespace patina::nodelang
