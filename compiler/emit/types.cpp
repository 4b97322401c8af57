#include "compiler/emit/types.h"

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/emit/constant_value.h"
#include "compiler/emit/operations/textures.h"
#include "compiler/ir/texture_kinds.h"
#include "compiler/nodelang/other_names.h"

namespace patina::emit {

using ir::Scalar;
using ir::Type;

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

Type type(Emitter& emitter, const TypeName& name, const Scope& scope) {
    Type base = numeric_type(name.name);
    if (base.kind != ir::Kind::Void) {
        // nothing to look up
    } else if (name.name == "floatN") {
        base = Type::vector(Scalar::Float, std::max(1u, scope.generic_width));
    } else if (const ir::TextureKind* texture = ir::texture_kind(name.name)) {
        base = texture_type(emitter, texture->kind);
    } else if (name.name == "SamplerState") {
        base = Type::of(ir::Kind::Sampler);
    } else if (name.name == "void") {
        return Type::none();
    }
    if (base.kind == ir::Kind::Void) {
        if (const StructDecl* decl = scope.declarations->structure(name.name)) {
            base = structure(emitter, *decl, *scope.declarations);
        } else if (scope.declarations->enumeration(name.name)) {
            base = ir::kInt;
        } else if (name.name.empty()) {
            return Type::error();  // that it is missing has been reported
        } else {
            std::vector<std::string_view> known = {"bool",   "int",    "uint",   "half",     "float",   "float2",
                                                   "float3", "float4", "floatN", "float3x3", "float4x4"};
            for (const ir::TextureKind& each : ir::kTextureKinds) known.push_back(each.name);
            const std::string advice = nodelang::word_advice(name.name);
            emitter.diagnostics.report(Code::UnknownType, name.span, name.name)
                .note(advice.empty() ? Diagnostics::suggestion(name.name, known) : advice);
            return Type::error();
        }
    }
    if (scope.half && base.is_numeric() && base.scalar == Scalar::Float) base = base.with_scalar(Scalar::Half);
    if (!name.array_size) return base;
    const std::optional<double> count = constant_value(emitter.known, *name.array_size, scope);
    if (!count || *count < 1 || *count > 4096 || *count != static_cast<std::uint32_t>(*count)) {
        emitter.diagnostics.report(Code::NotConstant, name.array_size->span, "the size of an array (1 to 4096)");
        return Type::error();
    }
    return emitter.module.array_of(base, static_cast<std::uint32_t>(*count));
}

Type structure(Emitter& emitter, const StructDecl& decl, const Declarations& home) {
    std::map<const StructDecl*, Type>& structs = emitter.structures.made;
    if (const auto found = structs.find(&decl); found != structs.end()) return found->second;
    structs[&decl] = Type::error();  // found again if the struct contains itself
    const Scope scope{.declarations = &home};
    ir::Struct made{.name = std::string(decl.name), .members = {}};
    for (const MemberDecl& member : decl.members) {
        const Type member_type = type(emitter, member.type, scope);
        if (member_type.is_error()) return Type::error();
        made.members.push_back({std::string(member.name), member_type});
    }
    const auto extra = emitter.known.extra_members.find(&decl);
    if (extra != emitter.known.extra_members.end()) {
        made.members.insert(made.members.end(), extra->second.begin(), extra->second.end());
    }
    emitter.module.structs.push_back(std::move(made));
    return structs[&decl] = Type::structure(static_cast<std::uint32_t>(emitter.module.structs.size() - 1));
}

}  // namespace patina::emit
