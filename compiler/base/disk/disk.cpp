#include "compiler/base/disk/disk.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>

#if __has_include(<unistd.h>)
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#else
#include <fstream>
#endif

namespace patina {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<const Root>& process_root() {
    static std::unique_ptr<const Root> root;
    return root;
}

// Null: there is no limit.
const Root* chosen(const Root* root) {
    if (root == anywhere()) return nullptr;
    return root ? root : process_root().get();
}

std::string outside(const Root& root) {
    return "it is outside of the root folder '" + root.name() + "'";
}

std::string too_large(std::uint64_t most) {
    return "it has more than " + std::to_string(most) + " bytes";
}

bool is_missing(int error) {
    return error == ENOENT || error == ENOTDIR;
}

DiskFile failed(int error) {
    return {.bytes = {}, .why = is_missing(error) ? std::string() : std::strerror(error)};
}

#if __has_include(<unistd.h>)

// Why it is no regular file; null: it is one.
const char* other_kind(mode_t mode) {
    if (S_ISREG(mode)) return nullptr;
    if (S_ISDIR(mode)) return "it is a folder";
    if (S_ISFIFO(mode)) return "it is a FIFO";
    if (S_ISSOCK(mode)) return "it is a socket";
    return "it is a device";
}

class OpenFile {
public:
    // `path` has no links if there is a root.
    OpenFile(const std::string& path, const Root* root) { open(path, root); }
    ~OpenFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    bool is_good() const { return descriptor_ >= 0 && !failed_; }
    const DiskFile& failure() const { return failure_; }
    std::uint64_t size() const { return size_; }

    // At most so many bytes; fewer at the end of the file. False: errno says why not.
    bool read(std::string& into, std::uint64_t count) const { return read_all(descriptor_, into, count); }

    static bool read_all(int descriptor, std::string& into, std::uint64_t count) {
        constexpr std::uint64_t kPiece = std::uint64_t{1} << 18;
        while (count > 0) {
            const std::size_t begin = into.size();
            // What the caller reserved is filled first.
            const std::uint64_t room = into.capacity() > begin ? into.capacity() - begin : kPiece;
            into.resize(begin + static_cast<std::size_t>(std::min(count, room)));
            const ssize_t got = ::read(descriptor, into.data() + begin, into.size() - begin);
            const int error = errno;
            into.resize(begin + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
            if (got == 0) return true;
            if (got < 0 && error != EINTR) {
                errno = error;
                return false;
            }
            if (got > 0) count -= static_cast<std::uint64_t>(got);
        }
        return true;
    }

private:
    void open(const std::string& path, const Root* root) {
        struct stat there {};
        // Opening a device can be an action of its own, and opening a FIFO waits.
        if (::stat(path.c_str(), &there) != 0) return fail(errno);
        if (const char* const other = other_kind(there.st_mode)) return refuse(other);
        const int flags = O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY | (root ? O_NOFOLLOW : 0);
        descriptor_ = ::open(path.c_str(), flags);
        if (descriptor_ < 0 || ::fstat(descriptor_, &there) != 0) return fail(errno);
        if (const char* const other = other_kind(there.st_mode)) return refuse(other);
        size_ = static_cast<std::uint64_t>(std::max<off_t>(there.st_size, 0));
        if (root && !is_inside(*root, path, there)) refuse(outside(*root));
    }

    // Somebody may have put a link into the place of a folder meanwhile: the system knows where the open file is. If
    // the system does not say, root.find() must find the same file at the path again.
    bool is_inside(const Root& root, const std::string& path, const struct stat& there) const {
        std::error_code error;
        const fs::path real = fs::read_symlink("/proc/self/fd/" + std::to_string(descriptor_), error);
        if (!error) return root.holds(real.string());
        struct stat now {};
        const std::optional<std::string> again = root.find(path);
        return again && *again == path && ::lstat(path.c_str(), &now) == 0 && now.st_dev == there.st_dev &&
               now.st_ino == there.st_ino;
    }

    void fail(int error) {
        failed_ = true;
        failure_ = failed(error);
    }
    void refuse(std::string why) {
        failed_ = true;
        failure_.why = std::move(why);
    }

    int descriptor_ = -1;
    std::uint64_t size_ = 0;
    bool failed_ = false;
    DiskFile failure_{};
};

#else

// A system without POSIX: what is in the way of reading is found by name alone.
class OpenFile {
public:
    OpenFile(const std::string& path, const Root*) {
        std::error_code error;
        const fs::file_status status = fs::status(path, error);
        if (!fs::exists(status)) return;
        if (!fs::is_regular_file(status)) {
            failure_.why = fs::is_directory(status) ? "it is a folder" : "it is a device";
            return;
        }
        size_ = fs::file_size(path, error);
        stream_.open(path, std::ios::binary);
        if (!stream_) failure_.why = std::strerror(errno);
    }

