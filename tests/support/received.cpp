#include "tests/support/received.h"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace patina::testing {

namespace fs = std::filesystem;

namespace {

std::string shell_quoted(const std::string& text) {
    std::string quoted = "'";
    for (char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

// "line 3: expected '...', received '...'"
std::string first_difference(const std::string& expected, const std::string& received) {
    std::istringstream left(expected), right(received);
    for (int number = 1;; ++number) {
        std::string a, b;
        const bool more_left = static_cast<bool>(std::getline(left, a));
        const bool more_right = static_cast<bool>(std::getline(right, b));
        if (!more_left && !more_right) return "the last line break differs";
        if (a == b && more_left == more_right) continue;
        return "line " + std::to_string(number) + "\n  expected: " + (more_left ? a : "(the end)") +
               "\n  received: " + (more_right ? b : "(the end)");
    }
}

}  // namespace

fs::path tests_folder() {
    return PATINA_TESTS_FOLDER;
}

fs::path received_folder() {
    return PATINA_RECEIVED_FOLDER;
}

std::string read_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void write_file(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

::testing::AssertionResult as_expected(const std::string& name, const std::string& text) {
    const fs::path received = received_folder() / (name + ".received");
    fs::remove(received);
    const fs::path path = tests_folder() / name;
    const std::string expected = read_file(path);
    if (fs::exists(path) && expected == text) return ::testing::AssertionSuccess();
    write_file(received, text);
    return ::testing::AssertionFailure() << name << " differs at " << first_difference(expected, text)
                                         << "\nwhole text: " << received.string()
                                         << "\nto look at it and take it over: tests/accept";
}

Ran run(const std::string& command, const fs::path& folder) {
    const std::string program_folder = fs::path(PATINA_PROGRAM).parent_path();
    const std::string line = "cd " + shell_quoted(folder) + " && PATH=" + shell_quoted(program_folder) +
                             ":\"$PATH\" bash -c " + shell_quoted(command) + " 2>&1 </dev/null";
    Ran ran;
    std::FILE* pipe = ::popen(line.c_str(), "r");
    if (!pipe) return {.exit = -1, .output = "cannot run a shell"};
    std::array<char, 4096> buffer{};
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
        ran.output.append(buffer.data(), n);
    }
    const int status = ::pclose(pipe);
    ran.exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    return ran;
}

}  // namespace patina::testing
