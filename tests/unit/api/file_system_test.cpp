// What the compiler asks of a program's own file system, and what it does with the answers.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

#include "patina/options.h"
#include "patina/patina.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

using Texts = std::map<std::string, std::string>;

constexpr const char* kWave = "/// A wave.\n[node(\"Test/Wave\")]\nfloat Wave(float2 uv = uv0) { return sin(uv.x); }\n";
constexpr const char* kDeep = R"json({ "patina": 1, "kind": "subgraph",
    "nodes": [ { "id": "wave", "node": "./wave.node.hlsl" } ], "outputs": { "value": "wave" } })json";
constexpr const char* kGraph = R"json({
    "patina": 1, "workflow": "unlit",
    "properties": [ { "name": "_Rust", "type": "texture2d", "default": "./rust.png" } ],
    "nodes": [ { "id": "a", "node": "./wave.node.hlsl" }, { "id": "b", "node": "./wave.node.hlsl" },
               { "id": "deep", "node": "./deep.subgraph.json" },
               { "id": "rust", "node": "SampleTexture2D", "in": { "texture": "$_Rust" } } ],
    "surface": { "color": "= rust.rgb * (a + b + deep)" }
})json";

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

std::optional<std::string> text_in(const Texts& texts, const std::string& path) {
    const auto found = texts.find(path);
    return found == texts.end() ? std::nullopt : std::optional(found->second);
}

std::string said(const Result& result) {
    std::string all;
    for (const Diagnostic& diagnostic : result.diagnostics) all += to_text(diagnostic) + "\n";
    return all;
}

const Texture& texture_of(const Result& result, std::string_view name) {
    const std::vector<Texture>& all = result.reflection.textures;
    const auto found = std::find_if(all.begin(), all.end(), [&](const Texture& each) { return each.name == name; });
    EXPECT_NE(found, all.end());
    return *found;
}

// Counts what is asked for.
struct Asked {
    std::map<std::string, int> read, exists;

    FileSystem over(const Texts& texts) {
        return {.resolve = {},
                .exists =
                    [&](const std::string& path) {
                        ++exists[path];
                        return path.ends_with(".png") || texts.contains(path);
                    },
                .read =
                    [&](const std::string& path) {
                        ++read[path];
                        return text_in(texts, path);
                    }};
    }
};

TEST(FileSystem, IsAskedOnceForEachFileAndNeverForTheBytesOfATexture) {
    const Texts texts = {{"m/wave.node.hlsl", kWave}, {"m/deep.subgraph.json", kDeep}};
    Asked asked;
    CompileOptions options;
    options.files = asked.over(texts);
    options.targets = {Target::Glsl, Target::Hlsl, {"unity", "hlsl"}};
    const Result result = compiler().compile_text("m/test.graph.json", kGraph, options);
    EXPECT_TRUE(result.ok) << said(result);
    EXPECT_EQ(asked.read, (std::map<std::string, int>{{"m/deep.subgraph.json", 1}, {"m/wave.node.hlsl", 1}}));
    EXPECT_EQ(asked.exists, (std::map<std::string, int>{{"m/rust.png", 1}}));
}

TEST(FileSystem, WithReadAloneIsAskedOnceToo) {
    const Texts texts = {{"wave.node.hlsl", kWave}, {"deep.subgraph.json", kDeep}, {"rust.png", "a picture"}};
    std::map<std::string, int> asked;
    CompileOptions options;
    options.files.read = [&](const std::string& path) {
        ++asked[path];
        return text_in(texts, path);
    };
    const Result result = compiler().compile_text("test.graph.json", kGraph, options);
    EXPECT_TRUE(result.ok) << said(result);
    EXPECT_EQ(asked, (std::map<std::string, int>{{"deep.subgraph.json", 1}, {"rust.png", 1}, {"wave.node.hlsl", 1}}));
}

TEST(FileSystem, IncludeFoldersAreSearchedAfterTheFilesOwn) {
    const Texts texts = {{"shared/wave.node.hlsl", kWave}, {"shared/deep.subgraph.json", kDeep}};
    Asked asked;
    CompileOptions options;
    options.files = asked.over(texts);
    options.include_dirs = {"none", "shared"};
    const Result result = compiler().compile_text("m/test.graph.json", kGraph, options);
    EXPECT_TRUE(result.ok) << said(result);
    EXPECT_EQ(asked.read["m/wave.node.hlsl"], 1);
    EXPECT_EQ(asked.read["none/wave.node.hlsl"], 1);
    EXPECT_EQ(asked.read["shared/wave.node.hlsl"], 1);
}

