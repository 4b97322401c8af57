// The room `cli` is the command line. It reads options, calls the library and prints. It computes nothing itself.
//
// The command line as a whole: a list of subcommands, each with its options and the function that does its work. CLI11
// parses it. This class adds one form for errors in the command line ("did you mean ...?", exit code 2) and the options
// that all subcommands have.
//
// This folder: the program `patina` (main.cpp) and what all commands share (this file, console.h, files.h, inputs.h,
// outputs.h). failures/ says what was thrown, commands/ holds a file for each command, compile/ what `patina compile`
// also needs, cost/ is `patina cost`, diff/ what `patina diff` finds, licences/ is `patina --licences`, pages/ what
// `patina node` and `patina model` show, eval/ what `patina eval` computes, templates/ what `patina new` writes.
// import/ is the program `patina-import`; render/ and watch/ are `patina-render`. Nothing here includes the compiler's
// own headers: what a command needs of the library is public.
//
//   return run(argc, argv, [](Program& program, int, char**) -> std::optional<Exit> {
//       add_compile(program);
//       return {};
//   });
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/cli/console.h"
#include "runtime/outcome.h"

namespace patina::runtime {
struct Image;
}

namespace patina::cli {

// Which program runs a command; commands.def says why there are three.
enum class Home { Patina, Import, Render };
struct CommandInfo {
    std::string_view name;
    Home home;
    std::string_view summary;
};
// Turns this process into another program, which lies in the same folder, with the same command line. If that fails, it
// prints an error and returns.
Exit turn_into(Home home, char** argv);
// A row of commands.def, or null.
const CommandInfo* find_command(std::string_view name);

// How scenes are checked; false: something is wrong with one, and it has been reported. The other check gets each of
// the scene's materials, compiled for the scene, and answers in the same way.
using MaterialCheck = std::function<bool(const std::string& graph, const Result&)>;
using SceneCheck = bool (*)(const Console&, const Compiler&, const std::string& scene, const CompileOptions&,
                            const MaterialCheck&);

// How pictures of two versions of a graph are compared (diff/report.h).
struct Version;
struct PictureWish;
struct PictureChange;
using PictureComparison = std::optional<PictureChange> (*)(const Console&, const Version& before, const Version& after,
                                                           const PictureWish&);

// The bytes of a picture's file; the ending of its name is the format.
using PictureEncoder = runtime::Outcome<std::string> (*)(const std::string& name, const runtime::Image&);

struct Program {
    Program();

    CLI::App app;
    Console console;
    char** argv = nullptr;  // run() knows it
    // In patina-render alone.
    SceneCheck check_scene = nullptr;
    PictureComparison compare_pictures = nullptr;
    PictureEncoder encode_picture = nullptr;
    struct Command {
        CLI::App* app;
        std::function<Exit(const Console&)> work;
    };
    std::vector<Command> commands;
    void (*limit_pixels)(std::size_t most) = nullptr;  // in patina-render alone, too
};

// A new subcommand with --help, --quiet and --diagnostics; commands.def has its summary. `examples` are shown below its
// help, one a line.
CLI::App& add_command(Program& program, std::string name, const std::vector<std::string_view>& examples);
// Checks the arguments together, after all are read. It throws CLI::ValidationError.
void set_check(CLI::App& command, std::function<void()> check);
void set_work(Program& program, CLI::App& command, std::function<Exit(const Console&)> work);

// -I, repeatable, and --root: every command that reads graphs has them.
void add_include_option(CLI::App& command, std::vector<std::string>& folders);
// --root: from then on, this process reads nothing outside of a folder, and writes nothing through a link in it that
// leads outside. -I has it already.
void add_root_option(CLI::App& command);
// --max-pixels, of commands that read pictures. It has an effect where a picture can be read: in patina-render.
void add_pixels_option(Program& program, CLI::App& command);

// --path and -D: the rendering path, and which parts of it.
struct PathOptions {
    std::string path = "forward";
    std::vector<std::string> defines;
    // "shadows=true" -> ("shadows", "true"); "shadows" alone is true.
    std::vector<std::pair<std::string, std::string>> switches() const;
};
void add_path_options(CLI::App& command, PathOptions& options);
// -D alone.
void add_define_option(CLI::App& command, std::vector<std::string>& defines);

// Enters `name` with its value; no value stands for "true". Returns nothing, or what is wrong: the name has another
// value already.
std::string set_once(std::map<std::string, std::string>& values, const std::string& name, std::string value);

// A check for an option whose value must be one of `words`; its message has a suggestion.
std::function<std::string(std::string)> one_of(std::string what, std::vector<std::string> words);

// A check for an option whose value must be a number of this range.
std::function<std::string(std::string)> within(double low, double high);

// A check for an option whose value must be a folder that is there.
std::string is_folder(const std::string& word);

// An option that takes words with commas between them: "glsl,hlsl". `check` is called for each word, also for an empty
// one.
CLI::Option* add_words_option(CLI::App& command, std::string name, std::vector<std::string>& words, std::string help,
                              std::function<std::string(std::string)> check);

// If two graphs have the same name, or names that differ only in case, their files would overwrite each other.
// `ending`: of the files that are written, ".png". `verb`: what the command does to graphs, "render".
struct EqualOutputs {
    std::size_t first = 0, second = 0;
    std::string why{};  // "'a/rust.graph.json' and 'b/rust.graph.json' would both write rust.png: ..."
};
std::vector<EqualOutputs> find_equal_outputs(const std::vector<std::string>& graphs, std::string_view ending,
                                             std::string_view verb);
// Throws the usage error if there are such.
void refuse_equal_outputs(const std::vector<std::string>& graphs, std::string_view ending, std::string_view verb);

// Adds the commands of a program. An exit code: the program ends with it at once.
using SetUp = std::optional<Exit> (*)(Program& program, int argc, char** argv);
// Parses, runs the chosen subcommand and returns its exit code: what `main` does. No exception leaves it.
int run(int argc, char** argv, SetUp set_up) noexcept;

}  // namespace patina::cli
