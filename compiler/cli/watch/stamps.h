// Whether files have changed since they were read: by time, size and inode. So it also notices an editor that saves by
// renaming, and a file that appears or disappears. Files are looked at again and again, which works on every file
// system.
//
//   Stamps stamps = stamps_of(result.dependencies, before_it_was_read);
//   if (has_changed(stamps)) compile_again();
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace patina::cli {

struct Stamp {
    bool is_there = false;
    bool is_unsure = false;  // it may have been written after it was read
    std::int64_t nanoseconds = 0;
    off_t size = 0;
    ino_t inode = 0;
    friend bool operator==(const Stamp&, const Stamp&) = default;
};
using Stamps = std::map<std::string, Stamp>;  // by path

// Of files that were read after `begin`. A file that is younger than that counts as changed.
Stamps stamps_of(std::span<const std::string> files, std::chrono::system_clock::time_point begin);
// Of files that nobody reads now.
Stamps stamps_of(std::span<const std::string> files);
bool has_changed(const Stamps& stamps);

}  // namespace patina::cli
