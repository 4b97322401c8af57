// What a graph reads of a texture that its property turns or rearranges ("handedness", "swizzle"), through every node
// that reads texels: GLSL, HLSL and the CPU. The expected values follow from the texels by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "tests/textures/drawn.h"

namespace patina::runtime {
namespace {

class TextureViews : public testing::TestWithParam<std::string> {};

// Ways to a normal: each is a list of nodes, of which the last is "n".
const std::map<std::string, std::string> kNormalReaders = {
    {"map", R"({ "id": "n", "node": "SampleNormalMap", "in": { "texture": "$_Bump" } })"},
    {"plain", R"j({ "id": "n", "expr": "UnpackNormal(SampleTexture2D($_Bump))" })j"},
    {"level", R"j({ "id": "n", "expr": "UnpackNormal(SampleTexture2DLevel($_Bump))" })j"},
    {"grad", R"j({ "id": "n", "expr": "UnpackNormal(SampleTexture2DMoved($_Bump))" })j"},
    {"load", R"j({ "id": "n", "expr": "UnpackNormal(LoadTexture2D($_Bump, @uv0 * 2))" })j"},
};

std::string bump(const std::string& handedness, const std::string& reader) {
    return R"("properties": [ { "name": "_Bump", "type": "texture2d", "usage": "normal", )" + handedness +
           R"("sampler": { "filter": "nearest" } } ], "nodes": [ )" + reader +
           R"( ], "surface": { "color": "= n * 0.5 + 0.5" })";
}

// Texels of the direction (0, 0.6, 0.8), which is up, and (0.6, 0, 0.8) in the first column; their opposites in the
// second. As a file: (n + 1) / 2 with x and y in red and green, which are whole numbers of 255.
std::vector<std::array<float, 4>> bumps(bool green_is_down) {
    const float up = green_is_down ? 0.2f : 0.8f, down = 1 - up;
    return {{0.5f, up, 0.9f, 1}, {0.5f, down, 0.9f, 1}, {0.8f, 0.5f, 0.9f, 1}, {0.2f, 0.5f, 0.9f, 1}};
}

TEST_P(TextureViews, GreenOfDirectXIsTurnedForEveryReader) {
    const std::string opengl = png_of("opengl", 2, 2, bumps(false)), directx = png_of("directx", 2, 2, bumps(true));
    constexpr double kHalf = 128 / 255.0;  // 0.5, as eight bits have it
    for (const auto& [name, reader] : kNormalReaders) {
        const Image of_opengl = drawn(GetParam(), "opengl_" + name, bump("", reader), {{"_Bump", opengl}});
        const Image said =
            drawn(GetParam(), "said_" + name, bump(R"("handedness": "opengl", )", reader), {{"_Bump", opengl}});
        const Image of_directx =
            drawn(GetParam(), "directx_" + name, bump(R"("handedness": "directx", )", reader), {{"_Bump", directx}});
        // z is what is left of a unit vector.
        const double x = 2 * kHalf - 1, z = std::sqrt(1 - 0.36 - x * x);
        expect_at(of_opengl, 0, 0, {kHalf, 0.8, z / 2 + 0.5}, name + ": up");
        expect_at(of_opengl, 1, 0, {kHalf, 0.2, z / 2 + 0.5}, name + ": down");
        expect_at(of_opengl, 0, 1, {0.8, kHalf, z / 2 + 0.5}, name + ": right");
        EXPECT_EQ(said.pixels, of_opengl.pixels) << name;
        expect_at(of_directx, 0, 0, {kHalf, 0.8, z / 2 + 0.5}, name + ": up, turned");
        expect_at(of_directx, 1, 0, {kHalf, 0.2, z / 2 + 0.5}, name + ": down, turned");
        expect_at(of_directx, 0, 1, {0.8, 1 - kHalf, z / 2 + 0.5}, name + ": right, turned");
    }
}

// A lit relief: the picture of a file equals that of its twin with the green turned. Where the mesh is mirrored or seen
// from the side does not matter.
TEST_P(TextureViews, TwinsOfBothHandednessesLookTheSame) {
    constexpr int kTexels = 16;
    std::mt19937 random(7);
    std::vector<std::array<float, 4>> one, other;
    for (int i = 0; i < kTexels * kTexels; ++i) {
        const auto byte = [&] { return static_cast<int>(random() % 200) + 28; };
        const int r = byte(), g = byte();
        one.push_back({static_cast<float>(r) / 255, static_cast<float>(g) / 255, 1, 1});
        other.push_back({static_cast<float>(r) / 255, static_cast<float>(255 - g) / 255, 1, 1});
    }
    const auto relief = [&](const std::string& file, const std::string& handedness) {
        static const Compiler compiler;
        static RenderMachine machine;
        const std::string path = testing::TempDir() + "relief.graph.json";
        std::ofstream(path) << R"({ "patina": 1, "workflow": "metallic-roughness", "properties": [ { "name": "_Bump",
            "type": "texture2d", "usage": "normal", "tiling": true, )"
                            << handedness << R"("sampler": { "wrap": "mirror" } } ], "nodes": [ { "id": "n",
            "node": "SampleNormalMap", "in": { "texture": "$_Bump", "scale": 0.8 } } ],
            "surface": { "normalTS": "n", "roughness": 0.4 } })";
        RenderRequest request{.graph = path,
                              .mesh = "torus",
                              .size = 48,
                              .samples = 1,
                              .overrides = {{"_Bump", file}, {"_Bump_ST", "5,-3,0.1,0.4"}}};
        request.options.via = GetParam();
        request.options.exact_textures = true;
        RenderOutcome outcome = render(compiler, request, machine);
        EXPECT_TRUE(outcome.ok) << outcome.error;
        return outcome.image;
    };
    const std::string first = png_of("relief", kTexels, kTexels, one), second = png_of("twin", kTexels, kTexels, other);
    const Image expected = relief(first, ""), same = relief(second, R"("handedness": "directx", )"),
                wrong = relief(second, "");
    ASSERT_EQ(expected.pixels.size(), same.pixels.size());
    float most = 0, most_wrong = 0;
    for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
        most = std::max(most, std::abs(expected.pixels[i] - same.pixels[i]));
        most_wrong = std::max(most_wrong, std::abs(expected.pixels[i] - wrong.pixels[i]));
    }
    EXPECT_LT(most, 1e-4F);
    EXPECT_GT(most_wrong, 0.1F);
}

