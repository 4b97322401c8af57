// The functions of two materials, pasted into one shader that somebody wrote by hand: its light loop, its surroundings
// and its blocks are its own, and the pictures are those of the forward pass.
#include <gtest/gtest.h>

#include <algorithm>

#include "patina/validate.h"
#include "runtime/gpu/renderer.h"
#include "runtime/picture/compare.h"
#include "runtime/values/material_values.h"
#include "runtime/values/textures.h"

namespace patina::runtime {
namespace {

// Textured, moved in the vertex stage, lit by the split sum.
constexpr const char* kRock = R"json({
  "patina": 1,
  "workflow": "metallic-roughness",
  "lighting": "gltf",
  "properties": [
    { "name": "_MainTex", "type": "texture2d", "usage": "color", "default": "./textures/rock_color.png" },
    { "name": "_Height", "type": "float", "default": 0.08 },
    { "name": "_Roughness", "type": "float", "default": 0.4 }
  ],
  "nodes": [
    { "id": "albedo", "node": "SampleTexture2D", "in": { "texture": "$_MainTex" } },
    { "id": "lifted", "expr": "@positionOS + @normalOS * (sin(@positionOS.x * 9 + @time) * $_Height)"
}
  ],
  "vertex": { "positionOS": "lifted" },
  "surface": {
      "baseColor" : "albedo.rgb", "metallic" : "albedo.g", "roughness" : "$_Roughness"
  }
  })json";

// The same names of properties and of nodes, another workflow, another lighting, transparent.
constexpr const char* kGlass = R"json({
  "patina": 1,
  "workflow": "specular-glossiness",
  "lighting": "unity-brdf1",
  "properties": [
    { "name": "_Roughness", "type": "float", "default": 0.25 },
    { "name": "_Tint", "type": "color", "default": "#4080c0a0" }
  ],
  "nodes": [ { "id": "albedo", "expr": "$_Tint.rgb * (0.5 + 0.5 * @uv0.x)"
  } ],
  "surface": { "baseColor": "albedo", "specular": "= float3(0.1, 0.2, 0.3)", "glossiness": "= 1 - $_Roughness",
               "alpha": "= $_Tint.a" },
  "render": {
      "surface" : "transparent"
  }
  })json";

// Except for these, the shader's author uses only features that both languages have.
constexpr const char* kGlslHead = R"(#version 450
#define float2 vec2
#define float3 vec3
#define float4 vec4
#define float4x4 mat4
#define mul(m, v) ((m) * (v))
#define saturate(x) clamp(x, 0.0, 1.0)
#define SAMPLE(kind, name, at, level) textureLod(sampler##kind(name, name##Sampler), at, level)
layout(set = 0, binding = 0, std140) uniform Engine {
    float4x4 worldToClip;
    float4x4 objectToWorld;
    float4x4 worldToObject;
    float3 cameraPositionWS;
    int lightCount;
    float4 lightPosition[16];
    float4 lightColor[16];
    float4 ambientSH[9];
    float time;
};
layout(set = 0, binding = 1) uniform textureCube environmentMap;
layout(set = 0, binding = 2) uniform texture2D splitSumTable;
layout(set = 0, binding = 3) uniform sampler environmentMapSampler;
layout(set = 0, binding = 4) uniform sampler splitSumTableSampler;
)";
constexpr const char* kHlslHead = R"(
#define SAMPLE(kind, name, at, level) name.SampleLevel(name##Sampler, at, level)
cbuffer Engine : register(b0, space0) {
    float4x4 worldToClip;
    float4x4 objectToWorld;
    float4x4 worldToObject;
    float3 cameraPositionWS;
    int lightCount;
    float4 lightPosition[16];
    float4 lightColor[16];
    float4 ambientSH[9];
    float time;
};
TextureCube environmentMap : register(t0, space0);
Texture2D splitSumTable : register(t1, space0);
SamplerState environmentMapSampler : register(s0, space0);
SamplerState splitSumTableSampler : register(s1, space0);
)";

// #NAME# is a call of that function with arguments that are called like its parameters; PREFIX is the material's.
constexpr const char* kVertexBody = R"(
float4 place(float3 positionOS, float3 normalOS, out float3 positionWS, out float3 vertexNormalWS) {
    positionOS = #vertexPositionOS#;
    positionWS = mul(objectToWorld, float4(positionOS, 1.0)).xyz;
    vertexNormalWS = normalize(mul(transpose(worldToObject), float4(normalOS, 0.0)).xyz);
    return mul(worldToClip, float4(positionWS, 1.0));
}
)";

