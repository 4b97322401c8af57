#include "compiler/nodelang/other_names.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"

namespace patina::nodelang {
namespace {

constexpr std::string_view kTerrain = "a graph knows no terrain: declare a texture for each of its layers",
                           kDeformed = "the renderer deforms the mesh, and a graph reads the deformed vertices",
                           kInterface = "it draws Unity's user interface, and a graph is the material of a mesh";

// Words of the language itself, and values. A node has its other names in its file: [also("mix")].
constexpr OtherName kOtherNames[] = {
    // GLSL
    {"mix", "lerp"},
    {"fract", "frac"},
    {"inversesqrt", "rsqrt"},
    {"roundEven", "round"},
    {"atan/2", "atan2"},
    {"dFdx", "ddx"},
    {"dFdy", "ddy"},
    {"mod", "x - y * floor(x / y)"},
    {"fma", "a * b + c"},
    {"lessThan", "a < b"},
    {"lessThanEqual", "a <= b"},
    {"greaterThan", "a > b"},
    {"greaterThanEqual", "a >= b"},
    {"equal", "a == b"},
    {"notEqual", "a != b"},
    {"outerProduct", "float3x3(a.x * b, a.y * b, a.z * b)"},
    {"matrixCompMult", "", "multiply the rows: float3x3(a[0] * b[0], a[1] * b[1], a[2] * b[2])"},
    {"faceforward", "dot(i, g) < 0 ? n : -n"},
    {"modf", "x - trunc(x)", "the whole part is trunc(x)"},
    {"asinh", "log(x + sqrt(x * x + 1))"},
    {"acosh", "log(x + sqrt(x * x - 1))"},
    {"atanh", "0.5 * log((1 + x) / (1 - x))"},
    {"if", "c ? a : b", "an expression has no 'if'"},
    {"inverse", "", "a matrix has no 'inverse' here; if it only rotates, use 'transpose'"},
    {"vec2", "float2"},
    {"vec3", "float3"},
    {"vec4", "float4"},
    {"bvec2", "bool2"},
    {"bvec3", "bool3"},
    {"bvec4", "bool4"},
    {"ivec2", "int2"},
    {"ivec3", "int3"},
    {"ivec4", "int4"},
    {"uvec2", "uint2"},
    {"uvec3", "uint3"},
    {"uvec4", "uint4"},
    {"mat2", "float2x2"},
    {"mat3", "float3x3"},
    {"mat4", "float4x4"},
    {"sampler2D", "Texture2D"},
    {"samplerCube", "TextureCube"},
    {"SampleVirtualTexture", "",
     "a virtual texture needs an engine that streams its tiles: sample a texture of each layer"},
    {"gl_FragCoord", "@fragCoord"},
    {"gl_FrontFacing", "@frontFacing"},
    {"gl_VertexIndex", "@vertexId"},
    {"gl_VertexID", "@vertexId"},
    {"gl_InstanceIndex", "@instanceId"},
    {"gl_InstanceID", "@instanceId"},
    // HLSL and Unity
    {"mad", "a * b + c"},
    {"log10", "log(x) / log(10)"},
    {"sincos", "sin(x) and cos(x)"},
    {"dst", "float4(1, a.y * b.y, a.z, b.w)"},
    {"DotClamped", "saturate(dot(a, b))"},
    {"LerpWhiteTo", "lerp(1, b, t)"},
    {"LerpOneTo", "lerp(1, b, t)"},
    {"UNITY_LIGHT_ATTENUATION", "@light.attenuation * @light.shadow"},
    {"LIGHT_ATTENUATION", "@light.attenuation * @light.shadow"},
    {"SHADOW_ATTENUATION", "@light.shadow"},
    {"ComputeScreenPos", "@screenUV", "of this pixel, divided by w; for another point, use the node 'ScreenFromWorld'"},
    {"ComputeGrabScreenPos", "@screenUV", "of this pixel, divided by w"},
    {"clip", "", "a surface of the kind 'cutout' drops the pixels whose 'alpha' is below 'alphaClip'"},
    {"texCUBE", "",
     "the node 'SampleTextureCube' reads a property of the type 'textureCube', and 'EnvironmentRadiance' the "
     "environment"},
    {"fixed", "half"},
    {"fixed3", "float3"},
    {"fixed4", "float4"},
    {"real", "half"},
    {"clamp01", "saturate"},
    {"Vector2", "float2"},
    {"Vector3", "float3"},
    {"Vector4", "float4"},
    {"UNITY_PI", "PI"},
    {"UNITY_TWO_PI", "2 * PI"},
    {"UNITY_HALF_PI", "PI / 2"},
    {"_Time", "@time", "in seconds, as _Time.y"},
    {"_SinTime", "sin(@time)", "as _SinTime.w"},
    {"_CosTime", "cos(@time)", "as _CosTime.w"},
    {"_ScreenParams", "@screenSize", "its x and y"},
    {"_WorldSpaceCameraPos", "@cameraPositionWS"},
    {"_WorldSpaceLightPos0", "@light.direction", "the direction to the light, of every kind of light"},
    {"_LightColor0", "@light.color"},
    {"unity_ObjectToWorld", "", "no matrix is needed: read '@positionWS', '@normalWS' or '@tangentWS'"},
    {"unity_WorldToObject", "", "no matrix is needed: read '@positionOS', '@normalOS' or '@tangentOS'"},
    {"UnityObjectToClipPos", "", "the passes compute it: a graph gives \"positionOS\" in its block \"vertex\""},
    {"UnityObjectToViewPos", "@positionVS"},
    {"UnityObjectToWorldNormal", "@normalWS", "the mesh's normal, of unit length"},
    {"UnityObjectToWorldDir", "", "of the mesh, read '@normalWS', '@tangentWS' or '@bitangentWS'"},
    {"WorldSpaceViewDir", "@viewDirWS", "of unit length"},
    {"UnityWorldSpaceViewDir", "@viewDirWS", "of unit length"},
    {"ObjSpaceViewDir", "", "the direction to the camera is '@viewDirWS', in world space"},
    {"WorldSpaceLightDir", "@light.direction", "of unit length"},
    {"UnityWorldSpaceLightDir", "@light.direction", "of unit length"},
    // Unity's Shader Graph: nodes that are no nodes here
    {"Boolean", "", "write 'true' or 'false' at the port, or declare a property of the type 'bool'"},
    {"Property", "", "a graph reads a property by its name: '$_Tint'"},
    {"Keyword", "", "a keyword is a property with \"as\": \"variant\""},
    {"Dropdown", "", "a choice is a property of the type 'enum'; of a sub-graph, it is an input of the type 'int'"},
    {"SubGraph", "", "a sub-graph is a file: \"node\": \"./name.subgraph.json\""},
    {"Sub-graph", "", "a sub-graph is a file: \"node\": \"./name.subgraph.json\""},
    {"CustomFunction", "", "a function of your own is a file: \"node\": \"./name.node.hlsl\""},
    {"CustomInterpolator", "",
     "a node with \"stage\": \"vertex\" is computed for each vertex, and what reads it gets the interpolated value"},
    {"SamplerState", "",
     "a sampler is a word such as \"nearestClamp\" at the input 'sampler' of a node, or a property of the type "
     "'sampler'"},
    {"Texture2DAsset", "", "a texture is a property of the type 'texture2d', with the file as its default"},
    {"Texture2DArrayAsset", "", "a texture is a property of the type 'texture2dArray', with the file as its default"},
    {"Texture3DAsset", "", "a texture is a property of the type 'texture3d', with the file as its default"},
    {"CubemapAsset", "", "a texture is a property of the type 'textureCube', with the file as its default"},
    {"MatrixTranspose", "transpose(m)"},
    {"MatrixDeterminant", "determinant(m)"},
    {"Preview", "", "'patina render --node NAME' shows the value of a node"},
    {"BranchOnInputConnection", "",
     "no input knows whether it is connected: give a sub-graph an input of the type 'bool'"},
    {"Instance", "",
     "Unity shows a custom interpolator by this name, which is a node with \"stage\": \"vertex\"; the number of an "
     "instance is the node 'InstanceId'"},
    {"EyeIndex", "0", "a graph is drawn for one eye"},
    // Unity's Shader Graph: nodes of parts of that engine
    {"TerrainProperties", "", kTerrain},
    {"TerrainTexture", "", kTerrain},
    {"ComputeDeformation", "", kDeformed},
    {"LinearBlendSkinning", "", kDeformed},
    {"SpriteSkinning", "", kDeformed},
    {"ElementLayoutUV", "", kInterface},
    {"ElementTextureSize", "", kInterface},
    {"ElementTextureUV", "", kInterface},
    {"SampleElementTexture", "", kInterface},
    {"DefaultBitmapText", "", kInterface},
    {"DefaultGradient", "", kInterface},
    {"DefaultSDFText", "", kInterface},
    {"DefaultSolid", "", kInterface},
    {"DefaultTexture", "", kInterface},
    {"IsForcedGamma", "", kInterface},
    {"RenderType", "", kInterface},
    {"RenderTypeBranch", "", kInterface},
    // C and C++
    {"fabs", "abs"},
    {"fmin", "min"},
    {"fmax", "max"},
    {"M_PI", "PI"},
    {"pi", "PI"},
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
    {"ramplr", "lerp(left, right, saturate(@uv0.x))"},
    {"ramptb", "lerp(top, bottom, saturate(@uv0.y))"},
    {"splitlr", "@uv0.x < center ? left : right"},
    {"splittb", "@uv0.y < center ? top : bottom"},
    {"rotate3d", "RotateAboutAxis", "its angle is in radians"},
    {"screen", "BlendColors", "its mode is 'Screen'"},
    {"overlay", "BlendColors", "its mode is 'Overlay'"},
    {"burn", "BlendColors", "its mode is 'Burn'"},
    {"dodge", "BlendColors", "its mode is 'Dodge'"},
    {"difference", "abs(a - b)"},
    {"over", "a + b * (1 - a.a)"},
    {"plus", "a + b"},
    {"minus", "b - a", "MaterialX subtracts 'fg', which is a here, from 'bg'"},
    {"premult", "float4(c.rgb * c.a, c.a)"},
    {"unpremult", "float4(c.rgb / c.a, c.a)"},
    {"heighttonormal", "",
     "the node 'NormalFromTexture' reads a texture of heights, 'NormalFromHeight' takes a height"},
    {"triplanarprojection", "",
     "no node projects from three sides: sample at the yz, xz and xy of '@positionWS', and weigh the samples with "
     "the squares of '@normalWS'"},
    {"color3", "float3"},
    {"color4", "float4"},
    {"vector2", "float2"},
    {"vector3", "float3"},
    {"vector4", "float4"},
    {"integer", "int"},
};

std::string remark_of(const OtherName& row) {
    return row.remark.empty() ? std::string() : fmt::format(": {}", row.remark);
}

const OtherName* find_other(std::string_view word) {
    const auto found = std::find_if(std::begin(kOtherNames), std::end(kOtherNames),
                                    [&](const OtherName& row) { return row.other == word; });
    return found == std::end(kOtherNames) ? nullptr : found;
}

// The same, or one that differs in capitals, spaces and _ alone: people write the names of nodes in several ways.
const OtherName* find_alike(std::string_view word) {
    if (const OtherName* row = find_other(word)) return row;
    const std::string plain = spelled_alike(word);
    const auto found = std::find_if(std::begin(kOtherNames), std::end(kOtherNames),
                                    [&](const OtherName& row) { return spelled_alike(row.other) == plain; });
    return found == std::end(kOtherNames) ? nullptr : found;
}

}  // namespace

std::span<const OtherName> other_names() {
    return kOtherNames;
}

std::string word_advice(std::string_view word) {
    const OtherName* row = find_other(word);
    if (!row) return {};
    if (row->own.empty()) return std::string(row->remark);
    const std::string_view plain = word.substr(0, word.find('/'));
    return fmt::format("'{}' is written '{}' here{}", plain, row->own, remark_of(*row));
}

const FunctionDecl* known_as(const Declarations& declarations, std::string_view word) {
    const std::string plain = spelled_alike(word);
    const FunctionDecl* found = nullptr;
    for (const std::string_view name : declarations.function_names()) {
        const FunctionDecl* function = declarations.function(name);
        const Attribute* also = function ? function->attribute("also") : nullptr;
        if (!also) continue;
        for (const Expr* each : also->args) {
            if (spelled_alike(each->text) == plain && (!found || name < found->name)) found = function;
        }
    }
    return found;
}

std::string port_advice(std::string_view word, std::span<const std::string_view> known, const FunctionDecl* function) {
    if (known.empty()) return "it has no inputs";
    for (const ParamDecl& param : function ? std::span(function->params) : std::span<const ParamDecl>())
        for (const Attribute& attribute : param.attributes)
            for (const Expr* each : attribute.args)
                if (attribute.name == "also" && each->text == word)
                    return fmt::format("'{}' is the input '{}' here", word, param.name);
    return Diagnostics::suggestion(word, known);
}

std::string node_advice(std::string_view word, std::span<const std::string_view> known,
                        const Declarations& declarations) {
    if (const FunctionDecl* node = known_as(declarations, word))
        return fmt::format("'{}' is the node '{}' here", word, node->name);
    if (const OtherName* row = find_alike(word)) {
        if (row->own.empty()) return std::string(row->remark);
        if (declarations.function(row->own))
            return fmt::format("'{}' is the node '{}' here{}", word, row->own, remark_of(*row));
        return fmt::format("write an expression: \"expr\": \"{}\"{}", row->own, remark_of(*row));
    }
    const std::string_view near = nearest(word, known);
    return near.empty() ? std::string() : fmt::format("did you mean '{}'?", near);
}

std::string advice(std::string_view word, std::span<const std::string_view> known, const Declarations& declarations) {
    const std::string own = word_advice(word);
    return own.empty() ? node_advice(word, known, declarations) : own;
}

}  // namespace patina::nodelang
