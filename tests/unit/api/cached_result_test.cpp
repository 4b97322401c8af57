// A request that comes again: when its result is the one of before, and when it is made anew.
#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "patina/patina.h"

namespace patina {
namespace {

constexpr const char* kGraph = R"json({
    "patina": 1, "workflow": "unlit",
    "properties": [ { "name": "_Rust", "type": "texture2d", "default": "./rust.png" } ],
    "nodes": [ { "id": "rust", "node": "SampleTexture2D", "in": { "texture": "$_Rust" } },
               { "id": "half", "node": "./half.subgraph.json" } ],
    "surface": { "color": "= rust.rgb * half" }
})json";

std::string half(const std::string& number) {
    return R"json({ "patina": 1, "kind": "subgraph", "nodes": [ { "id": "n", "expr": ")json" + number +
           R"json( * @uv0.x" } ], "outputs": { "value": "n" } })json";
}

// A compiler, and files that may change between its compilations.
class CachedResult : public testing::Test {
protected:
    CachedResult() {
        options.files.read = [this](const std::string& path) {
            ++reads;
            const auto found = files.find(path);
            return found == files.end() ? std::nullopt : std::optional(found->second);
        };
        options.files.exists = [this](const std::string& path) { return files.contains(path); };
        // A compilation asks it often. One that is answered asks it once.
        options.limits.cancelled = [this] {
            ++questions;
            return false;
        };
    }

    Result compile() {
        reads = questions = 0;
        return compiler.compile_text("a.graph.json", graph, options);
    }
    bool was_answered() const { return questions == 1; }
    // A result is kept when it is asked for the second time.
    Result compile_thrice() {
        compile();
        compile();
        return compile();
    }

    Compiler compiler;
    CompileOptions options;
    std::string graph = kGraph;
    std::map<std::string, std::string> files = {{"half.subgraph.json", half("0.5")}, {"rust.png", ""}};
    int reads = 0, questions = 0;
};

TEST_F(CachedResult, HasTheSameResult) {
    const Result first = compile();
    EXPECT_FALSE(was_answered());
    const Result second = compile();
    EXPECT_FALSE(was_answered());
    const Result third = compile();
    EXPECT_TRUE(was_answered());
    EXPECT_EQ(reads, 1) << "the sub-graph may have changed";
    ASSERT_TRUE(first.ok && third.ok);
    ASSERT_EQ(third.shaders.size(), first.shaders.size());
    for (std::size_t i = 0; i < first.shaders.size(); ++i) EXPECT_EQ(third.shaders[i].text, first.shaders[i].text);
    EXPECT_EQ(third.reflection.to_json(), first.reflection.to_json());
    EXPECT_EQ(third.dependencies, first.dependencies);
    EXPECT_EQ(third.nodes, first.nodes);
}

TEST_F(CachedResult, IsMadeAnewIfAFileChanges) {
    const Result before = compile_thrice();
    files["half.subgraph.json"] = half("0.75");
    const Result after = compile();
    EXPECT_FALSE(was_answered());
    EXPECT_EQ(reads, 1) << "a file is asked for once";
    ASSERT_TRUE(after.ok);
    EXPECT_NE(after.shaders[1].text, before.shaders[1].text);
    EXPECT_NE(after.shaders[1].text.find("0.75"), std::string::npos);
    // From now on the new one is kept.
    EXPECT_EQ(compile().shaders[1].text, after.shaders[1].text);
    EXPECT_TRUE(was_answered());
    files["half.subgraph.json"] = half("0.5");
    EXPECT_EQ(compile().shaders[1].text, before.shaders[1].text);
}

TEST_F(CachedResult, IsMadeAnewIfATextureGoes) {
    compile_thrice();
    files.erase("rust.png");
    EXPECT_FALSE(compile().ok);
    EXPECT_FALSE(compile().ok);
    files["rust.png"] = "";
    EXPECT_TRUE(compile().ok);
}

TEST_F(CachedResult, IsMadeAnewIfANameMeansAnotherFile) {
    std::string folder;
    options.files.resolve = [&](const std::string&, const std::string& name) { return folder + name.substr(2); };
    files["new/half.subgraph.json"] = half("0.125");
    files["new/rust.png"] = "";
    compile_thrice();
    EXPECT_TRUE(was_answered());
    folder = "new/";
    const Result moved = compile();
    EXPECT_FALSE(was_answered());
    ASSERT_TRUE(moved.ok);
    EXPECT_NE(moved.shaders[1].text.find("0.125"), std::string::npos);
}

TEST_F(CachedResult, IsMadeAnewIfTheProgramBeginsToResolveNames) {
    files["new/half.subgraph.json"] = half("0.125");
    files["new/rust.png"] = "";
    compile_thrice();
    EXPECT_TRUE(was_answered());
    std::string folder;
    options.files.resolve = [&](const std::string&, const std::string& name) { return folder + name.substr(2); };
    compile();
    EXPECT_TRUE(was_answered()) << "each name means the same file";
    folder = "new/";
    const Result moved = compile();
    EXPECT_FALSE(was_answered());
    ASSERT_TRUE(moved.ok);
    EXPECT_NE(moved.shaders[1].text.find("0.125"), std::string::npos);
    EXPECT_NE(moved.reflection.to_json().find("new/rust.png"), std::string::npos);
    // And back.
    options.files.resolve = nullptr;
    EXPECT_NE(compile().shaders[1].text.find("0.5"), std::string::npos);
}

TEST_F(CachedResult, IsAnotherOneWithOtherOptions) {
    compile_thrice();
    options.targets = {Target::Hlsl};
    EXPECT_EQ(compile().shaders.size(), 2u);
    EXPECT_FALSE(was_answered());
    options.limits.nodes = 1;
    EXPECT_FALSE(compile().ok) << "the result of before had more nodes";
    options.limits.nodes = Limits::kNone;
    graph.insert(graph.rfind('}'), " ");
    compile();
    EXPECT_FALSE(was_answered());
}

TEST_F(CachedResult, ErrorsAreFoundAgain) {
    graph.replace(graph.find("rust.rgb"), 8, "rust.xyq");
    for (int round = 0; round < 4; ++round) {
        const Result result = compile();
        EXPECT_FALSE(result.ok);
        EXPECT_FALSE(was_answered());
        EXPECT_EQ(result.diagnostics.size(), 1u);
    }
}

TEST_F(CachedResult, CanBeCancelled) {
    compile_thrice();
    options.limits.cancelled = [] { return true; };
    const Result cancelled = compile();
    EXPECT_FALSE(cancelled.ok);
    ASSERT_EQ(cancelled.diagnostics.size(), 1u);
    EXPECT_EQ(cancelled.diagnostics[0].code, "cancelled");
    options.limits.cancelled = []() -> bool { throw std::runtime_error("enough"); };
    const Result thrown = compile();
    ASSERT_EQ(thrown.diagnostics.size(), 1u);
    EXPECT_NE(thrown.diagnostics[0].message.find("enough"), std::string::npos);
}

}  // namespace
}  // namespace patina
