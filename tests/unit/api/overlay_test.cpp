// A program's own nodes, semantics, models and paths beside the library's.
#include <gtest/gtest.h>

#include <algorithm>

#include "patina/patina.h"

namespace patina {
namespace {

constexpr const char* kDots = R"hlsl(/// Round dots, a grid of them.
[node("Procedural/Dots")]
float Dots(float2 uv = uv0, float scale = 4) {
    float2 cell = frac(uv * scale) - 0.5;
    return smoothstep(0.35, 0.3, length(cell));
}

/// How far the surface is from the camera.
[semantic("pixel")]
float distanceToCamera(float3 position = positionWS) { return length(cameraPositionWS - position); }
)hlsl";

constexpr const char* kFlat = R"json({
    "patina": 1, "kind": "lighting",
    "direct": "= @light.radiance * @surface.baseColor * 0.25", "indirect": "= @surface.baseColor * 0.5"
})json";

constexpr const char* kPaint = R"json({
    "patina": 1, "kind": "workflow",
    "inputs": [ { "name": "paint", "type": "color3", "default": [1, 1, 1] },
                { "name": "alpha", "type": "float", "default": 1 },
                { "name": "alphaClip", "type": "float", "default": 0.5 } ],
    "surface": { "baseColor": "$paint", "diffuseColor": "$paint", "f0": [0, 0, 0], "metallic": 0,
                 "oneMinusReflectivity": 1, "roughness": 1, "normalWS": "@geometryNormalWS", "occlusion": 1,
                 "emission": [0, 0, 0] }
})json";

constexpr const char* kPass = R"hlsl(// A pass that shows where the surface faces.
[pass("facing")] [vertex]
float4 facingVertex(float3 position = positionWS) { return mul(worldToClip, float4(position, 1)); }

[pass("facing")] [fragment] [lights("none")] [blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
float4 facingFragment() {
    LightingSurface lit = lightingSurface();
    return float4(0.5 + 0.5 * lit.normalWS, 1);
}
)hlsl";

constexpr const char* kGraph = R"json({
    "patina": 1, "workflow": "paint", "lighting": "flat",
    "nodes": [ { "id": "dots", "node": "Dots", "in": { "scale": "= 8 / (1 + @distanceToCamera)" } } ],
    "surface": { "paint": "= dots" }
})json";

LibraryOverlay overlay() {
    return {.files = {{"mine/dots.node.hlsl", kDots},
                      {"mine/flat.lighting.json", kFlat},
                      {"mine/paint.workflow.json", kPaint}}};
}

std::string said(const std::vector<Diagnostic>& diagnostics) {
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics) all += to_text(diagnostic) + "\n";
    return all;
}

TEST(Overlay, IsFoundByNameAsTheLibraryIs) {
    const Compiler compiler(overlay());
    EXPECT_EQ(said(compiler.library_diagnostics()), "");
    const Result result = compiler.compile_text("test.graph.json", kGraph);
    ASSERT_TRUE(result.ok) << said(result.diagnostics);
    EXPECT_EQ(result.reflection.lighting, "flat");
    EXPECT_EQ(result.reflection.workflow, "paint");
    EXPECT_EQ(result.dependencies, std::vector<std::string>{"test.graph.json"});
    ASSERT_NE(compiler.node("Dots"), nullptr);
    EXPECT_EQ(compiler.node("Dots")->file, "mine/dots.node.hlsl");
    const auto has = [](const auto& all, std::string_view name) {
        return std::any_of(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
    };
    EXPECT_TRUE(has(compiler.semantics(), "distanceToCamera"));
    EXPECT_TRUE(has(compiler.lighting_models(), "flat"));
    EXPECT_TRUE(has(compiler.workflows(), "paint"));
    EXPECT_NE(compiler.schema().find("Dots"), std::string::npos);
    EXPECT_FALSE(Compiler().compile_text("test.graph.json", kGraph).ok);
}

TEST(Overlay, HasPaths) {
    const Compiler compiler(LibraryOverlay{.files = {{"mine/own.pass.hlsl", kPass}}});
    EXPECT_EQ(said(compiler.library_diagnostics()), "");
    CompileOptions options;
    options.request = CompileOptions::Passes{.path = "own"};
    const Result result =
        compiler.compile_text("test.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness" })", options);
    ASSERT_TRUE(result.ok) << said(result.diagnostics);
    EXPECT_EQ(result.reflection.path, "own");
    ASSERT_EQ(result.reflection.passes.size(), 1u);
    EXPECT_EQ(result.reflection.passes[0].name, "facing");
}

