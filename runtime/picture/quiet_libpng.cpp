#include "runtime/picture/quiet_libpng.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <string>
#include <string_view>

namespace patina::runtime {
namespace {

// libpng writes to the stream `stderr` itself, and OpenImageIO gives no way to tell it otherwise.
struct Collection {
    std::mutex mutex;
    int users = 0;
    int terminal = -1;   // what stderr was
    int collected = -1;  // a file in memory
};

Collection& collection() {
    static Collection made;
    return made;
}

void begin(Collection& made) {
    std::fflush(stderr);
    made.terminal = ::dup(STDERR_FILENO);
    made.collected = ::memfd_create("stderr", MFD_CLOEXEC);
    if (made.terminal >= 0 && made.collected >= 0) ::dup2(made.collected, STDERR_FILENO);
}

std::string text_of(int file) {
    std::string text;
    char bytes[4096];
    ::lseek(file, 0, SEEK_SET);
    for (ssize_t count = 0; (count = ::read(file, bytes, sizeof bytes)) > 0;) text.append(bytes, std::size_t(count));
    return text;
}

void end(Collection& made) {
    std::fflush(stderr);
    if (made.terminal >= 0 && made.collected >= 0) {
        ::dup2(made.terminal, STDERR_FILENO);
        const std::string text = text_of(made.collected);
        std::string_view rest = text;
        while (!rest.empty()) {
            const std::size_t size = std::min(rest.find('\n'), rest.size() - 1) + 1;
            const std::string_view line = rest.substr(0, size);
            if (!line.starts_with("libpng ")) std::fwrite(line.data(), 1, line.size(), stderr);
            rest.remove_prefix(size);
        }
    }
    if (made.terminal >= 0) ::close(made.terminal);
    if (made.collected >= 0) ::close(made.collected);
    made.terminal = made.collected = -1;
}

}  // namespace

QuietLibpng::QuietLibpng() {
    Collection& made = collection();
    const std::lock_guard lock(made.mutex);
    if (made.users++ == 0) begin(made);
}

QuietLibpng::~QuietLibpng() {
    Collection& made = collection();
    const std::lock_guard lock(made.mutex);
    if (--made.users == 0) end(made);
}

}  // namespace patina::runtime
