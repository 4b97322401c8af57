#include "compiler/nodelang/other_names.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"

namespace patina::nodelang {
namespace {

struct OtherName {
    std::string_view other, own;
};
// Words of the language itself. A node has its other names in its file: [also("mix")].
constexpr OtherName kOtherNames[] = {
    // GLSL
    {"mix", "lerp"},
    {"fract", "frac"},
    {"inversesqrt", "rsqrt"},
    {"dFdx", "ddx"},
    {"dFdy", "ddy"},
    {"mod", "x - y * floor(x / y)"},
    {"vec2", "float2"},
    {"vec3", "float3"},
    {"vec4", "float4"},
    {"ivec2", "int2"},
    {"ivec3", "int3"},
    {"ivec4", "int4"},
    {"uvec2", "uint2"},
    {"uvec3", "uint3"},
    {"uvec4", "uint4"},
    {"mat3", "float3x3"},
    {"mat4", "float4x4"},
    {"sampler2D", "Texture2D"},
    {"samplerCube", "TextureCube"},
    // HLSL and Unity
    {"mad", "a * b + c"},
    {"fixed", "half"},
    {"fixed3", "float3"},
    {"fixed4", "float4"},
    {"real", "half"},
    {"clamp01", "saturate"},
    // C and C++
    {"fabs", "abs"},
    {"fmin", "min"},
    {"fmax", "max"},
    {"double", "float"},
    {"unsigned", "uint"},
    {"boolean", "bool"},
    // MaterialX
    {"absval", "abs"},
    {"ln", "log"},
    {"magnitude", "length"},
    {"dotproduct", "dot"},
    {"crossproduct", "cross"},
    {"ifgreater", "a > b ? x : y"},
    {"ifgreatereq", "a >= b ? x : y"},
    {"ifequal", "a == b ? x : y"},
    {"color3", "float3"},
    {"color4", "float4"},
    {"vector2", "float2"},
    {"vector3", "float3"},
    {"vector4", "float4"},
    {"integer", "int"},
};

}  // namespace

std::string_view own_word(std::string_view word) {
    const auto found = std::find_if(std::begin(kOtherNames), std::end(kOtherNames),
                                    [&](const OtherName& row) { return row.other == word; });
    return found == std::end(kOtherNames) ? std::string_view() : found->own;
}

const FunctionDecl* known_as(const Declarations& declarations, std::string_view word) {
    const std::string plain = spelled_alike(word);
    const FunctionDecl* found = nullptr;
    for (const Declarations* scope = &declarations; scope; scope = scope->parent) {
        for (const auto& [name, function] : scope->functions) {
            const Attribute* also = function->attribute("also");
            if (!also) continue;
            for (const Expr* each : also->args) {
                if (spelled_alike(each->text) == plain && (!found || name < found->name)) found = function;
            }
        }
    }
    return found;
}

std::string node_advice(std::string_view word, std::span<const std::string_view> known,
                        const Declarations& declarations) {
    if (const FunctionDecl* node = known_as(declarations, word))
        return fmt::format("'{}' is the node '{}' here", word, node->name);
    const std::string_view near = nearest(word, known);
    return near.empty() ? std::string() : fmt::format("did you mean '{}'?", near);
}

std::string advice(std::string_view word, std::span<const std::string_view> known, const Declarations& declarations) {
    const std::string_view own = own_word(word);
    return own.empty() ? node_advice(word, known, declarations) : fmt::format("'{}' is written '{}' here", word, own);
}

}  // namespace patina::nodelang