// The channels of one texel that a material sees: its colour in one half, its alpha in the other.
std::string shown(const std::string& keys, const std::string& type, const std::string& texel) {
    return R"("properties": [ { "name": "_Map", "type": ")" + type + R"(", )" + keys +
           R"("sampler": { "filter": "nearest" } } ], "nodes": [ { "id": "t", "expr": ")" + texel +
           R"(" } ], "surface": { "color": "= @uv0.x < 0.5 ? t.rgb : t.aaa" })";
}

TEST_P(TextureViews, ASwizzleRearrangesWhatEveryNodeReads) {
    constexpr std::array<float, 4> kTexel = {0.2f, 0.4f, 0.6f, 0.8f};
    const std::string file = png_of("channels", 1, 1, {kTexel});
    struct Case {
        const char* swizzle;
        std::array<double, 4> expected;
    };
    const std::vector<Case> cases = {
        {"bgra", {0.6, 0.4, 0.2, 0.8}}, {"r", {0.2, 0.2, 0.2, 1}},      {"ga", {0.4, 0.4, 0.4, 0.8}},
        {"abg", {0.8, 0.6, 0.4, 1}},    {"rrr1", {0.2, 0.2, 0.2, 1}},   {"01ra", {0, 1, 0.2, 0.8}},
        {"aaa0", {0.8, 0.8, 0.8, 0}},   {"rgba", {0.2, 0.4, 0.6, 0.8}}, {"rgb", {0.2, 0.4, 0.6, 1}}};
    for (const Case& each : cases) {
        const std::string keys = std::string(R"("usage": "data", "swizzle": ")") + each.swizzle + R"(", )";
        const Image seen =
            drawn(GetParam(), "swizzle", shown(keys, "texture2d", "SampleTexture2D($_Map)"), {{"_Map", file}});
        expect_at(seen, 0, 0, {each.expected[0], each.expected[1], each.expected[2]}, each.swizzle);
        expect_at(seen, 1, 0, {each.expected[3], each.expected[3], each.expected[3]}, each.swizzle);
    }
    const std::string turned = R"("usage": "data", "swizzle": "abr0", )";
    const std::vector<std::pair<const char*, const char*>> readers = {
        {"texture2d", "SampleTexture2DLevel($_Map)"},
        {"texture2d", "SampleTexture2DMoved($_Map)"},
        {"texture2d", "LoadTexture2D($_Map, 0)"},
        {"texture2dArray", "SampleTexture2DArray($_Map)"},
        {"texture2dArray", "SampleTexture2DArrayLevel($_Map)"},
        {"texture3d", "SampleTexture3D($_Map)"},
        {"texture3d", "SampleTexture3DLevel($_Map)"},
    };
    for (const auto& [type, texel] : readers) {
        const Image seen = drawn(GetParam(), "reader", shown(turned, type, texel), {{"_Map", file}});
        expect_at(seen, 0, 0, {0.8, 0.6, 0.2}, texel);
        expect_at(seen, 1, 0, {0, 0, 0}, texel);
    }
}

// A cube's picture keeps no alpha.
TEST_P(TextureViews, ASwizzleRearrangesACube) {
    const std::string strip = png_of("strip", 6, 1, std::vector<std::array<float, 4>>(6, {0.2f, 0.4f, 0.6f, 1}));
    for (const char* texel : {"SampleTextureCube($_Map)", "SampleTextureCubeLevel($_Map)"}) {
        const Image seen =
            drawn(GetParam(), "cube", shown(R"("usage": "data", "swizzle": "bbr0", )", "textureCube", texel),
                  {{"_Map", strip}});
        expect_at(seen, 0, 0, {0.6, 0.6, 0.2}, texel);
        expect_at(seen, 1, 0, {0, 0, 0}, texel);
    }
}

// The file's colours are decoded, and its alpha is not, wherever they are seen.
TEST_P(TextureViews, ColoursAreDecodedBeforeTheyAreRearranged) {
    const std::string file = png_of("decoded", 1, 1, {{0.2f, 0.4f, 0.6f, 0.8f}});
    const Image seen = drawn(GetParam(), "decoded",
                             shown(R"("swizzle": "arbg", )", "texture2d", "SampleTexture2D($_Map)"), {{"_Map", file}});
    const auto decode = [](double v) { return std::pow((v + 0.055) / 1.055, 2.4); };  // IEC 61966-2-1
    expect_at(seen, 0, 0, {0.8, decode(0.2), decode(0.6)}, "colour");
    expect_at(seen, 1, 0, {decode(0.4), decode(0.4), decode(0.4)}, "alpha");
}

// The swizzle comes first: what it puts into green is turned.
TEST_P(TextureViews, ANormalMapMayHaveBoth) {
    const std::string file = png_of("both", 1, 1, {{0.9f, 0.8f, 0.2f, 0.6f}});
    const Image seen = drawn(GetParam(), "both",
                             bump(R"("handedness": "directx", "swizzle": "ab01", )",
                                  R"({ "id": "n", "expr": "SampleTexture2D($_Bump).rgb * 2 - 1" })"),
                             {{"_Bump", file}});
    expect_at(seen, 0, 0, {0.6, 1 - 0.2, 0}, "x in alpha, y in blue");
}

// Through a sub-graph, a function of one's own, and two views of one file in one material.
TEST_P(TextureViews, ViewsPassThroughSubGraphsAndFunctions) {
    std::ofstream(testing::TempDir() + "pick.node.hlsl") << R"(
/// Reads a texture through a function of its own.
[node("Test/Pick")] float4 Pick(Texture2D map, float2 at = uv0) { Texture2D own = map; return own.Sample(own.sampler, at); }
)";
    std::ofstream(testing::TempDir() + "inner.subgraph.json") << R"({ "patina": 1, "kind": "subgraph",
        "inputs": [ { "name": "map", "type": "texture2d" } ],
        "nodes": [ { "id": "t", "node": "./pick.node.hlsl", "in": { "map": "$map" } } ], "outputs": { "texel": "t" } })";
    const std::string file = png_of("inner", 1, 1, {{0.2f, 0.4f, 0.6f, 0.8f}});
    const Image seen = drawn(GetParam(), "outer", R"("properties": [
          { "name": "_A", "type": "texture2d", "usage": "data", "swizzle": "bgr" },
          { "name": "_B", "type": "texture2d", "usage": "data" },
          { "name": "_C", "type": "texture2d", "usage": "data", "swizzle": "a" } ],
        "nodes": [ { "id": "a", "node": "./inner.subgraph.json", "in": { "map": "$_A" } },
                   { "id": "b", "node": "./inner.subgraph.json", "in": { "map": "$_B" } },
                   { "id": "c", "node": "./inner.subgraph.json", "in": { "map": "$_C" } } ],
        "surface": { "color": "= @uv0.x < 0.5 ? a.rgb : @uv0.y < 0.5 ? b.rgb : c.rgb" })",
                             {{"_A", file}, {"_B", file}, {"_C", file}});
    expect_at(seen, 0, 0, {0.6, 0.4, 0.2}, "bgr");
    expect_at(seen, 1, 0, {0.2, 0.4, 0.6}, "as it is");
    expect_at(seen, 1, 1, {0.8, 0.8, 0.8}, "a");
}

