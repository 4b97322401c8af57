// How output files are written: whole or not at all, through links, and not over what is no file.
#include "runtime/files/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;
using Kind = Destination::Kind;

// A folder of its own for each test, gone afterwards.
class Files : public testing::Test {
protected:
    Files() {
        std::string name = (fs::canonical(fs::temp_directory_path()) / "patina_files_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~Files() override { fs::remove_all(folder); }
    std::string path(const std::string& name) const { return (folder / name).string(); }
    std::string text(const std::string& name) const {
        std::ifstream file(folder / name, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    }
    std::size_t file_count() const {
        return std::size_t(std::distance(fs::recursive_directory_iterator(folder), fs::recursive_directory_iterator()));
    }

    fs::path folder;
};

TEST_F(Files, AreWrittenWithTheirFolders) {
    EXPECT_EQ(write_file(path("a/b/c.txt"), "one"), "");
    EXPECT_EQ(text("a/b/c.txt"), "one");
    EXPECT_EQ(write_file(path("a/b/c.txt"), "two"), "");
    EXPECT_EQ(text("a/b/c.txt"), "two");
    EXPECT_EQ(file_count(), 3u);
}

TEST_F(Files, AreAllThereOrNone) {
    fs::create_directories(folder / "taken");
    const std::vector<OutputFile> files = {{path("new/deep/a.txt"), "a"}, {path("b.txt"), "b"}, {path("taken"), "c"}};
    EXPECT_EQ(write_files(files), "cannot write '" + path("taken") + "': it is a folder");
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(Files, WithTheSameBytesKeepTheirTime) {
    ASSERT_EQ(write_file(path("same"), "old"), "");
    const fs::file_time_type long_ago = fs::last_write_time(path("same")) - std::chrono::hours(1);
    fs::last_write_time(path("same"), long_ago);
    ASSERT_EQ(write_file(path("same"), "old"), "");
    EXPECT_EQ(fs::last_write_time(path("same")), long_ago);
    ASSERT_EQ(write_file(path("same"), "new"), "");  // as long, with other bytes
    EXPECT_GT(fs::last_write_time(path("same")), long_ago);
    EXPECT_EQ(text("same"), "new");
    fs::last_write_time(path("same"), long_ago);
    const OutputFile stamp{.path = path("same"), .bytes = "new", .is_stamp = true};
    ASSERT_EQ(write_files({&stamp, 1}), "");
    EXPECT_GT(fs::last_write_time(path("same")), long_ago);
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(Files, GoWhereALinkLeads) {
    std::ofstream(folder / "target.txt") << "old";
    fs::permissions(folder / "target.txt", fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("target.txt", folder / "link.txt");
    fs::create_symlink(folder / "link.txt", folder / "link of a link.txt");
    fs::create_symlink("new/made.txt", folder / "dangling.txt");
    fs::create_symlink("round.txt", folder / "round.txt");
    EXPECT_EQ(destination_of(path("link of a link.txt")).path, path("target.txt"));
    EXPECT_EQ(write_file(path("link of a link.txt"), "new"), "");
    EXPECT_EQ(text("target.txt"), "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
    EXPECT_TRUE(fs::is_symlink(folder / "link of a link.txt"));
    EXPECT_EQ(fs::status(folder / "target.txt").permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(write_file(path("dangling.txt"), "made"), "");
    EXPECT_EQ(text("new/made.txt"), "made");
    EXPECT_NE(write_file(path("round.txt"), "x"), "");
}

TEST_F(Files, ThroughAFifoAreNotFiles) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    EXPECT_EQ(destination_of(path("pipe")).kind, Kind::Stream);
    const std::string sent(200'000, 'x');  // more than a pipe holds
    std::string received;
    std::thread reader([&] { received = text("pipe"); });
    EXPECT_EQ(write_file(path("pipe"), sent), "");
    reader.join();
    EXPECT_EQ(received, sent);
    EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

TEST_F(Files, FailIfTheReaderOfAPipeHasGone) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    close(ends[0]);
    const std::string name = "/dev/fd/" + std::to_string(ends[1]);
    EXPECT_EQ(write_files(std::vector<OutputFile>{{path("a.txt"), "a"}, {name, "b"}}),
              "cannot write '" + name + "': Broken pipe");
    EXPECT_EQ(file_count(), 0u);
    close(ends[1]);
}

// Opening the path again would begin at the start of the file, and renaming would take its name away.
TEST_F(Files, AreAppendedToAnOpenDescriptor) {
    std::ofstream(folder / "open.txt") << "before ";
    const int descriptor = open(path("open.txt").c_str(), O_WRONLY | O_APPEND);
    for (const char* form : {"/dev/fd/", "/proc/self/fd/"}) {
        const Destination to = destination_of(form + std::to_string(descriptor));
        EXPECT_EQ(to.kind, Kind::Descriptor);
        EXPECT_EQ(to.descriptor, descriptor);
        EXPECT_EQ(write_file(form + std::to_string(descriptor), "and "), "");
    }
    close(descriptor);
    EXPECT_EQ(text("open.txt"), "before and and ");
}

// Not written to: if this went wrong, root would lose the device of the whole machine.
TEST_F(Files, DoNotReplaceDevices) {
    EXPECT_EQ(destination_of("/dev/null").kind, Kind::Stream);
}

// Their own names for a while, which somebody else may have taken, and at the greatest length of a name.
TEST_F(Files, HaveTemporaryNamesThatNobodyHas) {
    const std::string taken = ".patina-" + std::to_string(getpid()) + "-0";
    std::ofstream(folder / taken) << "mine";
    const std::string longest = std::string(251, 'x') + ".txt";
    EXPECT_EQ(write_file(path(longest), "x"), "");
    EXPECT_EQ(text(taken), "mine");
    EXPECT_EQ(text(longest), "x");
    EXPECT_EQ(file_count(), 2u);
}

TEST_F(Files, ThatAreProtectedStay) {
    if (geteuid() == 0) GTEST_SKIP() << "nothing is protected from root";
    std::ofstream(folder / "protected.txt") << "mine";
    fs::permissions(folder / "protected.txt", fs::perms::owner_read);
    EXPECT_EQ(write_file(path("protected.txt"), "x"),
              "cannot write '" + path("protected.txt") + "': Permission denied");
    EXPECT_EQ(text("protected.txt"), "mine");
}

}  // namespace
}  // namespace patina::runtime
