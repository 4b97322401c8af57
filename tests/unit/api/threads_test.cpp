// One compiler, many threads: the library's bodies and models are read when first asked for, by whoever asks first.
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "patina/patina.h"

namespace patina {
namespace {

std::string material(const std::string& model) {
    return R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": ")" + model + "\" }";
}

std::string texts(const Compiler& compiler, const std::string& model) {
    std::string all;
    for (const Shader& shader : compiler.compile_text("m.graph.json", material(model)).shaders) all += shader.text;
    return all;
}

TEST(Threads, CompileWithOneCompilerAsEachDoesAlone) {
    const std::vector<std::string> models = {"lambert", "gltf",        "disney-principled", "toon",
                                             "phong",   "unity-brdf2", "energy-conserving", "merl"};
    constexpr std::size_t kThreads = 8;
    const Compiler shared;
    std::vector<std::vector<std::string>> made(kThreads);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < kThreads; ++t) {
        threads.emplace_back([&, t] {
            // Each begins elsewhere.
            for (std::size_t i = 0; i < models.size(); ++i)
                made[t].push_back(texts(shared, models[(t + i) % models.size()]));
        });
    }
    for (std::thread& thread : threads) thread.join();
    const Compiler alone;
    for (std::size_t t = 0; t < kThreads; ++t) {
        for (std::size_t i = 0; i < models.size(); ++i) {
            const std::string expected = texts(alone, models[(t + i) % models.size()]);
            EXPECT_FALSE(expected.empty());
            EXPECT_EQ(made[t][i], expected);
        }
    }
}

// A compiler with an overlay, of which nothing has been read yet, and a file system that all threads ask.
TEST(Threads, ShareAColdCompilerWithAnOverlayAndAFileSystem) {
    const std::string wave = "[node(\"Test/Wave\")]\nfloat Wave(float2 uv = uv0) { return sin(uv.x); }\n";
    const std::string graph = R"json({ "patina": 1, "workflow": "metallic-roughness", "lighting": "flat",
        "nodes": [ { "id": "wave", "node": "./wave.node.hlsl" }, { "id": "own", "node": "Own", "in": { "x": "wave" } } ],
        "surface": { "baseColor": "= own" } })json";
    const LibraryOverlay overlay{
        .files = {{"mine/own.node.hlsl", "[node(\"Test/Own\")]\nfloat Own(float x = 0) { return x * x; }\n"},
                  {"mine/flat.lighting.json", R"json({ "patina": 1, "kind": "lighting",
                      "direct": "= @light.radiance * @surface.baseColor", "indirect": [0, 0, 0] })json"}}};
    std::atomic<int> asked = 0;
    CompileOptions options;
    options.files.read = [&](const std::string& path) {
        ++asked;
        return path == "wave.node.hlsl" ? std::optional(wave) : std::nullopt;
    };
    struct Made {
        std::string key, hash, text;
        std::size_t nodes = 0;
        bool operator==(const Made&) const = default;
    };
    const auto make = [&](const Compiler& compiler) {
        Made made;
        made.key = compiler.cache_key("a.graph.json", graph, options);
        made.hash = compiler.library_hash();
        const Result result = compiler.compile_text("a.graph.json", graph, options);
        for (const Diagnostic& diagnostic : result.diagnostics) made.text += to_text(diagnostic);
        for (const Shader& shader : result.shaders) made.text += shader.text;
        made.nodes = compiler.nodes().size();
        return made;
    };
    constexpr std::size_t kThreads = 4;
    const Compiler shared(overlay);
    std::vector<Made> made(kThreads);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < kThreads; ++t) threads.emplace_back([&, t] { made[t] = make(shared); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(asked, 2 * static_cast<int>(kThreads));  // once for the key, once for the shaders
    const Made alone = make(Compiler(overlay));
    EXPECT_NE(alone.text.find("void main"), std::string::npos) << alone.text;
    for (const Made& each : made) EXPECT_TRUE(each == alone);
}

}  // namespace
}  // namespace patina
