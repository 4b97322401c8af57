#include "compiler/emit/operations/textures.h"

#include <algorithm>
#include <array>

#include "compiler/emit/operations/operations.h"
#include "compiler/ir/texture_kinds.h"

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

// "Texture2D", "Texture2D.bgra": only messages show it.
std::string type_name(ir::Kind kind, const TextureView& view) {
    std::string name(ir::texture_kind(kind)->name);
    if (view.channels != TextureView{}.channels) name.append(".").append(view.channels.data(), view.channels.size());
    return view.green_is_down ? name + ".directx" : name;
}

}  // namespace

Type texture_type(Emitter& emitter, ir::Kind kind, const TextureView& view) {
    const auto [made, is_new] = emitter.structures.textures.try_emplace({kind, view});
    if (is_new) {
        ir::Struct structure{.name = type_name(kind, view),
                             .members = {{"texture", Type::of(kind)}, {"sampler", Type::of(ir::Kind::Sampler)}}};
        if (kind == ir::Kind::Texture2D) {
            structure.members.push_back({"texelSize", ir::kFloat4});
            structure.members.push_back({"tiling", ir::kFloat4});
        }
        emitter.module.structs.push_back(std::move(structure));
        made->second = Type::structure(static_cast<std::uint32_t>(emitter.module.structs.size() - 1));
    }
    return made->second;
}

Typed make_texture(Emitter& emitter, const TextureParts& parts, Scope& scope) {
    ir::Builder& b = *scope.builder;
    const ir::Kind kind = b.type(parts.texture).kind;
    const Type bundle = texture_type(emitter, kind, parts.view);
    std::vector<Value> members = {parts.texture, parts.sampler};
    if (kind == ir::Kind::Texture2D) {
        members.push_back(parts.texel_size ? parts.texel_size : texel_size(parts.texture, scope));
        members.push_back(parts.tiling ? parts.tiling : b.constant(ir::kFloat4, {1, 1, 0, 0}));
    }
    return {.value = b.construct(bundle, members), .type = bundle};
}

namespace {

// What follows the place in a texture.
enum class Further { Nothing, Number, Derivatives };
struct Method {
    std::string_view name;
    Op op;
    Further further = Further::Nothing;
};
constexpr Method kMethods[] = {
    {"Sample", Op::Sample},
    {"SampleBias", Op::SampleBias, Further::Number},
    {"SampleLevel", Op::SampleLevel, Further::Number},
    {"SampleGrad", Op::SampleGrad, Further::Derivatives},
    {"Load", Op::TexelLoad},
    {"Size", Op::TextureSize},
};

// Single texels and sizes are those of one picture.
bool has_method(const ir::TextureKind& texture, const Method& method) {
    if (method.op == Op::TexelLoad) return texture.kind == ir::Kind::Texture2D;
    if (method.op == Op::TextureSize)
        return texture.kind == ir::Kind::Texture2D || texture.kind == ir::Kind::TextureCube;
    return true;
}

bool takes_sampler(Op op) {
    return op != Op::TexelLoad && op != Op::TextureSize;
}

// The types of the arguments behind the sampler.
std::vector<Type> parameters(const ir::TextureKind& texture, const Method& method) {
    if (method.op == Op::TexelLoad) return {Type::vector(Scalar::Int, 2), ir::kInt};
    if (method.op == Op::TextureSize) return {ir::kInt};
    std::vector<Type> made = {Type::vector(Scalar::Float, texture.coordinates)};
    if (method.further == Further::Number) made.push_back(ir::kFloat);
    if (method.further == Further::Derivatives)
        made.insert(made.end(), 2, Type::vector(Scalar::Float, texture.derivatives));
    return made;
}

struct TextureOfType {
    const ir::TextureKind* kind = nullptr;  // null: it is no texture
    TextureView view{};
};
TextureOfType texture_of(const Emitter& emitter, Type type) {
    for (const auto& [known, made] : emitter.structures.textures) {
        if (made == type) return {ir::texture_kind(known.first), known.second};
    }
    return {};
}

// What the view shows of a texel: neighbouring channels of the texel together, as one swizzle.
Value seen(const TextureView& view, Value texel, ir::Builder& b) {
    if (view == TextureView{}) return texel;
    std::vector<Value> parts;
    std::vector<unsigned> run;
    const auto end_run = [&] {
        if (!run.empty()) parts.push_back(b.swizzle(texel, run));
        run.clear();
    };
    for (std::size_t i = 0; i < view.channels.size(); ++i) {
        const std::size_t channel = std::string_view("rgba").find(view.channels[i]);
        const bool is_turned = view.green_is_down && i == 1;
        if (channel != std::string_view::npos && !is_turned) {
            run.push_back(static_cast<unsigned>(channel));
            continue;
        }
        end_run();
        Value part = channel == std::string_view::npos ? b.constant(ir::kFloat, {view.channels[i] == '1' ? 1.0 : 0.0})
                                                       : b.extract(texel, static_cast<std::uint32_t>(channel));
        if (is_turned) part = b.emit(Op::Sub, ir::kFloat, {b.constant(ir::kFloat, {1}), part});
        parts.push_back(part);
    }
    end_run();
    return parts.size() == 1 ? parts[0] : b.construct(ir::kFloat4, parts);
}

}  // namespace

