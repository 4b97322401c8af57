#include "runtime/files/files.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <set>
#include <vector>

#include "compiler/base/disk/disk.h"
#include "patina/patina.h"
#include "runtime/files/folder_lock.h"
#include "runtime/files/leftovers.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as many as Linux follows

std::string cannot_write(const std::string& path, const std::string& why) {
    return "cannot write '" + path + "': " + why;
}

std::string unread(const std::string& path, const DiskFile& file) {
    if (!file.why.empty()) return "cannot read '" + path + "': " + file.why;
    const std::string advice = file_suggestion(path);
    return "there is no file '" + path + "'" + (advice.empty() ? "" : ": " + advice);
}

// The folder of a file.
std::string cannot_make(const std::string& path, const std::string& why) {
    const fs::path folder = fs::path(path).parent_path();
    fs::path there = folder;
    std::error_code failure;
    while (!fs::exists(there, failure) && there.has_relative_path()) there = there.parent_path();
    const bool is_file = fs::exists(there, failure) && !fs::is_directory(there, failure);
    return "cannot make the folder '" + folder.string() +
           "': " + (is_file ? "'" + there.string() + "' is a file" : why);
}

// "/proc/self/fd/1" is 1; -1 if the path is no descriptor of this process.
int own_descriptor(const fs::path& path) {
    std::error_code failure;
    const fs::path own = fs::canonical("/proc/self/fd", failure);
    if (failure || path.parent_path() != own) return -1;
    const std::string name = path.filename().string();
    int descriptor = -1;
    std::from_chars(name.data(), name.data() + name.size(), descriptor);
    return descriptor;
}

