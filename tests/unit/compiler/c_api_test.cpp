// The C functions, by their header alone: what they return for good and for bad arguments, and that nothing passes
// them as an exception.
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "patina/patina_c.h"

namespace {

constexpr const char* kGraph = R"json({
  "patina": 1,
  "workflow": "metallic-roughness",
  "lighting": "lambert",
  "properties": [{ "name": "_Tint", "type": "color", "default": "#c9a27e" }],
  "nodes": [{ "id": "dots", "node": "./dots.node.hlsl" }],
  "surface": { "baseColor": "= $_Tint.rgb * dots" }
})json";
constexpr const char* kDots = "/// Dots.\n[node(\"Mine/Dots\")]\nfloat Dots(float2 uv = uv0) {\n    return uv.x;\n}\n";

struct Compiler {
    patina_compiler* handle = nullptr;

    explicit Compiler(const std::vector<patina_library_file>& files = {}) {
        EXPECT_EQ(patina_compiler_create(PATINA_C_ABI, files.data(), files.size(), &handle), PATINA_OK);
    }
    ~Compiler() { patina_compiler_free(handle); }
    Compiler(const Compiler&) = delete;
    Compiler& operator=(const Compiler&) = delete;
};

struct Result {
    patina_result* handle = nullptr;
    patina_status status = PATINA_OK;

    ~Result() { patina_result_free(handle); }
    Result() = default;
    Result(const Result&) = delete;
    Result& operator=(const Result&) = delete;

    bool says(const std::string& text) const {
        return std::string(patina_result_messages(handle)).find(text) != std::string::npos;
    }
};

// Files by their paths, and how often each was read.
struct Files {
    std::map<std::string, std::string> texts{{"dots.node.hlsl", kDots}};
    std::map<std::string, int> read{};

    static void read_one(void* user, const char* path, patina_reply* reply) {
        Files& files = *static_cast<Files*>(user);
        ++files.read[path];
        const auto found = files.texts.find(path);
        if (found != files.texts.end()) patina_reply_text(reply, found->second.data(), found->second.size());
    }
    patina_callbacks callbacks() {
        return {.user = this, .read = read_one, .exists = nullptr, .resolve = nullptr, .cancelled = nullptr};
    }
};

void compile(Result& result, const Compiler& compiler, const char* options, const patina_callbacks& callbacks,
             const std::string& graph = kGraph) {
    result.status = patina_compile(compiler.handle, "mine.graph.json", graph.data(), graph.size(), options, &callbacks,
                                   &result.handle);
}

TEST(CApi, CompilesATextWithFilesOfTheProgram) {
    Files files;
    Result result;
    {
        const Compiler compiler;
        compile(result, compiler, R"({"targets": ["glsl"]})", files.callbacks());
    }
    // The result lives longer than the compiler.
    ASSERT_EQ(result.status, PATINA_OK) << patina_result_messages(result.handle);
    EXPECT_STREQ(patina_result_messages(result.handle), "");
    EXPECT_STREQ(patina_result_diagnostics(result.handle), "[]");
    ASSERT_EQ(patina_result_shader_count(result.handle), 2u);
    const patina_shader* shader = patina_result_shader(result.handle, 1);
    EXPECT_STREQ(shader->file_name, "mine.forward.frag.glsl");
    EXPECT_STREQ(shader->pass, "forward");
    EXPECT_STREQ(shader->stage, "fragment");
    EXPECT_STREQ(shader->engine, "");
    EXPECT_STREQ(shader->language, "glsl");
    EXPECT_EQ(std::strlen(shader->text), shader->size);
    EXPECT_NE(std::strstr(shader->text, "#version 450"), nullptr);
    EXPECT_EQ(patina_result_shader(result.handle, 2), nullptr);
    EXPECT_NE(std::strstr(patina_result_reflection(result.handle), "\"_Tint\""), nullptr);
    ASSERT_EQ(patina_result_dependency_count(result.handle), 2u);
    EXPECT_STREQ(patina_result_dependency(result.handle, 0), "mine.graph.json");
    EXPECT_STREQ(patina_result_dependency(result.handle, 1), "dots.node.hlsl");
    EXPECT_EQ(patina_result_dependency(result.handle, 2), nullptr);
    EXPECT_EQ(patina_result_missing_count(result.handle), 0u);
    EXPECT_EQ(patina_result_missing(result.handle, 0), nullptr);
    EXPECT_EQ(files.read["dots.node.hlsl"], 1);
}