// The errors of an overlay, each of which a compilation reports, too.
std::string refusal(LibraryOverlay files) {
    const Compiler compiler(files);
    const std::vector<Diagnostic> own = compiler.library_diagnostics();
    for (const Diagnostic& each : own) EXPECT_TRUE(each.file.starts_with("mine/")) << to_text(each);
    const Result result = compiler.compile_text("test.graph.json", R"({ "patina": 1, "workflow": "unlit" })");
    EXPECT_EQ(result.ok, own.empty());
    EXPECT_EQ(said(result.diagnostics), said(own));
    const Result builtin = Compiler().compile_text("test.graph.json", R"({ "patina": 1, "workflow": "unlit" })");
    EXPECT_TRUE(builtin.ok);
    return said(own);
}

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != text.npos;
}

TEST(Overlay, WithANameTwiceIsRefused) {
    const std::string second = "[node(\"Test/Second\")]\nfloat Dots(float2 uv = uv0) { return uv.x; }\n";
    std::string text = refusal({{{"mine/a.node.hlsl", kDots}, {"mine/b.node.hlsl", second}}});
    EXPECT_TRUE(has(text, "mine/b.node.hlsl:2:7: error: 'Dots' is declared twice [redefinition]")) << text;
    EXPECT_TRUE(has(text, "mine/a.node.hlsl:3:7: note: the first is here")) << text;
    text = refusal({{{"mine/b.node.hlsl", "[node(\"Test/Second\")]\nfloat Lerp(float a = 0) { return a; }\n"}}});
    EXPECT_TRUE(has(text, "mine/b.node.hlsl:2:7: error: 'Lerp' is declared twice [redefinition]")) << text;
    EXPECT_TRUE(has(text, "nodes/math/")) << text;
    text = refusal({{{"mine/lambert.lighting.json", kFlat}}});
    EXPECT_TRUE(has(text, "mine/lambert.lighting.json:1:1: error: a second lighting model is called 'lambert'"))
        << text;
    text = refusal({{{"mine/unlit.workflow.json", kPaint}}});
    EXPECT_TRUE(has(text, "a second workflow is called 'unlit'")) << text;
    text = refusal({{{"mine/forward.pass.hlsl", kPass}}});
    EXPECT_TRUE(has(text, "a second rendering path is called 'forward'")) << text;
    text = refusal({{{"mine/flat.lighting.json", kFlat}, {"mine/flat.lighting.json", kFlat}}});
    EXPECT_TRUE(has(text, "a second file of the library is called 'mine/flat.lighting.json'")) << text;
}