    bool is_good() const { return stream_.is_open(); }
    const DiskFile& failure() const { return failure_; }
    std::uint64_t size() const { return size_; }

    bool read(std::string& into, std::uint64_t count) {
        count = std::min(count, size_ + 1);
        into.resize(static_cast<std::size_t>(count));
        stream_.read(into.data(), static_cast<std::streamsize>(count));
        into.resize(static_cast<std::size_t>(stream_.gcount()));
        return !stream_.bad();
    }

private:
    std::ifstream stream_{};
    std::uint64_t size_ = 0;
    DiskFile failure_{};
};

#endif

// Opens the file that the path means, and does `work` with it.
template <class Work>
DiskFile with_file(const std::string& path, const Root* root, const Work& work) {
    // A name from a file may hold a zero byte, where the system would end it.
    if (path.find('\0') != path.npos) return {};
    const Root* const within = chosen(root);
    const std::optional<std::string> real = within ? within->find(path) : path;
    if (!real) return {.bytes = {}, .why = outside(*within)};
    OpenFile file(*real, within);
    if (!file.is_good()) return file.failure();
    return work(file);
}

}  // namespace

const Root* anywhere() {
    static const Root all("/");
    return &all;
}

DiskFile read_disk(const std::string& path, std::uint64_t most, const Root* root) {
    return with_file(path, root, [&](OpenFile& file) -> DiskFile {
        if (file.size() > most) return {.bytes = {}, .why = too_large(most), .size = file.size(), .is_too_large = true};
        std::string bytes;
        bytes.reserve(static_cast<std::size_t>(file.size()) + 1);
        // A file that grows meanwhile, or whose size the system does not know, as of those in /proc.
        const std::uint64_t limit = most == std::numeric_limits<std::uint64_t>::max() ? most : most + 1;
        if (!file.read(bytes, limit)) return failed(errno);
        if (bytes.size() > most)
            return {.bytes = {}, .why = too_large(most), .size = bytes.size(), .is_too_large = true};
        const std::uint64_t size = bytes.size();
        return {.bytes = std::move(bytes), .why = {}, .size = size};
    });
}

DiskFile read_beginning(const std::string& path, std::size_t count, const Root* root) {
    return with_file(path, root, [&](OpenFile& file) -> DiskFile {
        std::string bytes;
        bytes.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(count, file.size())) + 1);
        if (!file.read(bytes, count)) return failed(errno);
        return {.bytes = std::move(bytes), .why = {}, .size = file.size()};
    });
}

DiskFile look_on_disk(const std::string& path, const Root* root) {
    return with_file(path, root, [](OpenFile& file) -> DiskFile {
        return {.bytes = std::string(), .why = {}, .size = file.size()};
    });
}

bool is_on_disk(const std::string& path, const Root* root) {
    if (path.find('\0') != path.npos) return false;
    const Root* const within = chosen(root);
    const std::optional<std::string> real = within ? within->find(path) : path;
    std::error_code error;
    return real && fs::is_regular_file(*real, error);
}

bool is_folder_on_disk(const std::string& path, const Root* root) {
    if (path.find('\0') != path.npos) return false;
    const Root* const within = chosen(root);
    const std::optional<std::string> real = within ? within->find(path.empty() ? "." : path) : path;
    std::error_code error;
    return real && fs::is_directory(real->empty() ? fs::path(".") : fs::path(*real), error);
}

std::string without_links(const std::string& path) {
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
    const fs::path real = fs::canonical(path, error);
    return error ? path : real.string();
}

std::string why_outside(const std::string& path, const Root* root) {
    const Root* const within = chosen(root);
    return within && !within->find(path) ? outside(*within) : std::string();
}

std::string why_unwritable(const std::string& path, const Root* root) {
    const Root* const within = chosen(root);
    if (!within || within->lets_write(path)) return {};
    return "a link leads outside of the root folder '" + within->name() + "'";
}

bool is_in_root(const std::string& real_path, const Root* root) {
    const Root* const within = chosen(root);
    return within && within->holds(real_path);
}

void confine_disk(const std::string& folder) {
    process_root() = std::make_unique<const Root>(folder);
}

std::optional<std::string> read_standard_input(std::uint64_t most, std::string& why) {
#if __has_include(<unistd.h>)
    std::string bytes;
    if (!OpenFile::read_all(STDIN_FILENO, bytes, most + 1)) {
        why = std::strerror(errno);
        return {};
    }
    if (bytes.size() <= most) return bytes;
    why = too_large(most);
#else
    why = "this system has none";
    static_cast<void>(most);
#endif
    return {};
}

}  // namespace patina