// A program that compiles again when a file changes must also know of those that are to appear.
TEST(FileSystem, AFailedCompilationDependsOnWhatItLookedFor) {
    const Texts texts = {{"m/wave.node.hlsl", kWave}};
    Asked asked;
    CompileOptions options;
    options.files = asked.over(texts);
    options.files.exists = [](const std::string&) { return false; };
    options.include_dirs = {"shared"};
    const Result result = compiler().compile_text("m/test.graph.json", kGraph, options);
    EXPECT_FALSE(result.ok);
    const std::set<std::string> files(result.dependencies.begin(), result.dependencies.end());
    for (const char* file :
         {"m/test.graph.json", "m/wave.node.hlsl", "m/deep.subgraph.json", "shared/deep.subgraph.json"})
        EXPECT_TRUE(files.contains(file)) << file;
}

// A file that is found along the second include folder was looked for in three others: a file there would be read
// instead. That a compilation goes well does not make them known any less.
TEST(FileSystem, WhatAFileWouldBeReadInsteadIsMissing) {
    Texts texts = {{"shared/wave.node.hlsl", kWave}, {"shared/deep.subgraph.json", kDeep}};
    Asked asked;
    CompileOptions options;
    options.files = asked.over(texts);
    options.files.exists = [](const std::string& path) { return path == "shared/rust.png"; };
    options.include_dirs = {"none", "shared"};
    const std::vector<std::string> dependencies = {"m/test.graph.json", "shared/wave.node.hlsl",
                                                   "shared/deep.subgraph.json", "shared/rust.png"};
    const std::vector<std::string> missing = {"m/deep.subgraph.json",    "m/rust.png",    "m/wave.node.hlsl",
                                              "none/deep.subgraph.json", "none/rust.png", "none/wave.node.hlsl"};
    const Compiler own;  // also of a kept result
    for (int times = 0; times < 3; ++times) {
        const Result result = own.compile_text("m/test.graph.json", kGraph, options);
        ASSERT_TRUE(result.ok) << said(result);
        EXPECT_EQ(std::set(result.dependencies.begin(), result.dependencies.end()),
                  std::set(dependencies.begin(), dependencies.end()));
        EXPECT_EQ(result.missing, missing);
    }
    options.targets = {Target::Glsl, Target{"unity", "hlsl"}};  // several engines: each file once
    EXPECT_EQ(own.compile_text("m/test.graph.json", kGraph, options).missing, missing);
    texts["none/wave.node.hlsl"] = kWave;
    const Result shadowed = own.compile_text("m/test.graph.json", kGraph, options);
    EXPECT_EQ(std::count(shadowed.missing.begin(), shadowed.missing.end(), "none/wave.node.hlsl"), 0);
    EXPECT_EQ(std::count(shadowed.dependencies.begin(), shadowed.dependencies.end(), "none/wave.node.hlsl"), 1);
    EXPECT_EQ(compiler().compile_file("m/gone.graph.json", options).missing,
              std::vector<std::string>{"m/gone.graph.json"});
}

// A graph, its parts and a texture that are URIs.
TEST(FileSystem, UrisStayWhatTheyAre) {
    const Texts texts = {{"pack://stone/wave.node.hlsl", kWave},
                         {"pack://stone/wet/a.graph.json", R"json({ "patina": 1, "workflow": "unlit",
        "properties": [ { "name": "_Rust", "type": "texture2d", "default": "tex://rust/../rust.png" } ],
        "nodes": [ { "id": "wave", "node": "../wave.node.hlsl" }, { "id": "same", "node": "pack://stone/wave.node.hlsl" },
                   { "id": "rust", "node": "SampleTexture2D", "in": { "texture": "$_Rust" } } ],
        "surface": { "color": "= rust.rgb * wave * same" } })json"}};
    CompileOptions options;
    options.files.read = [&](const std::string& path) { return text_in(texts, path); };
    options.files.exists = [](const std::string& path) { return path == "tex://rust/../rust.png"; };
    const Result result = compiler().compile_file("pack://stone/wet/a.graph.json", options);
    ASSERT_TRUE(result.ok) << said(result);
    EXPECT_EQ(result.dependencies, (std::vector<std::string>{"pack://stone/wet/a.graph.json",
                                                             "pack://stone/wave.node.hlsl", "tex://rust/../rust.png"}));
    const Texture& rust = texture_of(result, "_Rust");
    EXPECT_EQ(rust.default_texture, TextureDefault::File);
    EXPECT_EQ(rust.default_file, "tex://rust/../rust.png");
    EXPECT_EQ(result.shaders[0].file_name, "a.forward.vert.glsl");
}

