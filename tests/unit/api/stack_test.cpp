// How deep graphs may be, and the stack that a thread needs for them (docs/embedding.md).
#include <gtest/gtest.h>
#include <pthread.h>

#include <map>

#include "patina/patina.h"

#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define PATINA_HAS_SANITIZER
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PATINA_HAS_SANITIZER
#endif

namespace patina {
namespace {

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

std::string unlit(const std::string& nodes, const std::string& color) {
    return R"({ "patina": 1, "workflow": "unlit", "nodes": [ )" + nodes + R"( ], "surface": { "color": "= )" + color +
           R"(" } })";
}
std::string use(const std::string& id, const std::string& file, const std::string& x) {
    return R"({ "id": ")" + id + R"(", "node": "./)" + file + R"(.subgraph.json", "in": { "x": "= )" + x + R"(" } })";
}
std::string subgraph(const std::string& nodes, const std::string& value) {
    return R"({ "patina": 1, "kind": "subgraph", "inputs": [ { "name": "x", "type": "float" } ], "nodes": [ )" + nodes +
           R"( ], "outputs": { "v": "= )" + value + R"(" } })";
}

// A graph and the sub-graphs below it, by their names.
struct Deep {
    std::string graph;
    std::map<std::string, std::string> files{};

    Result compile() const {
        CompileOptions options;
        options.limits.nodes = Limits::kNone;  // each level doubles them
        options.files.read = [&](const std::string& path) -> std::optional<std::string> {
            const auto found = files.find(path.substr(0, path.find('.')));
            return found == files.end() ? std::nullopt : std::optional(found->second);
        };
        return compiler().compile_text("test.graph.json", graph, options);
    }
};

// Adds the sub-graphs `letter`1, `letter`2, ..., each of which uses the next one twice; the last one has the
// expression.
void add_levels(Deep& deep, const std::string& letter, int count, const std::string& last) {
    for (int i = 1; i < count; ++i) {
        const std::string next = letter + std::to_string(i + 1);
        deep.files[letter + std::to_string(i)] =
            subgraph(use("a", next, "$x * 1.01") + ", " + use("b", next, "$x + a"), "a * b");
    }
    deep.files[letter + std::to_string(count)] = last;
}

Deep levels(int count, const std::string& value = "$x + 1") {
    Deep deep{.graph = unlit(use("all", "a1", "@uv0.x"), "float3(all)")};
    add_levels(deep, "a", count, subgraph("", value));
    return deep;
}

void expect_too_deep(const Deep& deep, const std::string& file, const std::string& node) {
    const Result result = deep.compile();
    ASSERT_FALSE(result.diagnostics.empty());
    const Diagnostic& error = result.diagnostics[0];
    EXPECT_EQ(error.code, "too-deep");
    EXPECT_EQ(error.message, "this is nested more than 200 levels deep");
    EXPECT_EQ(error.file, file);
    EXPECT_EQ(error.node, node);
    EXPECT_EQ(error.line, 1);
}

TEST(Levels, OfSubGraphsAreAtMost200) {
    EXPECT_TRUE(levels(200).compile().ok);
    expect_too_deep(levels(201), "a200.subgraph.json", "a");
    expect_too_deep(levels(7000), "a200.subgraph.json", "a");
}

// The graph uses the lower levels first, where they are not deep.
TEST(Levels, CountWhereASubGraphIsUsedMostDeeply) {
    const auto joined = [](int upper, int lower) {
        Deep deep{.graph =
                      unlit(use("low", "b1", "@uv0.x") + ", " + use("all", "a1", "@uv0.x"), "float3(low, all, 0)")};
        add_levels(deep, "b", lower, subgraph("", "$x + 1"));
        add_levels(deep, "a", upper, subgraph(use("into", "b1", "$x"), "into"));
        return deep;
    };
    EXPECT_TRUE(joined(50, 150).compile().ok);
    expect_too_deep(joined(51, 150), "a51.subgraph.json", "into");
}

// --- stacks

std::string nested(int count, const std::string& before, const std::string& after, std::string inner = "$x") {
    for (int i = 0; i < count; ++i) inner = before + inner + after;
    return inner;
}

struct Job {
    const Deep* deep = nullptr;
    Result result{};
};

void expect_compiles_in(std::size_t stack_bytes, const Deep& deep) {
    Job job{.deep = &deep};
    pthread_attr_t attributes;
    ASSERT_EQ(pthread_attr_init(&attributes), 0);
    ASSERT_EQ(pthread_attr_setstacksize(&attributes, stack_bytes), 0);
    pthread_t thread{};
    const auto run = [](void* given) -> void* {
        Job& of = *static_cast<Job*>(given);
        of.result = of.deep->compile();
        return nullptr;
    };
    ASSERT_EQ(pthread_create(&thread, &attributes, run, &job), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    EXPECT_TRUE(job.result.ok) << to_text(job.result.diagnostics.front());
}

// A stack that is too small ends the test with a signal.
class Stacks : public testing::Test {
protected:
    void SetUp() override {
#if !defined(__OPTIMIZE__) || defined(PATINA_HAS_SANITIZER)
        GTEST_SKIP() << "frames are larger with a sanitizer, and without optimisation";
#endif
    }
};

TEST_F(Stacks, Of2MibTakeAllThatTheFormatAllows) {
    const std::string sum = "$x" + nested(800, "", " + @uv0.y", "");
    for (const std::string& value :
         {"$x" + nested(990, "", " + @uv0.y", ""), nested(190, "sin(", ")", sum), nested(190, "max(", ", @uv0.y)", sum),
          nested(95, "(@uv0.y > 0.5 ? ", " : 0.3)", sum)})
        expect_compiles_in(2u << 20, levels(200, value));
}

TEST_F(Stacks, Of512KibTake50LevelsAndExpressionsOf100) {
    const std::string sum = "$x" + nested(98, "", " + @uv0.y", "");
    for (const std::string& value : {sum, nested(95, "sin(", ")"), nested(95, "max(", ", @uv0.y)"),
                                     nested(95, "(", " + @uv0.y)"), nested(48, "(@uv0.y > 0.5 ? ", " : 0.3)")})
        expect_compiles_in(512u << 10, levels(50, value));
}

}  // namespace
}  // namespace patina
