// What the commands say, and where: products (paths, tables, values) on stdout, complaints and progress on stderr.
// With --diagnostics=json complaints are JSON objects, one a line, on stdout instead. Colours and progress appear only
// on a terminal, and colours not where NO_COLOR is set.
//
//   Console console = open_console();
//   report(console, result.diagnostics);
//   say(console, "out/rust.forward.frag.glsl");
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "patina/patina.h"

namespace patina::cli {

// What a command returns to the shell.
enum class Exit : int {
    Ok = 0,
    Wrong = 1,    // the input is wrong
    Usage = 2,    // the command line is wrong
    Machine = 3,  // this machine lacks something
};
// Of several graphs: the machine's fault is told before the graph's.
Exit worse(Exit a, Exit b);

struct Console {
    bool json = false;          // --diagnostics=json
    bool quiet = false;         // --quiet: errors only
    bool error_colors = false;  // stderr is a terminal that shows colours
    bool output_colors = false;
    bool progress = false;  // stderr is a terminal
};
Console open_console();

// Warnings are left out when quiet. Returns true if there was an error among them.
bool report(const Console& console, std::span<const Diagnostic> diagnostics);
// A complaint of the command itself, which has no place in a file.
void complain(const Console& console, std::string_view code, std::string message);

// A line on stdout about what was done: not when quiet, nor among JSON diagnostics.
void say(const Console& console, std::string_view line);
// A remark about the work on stderr: not when quiet, nor beside JSON diagnostics.
void remark(const Console& console, std::string_view line);
// Text that was asked for: always on stdout.
void print(std::string_view text);
// True if some of it could not be written: a full disk, a closed descriptor.
bool output_failed();
// Bold, if stdout shows colours.
std::string heading(const Console& console, std::string_view text);

// A line that replaces itself: "rust.graph.json 37%".
void show_share(const Console& console, double share, std::string_view item);
// One line that replaces itself: "[3/12] rust.graph.json". Not shown for a single item.
void show_progress(const Console& console, std::size_t index, std::size_t count, std::string_view item);
void end_progress(const Console& console);

}  // namespace patina::cli