// A relief that moves the coordinates, vertices that a texture moves, a lighting graph that gets a texture, and sizes
// and tilings: a material whose textures are rearranged looks like one whose files are.
TEST_P(TextureViews, EverythingThatReadsATextureSeesItsView) {
    constexpr int kTexels = 8;
    std::mt19937 random(11);
    std::vector<std::array<float, 4>> height, height_in_alpha, ramp, ramp_reversed;
    for (int i = 0; i < kTexels * kTexels; ++i) {
        const auto byte = [&] { return static_cast<float>(random() % 256) / 255; };
        const float h = byte(), r = byte(), g = byte(), b = byte();
        height.push_back({h, h, h, 1});
        height_in_alpha.push_back({byte(), byte(), byte(), h});
        ramp.push_back({r, g, b, 1});
        ramp_reversed.push_back({b, g, r, byte()});
    }
    std::ofstream(testing::TempDir() + "ramp.lighting.json") << R"j({ "patina": 1, "kind": "lighting",
        "properties": [ { "name": "_Ramp", "type": "texture2d", "usage": "data" } ],
        "direct": "= @surface.diffuseColor * SampleTexture2DLevel($_Ramp, float2(saturate(dot(@surface.normalWS, @light.direction)), 0.3)).rgb" })j";
    const auto picture = [&](const std::string& height_key, const std::string& ramp_key, const std::string& height_file,
                             const std::string& ramp_file) {
        static const Compiler compiler;
        static RenderMachine machine;
        const std::string path = testing::TempDir() + "everything.graph.json";
        std::ofstream(path) << R"j({ "patina": 1, "workflow": "metallic-roughness",
          "lighting": { "use": "./ramp.lighting.json", "in": { "_Ramp": "$_Mine" } },
          "properties": [
            { "name": "_Height", "type": "texture2d", "usage": "data", "tiling": true)j"
                            << height_key << R"j( }, { "name": "_Mine", "type": "texture2d", "usage": "data")j"
                            << ramp_key << R"j( } ],
          "nodes": [
            { "id": "view", "node": "ViewDirection", "in": { "space": "Tangent" } },
            { "id": "relief", "node": "ParallaxOcclusion", "in": { "texture": "$_Height", "viewTS": "view" } },
            { "id": "color", "node": "SampleTexture2DMoved", "in": { "texture": "$_Mine", "uv": "relief", "smoothUV": "@uv0" } },
            { "id": "size", "expr": "$_Height.texelSize.z * 0.1 + $_Height.tiling.x * 0.1 + TexelSize($_Mine).x" } ],
          "vertex": { "positionOS": "= @positionOS + @normalOS * SampleTexture2DLevel($_Height).r * 0.2" },
          "surface": { "baseColor": "= color.rgb * size" } })j";
        RenderRequest request{.graph = path,
                              .mesh = "sphere",
                              .size = 48,
                              .samples = 1,
                              .overrides = {{"_Height", height_file}, {"_Mine", ramp_file}, {"_Height_ST", "2,2,0,0"}}};
        request.options.via = GetParam();
        request.options.exact_textures = true;
        RenderOutcome outcome = render(compiler, request, machine);
        for (const Diagnostic& each : outcome.diagnostics) ADD_FAILURE() << to_text(each);
        EXPECT_TRUE(outcome.ok) << outcome.error;
        return outcome.image;
    };
    const Image expected =
        picture("", "", png_of("height", kTexels, kTexels, height), png_of("ramp", kTexels, kTexels, ramp));
    const std::string alpha = png_of("height_in_alpha", kTexels, kTexels, height_in_alpha),
                      reversed = png_of("ramp_reversed", kTexels, kTexels, ramp_reversed);
    const Image same = picture(R"(, "swizzle": "a")", R"(, "swizzle": "bgr")", alpha, reversed);
    EXPECT_EQ(same.pixels, expected.pixels);
    EXPECT_NE(picture("", R"(, "swizzle": "bgr")", alpha, reversed).pixels, expected.pixels);
    EXPECT_NE(picture(R"(, "swizzle": "a")", "", alpha, reversed).pixels, expected.pixels);
}

