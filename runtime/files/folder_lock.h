// Folders that one process at a time writes files to.
//
// The lock is one of the kernel (flock) on the folder itself. It leaves no file behind and does not change the folder's
// time. It ends with the process that holds it, also if the process is killed. A reader that wants files of one run
// alone takes a shared lock on the folder: `flock --shared out cat out/*`. Two processes that lock several folders do
// so in the same order. A folder that cannot be locked, as on NFS, is written to all the same.
//
//   FolderLocks locks;
//   if (std::string error = locks.take({"out"}); !error.empty()) return error;
#pragma once

#include <sys/types.h>

#include <chrono>
#include <set>
#include <string>
#include <vector>

namespace patina::runtime {

class FolderLocks {
public:
    // How long to wait for others. A process that writes holds its lock for some milliseconds. A stopped process holds
    // it until it continues.
    static constexpr std::chrono::milliseconds kPatience = std::chrono::seconds(60);

    FolderLocks() = default;
    FolderLocks(const FolderLocks&) = delete;
    FolderLocks& operator=(const FolderLocks&) = delete;
    ~FolderLocks();  // gives them back

    // Waits until this process has all of them. Returns nothing, or which folder another program keeps locked.
    std::string take(const std::set<std::string>& folders, std::chrono::milliseconds patience = kPatience);
    // False for a folder that cannot be locked: others may be writing to it.
    bool has(const std::string& folder) const { return held_.contains(folder); }

private:
    struct Folder {
        std::string path{};
        int descriptor = -1;
        dev_t device = 0;
        ino_t inode = 0;
    };
    std::vector<Folder> open_{};
    std::set<std::string> held_{};
};

}  // namespace patina::runtime
