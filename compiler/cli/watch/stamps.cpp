#include "compiler/cli/watch/stamps.h"

#include <sys/stat.h>

#include <algorithm>

#include "compiler/base/disk/disk.h"

namespace patina::cli {
namespace {

using namespace std::chrono_literals;

// The kernel's times of files may lie behind the clock by a tick.
constexpr std::chrono::nanoseconds kTick = 20ms;

Stamp stamp_of(const std::string& path) {
    struct stat there {};
    if (!why_outside(path).empty() || ::stat(path.c_str(), &there) != 0) return {};
    return {.is_there = true,
            .nanoseconds = std::int64_t(there.st_mtim.tv_sec) * 1'000'000'000 + there.st_mtim.tv_nsec,
            .size = there.st_size,
            .inode = there.st_ino};
}

}  // namespace

Stamps stamps_of(std::span<const std::string> files, std::chrono::system_clock::time_point begin) {
    const std::chrono::nanoseconds read = begin.time_since_epoch() - kTick;
    Stamps stamps;
    for (const std::string& file : files) {
        const auto [at, is_new] = stamps.try_emplace(file);
        if (!is_new) continue;
        at->second = stamp_of(file);
        at->second.is_unsure = at->second.nanoseconds >= read.count();
    }
    return stamps;
}

Stamps stamps_of(std::span<const std::string> files) {
    return stamps_of(files, std::chrono::system_clock::time_point::max());
}

bool has_changed(const Stamps& stamps) {
    return std::ranges::any_of(stamps, [](const auto& each) { return each.second != stamp_of(each.first); });
}

}  // namespace patina::cli