// Spherical harmonics: Ramamoorthi and Hanrahan 2001, eq. 3 and 9, over pi. The light: docs/conventions.md.
constexpr const char* kFragmentBody = R"(
float3 AmbientIrradiance(float3 n) {
    float3 sum = 0.282095 * ambientSH[0].xyz;
    sum += 2.0 / 3.0 * 0.488603 * (ambientSH[1].xyz * n.y + ambientSH[2].xyz * n.z + ambientSH[3].xyz * n.x);
    sum += 0.25 * 1.092548 * (ambientSH[4].xyz * n.x * n.y + ambientSH[5].xyz * n.y * n.z);
    sum += 0.25 * 1.092548 * ambientSH[7].xyz * n.x * n.z;
    sum += 0.25 * 0.315392 * ambientSH[6].xyz * (3.0 * n.z * n.z - 1.0);
    sum += 0.25 * 0.546274 * ambientSH[8].xyz * (n.x * n.x - n.y * n.y);
    return max(sum, float3(0.0, 0.0, 0.0));
}

float3 EnvironmentRadiance(float3 direction, float roughness) {
    return SAMPLE(Cube, environmentMap, direction, 5.0 * roughness * (1.7 - 0.7 * roughness)).xyz;
}

SplitSumTableResult SplitSumTable(float roughness, float ndotv) {
    float2 place = float2(sqrt(saturate(ndotv)), saturate(roughness)) * (63.0 / 64.0) + 0.5 / 64.0;
    SplitSumTableResult result;
    result.scale = SAMPLE(2D, splitSumTable, place, 0.0).x;
    result.offset = SAMPLE(2D, splitSumTable, place, 0.0).y;
    return result;
}

float4 shade(float2 uv0, float3 positionWS, float3 vertexNormalWS) {
    float3 geometryNormalWS = normalize(vertexNormalWS);
    float3 viewDirWS = normalize(cameraPositionWS - positionWS);
    PREFIXLightingSurface surface = #lightingSurface#;
    PREFIXLightSum sum;
    sum.direct = float3(0.0, 0.0, 0.0);
    for (int i = 0; i < lightCount; i++) {
        float isLocal = lightPosition[i].w;
        float3 toLight = lightPosition[i].xyz - isLocal * positionWS;
        float distanceSquared = dot(toLight, toLight);
        float ratio = distanceSquared / (lightColor[i].w * lightColor[i].w);
        float window = saturate(1.0 - ratio * ratio);
        PREFIXLight light;
        light.direction = normalize(toLight);
        light.color = lightColor[i].xyz;
        light.attenuation = isLocal > 0.5 ? window * window / distanceSquared : 1.0;
        light.shadow = 1.0;
        light.index = i;
        light.type = int(isLocal);
        sum.direct += #direct#;
    }
    sum.indirect = #indirect#;
    return float4(#final#, surface.alpha);
}
)";

constexpr const char* kGlslVertexMain = R"(
layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec2 inUv;
layout(location = 0) out vec2 uv;
layout(location = 1) out vec3 position;
layout(location = 2) out vec3 normal;
void main() {
    uv = inUv;
    gl_Position = place(inPosition, inNormal, position, normal);
})";
constexpr const char* kGlslFragmentMain = R"(
layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 position;
layout(location = 2) in vec3 normal;
layout(location = 0) out vec4 color;
void main() { color = shade(uv, position, normal); })";
constexpr const char* kHlslVaryings = R"(
struct Varyings {
    float2 uv : TEXCOORD0;
    float3 position : TEXCOORD1;
    float3 normal : TEXCOORD2;
    float4 place : SV_Position;
};)";
constexpr const char* kHlslVertexMain = R"(
struct Vertex {
    float3 position : POSITION;
    float3 normal : NORMAL;
    float2 uv : TEXCOORD0;
};
Varyings main(Vertex vertex) {
    Varyings made;
    made.uv = vertex.uv;
    made.place = place(vertex.position, vertex.normal, made.position, made.normal);
    return made;
})";
constexpr const char* kHlslFragmentMain = R"(
float4 main(Varyings seen) : SV_Target0 { return shade(seen.uv, seen.position, seen.normal); })";

void replace_all(std::string& text, const std::string& word, const std::string& by) {
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + by.size())) {
        text.replace(at, word.size(), by);
    }
}

// A material: as functions, and as the forward pass that they are compared with.
struct Material {
    std::string prefix;
    Result functions, forward;

