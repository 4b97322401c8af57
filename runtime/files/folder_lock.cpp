#include "runtime/files/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <thread>
#include <tuple>

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

enum class Answer { Held, OfAnother, Impossible };

Answer ask(int descriptor) {
    while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        if (errno == EWOULDBLOCK) return Answer::OfAnother;
        if (errno != EINTR) return Answer::Impossible;
    }
    return Answer::Held;
}

// True if a descriptor that this program was started with holds the lock: `flock out sh -c 'patina ... && pack out'`.
// Those that it has opened itself close at exec, and may be of another thread.
bool is_held_by_starter(dev_t device, ino_t inode) {
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc/self/fd", failure)) {
        const std::string name = entry.path().filename().string();
        int descriptor = -1;
        std::from_chars(name.data(), name.data() + name.size(), descriptor);
        const int flags = ::fcntl(descriptor, F_GETFD);
        struct stat there {};
        if (flags < 0 || (flags & FD_CLOEXEC) != 0 || ::fstat(descriptor, &there) != 0) continue;
        if (there.st_dev == device && there.st_ino == inode && S_ISDIR(there.st_mode) &&
            ask(descriptor) == Answer::Held)
            return true;
    }
    return false;
}

}  // namespace

FolderLocks::~FolderLocks() {
    for (const Folder& each : open_) ::close(each.descriptor);
}

std::string FolderLocks::take(const std::set<std::string>& folders, std::chrono::milliseconds patience) {
    for (const std::string& path : folders) {
        const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (descriptor < 0) continue;  // it cannot be read: other programs write to it without a lock
        struct stat there {};
        ::fstat(descriptor, &there);
        open_.push_back({.path = path, .descriptor = descriptor, .device = there.st_dev, .inode = there.st_ino});
    }
    // Two processes that begin with different folders would wait for each other.
    std::ranges::sort(open_, {}, [](const Folder& each) { return std::tie(each.device, each.inode); });
    const Clock::time_point end = Clock::now() + patience;
    const Folder* before = nullptr;
    for (const Folder& each : open_) {
        const bool is_same = before && before->device == each.device && before->inode == each.inode;
        if (is_same && has(before->path)) held_.insert(each.path);
        before = &each;
        if (is_same) continue;
        Answer answer = ask(each.descriptor);
        if (answer == Answer::OfAnother && is_held_by_starter(each.device, each.inode)) answer = Answer::Held;
        for (auto pause = 1ms; answer == Answer::OfAnother; pause = std::min(pause * 2, 50ms)) {
            if (Clock::now() > end)
                return "another program holds a lock on the folder '" + each.path +
                       "': end it, or write to another folder";
            std::this_thread::sleep_for(pause);
            answer = ask(each.descriptor);
        }
        if (answer == Answer::Held) held_.insert(each.path);
    }
    return "";
}

}  // namespace patina::runtime