// An engine whose assets have ids.
TEST(FileSystem, WhatTheProgramResolvesIsPassedOnUnchanged) {
    std::vector<std::pair<std::string, std::string>> resolved;
    CompileOptions options;
    options.include_dirs = {"library"};
    options.files.resolve = [&](const std::string& from, const std::string& name) -> std::string {
        resolved.emplace_back(from, name);
        if (from == "library/") return "";
        return name == "./wave.node.hlsl" ? "{7A..//1}" : name == "./deep.subgraph.json" ? "{7A..//2}" : "white";
    };
    options.files.exists = [](const std::string& path) { return path == "white"; };
    options.files.read = [](const std::string& path) -> std::optional<std::string> {
        if (path == "{7A..//1}") return kWave;
        if (path == "{7A..//2}") return kDeep;
        return {};
    };
    const Result result = compiler().compile_text("{7A..//0}", kGraph, options);
    ASSERT_TRUE(result.ok) << said(result);
    EXPECT_EQ(result.dependencies, (std::vector<std::string>{"{7A..//0}", "{7A..//1}", "{7A..//2}", "white"}));
    const Texture& rust = texture_of(result, "_Rust");
    EXPECT_EQ(rust.default_texture, TextureDefault::File);
    EXPECT_EQ(rust.default_file, "white");
    const auto has = [&](const char* from, const char* name) {
        return std::count(resolved.begin(), resolved.end(), std::pair<std::string, std::string>(from, name)) > 0;
    };
    EXPECT_TRUE(has("{7A..//0}", "./wave.node.hlsl"));
    EXPECT_TRUE(has("{7A..//2}", "./wave.node.hlsl"));
    EXPECT_TRUE(has("library/", "./rust.png"));
}

// The diagnostic with this code at a line of the graph, or an empty one.
Diagnostic at_line(const Result& result, std::string_view code, int line) {
    for (const Diagnostic& each : result.diagnostics)
        if (each.code == code && each.file == "test.graph.json" && each.line == line) return each;
    return {};
}

// An id may be any text; the names of the shaders are made of its last part.
TEST(FileSystem, ShadersHaveNamesThatEverySystemTakes) {
    const auto name_of = [](const std::string& path) {
        CompileOptions options;
        options.targets = {Target::Glsl};
        const Result result = compiler().compile_text(path, R"({ "patina": 1, "workflow": "unlit" })", options);
        EXPECT_TRUE(result.ok) << said(result);
        return result.shaders.empty() ? "" : result.shaders[0].file_name;
    };
    EXPECT_EQ(name_of("pack://wet stone/Öl-1.graph.json"), "Öl-1.forward.vert.glsl");
    EXPECT_EQ(name_of("id:1"), "id_1.forward.vert.glsl");
    EXPECT_EQ(name_of("asset?id=5&rev=2"), "asset_id=5&rev=2.forward.vert.glsl");
    EXPECT_EQ(name_of("a\"b<c>|*\n.graph.json"), "a_b_c____.forward.vert.glsl");
    EXPECT_EQ(name_of(""), "graph.forward.vert.glsl");
    EXPECT_EQ(name_of("x/"), "graph.forward.vert.glsl");
    EXPECT_EQ(name_of("Con.v1.graph.json"), "_on.v1.forward.vert.glsl");
    EXPECT_EQ(name_of("com1.graph.json"), "_om1.forward.vert.glsl");
    EXPECT_EQ(name_of("cone.graph.json"), "cone.forward.vert.glsl");
}

