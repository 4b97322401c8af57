// Where the commands print. Results (paths, tables, values) go to stdout; errors, warnings and progress go to stderr.
// With --diagnostics=json, errors and warnings are JSON objects on stdout, one a line. Progress is shown only on a
// terminal; so are colours, unless NO_COLOR is set.
//
//   Console console = open_console();
//   report(console, result.diagnostics);
//   complain(console, Complaint::CannotRead, {path, "no such file"});
//   say(console, "out/rust.forward.frag.glsl");
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "patina/complaints.h"
#include "patina/patina.h"

namespace patina::cli {

// What a command returns to the shell.
enum class Exit : int {
    Ok = 0,
    Wrong = 1,    // the input is wrong
    Usage = 2,    // the command line is wrong
    Machine = 3,  // this machine lacks something: a GPU, a program, memory
    Mistake = 4,  // a bug in Patina, to be reported
};
// The exit code of a command that did two things: the greater one.
Exit worse(Exit a, Exit b);

struct Console {
    bool json = false;          // --diagnostics=json
    bool quiet = false;         // --quiet: errors only
    bool error_colors = false;  // stderr is a terminal that shows colours
    bool output_colors = false;
    bool progress = false;  // stderr is a terminal
};
Console open_console();

// Prints diagnostics, without the warnings if quiet. Returns true if one of them is an error. What is no fault of the
// input also counts for exit_of_reports().
bool report(const Console& console, std::span<const Diagnostic> diagnostics);
// The exit code that the errors reported so far ask for: Ok, Machine for lack of memory, Mistake for a bug in Patina.
// run() ends the program with no smaller one.
Exit exit_of_reports();
void ask_for_exit(Exit exit) noexcept;
// Reports an error of the command itself, which has no place in a file.
void complain(const Console& console, Complaint what, std::initializer_list<std::string_view> words);
// True, after a complaint, if standard output would hold diagnostics as JSON and `what`: a command may print one of
// them.
bool is_mixed(const Console& console, bool prints, std::string_view what);

// Prints to stdout which file was written or checked. Prints nothing if quiet or with --diagnostics=json.
void say(const Console& console, std::string_view line);
// Prints a remark about the work to stderr. Prints nothing if quiet or with --diagnostics=json.
void remark(const Console& console, std::string_view line);
// Prints the command's result to stdout.
void print(std::string_view text);
// True if not all of stdout could be written: the disk is full, or the descriptor is closed.
bool output_failed();
// Bold, if stdout shows colours.
std::string heading(const Console& console, std::string_view text);

// Progress on one line, which is overwritten: "rust.graph.json 37%".
void show_share(const Console& console, double share, std::string_view item);
// The same for one of several items: "[#####---------------] 3/12 rust.graph.json". Not shown for a single item.
void show_progress(const Console& console, std::size_t index, std::size_t count, std::string_view item);
void end_progress(const Console& console);

}  // namespace patina::cli
