// The files that one command writes. Each write is all or nothing (runtime/files), and no file of the user's is lost
// silently. Two outputs of one name are refused. An output is also refused if it would replace the reference picture of
// a snapshot or a file from which it is made.
//
//   Outputs outputs(console);
//   for (const std::string& graph : graphs) {
//       OutputFiles files;
//       files.add("out/rust.forward.vert.glsl", text);
//       if (!outputs.write(graph, files, result.dependencies)) return Exit::Wrong;  // it has complained
//       say(console, files);
//   }
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/cli/console.h"
#include "runtime/files/files.h"

namespace patina::cli {

struct OutputFiles {
    std::vector<runtime::OutputFile> files;

    void add(std::string path, std::string bytes) { files.push_back({std::move(path), std::move(bytes)}); }
};

class Outputs {
public:
    explicit Outputs(const Console& console) : console_(console) {}

    // Writes all of the files or none; false: none, and it has complained. `source`: the argument that they are made
    // from, for messages. `inputs`: files that it was made from.
    bool write(const std::string& source, const OutputFiles& files, std::span<const std::string> inputs = {});
    // The same without a complaint: returns it.
    std::optional<Diagnostic> try_write(const std::string& source, const OutputFiles& files,
                                        std::span<const std::string> inputs = {});

    // False: a file of this name cannot be written, and it has complained. For work that takes a while: ask before it.
    bool is_possible(const std::string& path) const;

private:
    struct Written {
        std::string source, path;
    };
    std::optional<Diagnostic> take(const std::string& source, const std::string& path,
                                   std::span<const std::string> inputs);

    const Console& console_;
    std::map<std::string, Written> written_;  // by the file itself, for all links that lead to it
};

// Prints which files were written, but not between the bytes of one that was written to standard output.
void say(const Console& console, const OutputFiles& files);

// "-", or a name of that descriptor, such as /dev/stdout.
bool is_standard_output(const std::string& path);
// True if nothing can be written there without replacing a file: it is there already, or it is a folder.
bool is_taken(const std::string& path);
// True for a device, a FIFO or an open descriptor: what is written there goes through it.
bool is_stream(const std::string& path);

// A check for options and arguments that name a folder. Returns what is wrong, or nothing.
std::string is_folder_name(const std::string& word);

}  // namespace patina::cli
