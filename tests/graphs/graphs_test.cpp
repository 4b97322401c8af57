// Each folder next to this file is a test: a small graph, and its expected output. The *.graph.json of the folder is
// compiled; both other compilers must accept every stage, and GLSL, HLSL and reflection are compared with the files
// next to it. A folder with a file `prefix` expects functions with that prefix instead of passes, and one with a file
// `target` expects that language alone. A change of a printer shows here as a diff that a reviewer can read:
// tests/accept accepts it.
#include <algorithm>
#include <vector>

#include "patina/validate.h"
#include "tests/support/received.h"

namespace patina::testing {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> stories() {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(tests_folder() / "graphs")) {
        if (entry.is_directory()) names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
}

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

std::string first_line(const std::string& file) {
    const std::string text = read_file(tests_folder() / file);
    return text.substr(0, text.find('\n'));
}

CompileOptions options_of(const std::string& folder) {
    CompileOptions options;
    const std::string prefix = first_line(folder + "prefix"), target = first_line(folder + "target");
    if (!prefix.empty()) options.request = CompileOptions::Functions{.prefix = prefix};
    if (!target.empty()) options.targets = compiler().targets(target);
    return options;
}

class Story : public ::testing::TestWithParam<std::string> {};

TEST_P(Story, BecomesWhatIsExpected) {
    const std::string folder = "graphs/" + GetParam() + "/";
    int graphs = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(tests_folder() / folder)) {
        const std::string path = entry.path();
        if (!path.ends_with(".graph.json")) continue;
        ++graphs;
        const Result result = compiler().compile_file(path, options_of(folder));
        for (const Diagnostic& d : result.diagnostics) ADD_FAILURE() << to_text(d);
        ASSERT_TRUE(result.ok);
        for (const Shader& shader : result.shaders) {
            const Validated validated = validate(shader);
            EXPECT_TRUE(validated.ok) << validated.log;
            EXPECT_TRUE(as_expected(folder + shader.file_name, shader.text));
        }
        const std::string name = entry.path().filename();
        EXPECT_TRUE(
            as_expected(folder + name.substr(0, name.find('.')) + ".reflect.json", result.reflection.to_json()));
    }
    EXPECT_GE(graphs, 1) << "no *.graph.json in " << folder;
}

// The same graph gives the same bytes, from another compiler and beside other work.
TEST_P(Story, IsTheSameEachTime) {
    const std::string folder = "graphs/" + GetParam() + "/";
    for (const fs::directory_entry& entry : fs::directory_iterator(tests_folder() / folder)) {
        if (!entry.path().string().ends_with(".graph.json")) continue;
        const Compiler other;
        const Result first = compiler().compile_file(entry.path(), options_of(folder));
        const Result second = other.compile_file(entry.path(), options_of(folder));
        ASSERT_EQ(first.shaders.size(), second.shaders.size());
        for (std::size_t i = 0; i < first.shaders.size(); ++i) {
            EXPECT_EQ(first.shaders[i].text, second.shaders[i].text);
        }
        EXPECT_EQ(first.reflection.to_json(), second.reflection.to_json());
    }
}

// Where the command runs, and how it names the graph, are no part of what it writes.
TEST(Reflections, NameTexturesFromTheGraphsFolder) {
    const fs::path source = tests_folder().parent_path();
    const fs::path folder = received_folder() / "run" / "reflections";
    fs::remove_all(folder);
    struct Case {
        fs::path where;
        std::string graph;
    };
    const std::string name = "examples/graphs/mossy_rock.graph.json";
    std::string first;
    for (const Case& each : {Case{source, name}, Case{source / "examples/graphs", "mossy_rock.graph.json"},
                             Case{source / "tests", "../" + name}, Case{source, (source / name).string()}}) {
        const Ran ran = run("patina compile " + each.graph + " -t glsl -o " + folder.string(), each.where);
        ASSERT_EQ(ran.exit, 0) << ran.output;
        const std::string reflection = read_file(folder / "mossy_rock.reflect.json");
        if (first.empty()) first = reflection;
        EXPECT_EQ(reflection, first) << each.graph;
    }
    EXPECT_NE(first.find("\"default\": \"textures/rock_color.png\""), std::string::npos) << first;
}

// A file that was found in an include folder is named from the graph's folder too, and is no default of the same name.
TEST(Reflections, NameIncludedTexturesFromTheGraphsFolder) {
    CompileOptions options;
    options.include_dirs = {"art/shared"};
    options.files.read = [](const std::string& path) -> std::optional<std::string> {
        if (path == "art/shared/rust.png" || path == "art/graphs/white") return "";
        return {};
    };
    const Result result = compiler().compile_text("art/graphs/plain.graph.json", R"({
        "patina": 1,
        "workflow": "unlit",
        "properties": [
            { "name": "_A", "type": "texture2d", "default": "./rust.png" },
            { "name": "_B", "type": "texture2d", "default": "./white" },
            { "name": "_C", "type": "texture2d", "default": "white" }
        ]
    })",
                                                  options);
    for (const Diagnostic& d : result.diagnostics) ADD_FAILURE() << to_text(d);
    ASSERT_GE(result.reflection.textures.size(), 3u);  // the engine has textures too
    EXPECT_EQ(result.reflection.textures[0].default_file, "../shared/rust.png");
    EXPECT_EQ(result.reflection.textures[1].default_file, "./white");
    EXPECT_EQ(result.reflection.textures[2].default_texture, TextureDefault::White);
}

INSTANTIATE_TEST_SUITE_P(All, Story, ::testing::ValuesIn(stories()), [](const auto& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace patina::testing