    std::string text(Stage stage, Target target) const {
        for (const Shader& shader : functions.shaders) {
            if (shader.stage == stage && shader.target == target) return shader.text;
        }
        return {};
    }
    // "Rock_direct(surface, light, viewDirWS)"; a function that the material lacks: `otherwise`.
    std::string call(const std::string& name, const std::string& otherwise) const {
        for (const ShaderFunction& function : functions.reflection.functions) {
            if (function.name != prefix + name) continue;
            std::string arguments;
            for (const ShaderFunction::Parameter& parameter : function.parameters)
                arguments += (arguments.empty() ? "" : ", ") + parameter.name;
            return function.name + "(" + arguments + ")";
        }
        return otherwise;
    }
};

class Pasting : public testing::Test {
protected:
    static void SetUpTestSuite() {
        auto opened = Renderer::open({.validation = true});
        ASSERT_TRUE(opened) << opened.error;
        renderer = std::move(opened.value);
        materials[0] = material("Rock_", kRock);
        materials[1] = material("Glass", kGlass);
    }
    static void TearDownTestSuite() { renderer.reset(); }
    void TearDown() override { EXPECT_EQ(renderer->messages(), std::vector<std::string>{}); }

    static Material material(const std::string& prefix, const std::string& text) {
        static const Compiler compiler;
        Material made{.prefix = prefix, .functions = {}, .forward = {}};
        CompileOptions options;
        made.forward = compiler.compile_text("examples/graphs/it.graph.json", text, options);
        options.request = CompileOptions::Functions{.prefix = prefix};
        made.functions = compiler.compile_text("examples/graphs/it.graph.json", text, options);
        for (const Diagnostic& d : made.functions.diagnostics) ADD_FAILURE() << to_text(d);
        EXPECT_TRUE(made.forward.ok && made.functions.ok);
        return made;
    }

    // Both materials are in the shader; `used` is drawn, and the other one has its bindings elsewhere.
    static Shader shader(std::size_t used, Stage stage, Target target) {
        const Material& material = materials[used];
        const bool is_hlsl = target == Target::Hlsl, is_vertex = stage == Stage::Vertex;
        std::string body = is_vertex ? kVertexBody : kFragmentBody;
        for (const char* name : {"vertexPositionOS", "lightingSurface", "direct", "indirect", "final"})
            replace_all(body, "#" + std::string(name) + "#", material.call(name, "positionOS"));
        replace_all(body, "PREFIX", material.prefix);
        Shader made;
        made.stage = stage;
        made.target = target;
        made.text = is_hlsl ? kHlslHead : kGlslHead;
        made.text += "#define " + materials[1 - used].prefix + "set " + (is_hlsl ? "space3\n" : "3\n");
        for (const Material& each : materials) made.text += each.text(stage, target) + "\n";
        if (is_hlsl) made.text += kHlslVaryings;
        made.text += body;
        made.text += is_hlsl ? (is_vertex ? kHlslVertexMain : kHlslFragmentMain)
                             : (is_vertex ? kGlslVertexMain : kGlslFragmentMain);
        made.hlsl_shifts = material.functions.reflection.hlsl_shifts;
        std::erase_if(made.hlsl_shifts, [](const Reflection::Shifts& shifts) { return shifts.set == 0; });
        made.hlsl_shifts.push_back({.set = 0, .textures = 1, .samplers = 3, .buffers = 0});
        made.hlsl_shifts.push_back({.set = 3, .textures = 8, .samplers = 16, .buffers = 0});
        return made;
    }

    static std::vector<std::uint32_t> spirv(const Shader& shader) {
        Validated validated = validate(shader);
        EXPECT_TRUE(validated.ok) << validated.log << shader.text;
        return validated.spirv;
    }

    // What the hand-written shader needs: the functions' own bindings, and one block that the engine made.
    static Reflection reflection(const Material& material) {
        Reflection made = material.functions.reflection;
        const Reflection& forward = material.forward.reflection;
        Block engine;
        engine.name = "Engine";
        engine.binding = 0;
        const auto add = [&](const char* name, std::uint32_t offset) {
            for (const Block& block : forward.blocks) {
                for (BlockMember member : block.members) {
                    if (member.name != name) continue;
                    member.offset = offset;
                    engine.members.push_back(member);
                }
            }
        };
        add("worldToClip", 0);
        add("objectToWorld", 64);
        add("worldToObject", 128);
        add("cameraPositionWS", 192);
        add("lightCount", 204);
        add("lightPosition", 208);
        add("lightColor", 464);
        add("ambientSH", 720);
        add("time", 864);
        EXPECT_EQ(engine.members.size(), 9u);
        engine.size = 880;
        made.blocks.push_back(engine);
        made.passes = {forward.passes.front()};
        Pass& pass = made.passes.front();
        pass.blocks = {"Engine"};
        pass.textures = {"environmentMap", "splitSumTable"};
        for (const Texture& texture : made.textures) pass.textures.push_back(texture.name);
        for (const Block& block : made.blocks) {
            if (block.is_material) pass.blocks.push_back(block.name);
        }
        for (Texture texture : forward.textures) {
            if (texture.name != "environmentMap" && texture.name != "splitSumTable") continue;
            texture.binding = texture.name == "environmentMap" ? 1 : 2;
            texture.sampler_binding = texture.binding + 2;
            made.textures.push_back(texture);
        }
        pass.vertex_inputs = {{"positionOS", ValueType::Float3, 0, ""},
                              {"normalOS", ValueType::Float3, 1, ""},
                              {"uv0", ValueType::Float2, 2, ""}};
        return made;
    }

