#include "compiler/emit/operations/textures.h"

#include <algorithm>
#include <array>

#include "compiler/emit/operations/operations.h"

namespace patina::emit {

using ir::Op;
using ir::Scalar;
using ir::Type;
using ir::Value;

namespace {

// (1/width, 1/height, width, height), asked of the texture.
Value texel_size(Value texture, Scope& scope) {
    ir::Builder& b = *scope.builder;
    const Value level = b.constant(ir::kInt, {0});
    const Value texels = b.emit(Op::TextureSize, Type::vector(Scalar::Int, 2), {texture, level});
    const Value size = b.convert(texels, Scalar::Float);
    const Value inverse = b.emit(Op::Div, ir::kFloat2, {b.splat_constant(ir::kFloat2, 1), size});
    return b.construct(ir::kFloat4, std::array{inverse, size});
}

}  // namespace

Type texture_type(Emitter& emitter) {
    if (!emitter.structures.texture2d) {
        emitter.module.structs.push_back({.name = "Texture2D",
                                          .members = {{"texture", Type::of(ir::Kind::Texture2D)},
                                                      {"sampler", Type::of(ir::Kind::Sampler)},
                                                      {"texelSize", ir::kFloat4},
                                                      {"tiling", ir::kFloat4}}});
        emitter.structures.texture2d = Type::structure(static_cast<std::uint32_t>(emitter.module.structs.size() - 1));
    }
    return *emitter.structures.texture2d;
}

Type cube_type(Emitter& emitter) {
    if (!emitter.structures.texture_cube) {
        emitter.module.structs.push_back(
            {.name = "TextureCube",
             .members = {{"texture", Type::of(ir::Kind::TextureCube)}, {"sampler", Type::of(ir::Kind::Sampler)}}});
        emitter.structures.texture_cube =
            Type::structure(static_cast<std::uint32_t>(emitter.module.structs.size() - 1));
    }
    return *emitter.structures.texture_cube;
}

bool is_texture(const Emitter& emitter, Type type) {
    return type == emitter.structures.texture2d || type == emitter.structures.texture_cube;
}

Typed make_texture(Emitter& emitter, const TextureParts& parts, Scope& scope) {
    const Value size = parts.texel_size ? parts.texel_size : texel_size(parts.texture, scope);
    const Type bundle = texture_type(emitter);
    const std::array members{parts.texture, parts.sampler, size, parts.tiling};
    return {.value = scope.builder->construct(bundle, members), .type = bundle};
}

Typed make_cube(Emitter& emitter, Value texture, Value sampler, Scope& scope) {
    const Type bundle = cube_type(emitter);
    return {.value = scope.builder->construct(bundle, std::array{texture, sampler}), .type = bundle};
}

// texture.Sample(uv), texture.Sample(sampler, uv), ...
Typed method(Emitter& emitter, const Expr& expr, Scope& scope) {
    struct Method {
        std::string_view name;
        Op op;
        std::array<Type, 3> params;
        std::size_t count;
        bool sampler;
    };
    static constexpr Method kMethods2D[] = {
        {"Sample", Op::Sample, {ir::kFloat2}, 1, true},
        {"SampleBias", Op::SampleBias, {ir::kFloat2, ir::kFloat}, 2, true},
        {"SampleLevel", Op::SampleLevel, {ir::kFloat2, ir::kFloat}, 2, true},
        {"SampleGrad", Op::SampleGrad, {ir::kFloat2, ir::kFloat2, ir::kFloat2}, 3, true},
        {"Load", Op::TexelLoad, {Type::vector(Scalar::Int, 2), ir::kInt}, 2, false},
        {"Size", Op::TextureSize, {ir::kInt}, 1, false},
    };
    static constexpr Method kMethodsCube[] = {
        {"Sample", Op::Sample, {ir::kFloat3}, 1, true},
        {"SampleBias", Op::SampleBias, {ir::kFloat3, ir::kFloat}, 2, true},
        {"SampleLevel", Op::SampleLevel, {ir::kFloat3, ir::kFloat}, 2, true},
        {"SampleGrad", Op::SampleGrad, {ir::kFloat3, ir::kFloat3, ir::kFloat3}, 3, true},
        {"Size", Op::TextureSize, {ir::kInt}, 1, false},
    };
    const Typed object = primary(emitter, expression(emitter, *expr.args[0], scope), scope, expr.args[0]->span);
    if (!object.ok()) return {};
    const std::span<const Method> methods = object.type == emitter.structures.texture_cube
                                                ? std::span<const Method>(kMethodsCube)
                                                : std::span<const Method>(kMethods2D);
    const auto row = std::find_if(methods.begin(), methods.end(), [&](const Method& m) { return m.name == expr.text; });
    if (!is_texture(emitter, object.type) || row == methods.end()) {
        DiagnosticRecord& record = emitter.diagnostics.report(Code::UnknownName, expr.name_span, "method", expr.text);
        if (is_texture(emitter, object.type)) {
            std::vector<std::string_view> names;
            for (const Method& m : methods) names.push_back(m.name);
            record.note(Diagnostics::suggestion(expr.text, names));
        } else {
            record.note(fmt::format("{} has no methods", emitter.module.type_name(object.type)));
        }
        return {};
    }
    ir::Builder& b = *scope.builder;
    std::span<const Expr* const> arguments = std::span(expr.args).subspan(1);
    std::vector<Value> operands{b.extract(object.value, 0)};
    Value sampler = b.extract(object.value, 1);
    if (row->sampler && arguments.size() == row->count + 1) {
        const Typed given = expression(emitter, *arguments[0], scope);
        if (!given.ok()) return {};
        if (given.type.kind != ir::Kind::Sampler) {
            emitter.diagnostics.report(Code::TypeMismatch, arguments[0]->span, "the first argument",
                                       emitter.module.type_name(given.type), "SamplerState");
            return {};
        }
        sampler = given.value;
        arguments = arguments.subspan(1);
    }
    if (arguments.size() != row->count) {
        emitter.diagnostics.report(Code::ArgumentCount, expr.name_span, expr.text, row->count, arguments.size());
        return {};
    }
    if (row->op != Op::TextureSize && row->op != Op::TexelLoad) operands.push_back(sampler);
    for (std::size_t i = 0; i < row->count; ++i) {
        const Typed value =
            expression_as(emitter, *arguments[i], row->params[i], scope, fmt::format("an argument of {}", expr.text));
        if (!value.ok()) return {};
        operands.push_back(value.value);
    }
    if (ir::has(row->op, ir::Derivative)) need_quad(emitter, scope, expr.span, expr.text, true);
    const Type result = row->op == Op::TextureSize ? Type::vector(Scalar::Int, 2) : ir::kFloat4;
    return {.value = b.emit(row->op, result, operands), .type = result};
}

}  // namespace patina::emit
