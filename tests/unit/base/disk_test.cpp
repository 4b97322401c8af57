// What is read of the disk: regular files alone, no more than the limit, and nothing outside of a root, by whatever
// links and names.
#include "compiler/base/disk/disk.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "compiler/base/disk/near_file.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

class Disk : public testing::Test {
protected:
    Disk() {
        std::string name = (fs::temp_directory_path() / "patina_disk_XXXXXX").string();
        folder = fs::canonical(mkdtemp(name.data()));
        fs::create_directories(folder / "art/deep");
        write("art/rust.json", "rust");
        write("secret.json", "secret");
    }
    ~Disk() override { fs::remove_all(folder); }

    std::string at(const std::string& name) const { return (folder / name).string(); }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(at(name), std::ios::binary) << text;
    }
    void link(const std::string& target, const std::string& name) const { fs::create_symlink(target, at(name)); }

    // Neither read nor found, by any function.
    void expect_hidden(const std::string& path, const Root& root) const {
        EXPECT_FALSE(root.find(path)) << path;
        for (const DiskFile& file :
             {read_disk(path, 100, &root), read_beginning(path, 3, &root), look_on_disk(path, &root)}) {
            EXPECT_FALSE(file.bytes) << path;
            EXPECT_EQ(file.why, "it is outside of the root folder '" + root.name() + "'") << path;
        }
        EXPECT_FALSE(is_on_disk(path, &root)) << path;
        EXPECT_FALSE(is_folder_on_disk(path, &root)) << path;
        EXPECT_EQ(near_file(path, &root), "") << path;
    }

    fs::path folder;
};

TEST_F(Disk, RefusesWhatIsNoRegularFileWithoutOpeningIt) {
    ASSERT_EQ(mkfifo(at("fifo").c_str(), 0600), 0);
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
    std::strncpy(address.sun_path, at("socket").c_str(), sizeof address.sun_path - 1);
    ASSERT_EQ(bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    link("/dev/zero", "zero.graph.json");
    link("fifo", "fifo.png");
    const std::pair<std::string, std::string> kinds[] = {
        {at("art"), "it is a folder"},    {at("fifo"), "it is a FIFO"},    {at("fifo.png"), "it is a FIFO"},
        {at("socket"), "it is a socket"}, {"/dev/zero", "it is a device"}, {at("zero.graph.json"), "it is a device"}};
    for (const auto& [path, why] : kinds) {
        const DiskFile read = read_disk(path, 1000), start = read_beginning(path, 10), look = look_on_disk(path);
        EXPECT_FALSE(read.bytes || start.bytes || look.bytes) << path;
        EXPECT_EQ(read.why, why) << path;
        EXPECT_EQ(start.why, why) << path;
        EXPECT_EQ(look.why, why) << path;
        EXPECT_FALSE(is_on_disk(path)) << path;
    }
    close(socket);
}

TEST_F(Disk, AFileThatIsNotThereHasNoReason) {
    for (const std::string name : {"none", "art/none", "rust.json/none", "none/none"}) {
        const DiskFile file = read_disk(at(name), 10);
        EXPECT_FALSE(file.bytes) << name;
        EXPECT_EQ(file.why, "") << name;
    }
    // The system would end the name at the zero byte.
    const DiskFile cut = read_disk(at("secret.json") + std::string("\0.graph.json", 12), 10);
    EXPECT_FALSE(cut.bytes);
    EXPECT_EQ(cut.why, "");
    link("circle", "circle");
    EXPECT_NE(read_disk(at("circle"), 10).why, "");
}

TEST_F(Disk, ReadsNoMoreThanTheLimit) {
    write("text", "0123456789");
    EXPECT_EQ(read_disk(at("text"), 10).bytes, "0123456789");
    const DiskFile more = read_disk(at("text"), 9);
    EXPECT_FALSE(more.bytes);
    EXPECT_TRUE(more.is_too_large);
    EXPECT_EQ(more.size, 10u);
    EXPECT_EQ(more.why, "it has more than 9 bytes");
    EXPECT_EQ(read_beginning(at("text"), 3).bytes, "012");
    EXPECT_EQ(read_beginning(at("text"), 30).bytes, "0123456789");
    EXPECT_EQ(read_beginning(at("text"), 3).size, 10u);
    write("empty", "");
    EXPECT_EQ(read_disk(at("empty"), 0).bytes, "");
    // The system says that it has no bytes.
    const DiskFile endless = read_disk("/proc/self/maps", 100);
    EXPECT_FALSE(endless.bytes);
    EXPECT_EQ(endless.why, "it has more than 100 bytes");
    EXPECT_GT(read_disk("/proc/self/maps", 1 << 24).bytes.value_or("").size(), 100u);
    const std::string long_text(3'000'000, 'x');
    write("long", long_text);
    EXPECT_EQ(read_disk(at("long"), 3'000'000).bytes, long_text);
}

TEST_F(Disk, ALargeFileIsRefusedBeforeItTakesMemory) {
    write("sparse", "");
    fs::resize_file(at("sparse"), std::uintmax_t{2} << 30);
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    const DiskFile file = read_disk(at("sparse"), kMostTextBytes);
    getrusage(RUSAGE_SELF, &after);
    EXPECT_TRUE(file.is_too_large);
    EXPECT_EQ(file.size, std::uintmax_t{2} << 30);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 8 << 10) << "kilobytes";
}

