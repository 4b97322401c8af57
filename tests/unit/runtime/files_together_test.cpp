// Two processes that write to one folder, and one that reads there: files of one run stay together, and what killed
// runs leave is removed by the next.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <thread>

#include "patina/reflection.h"
#include "runtime/files/files.h"
#include "runtime/files/folder_lock.h"
#include "runtime/files/leftovers.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr const char* kNames[] = {"rust.vert", "rust.frag", "rust.lit", "rust.fog"};

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
}

// Runs it in a process of its own.
pid_t start(const std::function<void()>& work) {
    const pid_t process = fork();
    if (process == 0) {
        work();
        _exit(testing::Test::HasFailure() ? 1 : 0);
    }
    return process;
}
bool ends_well(pid_t process) {
    int status = 0;
    return waitpid(process, &status, 0) == process && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

class Together : public testing::Test {
protected:
    Together() {
        std::string name = (fs::canonical(fs::temp_directory_path()) / "patina_together_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~Together() override { fs::remove_all(folder); }
    std::string path(const std::string& name) const { return (folder / name).string(); }

    // The files of one run: shaders, and the reflection that lists them.
    std::vector<OutputFile> files_of(const std::string& run) const {
        std::vector<OutputFile> files;
        Reflection reflection;
        reflection.name = run;
        for (const char* name : kNames) {
            files.push_back({.path = path(name), .bytes = run + " " + name + std::string(2000, '.')});
            reflection.files.push_back({.file = name, .hash = file_hash(files.back().bytes)});
        }
        files.push_back({.path = path("rust.reflect.json"), .bytes = reflection.to_json()});
        return files;
    }
    // True if the shaders that are there are those of the reflection that was there before.
    bool is_one_run() const {
        const ReadReflection read = Reflection::from_json(text_of(folder / "rust.reflect.json"));
        EXPECT_TRUE(read.ok);
        bool is_same = true;
        for (const WrittenFile& each : read.reflection.files) {
            const std::string text = text_of(folder / each.file);
            if (file_hash(text) != each.hash) return false;
            is_same = is_same && text.starts_with(read.reflection.name + " ");
        }
        EXPECT_TRUE(is_same) << "the hashes agree, and the files are of two runs";
        return true;
    }
    std::size_t leftovers() const {
        return std::size_t(std::count_if(fs::directory_iterator(folder), fs::directory_iterator(), [](const auto& at) {
            return at.path().filename().string().starts_with(".patina-");
        }));
    }

    fs::path folder;
};

TEST_F(Together, AReaderSeesFilesOfOneRun) {
    ASSERT_EQ(write_files(files_of("first")), "");
    std::vector<pid_t> writers;
    for (const char* run : {"sunny", "rainy"}) {
        writers.push_back(start([&] {
            for (int i = 0; i < 1000; ++i) EXPECT_EQ(write_files(files_of(run)), "");
        }));
    }
    const int lock = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    int mixed = 0;
    for (int i = 0; i < 2000; ++i) {
        ASSERT_EQ(flock(lock, LOCK_SH), 0);
        if (!is_one_run()) ++mixed;
        flock(lock, LOCK_UN);
        is_one_run();  // without a lock, the reader finds out
        std::this_thread::yield();
    }
    EXPECT_EQ(mixed, 0) << "of 2000 times, under a shared lock";
    close(lock);
    for (const pid_t writer : writers) EXPECT_TRUE(ends_well(writer));
    EXPECT_TRUE(is_one_run());
    EXPECT_EQ(leftovers(), 0u);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 5);
}

TEST_F(Together, ARunAfterOneThatWasKilledMakesTheFolderWhole) {
    std::mt19937 random(38);
    std::uniform_int_distribution<int> microseconds(0, 3000);
    std::size_t left = 0, mixed = 0;
    for (int i = 0; i < 200; ++i) {
        const pid_t writer = start([&] {
            for (int run = 0;; ++run) write_files(files_of(std::to_string(run)));
        });
        std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
        kill(writer, SIGKILL);
        waitpid(writer, nullptr, 0);
        left += leftovers() > 0 ? 1 : 0;
        if (fs::exists(folder / "rust.reflect.json")) mixed += is_one_run() ? 0 : 1;
        EXPECT_TRUE(ends_well(start([&] { EXPECT_EQ(write_files(files_of("whole")), ""); })));
        ASSERT_EQ(leftovers(), 0u);
        ASSERT_TRUE(is_one_run());
    }
    RecordProperty("left", int(left));
    RecordProperty("mixed", int(mixed));
    EXPECT_GT(left, 0u) << "no run was killed at the right moment: the test shows nothing";
}

TEST_F(Together, OnlyTemporaryFilesAreLeftovers) {
    const std::vector<std::string> kept = {".patina",     ".patina-",     ".patina-mine", ".patina-1-0.txt",
                                           ".patina-1-x", "x.patina-1-0", ".patina-1-0-", ".patina--0"};
    const std::vector<std::string> removed = {".patina-1-0", ".patina-123456-7", ".patina-1-18f3a2c0b1d2e3f4-12"};
    for (const std::string& name : kept) std::ofstream(folder / name) << "mine";
    for (const std::string& name : removed) std::ofstream(folder / name) << "left";
    fs::create_directory(folder / ".patina-2-0");
    fs::create_symlink("elsewhere", folder / ".patina-3-0");
    fs::create_directory(folder / "below");
    std::ofstream(folder / "below" / ".patina-1-0") << "in a folder that is not written to";
    ASSERT_EQ(write_file(path("a.txt"), "a"), "");
    for (const std::string& name : kept) EXPECT_TRUE(fs::exists(folder / name)) << name;
    for (const std::string& name : removed) EXPECT_FALSE(fs::exists(folder / name)) << name;
    EXPECT_TRUE(fs::exists(folder / ".patina-2-0"));
    EXPECT_TRUE(fs::is_symlink(folder / ".patina-3-0"));
    EXPECT_TRUE(fs::exists(folder / "below" / ".patina-1-0"));
    EXPECT_FALSE(is_temporary_of_another(temporary_name(0)));
}

// Where nobody knows whether another process writes, a young file may be its own.
TEST_F(Together, LeftoversOfAFolderThatCannotBeLockedAreOld) {
    for (const char* name : {".patina-1-0", ".patina-2-0"}) std::ofstream(folder / name) << "left";
    fs::last_write_time(folder / ".patina-2-0", fs::file_time_type::clock::now() - 2h);
    remove_leftovers(folder.string(), false);
    EXPECT_TRUE(fs::exists(folder / ".patina-1-0"));
    EXPECT_FALSE(fs::exists(folder / ".patina-2-0"));
}

TEST_F(Together, AFolderThatStaysLockedIsAnError) {
    const int other = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    ASSERT_EQ(flock(other, LOCK_SH), 0);
    {
        FolderLocks locks;
        EXPECT_NE(locks.take({folder.string()}, 20ms).find("holds a lock on the folder '" + folder.string() + "'"),
                  std::string::npos);
        EXPECT_FALSE(locks.has(folder.string()));
    }
    close(other);
    FolderLocks locks;
    EXPECT_EQ(locks.take({folder.string(), path("."), path("missing")}, 20ms), "");
    EXPECT_TRUE(locks.has(folder.string()));
    EXPECT_TRUE(locks.has(path(".")));
    EXPECT_FALSE(locks.has(path("missing")));
}

// `flock out sh -c 'patina ...'`: the lock is this program's own.
TEST_F(Together, ALockThatTheProgramWasStartedWithIsItsOwn) {
    const int inherited = open(folder.c_str(), O_RDONLY | O_DIRECTORY);
    ASSERT_EQ(flock(inherited, LOCK_EX), 0);
    {
        FolderLocks locks;
        EXPECT_EQ(locks.take({folder.string()}, 20ms), "");
        EXPECT_TRUE(locks.has(folder.string()));
    }
    const int other = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    EXPECT_NE(flock(other, LOCK_EX | LOCK_NB), 0) << "the lock of the program that started this one was given back";
    close(other);
    close(inherited);
}

// Locks of several folders, in whatever order their files are written.
TEST_F(Together, WritersOfTwoFoldersDoNotWaitForEachOther) {
    for (const char* name : {"a", "b"}) fs::create_directory(folder / name);
    std::vector<pid_t> writers;
    for (const bool is_turned : {false, true}) {
        writers.push_back(start([&] {
            std::vector<OutputFile> files = {{.path = path("a/x"), .bytes = is_turned ? "1" : "2"},
                                             {.path = path("b/x"), .bytes = is_turned ? "1" : "2"}};
            if (is_turned) std::swap(files[0], files[1]);
            for (int i = 0; i < 500; ++i) EXPECT_EQ(write_files(files), "");
        }));
    }
    for (const pid_t writer : writers) EXPECT_TRUE(ends_well(writer));
    EXPECT_EQ(text_of(folder / "a/x"), text_of(folder / "b/x"));
}

// A folder is watched by its time: what changes nothing in it leaves that alone.
TEST_F(Together, AStampWithTheSameBytesLeavesItsFolderAlone) {
    const std::vector<OutputFile> files = {{.path = path("same"), .bytes = "same"},
                                           {.path = path("stamp"), .bytes = "done", .is_stamp = true}};
    ASSERT_EQ(write_files(files), "");
    const fs::file_time_type long_ago = fs::file_time_type::clock::now() - 1h;
    for (const fs::path& each : {folder / "stamp", folder / "same", folder}) fs::last_write_time(each, long_ago);
    ASSERT_EQ(write_files(files), "");
    EXPECT_EQ(fs::last_write_time(folder), long_ago);
    EXPECT_EQ(fs::last_write_time(folder / "same"), long_ago);
    EXPECT_GT(fs::last_write_time(folder / "stamp"), long_ago);
}

}  // namespace
}  // namespace patina::runtime
