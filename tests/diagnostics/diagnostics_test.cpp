// Each folder beside this file is named for a code of diagnostics.def and holds the smallest inputs that provoke it.
// Every *.graph.json in it is checked by `patina check`, or, where the folder has a file `commands`, each of its lines
// is run in a copy of the folder. What is printed is compared with expected.txt: place, caret, words, suggestion, exit
// code.
#include "compiler/base/diagnostics.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "tests/support/received.h"

namespace patina::testing {
namespace {

namespace fs = std::filesystem;

// Codes without a folder, each with the reason.
constexpr std::pair<std::string_view, std::string_view> kExempt[] = {
    {"downstream-error",
     "a shader that another compiler refuses is a fault of the printers; validate_test.cpp makes one"},
    {"internal", "a library without one of its slots cannot be built"},
};

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

std::vector<std::string> graphs_of(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().string().ends_with(".graph.json")) names.push_back(entry.path().filename());
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
    for (const std::string& graph : graphs_of(folder)) commands.push_back("patina check " + graph);
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
        EXPECT_TRUE(ran.exit == 0 || ran.exit == 1) << command << " ended with " << ran.exit << "\n" << ran.output;
        text += "$ " + command + "\n" + ran.output + "exit " + std::to_string(ran.exit) + "\n\n";
    }
    EXPECT_NE(text.find("[" + code + "]"), std::string::npos) << "nothing here provokes the code:\n" << text;
    EXPECT_TRUE(as_expected("diagnostics/" + code + "/expected.txt", text));
}

// An error leaves no file behind, however far the compiler came.
TEST_P(DiagnosticFolder, LeavesNoPartialOutput) {
    const fs::path folder = working_copy(GetParam());
    for (const std::string& graph : graphs_of(folder)) {
        const Ran ran = run("patina compile " + graph + " -o out --depfile", folder);
        EXPECT_EQ(ran.exit == 0, fs::exists(folder / "out")) << graph << "\n" << ran.output;
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
    for (const CodeInfo& info : all_codes()) {
        const bool has_folder = std::find(names.begin(), names.end(), info.name) != names.end();
        EXPECT_NE(has_folder, is_exempt(info.name))
            << info.name << (has_folder ? " is exempt, but has a folder" : " needs an example in tests/diagnostics");
    }
    for (const std::string& name : names) {
        const auto codes = all_codes();
        const bool exists = std::any_of(codes.begin(), codes.end(), [&](const CodeInfo& c) { return c.name == name; });
        EXPECT_TRUE(exists) << name << " is not a code of diagnostics.def";
    }
}

}  // namespace
}  // namespace patina::testing
