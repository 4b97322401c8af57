// What the compiler asks of the caller's loader.
#include <gtest/gtest.h>

#include <map>

#include "patina/patina.h"

namespace patina {
namespace {

TEST(Loader, IsAskedOnceForEachPath) {
    const std::map<std::string, std::string> files = {
        {"wave.node.hlsl", "/// A wave.\n[node(\"Test/Wave\")]\nfloat Wave(float2 uv = uv0) { return sin(uv.x); }\n"},
        {"deep.subgraph.json", R"json({ "patina": 1, "kind": "subgraph",
            "nodes": [ { "id": "wave", "node": "./wave.node.hlsl" } ], "outputs": { "value": "wave" } })json"},
        {"rust.png", "the bytes of a picture"},
    };
    std::map<std::string, int> asked;
    CompileOptions options;
    options.loader = [&](const std::string& path) -> std::optional<std::string> {
        ++asked[path];
        const auto found = files.find(path);
        if (found == files.end()) return {};
        return found->second;
    };
    const Result result = Compiler().compile_text("test.graph.json", R"json({
        "patina": 1, "workflow": "unlit",
        "properties": [ { "name": "_Rust", "type": "texture2d", "default": "./rust.png" } ],
        "nodes": [ { "id": "a", "node": "./wave.node.hlsl" }, { "id": "b", "node": "./wave.node.hlsl" },
                   { "id": "deep", "node": "./deep.subgraph.json" },
                   { "id": "rust", "node": "SampleTexture2D", "in": { "texture": "$_Rust" } } ],
        "surface": { "color": "= rust.rgb * (a + b + deep)" }
    })json",
                                                  options);
    for (const Diagnostic& diagnostic : result.diagnostics) ADD_FAILURE() << to_text(diagnostic);
    EXPECT_TRUE(result.ok);
    EXPECT_EQ(asked, (std::map<std::string, int>{{"deep.subgraph.json", 1}, {"rust.png", 1}, {"wave.node.hlsl", 1}}));
}

}  // namespace
}  // namespace patina
