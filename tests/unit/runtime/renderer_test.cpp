// The Vulkan renderer against hand-written shaders and a hand-made reflection, so that a fault of the compiler cannot
// hide a fault of the runtime. The validation layer is on, and any message fails the test.
#include "runtime/gpu/renderer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "patina/validate.h"

namespace patina::runtime {
namespace {

constexpr const char* kVertex = R"(#version 450
layout(location = 0) in vec3 positionOS;
layout(location = 1) in vec3 normalOS;
layout(location = 2) in vec4 tangentOS;
layout(location = 3) in vec2 uv0;
layout(location = 4) in vec4 color;
layout(set = 0, binding = 0) uniform Camera { mat4 worldToClip; vec3 cameraPositionWS; };
layout(set = 0, binding = 1) uniform Object { mat4 objectToWorld; };
layout(location = 0) out vec3 positionWS;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec4 tangent;
layout(location = 3) out vec2 uv;
layout(location = 4) out vec4 vertexColor;
void main() {
    vec4 position = objectToWorld * vec4(positionOS, 1);
    positionWS = position.xyz;
    normal = normalOS;
    tangent = tangentOS;
    uv = uv0;
    vertexColor = color;
    gl_Position = worldToClip * position;
}
)";

constexpr const char* kFragmentHead = R"(#version 450
layout(location = 0) in vec3 positionWS;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;
layout(location = 4) in vec4 vertexColor;
layout(set = 0, binding = 0) uniform Camera { mat4 worldToClip; vec3 cameraPositionWS; };
layout(set = 0, binding = 2) uniform Lights { int lightCount; vec4 lightPosition[16]; vec4 lightColor[16]; };
layout(set = 2, binding = 0) uniform Material {
    float _Amount; vec3 _Direction; vec4 _Tint; int _Mode; vec4 _MainTex_ST;
};
layout(set = 2, binding = 1) uniform texture2D _MainTex;
layout(set = 2, binding = 2) uniform sampler sampler_MainTex;
layout(location = 0) out vec4 result;
void main() { result = )";

BlockMember member(std::string name, std::string_view type, std::uint32_t offset, std::uint32_t count = 0) {
    BlockMember result;
    result.name = std::move(name);
    result.type = from_word<ValueType>(type).value();
    result.offset = offset;
    result.array_count = count;
    result.array_stride = count ? 16 : 0;
    return result;
}

Block block(std::string name, std::uint32_t set, std::uint32_t binding, std::uint32_t size,
            std::vector<BlockMember> members) {
    Block result;
    result.name = std::move(name);
    result.set = set;
    result.binding = binding;
    result.size = size;
    result.members = std::move(members);
    result.is_material = result.name == "Material";
    return result;
}

Property property(std::string name, PropertyType type, std::array<double, 4> value, std::uint32_t offset) {
    Property result;
    result.name = std::move(name);
    result.type = type;
    result.value = value;
    result.block = "Material";
    result.offset = offset;
    result.values = {"Dry", "Wet"};
    return result;
}

Reflection make_reflection() {
    Reflection r;
    r.blocks = {
        block("Camera", 0, 0, 80, {member("worldToClip", "float4x4", 0), member("cameraPositionWS", "float3", 64)}),
        block("Object", 0, 1, 64, {member("objectToWorld", "float4x4", 0)}),
        block("Lights", 0, 2, 528,
              {member("lightCount", "int", 0), member("lightPosition", "float4", 16, 16),
               member("lightColor", "float4", 272, 16)}),
        // Set 1 stays empty on purpose.
        block("Material", 2, 0, 80,
              {member("_Amount", "float", 0), member("_Direction", "float3", 16), member("_Tint", "float4", 32),
               member("_Mode", "int", 48), member("_MainTex_ST", "float4", 64)})};
    r.properties = {property("_Amount", PropertyType::Float, {0.25}, 0),
                    property("_Direction", PropertyType::Float3, {1, 2, 3}, 16),
                    property("_Tint", PropertyType::Color, {0.1, 0.2, 0.3, 0.4}, 32),
                    property("_Mode", PropertyType::Enum, {0}, 48),
                    property("_MainTex", PropertyType::Texture2D, {}, 0)};
    Texture texture;
    texture.name = "_MainTex";
    texture.tiling = "_MainTex_ST";
    texture.default_texture = TextureDefault::White;
    texture.set = 2;
    texture.binding = 1;
    texture.sampler_binding = 2;
    r.textures = {texture};
    Pass pass;
    pass.name = "forward";
    pass.targets.resize(1);
    const char* inputs[] = {"positionOS", "normalOS", "tangentOS", "uv0", "vertexColor"};
    for (std::uint32_t i = 0; i < 5; i++) pass.vertex_inputs.push_back({inputs[i], ValueType::Float4, i, ""});
    pass.blocks = {"Camera", "Object", "Lights", "Material"};
    pass.textures = {"_MainTex"};
    r.passes = {pass};
    return r;
}

std::vector<std::uint32_t> compiled(Stage stage, const std::string& text) {
    Shader shader;
    shader.stage = stage;
    shader.text = text;
    Validated validated = validate(shader);
    EXPECT_TRUE(validated.ok) << validated.log;
    return validated.spirv;
}

class RendererTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        auto opened = Renderer::open({.validation = true});
        ASSERT_TRUE(opened) << opened.error;
        renderer = std::move(opened.value);
    }
    static void TearDownTestSuite() { renderer.reset(); }
    void TearDown() override {
        ASSERT_TRUE(renderer);
        EXPECT_EQ(renderer->messages(), std::vector<std::string>{});
    }

    // Draws with `expression` as the fragment's vec4.
    Image draw(const std::string& expression) {
        auto values = material_values(reflection, words);
        EXPECT_TRUE(values) << values.error;
        std::vector<BlockBytes> blocks = fill_blocks(reflection, values.value, scene);
        std::vector<std::uint32_t> vertex = compiled(Stage::Vertex, kVertex);
        std::vector<std::uint32_t> fragment = compiled(Stage::Fragment, kFragmentHead + expression + "; }");
        auto image = renderer->draw({.reflection = &reflection,
                                     .scene = &scene,
                                     .blocks = blocks,
                                     .textures = textures,
                                     .vertex_spirv = vertex,
                                     .fragment_spirv = fragment});
        EXPECT_TRUE(image) << image.error;
        return image ? image.value : make_image(scene.width, scene.height);
    }
    // The one colour of a picture that is the same everywhere.
    std::vector<float> value_of(const std::string& expression) {
        scene = fullscreen_scene(2, 2);
        scene.lights = lights;
        std::vector<float> pixels = draw(expression).pixels;
        return {pixels.begin(), pixels.begin() + 4};
    }

    static inline std::unique_ptr<Renderer> renderer;
    Reflection reflection = make_reflection();
    std::map<std::string, std::string> words;
    std::vector<LoadedTexture> textures = load_textures(reflection, "", {}, true).textures;
    std::vector<Light> lights;
    Scene scene = fullscreen_scene(8, 4);
};

