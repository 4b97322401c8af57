// Finds and reads files through the caller's FileSystem. It stores every answer, so each file is requested once.
// Compilations for several engines, or of several variants, share a Files, so a file that changes in between is the
// same for all of them. What the caller's functions throw becomes an answer, too.
//
//   Files files(options);
//   const Files::Answer& rust = files.read("rust.subgraph.json");   // its text, or why there is none
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/disk/disk.h"
#include "patina/options.h"

namespace patina::resolve {

// Calls a function of the program's. False: it has thrown, and `why` says what, or is `unknown`. Its lack of memory is
// ours, too: that exception goes on.
bool succeeds(const std::function<void()>& call, std::string& why,
              std::string_view unknown = "the program's function failed");
// The functions of disk(). Files recognises them by their types. Then it reads no more of a file than the limits allow,
// and distinguishes texts of the disk from those of a program.
struct DiskPart {
    std::shared_ptr<const Root> root{};  // null: all of it, or what the process is confined to
    std::size_t most_bytes = 0;
};
struct ReadFromDisk {
    DiskPart part;
    std::optional<std::string> operator()(const std::string& path) const;
};
struct FindOnDisk {
    DiskPart part;
    bool operator()(const std::string& path) const;
};

class Files {
public:
    // The text of a file, or whether it exists. If there is no text: `why` says why it cannot be read, and is empty if
    // there is no such file.
    struct Answer {
        std::optional<bool> exists{};
        bool is_read = false;
        std::optional<std::string> text{};
        std::string why{};
        std::size_t too_large = 0;  // the bytes of a file that has too many to be read
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

    // The options live longer.
    explicit Files(const CompileOptions& options) : options_(options) {}

    // Nothing is looked up.
    Path resolve(const std::string& from, const std::string& name);
    const Answer& read(const std::string& path);
    const Answer& find(const std::string& path);

    // A part that is compiled from its text is used by its name. Then the text must be used, and not the file of that
    // name.
    void give_part(const std::string& path, std::string text);

    // True if texts are those of files on the disk, which can be anything, and not of the program's own.
    bool reads_disk() const { return part_that_is_read() != nullptr; }
    bool looks_on_disk() const { return part_that_is_searched() != nullptr; }
    // Advice for a file of the disk that is not there; nothing for another file system.
    std::string advice_for(const std::string& path) const;
    // Of all texts that were read, and of the graph, if that was given as text.
    std::size_t bytes() const { return bytes_; }
    void add_bytes(std::size_t bytes) { bytes_ += bytes; }
    // All that was asked for, by path.
    const std::map<std::string, Answer>& answers() const { return answers_; }
    // All names that were asked for.
    const std::vector<Resolved>& resolved() const { return resolved_; }

private:
    // Null: the program reads itself, and says itself what is there.
    const DiskPart* part_that_is_read() const;
    const DiskPart* part_that_is_searched() const;

    const CompileOptions& options_;
    std::map<std::string, Answer> answers_{};
    std::vector<Resolved> resolved_{};
    std::size_t bytes_ = 0;
};

}  // namespace patina::resolve
