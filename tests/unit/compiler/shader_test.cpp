// Whole shaders: what a language lacks, declarations, comments, the line map, long graphs.
#include <algorithm>

#include "tests/unit/compiler/printer_fixture.h"

namespace patina::languages {
namespace {

constexpr Type kInt2 = Type::vector(Scalar::Int, 2);
constexpr Type kFloat3x3 = Type::matrix(Scalar::Float, 3, 3);

// --- what languages lack

TEST(Legalize, RemaindersHaveTheSignOfTheFirst) {
    Fixture f;
    f.finish(f.b->emit(Op::Mod, {f.b->param(0), f.b->param(1)}));
    EXPECT_EQ(f.body("glsl"), "return a - b * trunc(a / b);\n");
    EXPECT_EQ(f.body("hlsl"), "return a - b * trunc(a / b);\n");
    Fixture ints({kInt, kInt});
    EXPECT_EQ(ints.glsl(ints.b->emit(Op::Mod, {ints.b->param(0), ints.b->param(1)})), "return a - b * (a / b);\n");
    Fixture uints({kUint, kUint});
    EXPECT_EQ(uints.glsl(uints.b->emit(Op::Mod, {uints.b->param(0), uints.b->param(1)})), "return a % b;\n");
}

TEST(Legalize, SaturateIsHlsls) {
    Fixture f({kFloat3});
    f.finish(f.b->emit(Op::Saturate, {f.b->param(0)}));
    EXPECT_EQ(f.body("glsl"), "return clamp(a, 0.0, 1.0);\n");
    EXPECT_EQ(f.body("hlsl"), "return saturate(a);\n");
}

TEST(Legalize, MatricesAreMultipliedByRows) {
    Fixture f({kFloat3x3, kFloat3x3});
    f.finish(f.b->emit(Op::Mul, {f.b->param(0), f.b->param(1)}));
    EXPECT_EQ(f.body("hlsl"), "return float3x3(a[0] * b[0], a[1] * b[1], a[2] * b[2]);\n");
}

TEST(Legalize, VertexStagesSampleLevelZero) {
    Fixture f({kFloat2});
    const GlobalId texture = f.global("_Height", Type::of(Kind::Texture2D)),
                   sampler = f.global("sampler_Height", Type::of(Kind::Sampler));
    const Value texel = f.b->emit(Op::Sample, kFloat4, {f.read(texture), f.read(sampler), f.b->param(0)});
    f.make_stage(texel, {{.name = "uv0", .type = kFloat2, .semantic = "TEXCOORD0"}}, StageKind::Vertex);
    // Named after the output that it becomes.
    EXPECT_TRUE(contains(f.print("glsl"), "vec4 color = textureLod(sampler2D(_Height, sampler_Height), inUv0, 0.0);"))
        << f.print("glsl");
    EXPECT_TRUE(contains(f.print("hlsl"), "_Height.SampleLevel(sampler_Height, input.uv0, 0.0);"));
}

// --- whole shaders

TEST(Shaders, BindingsOfBothLanguages) {
    Fixture f({kFloat2});
    f.module.blocks.push_back({.name = "Material",
                               .place = {.set = 1},
                               .size = 32,
                               .members = {{.name = "_Roughness", .type = kFloat, .offset = 0},
                                           {.name = "_Tint", .type = kFloat4, .offset = 16, .padding = 3}}});
    f.module.blocks.push_back({.name = "Unread", .size = 16, .members = {{.name = "time", .type = kFloat}}});
    f.module.globals.push_back({.name = "_Tint", .type = kFloat4, .block = 0, .member = 1, .span = {}});
    const Value tint = f.read({0});
    const GlobalId texture = f.global("_MainTex", Type::of(Kind::Texture2D)),
                   sampler = f.global("sampler_MainTex", Type::of(Kind::Sampler));
    f.module.globals[texture.index].place.binding = 1;
    f.module.globals[sampler.index].place.binding = 9;
    f.global("_Unread", Type::of(Kind::Texture2D));
    const Value texel =
        f.named(f.b->emit(Op::Sample, kFloat4, {f.read(texture), f.read(sampler), f.b->param(0)}), "albedo");
    f.make_stage(f.b->emit(Op::Mul, {texel, tint}),
                 {{.name = "uv0", .type = kFloat2, .location = 0, .semantic = "TEXCOORD0"}});

    EXPECT_EQ(f.print("glsl", {.header = "made by hand"}),
              R"(// made by hand
#version 450

layout(set = 1, binding = 0, std140) uniform Material
{
    float _Roughness;
    vec4 _Tint;
};

layout(set = 1, binding = 1) uniform texture2D _MainTex;
layout(set = 1, binding = 9) uniform sampler sampler_MainTex;

layout(location = 0) in vec2 vUv0;
layout(location = 0) out vec4 outColor;

void main()
{
    vec4 albedo = texture(sampler2D(_MainTex, sampler_MainTex), vUv0);
    outColor = albedo * _Tint;
}
)");
    EXPECT_EQ(f.print("hlsl", {.header = "made by hand"}),
              R"(// made by hand

cbuffer Material : register(b0, space1)
{
    float _Roughness;
    float _pad0;
    float _pad1;
    float _pad2;
    float4 _Tint;
};

Texture2D _MainTex : register(t0, space1);
SamplerState sampler_MainTex : register(s0, space1);

struct FragmentInput
{
    float2 uv0 : TEXCOORD0;
};

struct FragmentOutput
{
    float4 color : SV_Target0;
};

FragmentOutput main(FragmentInput input)
{
    float4 albedo = _MainTex.Sample(sampler_MainTex, input.uv0);
    FragmentOutput output;
    output.color = albedo * _Tint;
    return output;
}
)");
}

TEST(Shaders, StageInputsAreDeclaredByLocation) {
    Fixture f({kFloat4, kFloat, kFloat});
    const Value w = f.b->emit(Op::Mul, {f.b->param(1), f.b->param(2)});
    f.make_stage(f.b->emit(Op::Mul, {f.b->param(0), f.b->splat(w, 4)}),
                 {{.name = "fragCoord", .type = kFloat4, .builtin = Builtin::FragCoord, .semantic = "SV_Position"},
                  {.name = "late", .type = kFloat, .location = 3, .semantic = "TEXCOORD3"},
                  {.name = "early", .type = kFloat, .location = 0, .semantic = "TEXCOORD0"}});
    EXPECT_TRUE(contains(f.print("hlsl"),
                         "    float early : TEXCOORD0;\n"
                         "    [[vk::location(3)]] float late : TEXCOORD3;\n"
                         "    float4 fragCoord : SV_Position;\n"))
        << f.print("hlsl");
    EXPECT_TRUE(contains(f.print("glsl"), "outColor = gl_FragCoord * (vLate * vEarly);"));
}

TEST(Shaders, LocalsDoNotHideGlobals) {
    Fixture f({kFloat});
    f.module.globals.push_back({.name = "tint", .type = kFloat, .block = 0, .member = 0, .span = {}});
    f.module.blocks.push_back({.name = "Material", .size = 16, .members = {{.name = "tint", .type = kFloat}}});
    const Value local = f.named(f.b->emit(Op::Sin, {f.b->param(0)}), "tint");
    EXPECT_EQ(f.glsl(f.b->emit(Op::Mul, {local, f.read({0})})), "float tint2 = sin(a);\nreturn tint2 * tint;\n");
}

TEST(Shaders, CommentsNameNodesAndLinesKnowThem) {
    Fixture f({kFloat});
    f.module.origins = {{.label = "Sine", .id = "wave\\", .span = {}}, {.label = "Power", .id = "sharp", .span = {}}};
    f.b->set_origin({0});
    const Value wave = f.named(f.b->emit(Op::Sin, {f.b->param(0)}), "wave");
    f.b->set_origin({1});
    const Value sharp = f.named(f.b->emit(Op::Pow, {wave, wave}), "sharp");
    f.b->set_origin({});
    f.function.comment = "One line.";
    f.finish(f.b->emit(Op::Mul, {sharp, sharp}));
    const Printed printed = find_language("glsl")->print(f.module, {});
    EXPECT_EQ(printed.text,
              "#version 450\n"
              "\n"
              "// One line.\n"
              "float f(float a)\n"
              "{\n"
              "    // Sine \"wave/\"\n"  // a backslash would join the next line to the comment
              "    float wave = sin(a);\n"
              "\n"
              "    // Power \"sharp\"\n"
              "    float sharp = pow(wave, wave);\n"
              "\n"
              "    return sharp * sharp;\n"
              "}\n");
    const auto origin_of = [&](int line) {
        OriginId origin;
        for (const PrintedLine& entry : printed.lines) {
            if (entry.line <= line) origin = entry.origin;
        }
        return origin;
    };
    EXPECT_EQ(origin_of(7), OriginId{0});
    EXPECT_EQ(origin_of(10), OriginId{1});
    EXPECT_EQ(origin_of(12), OriginId{});
    EXPECT_TRUE(std::is_sorted(printed.lines.begin(), printed.lines.end(),
                               [](const PrintedLine& a, const PrintedLine& b) { return a.line < b.line; }));
}

TEST(Shaders, LongChainsStayReadable) {
    Fixture f;
    Value v = f.b->param(0);
    for (int i = 0; i < 10000; ++i) v = f.b->emit(i % 3 == 0 ? Op::Mul : Op::Add, {f.b->param(1), v});
    f.finish(v);
    const std::string text = f.print("glsl");
    std::size_t longest = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        longest = std::max(longest, end - at);
        at = end + 1;
    }
    EXPECT_LE(longest, 120u);
    EXPECT_LT(text.size(), 200000u);
    EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '*')), 3334u) << "each product once";
}