TEST_F(RendererTest, FullscreenDrawsEveryPixelAtItsCenter) {
    scene = fullscreen_scene(8, 4);
    Image image = draw("vec4(uv, gl_FragCoord.xy)");
    for (int y = 0; y < 4; y++) {
        for (int x = 0; x < 8; x++) {
            EXPECT_FLOAT_EQ(image.at(x, y)[0], (x + 0.5f) / 8);
            EXPECT_FLOAT_EQ(image.at(x, y)[1], (y + 0.5f) / 4);
            EXPECT_EQ(image.at(x, y)[2], x + 0.5f);
            EXPECT_EQ(image.at(x, y)[3], y + 0.5f);
        }
    }
}

TEST_F(RendererTest, FillsPropertiesAtTheirOffsets) {
    EXPECT_EQ(value_of("vec4(_Amount, _Direction)"), (std::vector<float>{0.25f, 1, 2, 3}));
    EXPECT_EQ(value_of("_Tint"), (std::vector<float>{0.1f, 0.2f, 0.3f, 0.4f}));
    words = {{"_Amount", "0.5"},
             {"_Direction", "4,5,6"},
             {"_Tint", "#ff0000"},
             {"_Mode", "Wet"},
             {"_MainTex_ST", "2,3,4,5"}};
    EXPECT_EQ(value_of("vec4(_Amount, _Direction)"), (std::vector<float>{0.5f, 4, 5, 6}));
    EXPECT_EQ(value_of("_Tint"), (std::vector<float>{1, 0, 0, 1}));
    EXPECT_EQ(value_of("vec4(_Mode)"), (std::vector<float>{1, 1, 1, 1}));
    EXPECT_EQ(value_of("_MainTex_ST"), (std::vector<float>{2, 3, 4, 5}));
}