Typed sampler_value(Emitter& emitter, const Expr& expr, Scope& scope) {
    const auto is_local = [&](const Local& local) { return local.name == expr.text; };
    const bool is_word = expr.kind == Expr::Kind::Name && scope.environment &&
                         std::none_of(scope.locals.begin(), scope.locals.end(), is_local);
    return primary(emitter, is_word ? scope.environment->sampler(expr, scope) : expression(emitter, expr, scope), scope,
                   expr.span);
}

Typed view_as(Emitter& emitter, const Expr& expr, Type wanted, Scope& scope, std::string_view what) {
    if (wanted.kind == ir::Kind::Sampler)
        return convert(emitter, sampler_value(emitter, expr, scope), wanted, scope, expr.span, what);
    if (!is_texture(emitter, wanted)) return expression_as(emitter, expr, wanted, scope, what);
    const Typed given = primary(emitter, expression(emitter, expr, scope), scope, expr.span);
    return is_view_of(emitter, given.type, wanted) ? given : convert(emitter, given, wanted, scope, expr.span, what);
}

bool is_texture(const Emitter& emitter, Type type) {
    return texture_of(emitter, type).kind != nullptr;
}

bool is_view_of(const Emitter& emitter, Type type, Type texture) {
    const ir::TextureKind* const kind = texture_of(emitter, type).kind;
    return kind && kind == texture_of(emitter, texture).kind;
}

// texture.Sample(uv), texture.Sample(sampler, uv), ...
Typed method(Emitter& emitter, const Expr& expr, Scope& scope) {
    const Typed object = primary(emitter, expression(emitter, *expr.args[0], scope), scope, expr.args[0]->span);
    if (!object.ok()) return {};
    const TextureOfType read = texture_of(emitter, object.type);
    const ir::TextureKind* const texture = read.kind;
    const auto* const row = std::find_if(std::begin(kMethods), std::end(kMethods), [&](const Method& m) {
        return texture && m.name == expr.text && has_method(*texture, m);
    });
    if (row == std::end(kMethods)) {
        DiagnosticRecord& record = emitter.diagnostics.report(Code::UnknownName, expr.name_span, "method", expr.text);
        if (texture) {
            std::vector<std::string_view> names;
            for (const Method& m : kMethods) {
                if (has_method(*texture, m)) names.push_back(m.name);
            }
            record.note(Diagnostics::suggestion(expr.text, names));
        } else {
            record.note(fmt::format("{} has no methods", emitter.module.type_name(object.type)));
        }
        return {};
    }
    ir::Builder& b = *scope.builder;
    const std::vector<Type> wanted = parameters(*texture, *row);
    std::span<const Expr* const> arguments = std::span(expr.args).subspan(1);
    std::vector<Value> operands{b.extract(object.value, 0)};
    Value sampler = b.extract(object.value, 1);
    if (takes_sampler(row->op) && arguments.size() == wanted.size() + 1) {
        const Typed given = sampler_value(emitter, *arguments[0], scope);
        if (!given.ok()) return {};
        if (given.type.kind != ir::Kind::Sampler) {
            emitter.diagnostics.report(Code::TypeMismatch, arguments[0]->span, "the first argument",
                                       emitter.module.type_name(given.type), "SamplerState");
            return {};
        }
        sampler = given.value;
        arguments = arguments.subspan(1);
    }
    if (scope.hlsl && row->op == Op::TexelLoad && arguments.size() == 1) {
        // HLSL: the texel and the level as one int3.
        const Typed at = expression_as(emitter, *arguments[0], Type::vector(Scalar::Int, 3), scope, "the texel");
        if (!at.ok()) return {};
        operands.push_back(b.swizzle(at.value, std::array{0u, 1u}));
        operands.push_back(b.extract(at.value, 2));
        return {.value = seen(read.view, b.emit(row->op, ir::kFloat4, operands), b), .type = ir::kFloat4};
    }
    if (arguments.size() != wanted.size()) {
        emitter.diagnostics.report(Code::ArgumentCount, expr.name_span, expr.text, wanted.size(), arguments.size());
        return {};
    }
    if (takes_sampler(row->op)) operands.push_back(sampler);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Typed value =
            expression_as(emitter, *arguments[i], wanted[i], scope, fmt::format("an argument of {}", expr.text));
        if (!value.ok()) return {};
        operands.push_back(value.value);
    }
    if (ir::has(row->op, ir::Derivative)) need_quad(emitter, scope, expr.span, expr.text, true);
    if (row->op == Op::TextureSize) {
        const Type size = Type::vector(Scalar::Int, 2);
        return {.value = b.emit(row->op, size, operands), .type = size};
    }
    return {.value = seen(read.view, b.emit(row->op, ir::kFloat4, operands), b), .type = ir::kFloat4};
}

}  // namespace patina::emit