// Unity keeps two channels of what it imports as a normal map, so a swizzle reads a plain texture.
TEST(TextureViewsInUnity, ANormalMapWithASwizzleIsAPlainTexture) {
    static const Compiler compiler;
    const auto text = [&](const std::string& keys) {
        const std::string path = testing::TempDir() + "unitys.graph.json";
        std::ofstream(path) << R"({ "patina": 1, "workflow": "unlit", )" << bump(keys, kNormalReaders.at("map"))
                            << " }";
        CompileOptions options;
        options.targets = {{"unity", "hlsl"}};
        const Result made = compiler.compile_file(path, options);
        EXPECT_TRUE(made.ok);
        return made.ok ? made.shaders[0].text : std::string();
    };
    const std::string plain = text(""), turned = text(R"("handedness": "directx", )"),
                      packed = text(R"("swizzle": "ag1", )");
    const auto has = [](const std::string& all, const char* part) { return all.find(part) != all.npos; };
    EXPECT_TRUE(has(plain, "[Normal] _Bump") && has(plain, "UnpackScaleNormal("));
    EXPECT_TRUE(has(turned, "[Normal] _Bump") && has(turned, "NormalTexel(UNITY_SAMPLE_TEX2D(_Bump"));
    EXPECT_TRUE(has(packed, "_Bump") && !has(packed, "[Normal]") && !has(packed, "NormalTexel("));
}

INSTANTIATE_TEST_SUITE_P(Via, TextureViews, testing::Values("glsl", "hlsl", "cpu"));

}  // namespace
}  // namespace patina::runtime