TEST_F(RendererTest, FillsLightsDirectionalFirst) {
    lights = {{.kind = LightKind::Point, .position = {1, 2, 3}, .color = {4, 5, 6}, .range = 7},
              {.direction = {0, 2, 0}, .color = {8, 9, 10}}};
    EXPECT_EQ(value_of("vec4(lightCount)")[0], 2);
    EXPECT_EQ(value_of("lightPosition[0]"), (std::vector<float>{0, 1, 0, 0}));
    EXPECT_EQ(value_of("vec4(lightColor[0].rgb, 0)"), (std::vector<float>{8, 9, 10, 0}));
    EXPECT_EQ(value_of("lightPosition[1]"), (std::vector<float>{1, 2, 3, 1}));
    EXPECT_EQ(value_of("lightColor[1]"), (std::vector<float>{4, 5, 6, 7}));
}

TEST_F(RendererTest, PictureIsUprightAndFrontsAreCounterClockwise) {
    scene = default_scene("sphere");
    scene.width = scene.height = 64;
    scene.background = glm::vec4(-9);
    Image image = draw("vec4(positionWS, gl_FrontFacing ? 1 : 0)");
    EXPECT_GT(image.at(32, 8)[1], 0.5f);  // up is up
    EXPECT_LT(image.at(32, 56)[1], -0.5f);
    EXPECT_LT(image.at(8, 32)[0], -0.5f);  // left is left
    EXPECT_GT(image.at(32, 32)[2], 0.9f);  // the near side
    EXPECT_EQ(image.at(32, 32)[3], 1);
    EXPECT_EQ(image.at(0, 0)[0], -9);

    reflection.passes[0].cull = Cull::Front;
    Image inside = draw("vec4(positionWS, gl_FrontFacing ? 1 : 0)");
    EXPECT_LT(inside.at(32, 32)[2], -0.9f);
    EXPECT_EQ(inside.at(32, 32)[3], 0);

    reflection.passes[0].cull = Cull::Off;  // now the depth test alone decides
    EXPECT_GT(draw("vec4(positionWS, 1)").at(32, 32)[2], 0.9f);
    reflection.passes[0].depth_test = Compare::Always;
    reflection.passes[0].cull = Cull::Back;
    EXPECT_GT(draw("vec4(positionWS, 1)").at(32, 32)[2], 0.9f);
    reflection.passes[0].depth_test = Compare::Never;
    EXPECT_EQ(draw("vec4(positionWS, 1)").at(32, 32)[2], -9);
}

TEST_F(RendererTest, ObjectMatrixMovesTheObject) {
    scene = default_scene("plane");
    scene.width = scene.height = 32;
    scene.object_to_world[3] = glm::vec4(0, 0, 0.5f, 1);
    EXPECT_NEAR(draw("vec4(positionWS, 1)").at(16, 16)[2], 0.5f, 1e-6);
}

TEST_F(RendererTest, VertexColorsAreWhite) {
    EXPECT_EQ(value_of("vertexColor"), (std::vector<float>{1, 1, 1, 1}));
    EXPECT_EQ(value_of("tangent"), (std::vector<float>{1, 0, 0, 1}));
    EXPECT_EQ(value_of("vec4(normal, 0)"), (std::vector<float>{0, 0, 1, 0}));
}

TEST_F(RendererTest, SamplesAreAveraged) {
    scene = fullscreen_scene(4, 4);
    scene.samples = 4;
    // Each pixel holds samples at 1/8, 3/8, 5/8 and 7/8 of its width: their squares average to 21/64.
    Image image = draw("vec4(fract(uv.x * 4) * fract(uv.x * 4), 0, 0, 1)");
    EXPECT_EQ(image.width, 4);
    EXPECT_NEAR(image.at(2, 1)[0], 21.0 / 64, 1e-6);
}