TEST(Shaders, LaddersAreNotExpanded) {
    Fixture f;
    Value v = f.b->param(0);
    for (int i = 0; i < 10000; ++i) v = f.b->emit(Op::Mul, {v, v});
    f.finish(v);
    const std::string text = f.print("hlsl");
    EXPECT_EQ(std::count(text.begin(), text.end(), '*'), 10000);
}

TEST(Shaders, SwizzlesWithoutEndAreBroken) {
    Fixture f({kFloat3});
    Value v = f.b->param(0);
    const unsigned yzx[] = {1, 2, 0};
    for (int i = 0; i < 20000; ++i) v = f.b->swizzle(v, yzx);
    f.finish(v);
    EXPECT_LT(f.print("glsl").size(), 1000000u);
}

TEST(Shaders, TextureSizesAreAsked) {
    Fixture f({kInt});
    const GlobalId texture = f.global("_MainTex", Type::of(Kind::Texture2D));
    f.finish(f.b->emit(Op::TextureSize, kInt2, {f.read(texture), f.b->param(0)}));
    EXPECT_EQ(f.body("glsl"), "ivec2 size = textureSize(_MainTex, a);\nreturn size;\n");
    EXPECT_EQ(f.body("hlsl"),
              "uint width, height, levelCount;\n"
              "_MainTex.GetDimensions(a, width, height, levelCount);\n"
              "int2 size = int2(width, height);\n"
              "return size;\n");
}

TEST(Shaders, TheSameModuleGivesTheSameBytes) {
    SurfaceFixture f;
    f.finish(f.b->emit(Op::Insert, f.surface, {f.made(0.5), f.b->param(1)}, 1));
    EXPECT_EQ(f.print("glsl"), f.print("glsl"));
    EXPECT_EQ(f.print("hlsl"), f.print("hlsl"));
}

}  // namespace
}  // namespace patina::languages
