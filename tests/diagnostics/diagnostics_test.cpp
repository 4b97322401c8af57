// Each folder next to this file is named for a code, of diagnostics.def (the compiler) or of complaints.def (the
// command, the importers and the runtime), and holds the smallest inputs that provoke it. Every *.graph.json and
// *.scene.json in it is checked by `patina check`, or, where the folder has a file `commands`, each of its lines is run
// in a copy of the folder. What is printed is compared with expected.txt: place, caret, words, suggestion, exit code.
#include "compiler/base/diagnostics.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <vector>

#include "patina/complaints.h"
#include "patina/validate.h"
#include "tests/support/received.h"

namespace patina::testing {
namespace {

namespace fs = std::filesystem;

// Codes without a folder, each with the reason.
constexpr std::pair<std::string_view, std::string_view> kExempt[] = {
    {"downstream-error",
     "a shader that another compiler refuses is a fault of the printers; validate_test.cpp makes one"},
    {"cancelled", "only a program that embeds the library cancels; budget_test.cpp does"},
    {"no-program", "the command refuses it before it compiles; budget_test.cpp does"},
    {"over-budget", "only a program that embeds the library sets budgets; budget_test.cpp does"},
    {"two-values", "the command refuses it before it compiles; budget_test.cpp does"},
    {"internal", "a library without one of its slots cannot be built"},
    {"out-of-memory", "no input alone provokes it; tests/seams makes allocations fail"},
    {"system-refuses", "it is of the machine: no threads, no descriptors"},
};

// Codes of both tables.
std::set<std::string_view> known_codes() {
    std::set<std::string_view> codes;
    for (const CodeInfo& info : all_codes()) codes.insert(info.name);
    for (const ComplaintInfo& info : all_complaints()) codes.insert(info.code);
    return codes;
}

// True if compiling does not look for what is wrong.
bool is_only_checked(std::string_view code) {
    return std::ranges::any_of(all_complaints(),
                               [&](const ComplaintInfo& info) { return info.code == code && info.only_checked; });
}

// A command ends with 0 or 1, or, if what is wrong is not a file's fault, with the usage's or the machine's code.
bool is_expected_exit(const std::string& code, int exit) {
    if (code == "usage" || code == "bad-value") return exit == 1 || exit == 2;
    if (code == "missing-program") return exit == 3;
    return exit == 0 || exit == 1;
}

bool is_exempt(std::string_view code) {
    return std::any_of(std::begin(kExempt), std::end(kExempt), [&](const auto& row) { return row.first == code; });
}

std::vector<std::string> folders() {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(tests_folder() / "diagnostics")) {
        if (entry.is_directory()) names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> files_of(const fs::path& folder, const std::string& ending) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().string().ends_with(ending)) names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> commands_of(const fs::path& folder) {
    std::vector<std::string> commands;
    if (fs::exists(folder / "commands")) {
        std::istringstream lines(read_file(folder / "commands"));
        for (std::string line; std::getline(lines, line);) {
            if (!line.empty() && line[0] != '#') commands.push_back(line);
        }
        return commands;
    }
    for (const char* ending : {".graph.json", ".scene.json"}) {
        for (const std::string& file : files_of(folder, ending)) commands.push_back("patina check " + file);
    }
    return commands;
}

// A fresh copy of the folder, for commands to run in.
fs::path working_copy(const std::string& code) {
    const fs::path copy = received_folder() / "run" / code;
    fs::remove_all(copy);
    fs::create_directories(copy.parent_path());
    fs::copy(tests_folder() / "diagnostics" / code, copy, fs::copy_options::recursive);
    return copy;
}

class DiagnosticFolder : public ::testing::TestWithParam<std::string> {};

TEST_P(DiagnosticFolder, PrintsWhatIsExpected) {
    const std::string& code = GetParam();
    const fs::path folder = working_copy(code);
    std::string text;
    for (const std::string& command : commands_of(folder)) {
        const Ran ran = run(command, folder);
        EXPECT_TRUE(is_expected_exit(code, ran.exit)) << command << " ended with " << ran.exit << "\n" << ran.output;
        text += "$ " + command + "\n" + ran.output + "exit " + std::to_string(ran.exit) + "\n\n";
    }
    EXPECT_NE(text.find("[" + code + "]"), std::string::npos) << "nothing here provokes the code:\n" << text;
    EXPECT_TRUE(as_expected("diagnostics/" + code + "/expected.txt", text));
}

// Every graph alone, and as the commands check it along a path. What only `patina check` looks for, it may have options
// for that `patina compile` does not know.
std::set<std::string> compilations_of(const std::string& code, const fs::path& folder) {
    const std::string check = "patina check ";
    std::set<std::string> arguments;
    for (const std::string& graph : files_of(folder, ".graph.json")) arguments.insert(graph);
    if (is_only_checked(code)) return arguments;
    for (const std::string& command : commands_of(folder)) {
        if (command.starts_with(check) && command.find(".graph.json ") != command.npos)
            arguments.insert(command.substr(check.size()));
    }
    return arguments;
}

// An error leaves no file behind, however far the compiler came. An error that only `patina check` looks for is none of
// the compiler's.
TEST_P(DiagnosticFolder, LeavesNoPartialOutput) {
    const std::string& code = GetParam();
    const fs::path folder = working_copy(code);
    for (const std::string& arguments : compilations_of(code, folder)) {
        const Ran ran = run("patina compile " + arguments + " -o out --depfile", folder);
        const int expected = is_only_checked(code) ? 0 : run("patina check " + arguments, folder).exit;
        EXPECT_EQ(ran.exit, expected) << arguments << "\n" << ran.output;
        EXPECT_EQ(fs::exists(folder / "out"), expected == 0) << arguments << "\n" << ran.output;
        fs::remove_all(folder / "out");
    }
}

INSTANTIATE_TEST_SUITE_P(All, DiagnosticFolder, ::testing::ValuesIn(folders()), [](const auto& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(DiagnosticFolders, OneForEachCode) {
    const std::vector<std::string> names = folders();
    for (const std::string_view code : known_codes()) {
        const bool has_folder = std::find(names.begin(), names.end(), code) != names.end();
        EXPECT_NE(has_folder, is_exempt(code))
            << code << (has_folder ? " is exempt, but has a folder" : " needs an example in tests/diagnostics");
    }
    for (const std::string& name : names) {
        EXPECT_TRUE(known_codes().contains(name)) << name << " is not a code of diagnostics.def or complaints.def";
    }
}

// What is wrong with the command itself is said before any file is looked for, and ends with 2.
TEST(Usage, IsRefusedWithWhatIsWrong) {
    const std::pair<std::string, std::string> cases[] = {
        {"plain.graph.json -t glsl,,hlsl",
         "--target: '' is not a target; these exist: glsl, hlsl, vulkan, unity and spirv"},
        {"plain.graph.json -t glsl -t hlsl,",
         "--target: '' is not a target; these exist: glsl, hlsl, vulkan, unity and spirv"},
        {"plain.graph.json -t glsl,metal",
         "--target: 'metal' is not a target; these exist: glsl, hlsl, vulkan, unity and spirv"},
        {"plain.graph.json --dump ,tidy", "--dump: '' is not a step; these exist: graph, ir, linked, tidy and rates"},
        {"a/plain.graph.json b/plain.graph.json",
         "GRAPH: 'a/plain.graph.json' and 'b/plain.graph.json' would both write plain.*: compile them into different "
         "folders"},
        {"a/plain.graph.json b/Plain.graph.json",
         "GRAPH: 'a/plain.graph.json' and 'b/Plain.graph.json' would write plain.* and Plain.*, which are one for some "
         "file systems: compile them into different folders"}};
    const fs::path folder = received_folder() / "run";
    fs::create_directories(folder);
    for (const auto& [arguments, message] : cases) {
        const Ran ran = run("patina compile " + arguments, folder);
        EXPECT_EQ(ran.exit, 2) << arguments;
        EXPECT_EQ(ran.output, "patina compile: " + message + "\ntry 'patina compile --help'\n") << arguments;
    }
}

TEST(DiagnosticsOfTheLibrary, UnknownPass) {
    const Compiler compiler;
    CompileOptions options;
    options.request = CompileOptions::Passes{.only = {"forwrad"}};
    const Result result = compiler.compile_text("plain.graph.json", R"({ "patina": 1, "workflow": "unlit" })", options);
    EXPECT_FALSE(result.ok);
    EXPECT_TRUE(result.shaders.empty());
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(to_text(result.diagnostics[0]),
              "error: there is no pass 'forwrad' [unknown-pass]\nnote: did you mean 'forward'?");
}

// Words that mean something in a target language, and names that no target takes as they are: renamed in the shader, or
// refused with a place. Other compilers say whether a raw one got through.
class Identifiers : public ::testing::TestWithParam<const char*> {};

TEST_P(Identifiers, AreNeverEmittedRaw) {
    std::string text = R"json({
        "patina": 1,
        "workflow": "unlit",
        "properties": [
            { "name": "WORD", "type": "float", "default": 0.5 },
            { "name": "_Choice", "type": "enum", "values": ["Other", "WORD"] },
            { "name": "_WORD", "type": "texture2d", "tiling": true }
        ],
        "nodes": [
            { "id": "WORD", "expr": "@uv0 * $WORD", "stage": "vertex" },
            { "id": "texel", "node": "SampleTexture2D", "in": { "texture": "$_WORD", "uv": "WORD" } },
            { "id": "part", "node": "./part.subgraph.json", "in": { "WORD": "texel.r" } },
            { "id": "own", "node": "./own.node.hlsl", "in": { "WORD": "part.WORD" } }
        ],
        "surface": { "color": "= own + ($_Choice == WORD ? 1.0 : 0.5)", "alpha": "texel.a" }
    })json";
    std::string part = R"json({
        "patina": 1,
        "kind": "subgraph",
        "inputs": [ { "name": "WORD", "type": "float" } ],
        "nodes": [ { "id": "inner", "expr": "sin($WORD)" } ],
        "outputs": { "WORD": "= inner * 2", "rest": "inner" }
    })json";
    std::string own = R"hlsl(
        struct Pair { float WORD; float other; };
        float helper(Pair pair) { return pair.WORD * pair.other; }
        [node("Test/Own")]
        float Own(float WORD) {
            Pair pair;
            pair.WORD = WORD;
            pair.other = ddx(WORD);
            for (int i = 0; i < 3; i++) { pair.WORD += helper(pair); }
            return helper(pair);
        }
    )hlsl";
    const std::string word = GetParam();
    for (std::string* file : {&text, &part, &own}) {
        for (std::size_t at = 0; (at = file->find("WORD", at)) != std::string::npos; at += word.size()) {
            file->replace(at, 4, word);
        }
    }
    CompileOptions options;
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        if (path == "part.subgraph.json") return part;
        if (path == "own.node.hlsl") return own;
        return {};
    };
    const Compiler compiler;
    const Result result = compiler.compile_text("word.graph.json", text, options);
    for (const Diagnostic& d : result.diagnostics) EXPECT_GT(d.line, 0) << to_text(d);
    EXPECT_EQ(result.ok, !result.shaders.empty());
    EXPECT_NE(result.ok, std::any_of(result.diagnostics.begin(), result.diagnostics.end(),
                                     [](const Diagnostic& d) { return d.severity == Severity::Error; }));
    for (const Shader& shader : result.shaders) {
        const Validated validated = validate(shader);
        EXPECT_TRUE(validated.ok) << validated.log << shader.text;
    }
    RecordProperty("accepted", result.ok ? "yes" : "no");
}

INSTANTIATE_TEST_SUITE_P(Words, Identifiers,
                         ::testing::Values("texture", "float", "class", "main", "gl_x", "gl_Position", "a__b", "__x",
                                           "x_", "_", "if", "in", "out", "sampler", "half", "Light", "Surface",
                                           "surface", "Material", "Camera", "positionOS", "uv0", "saturate", "mix",
                                           "lerp", "vec3", "sample", "filter", "line", "point", "linear", "pass",
                                           "true", "default", "int", "fract", "SV_Target", "inUv0", "value", "at", "s",
                                           "forward", "input", "WorD", "Texture2D", "register", "defined", "discardIf",
                                           "return"));

}  // namespace
}  // namespace patina::testing