TEST_F(RendererTest, TexturesArriveWithTheirMipLevels) {
    Image texels = make_image(2, 2);
    for (int i = 0; i < 4; i++) texels.pixels[4 * std::size_t(i)] = float(i) / 4;
    TextureData data{.levels = mip_chain(texels), .sampler = {.wrap = Wrap::Clamp, .filter = Filter::Nearest}};
    textures = {{.name = "_MainTex", .data = std::make_shared<const TextureData>(data)}};
    scene = fullscreen_scene(2, 2);
    Image image = draw("textureLod(sampler2D(_MainTex, sampler_MainTex), uv, 0)");
    for (int i = 0; i < 4; i++) EXPECT_EQ(image.at(i % 2, i / 2)[0], float(i) / 4);
    EXPECT_EQ(value_of("textureLod(sampler2D(_MainTex, sampler_MainTex), uv, 1)")[0], 6 / 16.0f);
}

TEST_F(RendererTest, EightBitFormatsHoldTheirFilesNumbers) {
    float linear = srgb_decode(200 / 255.0f);
    for (TexelFormat format : {TexelFormat::Srgb8, TexelFormat::Unorm8}) {
        bool is_color = format == TexelFormat::Srgb8;
        float stored = is_color ? linear : 200 / 255.0f;
        TextureData data{.levels = mip_chain(make_image(1, 1, stored, stored, stored, 100 / 255.0f)), .sampler = {}};
        textures = {{.name = "_MainTex", .data = std::make_shared<const TextureData>(data), .format = format}};
        std::vector<float> value = value_of("texture(sampler2D(_MainTex, sampler_MainTex), uv)");
        // Software decodes sRGB with a small polynomial.
        EXPECT_NEAR(value[0], stored, is_color ? 3e-3 : 1e-6);
        EXPECT_NEAR(value[3], 100 / 255.0f, 1e-6);
    }
}

// Such a branch on the fourth uniform buffer crashes lavapipe (Mesa 22.3), if the shader has more than 100 values.
TEST_F(RendererTest, BranchesOnAUniform) {
    std::string rounds;
    float expected = 0.5f;
    for (int i = 0; i < 30; i++) {
        rounds += "v = 0.5 * sin(v) + cos(v); ";
        expected = 0.5f * std::sin(expected) + std::cos(expected);
    }
    EXPECT_NEAR(value_of("vec4(0); float v = 0.25 + uv.x; if (v > _Tint.g) { " + rounds + "} result = vec4(v)")[0],
                expected, 1e-4);
}

TEST_F(RendererTest, BlendsAsThePassSays) {
    reflection.passes[0].targets[0].blend.source = BlendFactor::SourceAlpha;
    reflection.passes[0].targets[0].blend.destination = BlendFactor::OneMinusSourceAlpha;
    scene = fullscreen_scene(2, 2);
    scene.background = {1, 0, 0, 1};
    EXPECT_NEAR(draw("vec4(0, 1, 0, 0.25)").at(0, 0)[0], 0.75f, 1e-6);
    EXPECT_NEAR(draw("vec4(0, 1, 0, 0.25)").at(0, 0)[1], 0.25f, 1e-6);
}

TEST_F(RendererTest, WhatCannotBeDrawnIsAnError) {
    struct Case {
        const char* expected;
        void (*spoil)(Reflection&, Scene&);
    };
    for (Case each :
         {Case{"no pass 'forward'", [](Reflection&r, Scene&) { r.passes[0].name = "other"; }},
          Case{"writes 3 targets", [](Reflection&r, Scene&) { r.passes[0].targets.resize(3); }},
          Case{"does not draw meshes", [](Reflection&r, Scene&) { r.passes[0].draws = PassDraws::Fullscreen; }},
          Case{"no vertex input 'wind'", [](Reflection&r, Scene&) { r.passes[0].vertex_inputs[0].name = "wind"; }},
          Case{"the block 'Fog' is not filled",
               [](Reflection&r, Scene&) { r.blocks.push_back(block("Fog", 3, 0, 16, {})); }},
          Case{"is not between 1 and", [](Reflection&, Scene&s) { s.width = 0; }},
          Case{"is not between 1 and", [](Reflection&, Scene&s) { s.samples = 10000; }},
          Case{"no mesh", [](Reflection&, Scene&s) { s.mesh = {}; }}}) {
        Reflection spoiled = make_reflection();
        Scene spoiled_scene = fullscreen_scene(4, 4);
        each.spoil(spoiled, spoiled_scene);
        auto values = material_values(reflection, {});
        auto blocks = fill_blocks(reflection, values.value, fullscreen_scene(4, 4));
        auto vertex = compiled(Stage::Vertex, kVertex),
             fragment = compiled(Stage::Fragment, kFragmentHead + std::string("_Tint; }"));
        auto image = renderer->draw({.reflection = &spoiled,
                                     .scene = &spoiled_scene,
                                     .blocks = blocks,
                                     .textures = textures,
                                     .vertex_spirv = vertex,
                                     .fragment_spirv = fragment});
        ASSERT_FALSE(image) << each.expected;
        EXPECT_NE(image.error.find(each.expected), std::string::npos) << image.error;
    }
}