TEST(CApi, CompilesAFileOfTheProgram) {
    Files files;
    files.texts["pack://stone/mine.graph.json"] = kGraph;
    files.texts["pack://stone/dots.node.hlsl"] = kDots;
    const Compiler compiler;
    const patina_callbacks callbacks = files.callbacks();
    Result result;
    result.status =
        patina_compile_file(compiler.handle, "pack://stone/mine.graph.json", nullptr, &callbacks, &result.handle);
    ASSERT_EQ(result.status, PATINA_OK) << patina_result_messages(result.handle);
    EXPECT_EQ(patina_result_shader_count(result.handle), 4u);  // GLSL and HLSL
}

TEST(CApi, RefusesAnotherAbi) {
    patina_compiler* compiler = nullptr;
    for (const std::uint32_t abi : {0u, PATINA_C_ABI + 1u}) {
        EXPECT_EQ(patina_compiler_create(abi, nullptr, 0, &compiler), PATINA_WRONG_ABI);
        EXPECT_EQ(compiler, nullptr);
    }
    EXPECT_EQ(patina_c_abi(), std::uint32_t(PATINA_C_ABI));
    EXPECT_STREQ(patina_version(), PATINA_VERSION_STRING);
    for (int status = PATINA_OK; status <= PATINA_INTERNAL_ERROR; ++status)
        EXPECT_GT(std::strlen(patina_status_text(patina_status(status))), 5u);
}

