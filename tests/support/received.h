// Expected texts in the source tree: a test writes what it received into the build, never into the tree, and fails
// with the first line that differs. `tests/accept` shows the differences and takes them over.
//
//   EXPECT_TRUE(as_expected("diagnostics/cycle/expected.txt", text));
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace patina::testing {

// tests/ of the source tree, and the folder of the build that mirrors it.
std::filesystem::path tests_folder();
std::filesystem::path received_folder();

// The bytes of a file; empty if it cannot be read.
std::string read_file(const std::filesystem::path& path);
void write_file(const std::filesystem::path& path, const std::string& text);

// Compares `text` with the file `name` of tests/. A difference leaves NAME.received in the received folder.
::testing::AssertionResult as_expected(const std::string& name, const std::string& text);

// Runs a line of shell in a folder, with the built `patina` on the PATH. Both output streams, in order.
struct Ran {
    int exit = 0;
    std::string output;
};
Ran run(const std::string& command, const std::filesystem::path& folder);

}  // namespace patina::testing