TEST_F(Disk, ARootHoldsWhatIsInItByAnyName) {
    const Root root(at("art"));
    write("art/deep/wet.json", "wet");
    link("deep/wet.json", "art/short.json");
    link("../rust.json", "art/deep/up.json");
    link(at("art/rust.json"), "art/whole.json");
    link("deep", "art/way");
    const std::pair<std::string, std::string> files[] = {
        {at("art/rust.json"), "rust"},   {at("art/deep/../rust.json"), "rust"}, {at("art/../art/rust.json"), "rust"},
        {at("art/short.json"), "wet"},   {at("art/deep/up.json"), "rust"},      {at("art/whole.json"), "rust"},
        {at("art/way/wet.json"), "wet"}, {at("art/./deep//wet.json"), "wet"},
    };
    for (const auto& [path, text] : files) {
        EXPECT_EQ(read_disk(path, 10, &root).bytes, text) << path;
        EXPECT_TRUE(is_on_disk(path, &root)) << path;
    }
    EXPECT_TRUE(is_folder_on_disk(at("art/way"), &root));
    EXPECT_EQ(read_disk(at("art/none.json"), 10, &root).why, "");
    EXPECT_EQ(near_file(at("art/rost.json"), &root), "did you mean '" + at("art/rust.json") + "'?");
    // By a link to the root itself.
    link("art", "paintings");
    const Root linked(at("paintings"));
    EXPECT_EQ(read_disk(at("paintings/rust.json"), 10, &linked).bytes, "rust");
    EXPECT_EQ(read_disk(at("art/rust.json"), 10, &linked).bytes, "rust");
    const fs::path here = fs::current_path();
    fs::current_path(at("art"));
    EXPECT_EQ(read_disk("deep/up.json", 10, &root).bytes, "rust");
    const Root current(".");
    EXPECT_EQ(read_disk("rust.json", 10, &current).bytes, "rust");
    expect_hidden("../secret.json", current);
    fs::current_path(here);
}

TEST_F(Disk, ARootHidesWhatIsOutsideOfIt) {
    const Root root(at("art"));
    link("../secret.json", "art/up.json");
    link(at("secret.json"), "art/whole.json");
    link("..", "art/out");
    link("/proc/self/root", "art/proc");
    link("/proc/self/fd", "art/open");
    link("up.json", "art/twice.json");
    link("/", "art/all");
    // It leads back, and would tell whether there is such a folder.
    link(at("art/../secret-or-not/../art/rust.json"), "art/back.json");
    fs::create_directories(at("artful"));
    write("artful/rust.json", "other");
    for (const std::string& path :
         {at("secret.json"), at("art/../secret.json"), at("art/up.json"), at("art/whole.json"), at("art/twice.json"),
          at("art/out/secret.json"), at("art/proc") + at("secret.json"), at("art/all") + at("secret.json"),
          at("art/open/0"), at("art/back.json"), at("artful/rust.json"), std::string("/etc/passwd"), std::string("/"),
          std::string("/proc/self/environ"), at("art/none/../../none.json"), at(""), at("art/out/art/rust.json")})
        expect_hidden(path, root);
    const Root none(at("nowhere"));
    expect_hidden(at("art/rust.json"), none);
    expect_hidden(at("nowhere"), none);
    link("circle", "art/circle");
    expect_hidden(at("art/circle"), root);
}