TEST(Overlay, ThatCannotBeReadIsRefused) {
    std::string text = refusal({{{"mine/a.node.hlsl", "[node(\"Test/A\")]\nfloat A(float x = 0) { return x + ; }\n"}}});
    EXPECT_TRUE(has(text, "mine/a.node.hlsl:2:35: error: expected a value")) << text;
    text = refusal({{{"mine/a.node.hlsl", "[node(\"Test/A\")]\nfloat A(float x = 0) { return x + float3(1, 1); }\n"}}});
    EXPECT_TRUE(has(text, "mine/a.node.hlsl:2:")) << text;
    text = refusal({{{"mine/a.lighting.json", "{ \"patina\": 1, \"kind\": \"lighting\", \"outpust\": {} }"}}});
    EXPECT_TRUE(has(text, "mine/a.lighting.json:1:37: error: unknown key 'outpust'")) << text;
    text = refusal({{{"mine/a.workflow.json", "{ \"patina\": 1"}}});
    EXPECT_TRUE(has(text, "mine/a.workflow.json:1:")) << text;
    text = refusal({{{"mine/two.workflow.json", "{ \"patina\": 1 }"}}});
    EXPECT_TRUE(has(text, "\"kind\": \"workflow\" is missing") && !has(text, "a material needs")) << text;
    text = refusal({{{"mine/two.lighting.json", kPaint}}});
    EXPECT_TRUE(has(text, "mine/two.lighting.json:2:26: error: this file must be a lighting graph")) << text;
    text = refusal({{{"mine/a.hlsl", kDots}}});
    EXPECT_TRUE(has(text, "error: 'mine/a.hlsl' is not a file of a library")) << text;
    text = refusal({{{"mine/b.pass.hlsl", "[pass(\"b\")] float4 main() { return 1; }\n"}}});
    EXPECT_TRUE(has(text, "mine/b.pass.hlsl:1:")) << text;
}

// The model parses, but names a node that is not there: the graph that uses it is told.
TEST(Overlay, ErrorsThatOnlyUseFindsAreAtItsFile) {
    LibraryOverlay files = overlay();
    files.files.push_back({"mine/bad.lighting.json", R"json({ "patina": 1, "kind": "lighting",
        "nodes": [ { "id": "a", "node": "Dotts" } ], "direct": "= a", "indirect": "= a" })json"});
    const Compiler compiler(files);
    EXPECT_TRUE(compiler.compile_text("test.graph.json", kGraph).ok);
    const Result result = compiler.compile_text(
        "test.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": "bad" })");
    EXPECT_FALSE(result.ok);
    EXPECT_TRUE(has(said(result.diagnostics), "mine/bad.lighting.json:2:42: error: there is no node 'Dotts'"))
        << said(result.diagnostics);
    EXPECT_TRUE(has(said(result.diagnostics), "did you mean 'Dots'?"));
    // Several graphs may use that file.
    EXPECT_TRUE(has(said(result.diagnostics), "the graph is 'test.graph.json'")) << said(result.diagnostics);
}

TEST(Overlay, AFunctionThatIsNoNodeIsToldApart) {
    LibraryOverlay files;
    files.files.push_back({"mine/dots.node.hlsl", "float Dots(float2 uv = uv0) {\n    return uv.x;\n}\n"});
    const Compiler compiler(files);
    EXPECT_TRUE(compiler.library_diagnostics().empty());
    const std::string wrong = said(compiler.compile_text("test.graph.json", kGraph).diagnostics);
    EXPECT_TRUE(has(wrong, "there is no node 'Dots'")) << wrong;
    EXPECT_TRUE(has(wrong, "mine/dots.node.hlsl:1:7: note: 'Dots' is a function of the library, but no node")) << wrong;
}

// --- hashes

TEST(LibraryHash, IsThatOfTheLibraryAndTheOverlay) {
    const std::string plain = Compiler().library_hash();
    EXPECT_EQ(plain.size(), 32u);
    EXPECT_EQ(Compiler().library_hash(), plain);
    EXPECT_EQ(Compiler(LibraryOverlay{}).library_hash(), plain);
    const std::string own = Compiler(overlay()).library_hash();
    EXPECT_NE(own, plain);
    EXPECT_EQ(Compiler(overlay()).library_hash(), own);
    LibraryOverlay changed = overlay();
    changed.files[0].text += " ";
    EXPECT_NE(Compiler(changed).library_hash(), own);
    changed = overlay();
    changed.files[1].name = "mine/flatter.lighting.json";
    EXPECT_NE(Compiler(changed).library_hash(), own);
}

