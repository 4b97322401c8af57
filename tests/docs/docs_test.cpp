// The examples of the documentation work. A fenced block whose first line is `// NAME` is the file NAME; the files of
// one page lie in one folder. Each graph compiles without a complaint and both other compilers accept its shaders; each
// scene can be read; each path draws the page's graphs; each file of nodes is sound and its test lines hold; every
// other file is used by one of these. A
// ```glsl block is what the graph before it becomes, a ```shaderlab block what it becomes for Unity.
#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "patina/validate.h"
#include "tests/support/received.h"

namespace patina::testing {
namespace {

namespace fs = std::filesystem;

struct Block {
    std::string language;  // "jsonc"
    std::string name;      // "plain.graph.json"; empty if its first line names no file
    std::string text;
};

std::vector<Block> blocks_of(const std::string& page) {
    std::vector<Block> blocks;
    std::istringstream lines(page);
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            inside = !inside;
            if (inside) blocks.push_back({.language = line.substr(3), .name = {}, .text = {}});
            continue;
        }
        if (!inside) continue;
        Block& block = blocks.back();
        const bool is_name = block.text.empty() && line.starts_with("// ") && line.find(' ', 3) == std::string::npos &&
                             (line.ends_with(".json") || line.ends_with(".hlsl"));
        if (is_name) block.name = line.substr(3);
        block.text += line + "\n";
    }
    return blocks;
}

std::string joined(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& d : diagnostics) text += to_text(d) + "\n";
    return text;
}

class Page : public ::testing::TestWithParam<const char*> {};

TEST_P(Page, HoldsExamplesThatWork) {
    const std::vector<Block> blocks = blocks_of(read_file(tests_folder().parent_path() / GetParam()));
    const fs::path folder = received_folder() / "run" / "docs" / fs::path(GetParam()).stem();
    fs::remove_all(folder);
    for (const Block& block : blocks) {
        if (!block.name.empty()) write_file(folder / block.name, block.text);
    }
    const Compiler compiler;
    std::vector<std::string> used;
    std::string last_shaders, last_file;
    int examples = 0;
    for (const Block& block : blocks) {
        const std::string path = folder / block.name;
        if (block.name.ends_with(".graph.json")) {
            ++examples;
            const Result result = compiler.compile_file(path);
            EXPECT_TRUE(result.ok && result.diagnostics.empty()) << joined(result.diagnostics);
            used.insert(used.end(), result.dependencies.begin(), result.dependencies.end());
            last_shaders.clear();
            for (const Shader& shader : result.shaders) {
                const Validated validated = validate(shader);
                EXPECT_TRUE(validated.ok) << validated.log;
                last_shaders += shader.text;
            }
            CompileOptions unity;
            unity.targets = {{"unity", "hlsl"}};
            const Result file = compiler.compile_file(path, unity);
            last_file = file.ok ? file.shaders.front().text : std::string();
        } else if (block.name.ends_with(".scene.json")) {
            ++examples;
            const SceneResult scene = compiler.read_scene(path);
            EXPECT_TRUE(scene.ok && scene.diagnostics.empty()) << joined(scene.diagnostics);
            used.push_back(path);
            for (const SceneMaterial& material : scene.scene.materials) used.push_back(material.graph.path);
        } else if (block.name.ends_with(".pass.hlsl")) {
            // A path of one's own draws every graph of its page.
            ++examples;
            used.push_back(path);
            CompileOptions along;
            along.request = CompileOptions::Passes{.path = path};
            for (const Block& graph : blocks) {
                if (!graph.name.ends_with(".graph.json")) continue;
                const Result result = compiler.compile_file(folder / graph.name, along);
                EXPECT_TRUE(result.ok && result.diagnostics.empty()) << joined(result.diagnostics);
                EXPECT_EQ(result.reflection.path + ".pass.hlsl", block.name);
                for (const Shader& shader : result.shaders) EXPECT_TRUE(validate(shader).ok) << shader.text;
            }
        } else if (block.name.ends_with(".node.hlsl")) {
            ++examples;
            used.push_back(path);
            const NodeFileResult result = compiler.check_node_file(path);
            EXPECT_TRUE(result.ok && result.diagnostics.empty()) << joined(result.diagnostics);
            for (const NodeTest& test : result.tests) EXPECT_TRUE(passed(test)) << test.text;
        } else if (block.language == "glsl" || block.language == "shaderlab") {
            const std::string& emitted = block.language == "glsl" ? last_shaders : last_file;
            // Declarations are left out there: paragraph by paragraph.
            for (std::size_t at = 0; at < block.text.size();) {
                const std::size_t end = std::min(block.text.find("\n\n", at), block.text.size() - 1) + 1;
                const std::string paragraph = block.text.substr(at, end - at);
                EXPECT_NE(emitted.find(paragraph), std::string::npos) << "no longer emitted:\n" << paragraph;
                at = end + 1;
            }
        }
    }
    EXPECT_GE(examples, 1) << "no example was found";
    for (const Block& block : blocks) {
        if (block.name.empty()) continue;
        const bool is_used = std::any_of(
            used.begin(), used.end(), [&](const std::string& path) { return fs::path(path).filename() == block.name; });
        EXPECT_TRUE(is_used) << block.name << " is used by no graph of the page";
    }
}

