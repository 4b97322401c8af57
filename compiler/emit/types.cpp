// The emitter's types: names of the language -> IR types, structs, and the texture bundle.
#include <algorithm>
#include <array>

#include "compiler/base/text.h"
#include "compiler/emit/emit.h"

namespace patina::nodelang {

using ir::Op;
using ir::Scalar;
using ir::Type;
using ir::Value;

namespace {

constexpr std::pair<std::string_view, Scalar> kScalars[] = {{"bool", Scalar::Bool},
                                                            {"int", Scalar::Int},
                                                            {"uint", Scalar::Uint},
                                                            {"half", Scalar::Half},
                                                            {"float", Scalar::Float}};

// "float3", "half", "float4x4"; Void if the word is none of them.
Type numeric_type(std::string_view word) {
    if (word.empty()) return Type::none();
    for (const auto& [name, scalar] : kScalars) {
        if (word[0] != name[0] || !word.starts_with(name)) continue;
        const std::string_view rest = word.substr(name.size());
        const auto digit = [](char c) { return c >= '1' && c <= '4' ? static_cast<unsigned>(c - '0') : 0u; };
        if (rest.empty()) return Type::scalar_of(scalar);
        if (rest.size() == 1 && digit(rest[0])) return Type::vector(scalar, digit(rest[0]));
        const bool matrix = rest.size() == 3 && rest[1] == 'x' && digit(rest[0]) > 1 && rest[0] == rest[2];
        if (matrix && (scalar == Scalar::Float || scalar == Scalar::Half)) {
            return Type::matrix(scalar, digit(rest[0]), digit(rest[2]));
        }
    }
    return Type::none();
}

}  // namespace

Emitter::Emitter(ir::Module& module, Diagnostics& diagnostics, ir::BuildOptions options)
    : module_(module), diagnostics_(diagnostics), options_(options) {}

const Outputs* Emitter::intern(Outputs outputs) {
    return &outputs_.emplace_back(std::move(outputs));
}

Type Emitter::type(const TypeName& name, const Scope& scope) {
    Type base = numeric_type(name.name);
    if (base.kind != ir::Kind::Void) {
        // nothing to look up
    } else if (name.name == "floatN") {
        base = Type::vector(Scalar::Float, std::max(1u, scope.generic_width));
    } else if (name.name == "Texture2D") {
        base = texture2d();
    } else if (name.name == "TextureCube") {
        base = texture_cube();
    } else if (name.name == "SamplerState") {
        base = Type::of(ir::Kind::Sampler);
    } else if (name.name == "void") {
        return Type::none();
    }
    if (base.kind == ir::Kind::Void) {
        if (const StructDecl* decl = scope.declarations->structure(name.name)) {
            base = structure(*decl, *scope.declarations);
        } else if (scope.declarations->enumeration(name.name)) {
            base = ir::kInt;
        } else {
            std::vector<std::string_view> known = {"bool",     "int",       "uint",       "half",   "float",
                                                   "float2",   "float3",    "float4",     "floatN", "float3x3",
                                                   "float4x4", "Texture2D", "TextureCube"};
            diagnostics_.report(Code::UnknownType, name.span, name.name)
                .note(Diagnostics::suggestion(name.name, known));
            return Type::error();
        }
    }
    if (scope.half && base.is_numeric() && base.scalar == Scalar::Float) base = base.with_scalar(Scalar::Half);
    if (!name.array_size) return base;
    const std::optional<double> count = constant_value(*name.array_size, scope);
    if (!count || *count < 1 || *count > 4096 || *count != static_cast<std::uint32_t>(*count)) {
        diagnostics_.report(Code::NotConstant, name.array_size->span, "the size of an array (1 to 4096)");
        return Type::error();
    }
    return module_.array_of(base, static_cast<std::uint32_t>(*count));
}

Type Emitter::structure(const StructDecl& decl, const Declarations& home) {
    const auto found = structs_.find(&decl);
    if (found != structs_.end()) return found->second;
    structs_[&decl] = Type::error();  // a struct that holds itself
    const Scope scope{.declarations = &home};
    ir::Struct made{.name = std::string(decl.name), .members = {}};
    for (const MemberDecl& member : decl.members) {
        const Type member_type = type(member.type, scope);
        if (member_type.is_error()) return Type::error();
        made.members.push_back({std::string(member.name), member_type});
    }
    const auto extension = extensions_.find(&decl);
    if (extension != extensions_.end()) {
        made.members.insert(made.members.end(), extension->second.begin(), extension->second.end());
    }
    module_.structs.push_back(std::move(made));
    return structs_[&decl] = Type::structure(static_cast<std::uint32_t>(module_.structs.size() - 1));
}

Type Emitter::texture2d() {
    if (!texture2d_) {
        module_.structs.push_back({.name = "Texture2D",
                                   .members = {{"texture", Type::of(ir::Kind::Texture2D)},
                                               {"sampler", Type::of(ir::Kind::Sampler)},
                                               {"texelSize", ir::kFloat4},
                                               {"tiling", ir::kFloat4}}});
        texture2d_ = Type::structure(static_cast<std::uint32_t>(module_.structs.size() - 1));
    }
    return *texture2d_;
}

Type Emitter::texture_cube() {
    if (!texture_cube_) {
        module_.structs.push_back(
            {.name = "TextureCube",
             .members = {{"texture", Type::of(ir::Kind::TextureCube)}, {"sampler", Type::of(ir::Kind::Sampler)}}});
        texture_cube_ = Type::structure(static_cast<std::uint32_t>(module_.structs.size() - 1));
    }
    return *texture_cube_;
}

bool Emitter::is_texture(Type type) const {
    return (texture2d_ && type == *texture2d_) || (texture_cube_ && type == *texture_cube_);
}

Value Emitter::texel_size(Value texture, Scope& scope) {
    ir::Builder& b = *scope.builder;
    const Value level = b.constant(ir::kInt, {0});
    const Value texels = b.emit(Op::TextureSize, Type::vector(Scalar::Int, 2), {texture, level});
    const Value size = b.convert(texels, Scalar::Float);
    const Value inverse = b.emit(Op::Div, ir::kFloat2, {b.splat_constant(ir::kFloat2, 1), size});
    return b.construct(ir::kFloat4, std::array{inverse, size});
}

Typed Emitter::make_texture(Value texture, Value sampler, Value texel_size, Value tiling, Scope& scope) {
    const Type bundle = texture2d();
    const std::array members{texture, sampler, texel_size, tiling};
    return {.value = scope.builder->construct(bundle, members), .type = bundle};
}

Typed Emitter::make_cube(Value texture, Value sampler, Scope& scope) {
    const Type bundle = texture_cube();
    return {.value = scope.builder->construct(bundle, std::array{texture, sampler}), .type = bundle};
}

}  // namespace patina::nodelang
