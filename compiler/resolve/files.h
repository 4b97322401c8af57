// Finds and reads files through the caller's FileSystem. It remembers every answer, so that each file is asked for once
// and a file that changes meanwhile is the same for everyone: compilations for several engines, or of several variants,
// share a Files. What the caller's functions throw becomes an answer, too.
//
//   Files files(options.files);
//   const Files::Answer& rust = files.read("rust.subgraph.json");   // its text, or why there is none
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "patina/options.h"

namespace patina::graph {

// Calls a function of the program's. False: it has thrown, and `why` says what, or is `unknown`. Its lack of memory is
// ours, too: that exception goes on.
bool succeeds(const std::function<void()>& call, std::string& why,
              std::string_view unknown = "the program's function failed");

class Files {
public:
    // The text of a file, or whether it exists. If there is no text: `why` says why it cannot be read, and is empty if
    // there is no such file.
    struct Answer {
        std::optional<bool> exists{};
        bool is_read = false;
        std::optional<std::string> text{};
        std::string why{};
    };
    struct Path {
        std::string path{};  // empty: there is none
        std::string why{};   // the caller's function failed
    };

    // A name in a file, and what it became.
    struct Resolved {
        std::string from{}, name{};
        Path path{};
    };

    explicit Files(const FileSystem& system) : system_(system) {}

    // Nothing is looked up.
    Path resolve(const std::string& from, const std::string& name);
    const Answer& read(const std::string& path);
    const Answer& find(const std::string& path);

    // A part that is compiled from its text is used by its name, and must not be what a file of that name holds.
    void give_part(const std::string& path, std::string text);

    bool is_disk() const { return !system_.read && !system_.exists; }
    // Of all texts that were read, and of the graph, if that was given as text.
    std::size_t bytes() const { return bytes_; }
    void add_bytes(std::size_t bytes) { bytes_ += bytes; }
    // All that was asked for, by path.
    const std::map<std::string, Answer>& answers() const { return answers_; }
    // All names that were asked for.
    const std::vector<Resolved>& resolved() const { return resolved_; }

private:
    const FileSystem& system_;
    std::map<std::string, Answer> answers_{};
    std::vector<Resolved> resolved_{};
    std::size_t bytes_ = 0;
};

}  // namespace patina::graph