// Whatever a result depends on changes its key, and nothing else does.
TEST(CacheKey, ChangesWithAllThatAResultDependsOn) {
    std::string node = "[node(\"Test/Wave\")]\nfloat Wave(float2 uv = uv0) { return sin(uv.x); }\n";
    std::string graph = R"json({ "patina": 1, "workflow": "unlit",
        "properties": [ { "name": "_Rust", "type": "texture2d", "default": "./rust.png" } ],
        "nodes": [ { "id": "wave", "node": "./wave.node.hlsl" },
                   { "id": "rust", "node": "SampleTexture2D", "in": { "texture": "$_Rust" } } ],
        "surface": { "color": "= rust.rgb * wave" } })json";
    bool has_texture = true;
    CompileOptions options;
    options.files.exists = [&](const std::string&) { return has_texture; };
    options.files.read = [&](const std::string& path) {
        return path == "m/wave.node.hlsl"    ? std::optional(node)
               : path == "m/test.graph.json" ? std::optional(graph)
                                             : std::nullopt;
    };
    const Compiler compiler;
    const auto key = [&] { return compiler.cache_key("m/test.graph.json", options); };
    const std::string first = key();
    EXPECT_EQ(first.size(), 32u);
    EXPECT_EQ(key(), first);
    EXPECT_EQ(Compiler().cache_key("m/test.graph.json", options), first);
    EXPECT_NE(Compiler(overlay()).cache_key("m/test.graph.json", options), first);
    EXPECT_NE(compiler.cache_key("m/other.graph.json", options), first);
    // A target that is named twice has no effect.
    options.targets.push_back(options.targets.front());
    EXPECT_EQ(key(), first);
    options.targets.pop_back();

    std::vector<std::string> keys = {first};
    const auto expect_new = [&](const char* what) {
        const std::string made = key();
        EXPECT_EQ(std::count(keys.begin(), keys.end(), made), 0) << what;
        keys.push_back(made);
    };
    const std::string old_node = node, old_graph = graph;
    node += "// changed\n";
    expect_new("a file");
    node = old_node;
    graph += " ";
    expect_new("the graph");
    graph = old_graph;
    has_texture = false;
    expect_new("whether a texture exists");
    has_texture = true;
    const CompileOptions usual = options;
    const auto with = [&](const char* what, auto change) {
        options = usual;
        change();
        expect_new(what);
        options = usual;
    };
    with("targets", [&] { options.targets = {Target::Glsl}; });
    with("path", [&] { options.request = CompileOptions::Passes{.path = "deferred"}; });
    with("only", [&] { options.request = CompileOptions::Passes{.only = {"forward"}}; });
    with("functions", [&] { options.request = CompileOptions::Functions{.prefix = "deferred"}; });
    with("preview", [&] { options.request = CompileOptions::Preview{.port = "wave"}; });
    with("another preview", [&] { options.request = CompileOptions::Preview{.port = "rust"}; });
    with("switches", [&] { options.switches = {{"fog", "true"}}; });
    with("more switches", [&] { options.switches = {{"fog", "true"}, {"shadows", ""}}; });
    with("keep_variants", [&] { options.keep_variants = true; });
    with("lighting", [&] { options.lighting = "lambert"; });
    with("accept_parts", [&] { options.accept_parts = true; });
    with("include_dirs", [&] { options.include_dirs = {"shared"}; });
    with("dump", [&] { options.dump = {"ir"}; });
    with("keep_programs", [&] { options.keep_programs = true; });
    with("hashes", [&] { options.hashes = true; });

    options.limits.nodes = 1000;
    options.limits.cancelled = [] { return false; };
    EXPECT_EQ(key(), first);
    EXPECT_NE(compiler.cache_key("m/test.graph.json", graph, usual), "");
}

}  // namespace
}  // namespace patina
