// The room `files`: how output files are written. It knows nothing about their contents.
//
// A file is written completely or not at all. All files are written under temporary names in their folders, and then
// renamed in their order. Nobody else can have such a name, because opening the file fails if there is one already.
// Their folders are locked meanwhile (folder_lock.h), so files of two processes do not mix. Of a symbolic link the
// target is replaced, not the link. A file that is replaced keeps its permissions. A file that is not regular (a
// device, a FIFO, /dev/stdout) is written to, and is not replaced. A file that has the same bytes already is not
// touched and keeps its time, so that a build does not repeat work that depends on it.
//
// If reading is confined to a root (compiler/base/disk/disk.h), then no link in the root leads to a new file outside of
// it. Files in the root that are not regular are not written to. In these functions, `root` is as in those that read.
//
//   std::string error = write_files(std::vector<OutputFile>{{.path = "out/rust.png", .bytes = png}});
//   // empty: written
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "runtime/outcome.h"

namespace patina {
class Root;  // compiler/base/disk/root.h
}

namespace patina::runtime {

struct OutputFile {
    std::string path{};
    std::string bytes{};
    bool is_stamp = false;  // its time says when the work was done: it is also written if it has these bytes already
};

// The file that a path means when its symbolic links are followed.
struct Destination {
    enum class Kind {
        File,       // a regular file, or nothing so far
        Folder,     // nothing can be written to it
        Stream,     // a device, a FIFO or a socket: it is opened and written to
        Descriptor  // an open descriptor of this process, as /dev/stdout is
    };
    Kind kind = Kind::File;
    std::string path{};   // absolute
    int descriptor = -1;  // of a Descriptor
    std::string error{};  // not empty: nothing must be written there, or the links lead nowhere
};
Destination destination_of(const std::string& path, const Root* root = nullptr);

// What would be in the way of writing a file there, as write_files() would say it; empty: nothing that can be seen now.
std::string obstacle_to(const std::string& path);

// The bytes of a file, at most so many (compiler/base/disk/disk.h). Its errors are "there is no file 'sizi.glb': did
// you mean 'suzi.glb'?", "cannot read 'out': it is a folder", "cannot read 'a.exr': it has more than 1000 bytes".
Outcome<std::string> read_file(const std::string& path, std::uint64_t most);
// The first bytes of a file.
Outcome<std::string> read_start(const std::string& path, std::size_t count);
// Nothing, or why no file can be read there, in the same words.
std::string no_file(const std::string& path);

// Makes missing folders and writes everything, or nothing. Returns nothing, or what is wrong: "cannot write 'x': ...".
std::string write_files(std::span<const OutputFile> files, const Root* root = nullptr);
std::string write_file(const std::string& path, std::string bytes, const Root* root = nullptr);
// Removes what an earlier run wrote, if there is something. What must not be written stays.
void remove_file(const std::string& path);

}  // namespace patina::runtime