// `exists` is for textures: a path is there if its file can be read.
TEST(FileSystem, APassFileThatIsNotThereIsNotSuggested) {
    CompileOptions options;
    options.request = CompileOptions::Passes{.path = "nope"};
    options.files.exists = [](const std::string&) { return true; };
    options.files.read = [](const std::string&) { return std::optional<std::string>(); };
    const std::string graph = R"({ "patina": 1, "workflow": "unlit" })";
    EXPECT_EQ(said(compiler().compile_text("a.graph.json", graph, options)).find("nope.pass.hlsl"), std::string::npos);
    options.files.read = [](const std::string& path) {
        return path == "nope.pass.hlsl" ? std::optional<std::string>("") : std::nullopt;
    };
    EXPECT_NE(said(compiler().compile_text("a.graph.json", graph, options)).find("did you mean './nope.pass.hlsl'?"),
              std::string::npos);
}

TEST(FileSystem, WhatReadThrowsIsAnErrorWhereTheFileIsNamed) {
    CompileOptions options;
    options.files.exists = [](const std::string&) { return true; };
    options.files.read = [](const std::string& path) -> std::optional<std::string> {
        if (path == "wave.node.hlsl") throw std::runtime_error("the pack is locked");
        if (path == "deep.subgraph.json") throw 7;
        return {};
    };
    const Result result = compiler().compile_text("test.graph.json", kGraph, options);
    EXPECT_FALSE(result.ok);
    EXPECT_TRUE(result.shaders.empty());
    EXPECT_EQ(at_line(result, "cannot-read", 4).message, "cannot read 'wave.node.hlsl': the pack is locked");
    EXPECT_EQ(at_line(result, "cannot-read", 4).node, "a");
    EXPECT_EQ(at_line(result, "cannot-read", 5).message,
              "cannot read 'deep.subgraph.json': the program's file system failed");
}

TEST(FileSystem, WhatTheOthersThrowIsAnErrorWhereTheFileIsNamed) {
    CompileOptions options;
    options.files.read = [](const std::string&) { return std::optional<std::string>(kWave); };
    options.files.exists = [](const std::string&) -> bool { throw std::runtime_error("offline"); };
    const Result result = compiler().compile_text("test.graph.json", kGraph, options);
    EXPECT_FALSE(result.ok);
    EXPECT_EQ(at_line(result, "cannot-read", 3).message, "cannot read 'rust.png': offline");
    EXPECT_EQ(at_line(result, "missing-file", 3).message, "");

    options.files.resolve = [](const std::string&, const std::string& name) -> std::string {
        throw std::runtime_error("no asset " + name);
    };
    const Result unresolved = compiler().compile_text("test.graph.json", kGraph, options);
    EXPECT_FALSE(unresolved.ok);
    EXPECT_EQ(at_line(unresolved, "cannot-read", 5).message,
              "cannot read './deep.subgraph.json': no asset ./deep.subgraph.json");
}

TEST(FileSystem, AFileThatIsNotThereIsMissing) {
    CompileOptions options;
    options.files.read = [](const std::string&) { return std::optional<std::string>(); };
    const Result result = compiler().compile_text("test.graph.json", kGraph, options);
    EXPECT_EQ(at_line(result, "missing-file", 5).message, "there is no file './deep.subgraph.json'");
    const Result no_graph = compiler().compile_file("none.graph.json", options);
    EXPECT_EQ(said(no_graph), "error: there is no file 'none.graph.json' [missing-file]\n");
}

