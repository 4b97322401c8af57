// The command line as a whole: a list of subcommands, each with its options and the function that does its work.
// Parsing is CLI11's; what this adds is one way to complain ("did you mean ...?", exit code 2) and the options that all
// have.
//
//   Program program("Compiles material graphs.");
//   add_compile(program);
//   return run(program, argc, argv);
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/cli/console.h"

namespace patina::cli {

struct Program {
    explicit Program(std::string description);

    CLI::App app;
    Console console;
    struct Command {
        CLI::App* app;
        std::function<Exit(const Console&)> work;
    };
    std::vector<Command> commands;
};

// A new subcommand with --help, --quiet and --diagnostics. `examples` are shown below its help, one a line.
CLI::App& add_command(Program& program, std::string name, std::string summary,
                      std::initializer_list<std::string_view> examples);
void set_work(Program& program, CLI::App& command, std::function<Exit(const Console&)> work);

// -I, repeatable, the same wherever graphs are read.
void add_include_option(CLI::App& command, std::vector<std::string>& folders);

// --path and -D: how a scene is drawn, and what of it.
struct PathOptions {
    std::string path = "forward";
    std::vector<std::string> defines;
    // "shadows=true" -> ("shadows", "true"); "shadows" alone is true.
    std::vector<std::pair<std::string, std::string>> switches() const;
};
void add_path_options(CLI::App& command, PathOptions& options);
// -D alone, with or without parts of a path.
void add_define_option(CLI::App& command, std::vector<std::string>& defines);

// Notes that `name` is to be `value`, where nothing is "true"; else what is wrong: another value was given before.
std::string say_once(std::map<std::string, std::string>& values, const std::string& name, std::string value);

// A check for an option whose value is one of a few words; complains with a suggestion.
std::function<std::string(std::string)> one_of(std::string what, std::vector<std::string> words);

// An option that takes words with commas between, "glsl,hlsl". `check` is asked of each, an empty one too.
CLI::Option* add_words_option(CLI::App& command, std::string name, std::vector<std::string>& words, std::string help,
                              std::function<std::string(std::string)> check);

// Two graphs of one name, or of names that differ in case alone, would overwrite each other's files: throws the usage
// error that says so. `ending`: of what a graph's files are called, ".png"; `verb`: what the command does to graphs.
void refuse_equal_outputs(const std::vector<std::string>& graphs, std::string_view ending, std::string_view verb);

// Parses, runs the chosen subcommand and returns its exit code.
int run(Program& program, int argc, char** argv);

}  // namespace patina::cli