// The program's own files are read whatever graphs may read; everything else of the process is confined.
TEST_F(Disk, AProcessCanBeConfined) {
    const auto in_a_child = [&](auto work) {
        const pid_t child = fork();
        if (child == 0) _exit(work() ? 0 : 1);
        int status = 0;
        waitpid(child, &status, 0);
        return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    };
    EXPECT_TRUE(in_a_child([&] {
        confine_disk(at("art"));
        return read_disk(at("art/rust.json"), 10).bytes == "rust" && !read_disk(at("secret.json"), 10).bytes &&
               !is_on_disk(at("secret.json")) && near_file(at("secrets.json")).empty() &&
               !why_outside(at("secret.json")).empty() && why_outside(at("art/none.json")).empty() &&
               read_disk(at("secret.json"), 10, anywhere()).bytes == "secret";
    }));
    EXPECT_TRUE(read_disk(at("secret.json"), 10).bytes);
}

// Files that are written: links of the root's do not lead out of it, and those that lie elsewhere go where they go.
TEST_F(Disk, LinksOfARootChooseNoFileOutsideOfIt) {
    const Root root(at("art"));
    fs::create_directories(at("other/deep"));
    link("../secret.json", "art/up.json");
    link(at("other"), "art/out");
    link("../none.json", "art/dangling.json");
    link("/proc/self/fd/1", "art/stdout");
    link("circle", "art/circle");
    link("deep", "art/way");
    link("rust.json", "art/same.json");
    link("deep/new.json", "art/new.json");
    link("art", "paintings");
    link("art/deep", "depth");
    link("art/up.json", "mine.json");
    link("other/deep", "elsewhere");
    for (const std::string& path :
         {at("art/up.json"), at("art/out/rust.json"), at("art/out/none/rust.json"), at("art/dangling.json"),
          at("art/stdout"), at("art/circle"), at("paintings/up.json"), at("paintings/out/rust.json"),
          at("depth/../up.json"), at("mine.json"), at("art/out/../rust.json"), at("art/out/../../other/x"),
          at("art/deep/../out/deep/x"), at("other/../art/up.json")}) {
        EXPECT_FALSE(root.lets_write(path)) << path;
        EXPECT_EQ(why_unwritable(path, &root), "a link leads outside of the root folder '" + at("art") + "'") << path;
        EXPECT_EQ(why_unwritable(path, anywhere()), "") << path;
    }
    for (const std::string& path :
         {at("art/rust.json"), at("art/made.json"), at("art/made/rust.json"), at("art/way/x"), at("art/same.json"),
          at("art/new.json"), at("paintings/same.json"), at("depth/x"), at("depth/../x"), at("secret.json"),
          at("other/made/x"), at("elsewhere/x"), at("elsewhere/../x"), at("art/../other/x"), std::string("/dev/stdout"),
          std::string("none/x"), std::string("x")})
        EXPECT_TRUE(root.lets_write(path)) << path;
    // By its text it lies in the root. The system goes from the target of the link, to "other/art".
    EXPECT_FALSE(root.lets_write(at("elsewhere/../art/rust.json")));
    const Root linked(at("paintings"));
    EXPECT_FALSE(linked.lets_write(at("paintings/up.json")));
    EXPECT_FALSE(linked.lets_write(at("art/up.json")));
    EXPECT_TRUE(linked.lets_write(at("paintings/same.json")));
}

TEST_F(Disk, StandardInputHasALimit) {
    std::string why;
    write("text", "0123456789");
    const int before = dup(STDIN_FILENO);
    const auto from_file = [&](std::uint64_t most) {
        EXPECT_NE(std::freopen(at("text").c_str(), "r", stdin), nullptr);
        return read_standard_input(most, why);
    };
    EXPECT_EQ(from_file(10), "0123456789");
    EXPECT_EQ(from_file(9), std::nullopt);
    EXPECT_EQ(why, "it has more than 9 bytes");
    dup2(before, STDIN_FILENO);
    close(before);
}

TEST_F(Disk, ALinkHasTheNameOfWhatItLeadsTo) {
    link("secret.json", "a.graph.json");
    EXPECT_EQ(without_links(at("a.graph.json")), at("secret.json"));
    EXPECT_EQ(without_links(at("secret.json")), at("secret.json"));
    EXPECT_EQ(without_links(at("none")), at("none"));
}

}  // namespace
}  // namespace patina