TEST(FileSystem, OfTheDiskSaysWhyAFileCannotBeRead) {
    const FileSystem files = disk();
    EXPECT_TRUE(files.exists("tests/unit/api/file_system_test.cpp"));
    EXPECT_FALSE(files.exists("tests/unit/api"));
    EXPECT_EQ(files.read("tests/unit/api/none"), std::nullopt);
    EXPECT_TRUE(files.read("tests/unit/api/file_system_test.cpp")->starts_with("// What the compiler asks"));
    try {
        files.read("tests/unit/api");
        ADD_FAILURE() << "a folder was read";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "it is a folder");
    }
    const auto resolved = [&](const char* from, const char* name) { return files.resolve(from, name); };
    EXPECT_EQ(resolved("m/wet/a.graph.json", "../rust.png"), "m/rust.png");
    EXPECT_EQ(resolved("m/", "./rust.png"), "m/rust.png");
    EXPECT_EQ(resolved("a.graph.json", "/textures/rust.png"), "/textures/rust.png");
    EXPECT_EQ(resolved("pack://stone/wet/a.graph.json", "../rust.png"), "pack://stone/rust.png");
    EXPECT_EQ(resolved("pack://stone/", "./a/./b/../rust.png"), "pack://stone/a/rust.png");
    EXPECT_EQ(resolved("pack://a.graph.json", "../../rust.png"), "pack://rust.png");
    EXPECT_EQ(resolved("pack://stone/a.graph.json", "/rust.png"), "pack://rust.png");
    EXPECT_EQ(resolved("m/a.graph.json", "pack://stone/../rust.png"), "pack://stone/../rust.png");
}

// The diagnostics of a graph that names a file, with files of a folder that the test makes.
class DiskFiles : public testing::Test {
protected:
    DiskFiles() {
        std::string name = (fs::temp_directory_path() / "patina_files_XXXXXX").string();
        folder = mkdtemp(name.data());
        fs::create_directories(folder / "art");
        write("art/wave.node.hlsl", kWave);
        write("out.node.hlsl", kWave);
        write("secret", "open sesame\n");
    }
    ~DiskFiles() override { fs::remove_all(folder); }
    std::string at(const std::string& name) const { return (folder / name).string(); }
    void write(const std::string& name, const std::string& text) const { std::ofstream(at(name)) << text; }
    static std::string using_node(const std::string& name) {
        return R"({ "patina": 1, "workflow": "unlit", "nodes": [ { "id": "a", "node": ")" + name +
               R"(" } ], "surface": { "color": "a" } })";
    }

    fs::path folder;
};

TEST_F(DiskFiles, ARootHoldsAllThatACompilationReads) {
    CompileOptions options;
    options.files = disk({.root = at("art")});
    write("art/good.graph.json", using_node("./wave.node.hlsl"));
    EXPECT_TRUE(compiler().compile_file(at("art/good.graph.json"), options).ok);
    write("out.graph.json", using_node("./out.node.hlsl"));
    const std::string outside = "it is outside of the root folder '" + at("art") + "'";
    EXPECT_NE(said(compiler().compile_file(at("out.graph.json"), options)).find(outside), std::string::npos);
    fs::create_symlink("../out.node.hlsl", folder / "art/link.node.hlsl");
    fs::create_symlink("..", folder / "art/up");
    for (const std::string& name :
         {std::string("../out.node.hlsl"), at("out.node.hlsl"), std::string("./link.node.hlsl"),
          std::string("./up/out.node.hlsl"), std::string("../nowhere.node.hlsl"), std::string("/etc/passwd")}) {
        write("art/bad.graph.json", using_node(name));
        const Result result = compiler().compile_file(at("art/bad.graph.json"), options);
        EXPECT_FALSE(result.ok);
        EXPECT_NE(said(result).find(outside), std::string::npos) << name << said(result);
    }
    write("art/picture.graph.json", kGraph);
    std::string textured = kGraph;
    textured.replace(textured.find("./rust.png"), 10, "../secret");
    EXPECT_NE(said(compiler().compile_text(at("art/t.graph.json"), textured, options)).find(outside),
              std::string::npos);
    // Another root has another answer, though the compiler keeps results.
    options.files = disk({.root = at("")});
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(compiler().compile_file(at("out.graph.json"), options).ok);
    options.files = disk({.root = at("art")});
    EXPECT_FALSE(compiler().compile_file(at("out.graph.json"), options).ok);
    EXPECT_NE(compiler().cache_key(at("out.graph.json"), options), compiler().cache_key(at("out.graph.json"), {}));
}