// Writes all of it. False: errno says why not.
bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno == EAGAIN) {
            pollfd ready{.fd = descriptor, .events = POLLOUT, .revents = 0};
            ::poll(&ready, 1, -1);
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

// If the reader of a pipe has gone, that is an error like others. The signal would end the program before it removes
// its temporary files.
class WithoutPipeSignal {
public:
    WithoutPipeSignal() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
    ~WithoutPipeSignal() { std::signal(SIGPIPE, before_); }
    WithoutPipeSignal(const WithoutPipeSignal&) = delete;
    WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

private:
    void (*before_)(int);
};

std::string write_to_stream(const OutputFile& file, const Destination& to) {
    const bool is_open = to.kind == Destination::Kind::Descriptor;
    const int descriptor = is_open ? ::dup(to.descriptor) : ::open(to.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (descriptor < 0) return cannot_write(file.path, std::strerror(errno));
    if (is_open) std::fflush(nullptr);  // what has been printed comes first
    const WithoutPipeSignal guard;
    const bool written = write_all(descriptor, file.bytes);
    const int failure = errno;
    const bool closed = ::close(descriptor) == 0;
    return written && closed ? "" : cannot_write(file.path, std::strerror(written ? errno : failure));
}

// True if the file holds these bytes already.
bool holds(const std::string& path, const struct stat& there, std::string_view bytes) {
    if (!S_ISREG(there.st_mode) || std::size_t(there.st_size) != bytes.size()) return false;
    return read_disk(path, bytes.size(), anywhere()).bytes == bytes;
}

// Files on their way to their names. What has not arrived is taken back.
class Replacement {
public:
    explicit Replacement(const Root* root) : root_(root) {}
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;
    // By the system's own calls: those of std::filesystem may need memory that is not there.
    ~Replacement() {
        for (const Temporary& each : temporaries_) ::unlink(each.path.c_str());
        // The deepest first. A folder that holds something else stays.
        std::for_each(folders_.rbegin(), folders_.rend(), [&](const fs::path& each) { ::rmdir(each.c_str()); });
    }

    std::string make_folder(const OutputFile& file, const fs::path& folder) {
        std::error_code failure;
        std::vector<fs::path> missing;
        for (fs::path at = folder; !fs::exists(at, failure) && at.has_relative_path(); at = at.parent_path())
            missing.push_back(at);
        folders_.insert(folders_.end(), missing.rbegin(), missing.rend());
        fs::create_directories(folder, failure);
        if (!failure) return "";
        return cannot_make(file.path, failure.message());
    }

    std::string add(const OutputFile& file, const std::string& destination) {
        struct stat there {};
        const bool is_there = ::stat(destination.c_str(), &there) == 0;
        // Renaming would replace a file that is protected from writing, too.
        if (is_there && ::access(destination.c_str(), W_OK) != 0) return cannot_write(file.path, std::strerror(errno));
        if (is_there && holds(destination, there, file.bytes)) {
            if (file.is_stamp) touched_.push_back({.destination = destination, .shown = file.path});
            return "";
        }
        const int descriptor = open_temporary(destination, file.path);
        if (descriptor < 0) return cannot_write(file.path, std::strerror(errno));
        if (has_left_root(descriptor, destination)) {
            ::close(descriptor);
            return cannot_write(file.path, "its folder has been replaced by a link meanwhile");
        }
        if (is_there) take_over(descriptor, there);
        const bool written = write_all(descriptor, file.bytes);
        const int failure = errno;
        const bool closed = ::close(descriptor) == 0;  // some file systems report a full disk here
        return written && closed ? "" : cannot_write(file.path, std::strerror(written ? errno : failure));
    }

    std::string finish() {
        for (const Temporary& each : temporaries_) {
            if (std::rename(each.path.c_str(), each.destination.c_str()) != 0)
                return cannot_write(each.shown, std::strerror(errno));
        }
        temporaries_.clear();
        folders_.clear();
        for (const Temporary& each : touched_) {
            if (::utimensat(AT_FDCWD, each.destination.c_str(), nullptr, 0) != 0)
                return cannot_write(each.shown, std::strerror(errno));
        }
        return "";
    }

private:
    struct Temporary {
        std::string path{}, destination{};
        std::string shown{};  // the destination as the user names it
    };

    // A new file next to the destination, so that it can be renamed.
    int open_temporary(const std::string& destination, const std::string& shown) {
        const fs::path folder = fs::path(destination).parent_path();
        for (;; ++count_) {
            // It is in the list before the file exists, so no failure can leave the file behind.
            temporaries_.push_back({(folder / temporary_name(count_)).string(), destination, shown});
            const char* path = temporaries_.back().path.c_str();
            const int descriptor = ::open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (descriptor < 0) temporaries_.pop_back();
            if (descriptor < 0 && errno == EEXIST) continue;
            return descriptor;
        }
    }

    // Somebody may have put a link into the place of a folder since the destination was found.
    bool has_left_root(int descriptor, const std::string& destination) const {
        if (!is_in_root(destination, root_)) return false;
        std::error_code error;
        const fs::path real = fs::read_symlink("/proc/self/fd/" + std::to_string(descriptor), error);
        return !error && !is_in_root(real.string(), root_);
    }

    // Only root can leave a file to another owner. If either call fails, the file is written all the same.
    static void take_over(int descriptor, const struct stat& from) {
        [[maybe_unused]] const bool is_of_same_owner = ::fchown(descriptor, from.st_uid, from.st_gid) == 0;
        ::fchmod(descriptor, from.st_mode & 0777);
    }

    std::vector<Temporary> temporaries_;
    std::vector<Temporary> touched_;  // files that get another time and no other bytes
    std::vector<fs::path> folders_;   // that were made, from the outside to the inside
    const Root* root_;
    unsigned count_ = 0;
};

// Of a path that may be written.
Destination follow(const std::string& path) {
    using Kind = Destination::Kind;
    std::error_code failure;
    fs::path at = fs::absolute(path, failure);
    for (int links = 0; links <= kMostLinks; ++links) {
        const fs::path folder = fs::weakly_canonical(at.parent_path(), failure);
        if (failure) return {.path = path, .error = failure.message()};
        at = folder / at.filename();
        const auto found = [&](Kind kind) { return Destination{.kind = kind, .path = at.string()}; };
        if (at.filename().empty()) return found(Kind::Folder);
        if (const int descriptor = own_descriptor(at); descriptor >= 0)
            return {.kind = Kind::Descriptor, .path = at.string(), .descriptor = descriptor};
        // The links of /proc stand for open files, and their texts need not be paths.
        if (at.string().starts_with("/proc/")) return found(Kind::Stream);
        const fs::file_status status = fs::symlink_status(at, failure);
        if (fs::is_directory(status)) return found(Kind::Folder);
        if (!fs::is_symlink(status)) {
            const bool is_stream = fs::exists(status) && !fs::is_regular_file(status);
            return found(is_stream ? Kind::Stream : Kind::File);
        }
        const fs::path target = fs::read_symlink(at, failure);
        at = folder / target;  // which is the target alone if that is absolute
    }
    return {.path = path, .error = std::strerror(ELOOP)};
}

}  // namespace

Destination destination_of(const std::string& path, const Root* root) {
    // This check comes first: a file outside is not examined, so no message shows whether it exists.
    if (std::string why = why_unwritable(path, root); !why.empty()) return {.path = path, .error = std::move(why)};
    Destination to = follow(path);
    // Opening a FIFO waits for its reader, and the author of the root's files may have put it there.
    if (to.kind == Destination::Kind::Stream && is_in_root(to.path, root))
        return {.path = path, .error = look_on_disk(to.path, anywhere()).why};
    return to;
}

std::string obstacle_to(const std::string& path) {
    const Destination to = destination_of(path);
    if (!to.error.empty()) return cannot_write(path, to.error);
    if (to.kind == Destination::Kind::Folder) return cannot_write(path, "it is a folder");
    if (to.kind != Destination::Kind::File) return "";
    std::error_code failure;
    if (fs::exists(to.path, failure) && ::access(to.path.c_str(), W_OK) != 0)
        return cannot_write(path, std::strerror(errno));
    const fs::path folder = fs::path(to.path).parent_path();
    fs::path there = folder;
    while (!fs::exists(there, failure) && there.has_relative_path()) there = there.parent_path();
    const bool is_folder = fs::is_directory(there, failure);
    if (is_folder && ::access(there.c_str(), W_OK | X_OK) == 0) return "";
    const std::string why = std::strerror(is_folder ? errno : ENOTDIR);
    return there == folder && is_folder ? cannot_write(path, why) : cannot_make(path, why);
}

std::string no_file(const std::string& path) {
    const DiskFile file = look_on_disk(path);
    return file.bytes ? std::string() : unread(path, file);
}

Outcome<std::string> read_file(const std::string& path, std::uint64_t most) {
    DiskFile file = read_disk(path, most);
    if (!file.bytes) return Failure{unread(path, file)};
    return std::move(*file.bytes);
}

Outcome<std::string> read_start(const std::string& path, std::size_t count) {
    DiskFile file = read_beginning(path, count);
    if (!file.bytes) return Failure{unread(path, file)};
    return std::move(*file.bytes);
}

std::string write_files(std::span<const OutputFile> files, const Root* root) {
    FolderLocks locks;  // outlive the temporary files
    Replacement replacement(root);
    std::vector<std::pair<const OutputFile*, Destination>> whole, streams;
    std::set<std::string> folders;
    for (const OutputFile& file : files) {
        Destination to = destination_of(file.path, root);
        if (!to.error.empty()) return cannot_write(file.path, to.error);
        switch (to.kind) {
            case Destination::Kind::Folder: return cannot_write(file.path, "it is a folder");
            case Destination::Kind::File: whole.emplace_back(&file, std::move(to)); break;
            case Destination::Kind::Stream:
            case Destination::Kind::Descriptor: streams.emplace_back(&file, std::move(to)); break;
        }
    }
    for (const auto& [file, to] : whole) {
        const fs::path folder = fs::path(to.path).parent_path();
        if (!folders.insert(folder.string()).second) continue;
        if (std::string error = replacement.make_folder(*file, folder); !error.empty()) return error;
    }
    // It is also decided under the lock which files keep their bytes, because nobody else can change them then.
    if (std::string error = locks.take(folders); !error.empty()) return cannot_write(files.front().path, error);
    for (const std::string& folder : folders) remove_leftovers(folder, locks.has(folder));
    for (const auto& [file, to] : whole) {
        if (std::string error = replacement.add(*file, to.path); !error.empty()) return error;
    }
    // What has gone into a pipe cannot be taken back: it goes when nothing else can be in the way.
    for (const auto& [file, to] : streams) {
        if (std::string error = write_to_stream(*file, to); !error.empty()) return error;
    }
    return replacement.finish();
}

std::string write_file(const std::string& path, std::string bytes, const Root* root) {
    const OutputFile file{.path = path, .bytes = std::move(bytes)};
    return write_files({&file, 1}, root);
}

void remove_file(const std::string& path) {
    std::error_code failure;
    if (destination_of(path).error.empty()) fs::remove(path, failure);
}

}  // namespace patina::runtime