    static Image draw(const Reflection& reflection, const std::vector<std::uint32_t>& vertex,
                      const std::vector<std::uint32_t>& fragment) {
        Scene scene = default_scene("sphere");
        scene.width = scene.height = 96;
        scene.time = 0.5f;
        scene.lights = {{.direction = {-0.5f, 0.7f, 1}, .color = glm::vec3(1, 0.9f, 0.8f)},
                        {.kind = LightKind::Point, .position = {1.5f, 0, 1.5f}, .color = glm::vec3(0.2f, 0.5f, 1)}};
        const auto values = material_values(reflection, {});
        EXPECT_TRUE(values) << values.error;
        LoadedTextures loaded = load_textures(reflection, "examples/graphs", {}, true);
        EXPECT_TRUE(loaded.errors.empty());
        add_engine_textures(loaded.textures, reflection, scene);
        const std::vector<BlockBytes> blocks = fill_blocks(reflection, values.value, scene);
        auto image = renderer->draw({.reflection = &reflection,
                                     .pass = "forward",
                                     .scene = &scene,
                                     .blocks = blocks,
                                     .textures = loaded.textures,
                                     .vertex_spirv = vertex,
                                     .fragment_spirv = fragment});
        EXPECT_TRUE(image) << image.error;
        return image ? image.value : make_image(1, 1);
    }

    static Image forward(const Material& material) {
        std::vector<std::uint32_t> stages[2];
        for (const Shader& each : material.forward.shaders) {
            if (each.target == Target::Glsl) stages[each.stage == Stage::Vertex ? 0 : 1] = spirv(each);
        }
        return draw(material.forward.reflection, stages[0], stages[1]);
    }

    static inline std::unique_ptr<Renderer> renderer;
    static inline Material materials[2];
};

TEST_F(Pasting, GivesThePictureOfTheForwardPass) {
    Image pictures[2];
    for (std::size_t used : {0, 1}) {
        const Image& expected = pictures[used] = forward(materials[used]);
        for (const Target& target : {Target::Glsl, Target::Hlsl}) {
            const Image received = draw(reflection(materials[used]), spirv(shader(used, Stage::Vertex, target)),
                                        spirv(shader(used, Stage::Fragment, target)));
            const Comparison difference = compare(expected, received, 1.0 / 255);
            EXPECT_TRUE(difference.same_size);
            EXPECT_EQ(difference.share, 0) << materials[used].prefix << target.name() << ", " << difference.largest
                                           << " at " << difference.worst_x << ", " << difference.worst_y;
        }
    }
    EXPECT_GT(compare(pictures[0], pictures[1], 1.0 / 255).share, 0.1);
}

// Whatever the text declares begins with the prefix, but for what the engine shares.
TEST_F(Pasting, TwoMaterialsShareOnlyWhatTheEngineProvides) {
    for (const ShaderFunction& function : materials[0].functions.reflection.functions)
        EXPECT_EQ(function.is_engines, !function.name.starts_with("Rock_")) << function.name;
    const Reflection& reflection = materials[0].functions.reflection;
    ASSERT_EQ(reflection.blocks.size(), 1u);
    EXPECT_EQ(reflection.blocks[0].name, "Rock_Material");
    EXPECT_EQ(reflection.blocks[0].members[0].name, "Rock_Height");
    ASSERT_EQ(reflection.textures.size(), 1u);
    EXPECT_EQ(reflection.textures[0].name, "_MainTex");
    EXPECT_EQ(reflection.textures[0].identifier, "Rock_MainTex");
    EXPECT_EQ(reflection.textures[0].sampler_name, "Rock_sampler_MainTex");
}

}  // namespace
}  // namespace patina::runtime