TEST_F(DiskFiles, AFileThatIsNoneOfOursIsNeverQuoted) {
    fs::create_symlink("secret", folder / "link.node.hlsl");
    fs::create_symlink("secret", folder / "link.subgraph.json");
    write("token.json", "{ \"token\": \"sesame\" ");
    for (const FileSystem& files : {FileSystem{}, disk()}) {
        CompileOptions options;
        options.files = files;
        options.dump = {"graph", "ir"};
        for (const std::string name :
             {"./secret", "./link.node.hlsl", "./link.subgraph.json", "./token.json", "/proc/self/environ"}) {
            write("a.graph.json", using_node(name));
            const Result result = compiler().compile_file(at("a.graph.json"), options);
            EXPECT_NE(said(result).find("it is neither a graph nor a file of nodes"), std::string::npos)
                << said(result);
            for (const Diagnostic& each : result.diagnostics)
                EXPECT_EQ((to_text(each) + to_json(each) + each.source_line).find("sesame"), std::string::npos) << name;
            for (const Dump& dump : result.dumps) EXPECT_EQ(dump.text.find("sesame"), std::string::npos);
        }
    }
    // What the program names is its own, and so are texts of its own file system.
    EXPECT_NE(said(compiler().compile_file(at("secret"))).find("open sesame"), std::string::npos);
    CompileOptions own;
    own.files.read = [](const std::string&) { return std::optional<std::string>("open sesame"); };
    EXPECT_NE(said(compiler().compile_text("x", using_node("./some-id"), own)).find("open sesame"), std::string::npos);
    // A graph without the ending is one by its content.
    write("mine", R"({ "patina": 1, "kind": "subgraph", "nodes": [ }, "outputs": { } })");
    write("a.graph.json", using_node("./mine"));
    EXPECT_NE(said(compiler().compile_file(at("a.graph.json"))).find("\"nodes\": [ }"), std::string::npos);
}

TEST_F(DiskFiles, NoMoreIsReadThanWhatIsLeftOfTheBudget) {
    write("a.graph.json", using_node("./large.node.hlsl"));
    write("large.node.hlsl", kWave);
    fs::resize_file(at("large.node.hlsl"), 60u << 20);
    CompileOptions options;
    options.limits.source_bytes = 10'000;
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    const Result result = compiler().compile_file(at("a.graph.json"), options);
    getrusage(RUSAGE_SELF, &after);
    EXPECT_NE(said(result).find("more than the budget of 10000 (node 'a') [over-budget]"), std::string::npos)
        << said(result);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 30 << 10) << "kilobytes";
    fs::resize_file(at("a.graph.json"), std::uintmax_t{2} << 30);
    EXPECT_NE(said(compiler().compile_file(at("a.graph.json"))).find("[too-large]"), std::string::npos);
    options = {};
    options.files = disk({.most_bytes = 100});
    write("a.graph.json", using_node("./wave.node.hlsl") + std::string(100, ' '));
    EXPECT_NE(said(compiler().compile_file(at("a.graph.json"), options)).find("it has more than 100 bytes"),
              std::string::npos);
}

// A compiler keeps what it made of a function. The text of a [foreign] one is a part of what it is made of.
TEST(FileSystem, ForeignCodeThatChangesIsPrintedAnew) {
    const auto printed = [](const std::string& code, const std::string& helper) {
        CompileOptions options;
        options.targets = compiler().targets("hlsl");
        options.files.read = [&](const std::string& path) -> std::optional<std::string> {
            if (!path.ends_with("text.node.hlsl")) return std::nullopt;
            return "[foreign]\nfloat " + helper + "(float x) { return x; }\n[node(\"Test/Text\")]\n[foreign]\n" +
                   "float Text(float x) { return " + code + "; }\n";
        };
        const Result result =
            compiler().compile_text("a.graph.json",
                                    R"({ "patina": 1, "workflow": "unlit", "surface": { "color": "text" },
                 "nodes": [ { "id": "text", "node": "./text.node.hlsl", "in": { "x": "@uv0.x" } } ] })",
                                    options);
        EXPECT_TRUE(result.ok) << said(result);
        return result.ok ? result.shaders.back().text : std::string();
    };
    EXPECT_NE(printed("help(x)", "help").find("return Text_help(x);"), std::string::npos);
    EXPECT_NE(printed("help(x) * 2", "help").find("return Text_help(x) * 2;"), std::string::npos);
    EXPECT_NE(printed("aid(x)", "aid").find("float Text_aid(float x)\n{\n    return x;\n}"), std::string::npos);
    EXPECT_NE(printed("help(x)", "help").find("return Text_help(x);"), std::string::npos);
}

}  // namespace
}  // namespace patina