TEST(Library, HasNoErrors) {
    const Compiler compiler;
    for (const Diagnostic& d : compiler.library_diagnostics()) ADD_FAILURE() << to_text(d);
}

// In the comment above its graph; see docs/graph-format.md.
TEST(Models, SayWhenToUseThemAndWhereTheyComeFrom) {
    const Compiler compiler;
    for (const ModelInfo& model : compiler.lighting_models()) {
        EXPECT_FALSE(model.doc == model.title) << model.file << ": there is no comment above the graph";
        EXPECT_FALSE(model.use.empty()) << model.file << ": the comment has no line 'use:'";
        const bool is_lit = model.name != "unlit";
        EXPECT_TRUE(!is_lit || !model.source.empty()) << model.file << ": the comment has no line 'source:'";
        EXPECT_TRUE(!is_lit || !model.formula.empty()) << model.file << ": the comment has no line 'formula:'";
    }
}

// What scripts/pictures draws: nothing is left out.
TEST(Pictures, ShowEveryLightingTermModelAndExample) {
    const fs::path docs = tests_folder().parent_path() / "docs", root = docs.parent_path();
    const std::string plots = read_file(docs / "nodes/plots.json"), gallery = read_file(docs / "gallery.md");
    const std::string families = read_file(docs / "nodes/families.json");
    const Compiler compiler;
    for (const NodeInfo& node : compiler.nodes()) {
        if (node.category != "Lighting" && !node.category.starts_with("Lighting/")) continue;
        const bool is_plotted = plots.find("\"node\": \"" + node.name + "\"") != plots.npos;
        const bool is_without = plots.find("\"" + node.name + "\": \"") != plots.npos;
        EXPECT_NE(is_plotted, is_without) << node.name << " is to be in docs/nodes/plots.json, once";
        const bool has_own = fs::exists(docs / ("nodes/plots/" + node.name + ".svg"));
        const bool is_shared = families.find('"' + node.name + '"') != families.npos;
        EXPECT_TRUE(is_plotted ? has_own || is_shared : !has_own) << node.name << ": run scripts/pictures plots";
    }
    for (const ModelInfo& model : compiler.lighting_models()) {
        const std::string picture = "models/pictures/" + model.name + ".png";
        EXPECT_TRUE(fs::exists(docs / picture) && gallery.find(picture) != gallery.npos)
            << "run scripts/pictures models";
    }
    int examples = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / "examples")) {
        const std::string path = fs::relative(entry.path(), root / "examples").string();
        if (!path.ends_with(".graph.json")) continue;
        ++examples;
        const std::string picture = "gallery/" + path.substr(0, path.size() - 11) + ".png";
        EXPECT_TRUE(fs::exists(docs / picture) && gallery.find(picture) != gallery.npos)
            << picture << ": run scripts/pictures examples";
    }
    EXPECT_GE(examples, 10);
}

// What a node's manual page offers to paste can be pasted, if nothing has to be filled in.
TEST(ManualPage, OffersANodeThatCompiles) {
    const Compiler compiler;
    int pasted = 0;
    for (const NodeInfo& node : compiler.nodes()) {
        const std::string page = run("patina node " + node.name, received_folder()).output;
        const std::size_t begin = page.find("{ \"id\": \"myNode\"");
        ASSERT_NE(begin, page.npos) << node.name;
        const std::string snippet = page.substr(begin, page.find('\n', begin) - begin);
        if (snippet.find("\"...\"") != snippet.npos) continue;
        ++pasted;
        const Result result =
            compiler.compile_text("page.graph.json", R"({ "patina": 1, "workflow": "unlit", "nodes": [ )" + snippet +
                                                         R"( ], "surface": { "color": "#808080" } })");
        EXPECT_TRUE(result.ok) << snippet << (result.diagnostics.empty() ? "" : to_text(result.diagnostics[0]));
    }
    EXPECT_GT(pasted, 50);
}

INSTANTIATE_TEST_SUITE_P(All, Page,
                         ::testing::Values("docs/graph-format.md", "docs/node-language.md", "docs/rendering-paths.md",
                                           "docs/adding-a-node.md", "docs/cost.md", "docs/unity.md", "README.md"),
                         [](const auto& info) {
                             std::string name = fs::path(info.param).stem();
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace patina::testing