TEST(CApi, TakesNullPointers) {
    const Compiler compiler;
    patina_result* result = reinterpret_cast<patina_result*>(1);
    EXPECT_EQ(patina_compiler_create(PATINA_C_ABI, nullptr, 0, nullptr), PATINA_BAD_ARGUMENT);
    patina_compiler* made = nullptr;
    EXPECT_EQ(patina_compiler_create(PATINA_C_ABI, nullptr, 1, &made), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_compile(nullptr, "a", "{}", 2, nullptr, nullptr, &result), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(result, nullptr);
    EXPECT_EQ(patina_compile(compiler.handle, nullptr, "{}", 2, nullptr, nullptr, &result), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_compile(compiler.handle, "a", nullptr, 2, nullptr, nullptr, &result), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_compile(compiler.handle, "a", "{}", 2, nullptr, nullptr, nullptr), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_compile_file(compiler.handle, nullptr, nullptr, nullptr, &result), PATINA_BAD_ARGUMENT);
    EXPECT_STREQ(patina_result_messages(nullptr), "");
    EXPECT_STREQ(patina_result_diagnostics(nullptr), "[]");
    EXPECT_STREQ(patina_result_reflection(nullptr), "");
    EXPECT_EQ(patina_result_shader_count(nullptr), 0u);
    EXPECT_EQ(patina_result_shader(nullptr, 0), nullptr);
    EXPECT_EQ(patina_result_dependency_count(nullptr), 0u);
    EXPECT_EQ(patina_result_dependency(nullptr, 0), nullptr);
    EXPECT_EQ(patina_result_missing_count(nullptr), 0u);
    EXPECT_EQ(patina_result_missing(nullptr, 0), nullptr);
    patina_reply_text(nullptr, "a", 1);
    patina_reply_error(nullptr, "a");
    patina_result_free(nullptr);
    patina_compiler_free(nullptr);
}

TEST(CApi, GivesErrorsOfTheGraphAsValues) {
    const Compiler compiler;
    Files files;
    Result result;
    compile(result, compiler, nullptr, files.callbacks(), "{\n  \"patina\": 1,\n  \"surfaces\": {}\n}");
    EXPECT_EQ(result.status, PATINA_HAS_ERRORS);
    EXPECT_TRUE(result.says("mine.graph.json:3:4: error: unknown key 'surfaces'"))
        << patina_result_messages(result.handle);
    EXPECT_NE(std::strstr(patina_result_diagnostics(result.handle), "\"unknown-key\""), nullptr);
    EXPECT_EQ(patina_result_shader_count(result.handle), 0u);
    EXPECT_STREQ(patina_result_reflection(result.handle), "");
}

// What is missing is missed one byte behind the end of a line, however long that line is.
TEST(CApi, SaysWhatIsWrongAtTheEndOfALongLine) {
    const Compiler compiler;
    Files files;
    for (const std::size_t length : {1u, 80u, 109u, 110u, 111u, 400u, 70000u}) {
        Result result;
        compile(result, compiler, nullptr, files.callbacks(),
                "{ \"patina\": 1, \"workflow\": \"unlit\", \"name\": \"" + std::string(length, 'x'));
        EXPECT_EQ(result.status, PATINA_HAS_ERRORS) << length;
        EXPECT_TRUE(result.says("mine.graph.json:1:")) << patina_result_messages(result.handle);
    }
}

TEST(CApi, SaysWhereTheOptionsAreWrong) {
    const Compiler compiler;
    Files files;
    const auto expect = [&](const char* options, const std::string& message) {
        Result result;
        compile(result, compiler, options, files.callbacks());
        EXPECT_EQ(result.status, PATINA_HAS_ERRORS) << options;
        EXPECT_TRUE(result.says(message)) << patina_result_messages(result.handle);
    };
    expect("", "options");
    expect("{", "broken JSON");
    expect("[]", "options:1:1: error: the text of the options must be an object");
    expect("{\"target\": []}", "options:1:3: error: unknown key 'target' in the options");
    expect("{\"target\": []}", "did you mean 'targets'?");
    expect("{\"targets\": [\"glls\"]}", "options:1:15: error: 'glls' is not a language or an engine");
    expect("{\"targets\": [\"glls\"]}", "did you mean 'glsl'?");
    expect("{\"targets\": \"glsl\"}", "'targets' must be an array");
    expect("{\"functions\": \"A_\", \"preview\": \"dots\"}", "'functions' and 'preview' exclude each other");
    expect("{\"hashes\": 1}", "'hashes' must be true or false");
    expect("{\"switches\": {\"shadows\": []}}", "'shadows' must be a word, a number, true or false");
    expect("{\"limits\": {\"nodes\": -1}}", "'nodes' must be a whole number from 0");
    expect("{\"limits\": {\"node\": 1}}", "unknown key 'node'");
    EXPECT_TRUE(files.read.empty());  // nothing was compiled
}

TEST(CApi, FollowsTheOptions) {
    const Compiler compiler;
    Files files;
    const auto shaders = [&](const char* options) {
        Result result;
        compile(result, compiler, options, files.callbacks());
        EXPECT_EQ(result.status, PATINA_OK) << patina_result_messages(result.handle);
        std::string names;
        for (size_t i = 0; i < patina_result_shader_count(result.handle); ++i)
            names += std::string(patina_result_shader(result.handle, i)->file_name) + " ";
        return names;
    };
    EXPECT_EQ(shaders(R"({"targets": ["hlsl"], "passes": ["depth-only"]})"),
              "mine.depth-only.vert.hlsl mine.depth-only.frag.hlsl ");
    EXPECT_EQ(shaders(R"({"targets": ["glsl"], "path": "vertex"})"), "mine.vertex.vert.glsl mine.vertex.frag.glsl ");
    EXPECT_EQ(shaders(R"({"targets": ["unity"]})"), "mine.shader ");
    EXPECT_EQ(shaders(R"({"targets": ["glsl"], "functions": "Mine_"})"), "mine.functions.glsl ");

    EXPECT_EQ(shaders(R"({"targets": []})"), "");  // only checks

    Result previewed, shadowed;
    compile(previewed, compiler, R"({"targets": ["glsl"], "preview": "dots"})", files.callbacks());
    ASSERT_EQ(previewed.status, PATINA_OK);
    EXPECT_EQ(std::strstr(patina_result_shader(previewed.handle, 1)->text, "lightAt"), nullptr);
    compile(shadowed, compiler, R"({"targets": ["glsl"], "switches": {"shadows": true}})", files.callbacks());
    ASSERT_EQ(shadowed.status, PATINA_OK);
    EXPECT_NE(std::strstr(patina_result_reflection(shadowed.handle), "\"worldToShadow\""), nullptr);
}

TEST(CApi, ACallbackMayFail) {
    const Compiler compiler;
    patina_callbacks callbacks{};
    callbacks.read = [](void*, const char*, patina_reply* reply) { patina_reply_error(reply, "the pack is locked"); };
    Result result;
    compile(result, compiler, nullptr, callbacks);
    EXPECT_EQ(result.status, PATINA_HAS_ERRORS);
    EXPECT_TRUE(result.says("mine.graph.json:6:38: error: cannot read 'dots.node.hlsl': the pack is locked"))
        << patina_result_messages(result.handle);
}

TEST(CApi, ACallbackOfCppMayThrow) {
    const Compiler compiler;
    patina_callbacks callbacks{};
    callbacks.read = [](void*, const char*, patina_reply*) { throw std::runtime_error("no network"); };
    Result result;
    compile(result, compiler, nullptr, callbacks);
    EXPECT_EQ(result.status, PATINA_HAS_ERRORS);
    EXPECT_TRUE(result.says("no network")) << patina_result_messages(result.handle);
    callbacks = {};
    callbacks.cancelled = [](void*) -> int { throw 7; };
    Result other;
    compile(other, compiler, nullptr, callbacks);
    EXPECT_EQ(other.status, PATINA_HAS_ERRORS);
}

TEST(CApi, ResolvesNamesAndAsksForTexturesAlone) {
    const Compiler compiler;
    Files files;
    files.texts = {{"id:7", kDots}};
    patina_callbacks callbacks = files.callbacks();
    callbacks.resolve = [](void*, const char*, const char* name, patina_reply* reply) {
        if (std::strcmp(name, "./dots.node.hlsl") == 0) patina_reply_text(reply, "id:7", 4);
    };
    callbacks.exists = [](void*, const char* path) { return int(std::strcmp(path, "./rust.png") == 0); };
    std::string graph = kGraph;
    graph.replace(graph.find("{ \"name\""), 0, R"({ "name": "_Map", "type": "texture2d", "default": "./rust.png" }, )");
    Result result;
    compile(result, compiler, nullptr, callbacks, graph);
    EXPECT_EQ(result.status, PATINA_OK) << patina_result_messages(result.handle);
    EXPECT_EQ(files.read, (std::map<std::string, int>{{"id:7", 1}}));
    callbacks.exists = [](void*, const char*) { return 0; };
    Result missing;
    compile(missing, compiler, nullptr, callbacks, graph);
    EXPECT_TRUE(missing.says("rust.png")) << patina_result_messages(missing.handle);
}

TEST(CApi, ARootHoldsAllThatIsRead) {
    const Compiler compiler;
    constexpr const char* kRoot = R"({ "root": "tests/unit/compiler", "targets": [] })";
    Result outside, inside, of_program;
    outside.status =
        patina_compile_file(compiler.handle, "examples/graphs/none.graph.json", kRoot, nullptr, &outside.handle);
    EXPECT_EQ(outside.status, PATINA_HAS_ERRORS);
    EXPECT_TRUE(outside.says("it is outside of the root folder 'tests/unit/compiler'"));
    inside.status = patina_compile(compiler.handle, "tests/unit/compiler/a.graph.json", kGraph, std::strlen(kGraph),
                                   kRoot, nullptr, &inside.handle);
    EXPECT_TRUE(inside.says("there is no file './dots.node.hlsl'"));
    // The program's own files are not those of the disk.
    Files files;
    files.texts["../dots.node.hlsl"] = kDots;
    std::string graph = kGraph;
    graph.replace(graph.find("./dots"), 6, "../dots");
    const patina_callbacks callbacks = {
        .user = &files, .read = Files::read_one, .exists = nullptr, .resolve = nullptr, .cancelled = nullptr};
    of_program.status = patina_compile(compiler.handle, "a.graph.json", graph.data(), graph.size(), kRoot, &callbacks,
                                       &of_program.handle);
    EXPECT_EQ(of_program.status, PATINA_OK) << patina_result_messages(of_program.handle);
}

TEST(CApi, EndsWhatIsCancelledOrTooLarge) {
    const Compiler compiler;
    Files files;
    patina_callbacks callbacks = files.callbacks();
    callbacks.cancelled = [](void*) { return 1; };
    Result cancelled, large;
    compile(cancelled, compiler, nullptr, callbacks);
    EXPECT_EQ(cancelled.status, PATINA_HAS_ERRORS);
    EXPECT_NE(std::strstr(patina_result_diagnostics(cancelled.handle), "\"cancelled\""), nullptr);
    compile(large, compiler, R"({"limits": {"shaderBytes": 100}})", files.callbacks());
    EXPECT_EQ(large.status, PATINA_HAS_ERRORS);
    EXPECT_NE(std::strstr(patina_result_diagnostics(large.handle), "\"over-budget\""), nullptr)
        << patina_result_messages(large.handle);
}

TEST(CApi, TheLibraryHasFilesOfTheProgram) {
    const Compiler compiler({{.name = "mine/dots.node.hlsl", .text = kDots, .size = std::strlen(kDots)}});
    Files files;
    std::string graph = kGraph;
    graph.replace(graph.find("./dots.node.hlsl"), 16, "Dots");
    Result result;
    compile(result, compiler, nullptr, files.callbacks(), graph);
    EXPECT_EQ(result.status, PATINA_OK) << patina_result_messages(result.handle);

    const Compiler broken({{.name = "mine/dots.node.hlsl", .text = "float Dots(", .size = 11}});
    Result errors;
    compile(errors, broken, nullptr, files.callbacks(), graph);
    EXPECT_EQ(errors.status, PATINA_HAS_ERRORS);
    EXPECT_TRUE(errors.says("mine/dots.node.hlsl:1:")) << patina_result_messages(errors.handle);
}

TEST(CApi, KeysTellWhatAResultDependsOn) {
    const Compiler compiler;
    Files files;
    const patina_callbacks callbacks = files.callbacks();
    const auto key = [&](const char* options) {
        char made[PATINA_KEY_SIZE] = "?";
        EXPECT_EQ(patina_cache_key(compiler.handle, "mine.graph.json", kGraph, std::strlen(kGraph), options, &callbacks,
                                   made),
                  PATINA_OK);
        EXPECT_EQ(std::strlen(made), 32u);
        return std::string(made);
    };
    const std::string plain = key(nullptr);
    EXPECT_EQ(key("{}"), plain);
    EXPECT_NE(key("{\"hashes\": true}"), plain);
    files.texts["dots.node.hlsl"] += "\n";
    EXPECT_NE(key(nullptr), plain);

    char other[PATINA_KEY_SIZE] = "?";
    EXPECT_EQ(patina_cache_key(compiler.handle, "mine.graph.json", "{}", 2, "{", &callbacks, other), PATINA_HAS_ERRORS);
    EXPECT_STREQ(other, "");
    files.texts["mine.graph.json"] = kGraph;
    EXPECT_EQ(patina_cache_key(compiler.handle, "mine.graph.json", nullptr, 0, nullptr, &callbacks, other), PATINA_OK);
    EXPECT_NE(other, plain);
    EXPECT_EQ(patina_cache_key(nullptr, "a", "{}", 2, nullptr, nullptr, other), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_cache_key(compiler.handle, "a", "{}", 2, nullptr, nullptr, nullptr), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_library_hash(nullptr, other), PATINA_BAD_ARGUMENT);

    char library[PATINA_KEY_SIZE], own[PATINA_KEY_SIZE];
    const Compiler mine({{.name = "mine/dots.node.hlsl", .text = kDots, .size = std::strlen(kDots)}});
    EXPECT_EQ(patina_library_hash(compiler.handle, library), PATINA_OK);
    EXPECT_EQ(patina_library_hash(mine.handle, own), PATINA_OK);
    EXPECT_STRNE(library, own);
}

TEST(CApi, ThreadsShareACompiler) {
    const Compiler compiler;
    std::vector<std::string> texts(4);
    std::vector<std::thread> threads;
    for (std::string& text : texts) {
        threads.emplace_back([&] {
            Files files;
            Result result;
            compile(result, compiler, nullptr, files.callbacks());
            for (size_t i = 0; i < patina_result_shader_count(result.handle); ++i)
                text += patina_result_shader(result.handle, i)->text;
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_GT(texts[0].size(), 1000u);
    for (const std::string& text : texts) EXPECT_EQ(text, texts[0]);
}

}  // namespace