TEST(Words, ThatAreWrongListWhatThereIs) {
    struct Case {
        const char *name, *value, *expected;
    };
    Reflection reflection = make_reflection();
    for (Case each :
         {Case{"_Amout", "1", "no property '_Amout'; did you mean '_Amount'?"},
          Case{"_MainTex_S", "1", "did you mean '_MainTex_ST'?"},
          Case{"nothing like it", "1", "these exist: _Amount, _Direction, _Tint, _Mode, _MainTex and _MainTex_ST"},
          Case{"_Amount", "a lot", "_Amount must be one number"}, Case{"_Amount", "1,2", "one number"},
          Case{"_Amount", "nan", "one number"}, Case{"_Direction", "1,2", "3 numbers"}, Case{"_Tint", "#12", "#rrggbb"},
          Case{"_Mode", "Moist", "one of Dry, Wet"}, Case{"_MainTex_ST", "2", "scale x, scale y"},
          Case{"_Other_ST", "1,1,0,0", "no property '_Other_ST'"}}) {
        auto values = material_values(reflection, {{each.name, each.value}});
        ASSERT_FALSE(values) << each.name;
        EXPECT_NE(values.error.find(each.expected), std::string::npos) << values.error;
    }
}

TEST(Words, OfAMatrixThatAreWrongSayItsForm) {
    Reflection reflection;
    reflection.properties.resize(2);
    reflection.properties[0].name = "_Turn";
    reflection.properties[0].type = PropertyType::Float2x2;
    reflection.properties[1].name = "_Frame";
    reflection.properties[1].type = PropertyType::Float3x3;
    const auto error = [&](const char* name, const char* value) {
        return material_values(reflection, {{name, value}}).error;
    };
    EXPECT_EQ(error("_Turn", "1,0,0,1"), "_Turn must be a matrix by rows, like [[1,0],[0,1]], not '1,0,0,1'");
    EXPECT_EQ(error("_Frame", "1"), "_Frame must be a matrix by rows, like [[1,0,0],[0,1,0],[0,0,1]], not '1'");
    EXPECT_TRUE(error("_Turn", "[[1, 0], [0]]").starts_with("_Turn: ")) << error("_Turn", "[[1, 0], [0]]");
    EXPECT_EQ(error("_Turn", "[[1, 2], [3, 4]]"), "");
}

TEST(Words, MeetTheRangesOfTheirProperties) {
    Reflection reflection = make_reflection();
    reflection.properties[0].range = {0.1, 1};
    reflection.properties[1].range = {0.1, 1};
    reflection.properties[1].hard = true;
    for (const char* inside : {"0.1", "1", "0.5"}) {
        auto values = material_values(reflection, {{"_Amount", inside}, {"_Direction", inside}});
        ASSERT_TRUE(values) << values.error;
        EXPECT_TRUE(values.value.warnings.empty()) << inside;
    }
    auto soft = material_values(reflection, {{"_Amount", "1.5"}});
    ASSERT_TRUE(soft) << soft.error;
    EXPECT_EQ(soft.value.numbers["_Amount"][0], 1.5);
    EXPECT_EQ(soft.value.warnings, std::vector<std::string>{"1.5 is outside the usual range 0.1 to 1 of '_Amount'"});
    auto hard = material_values(reflection, {{"_Direction", "1,0,1"}});
    ASSERT_FALSE(hard);
    EXPECT_EQ(hard.error, "0 is outside the range 0.1 to 1 of '_Direction'");
}

TEST(OpenDevice, AnUnknownNameListsTheDevices) {
    auto opened = Renderer::open({.device = "no such device"});
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.error.find("no Vulkan device is called 'no such device'; there are: "), std::string::npos)
        << opened.error;
}

}  // namespace
}  // namespace patina::runtime
