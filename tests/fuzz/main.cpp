// Runs the kinds of fuzz.h, with crashes caught:
//
//   build/fuzz --list                    # the kinds
//   build/fuzz graph quick               # as the tests do: a second
//   build/fuzz all 100000                # of each kind; the preset `asan` builds it with sanitizers
//   build/fuzz graph 1 1234 --keep x     # number 1234 alone, and keeps it as x
//   build/fuzz shadergraph 10000 --seeds FOLDER   # changes the files of a folder instead of the project's
//
// It prints the number of each failure. Inputs are run by a process of their own, which another one watches: if it
// crashes, or needs more than a minute for an input, that is a failure of that input, and the next one follows.
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "tests/fuzz/fuzz.h"

namespace patina::fuzz {
namespace {

namespace fs = std::filesystem;
constexpr unsigned kMostSeconds = 60;
constexpr unsigned long kSlow = 100'000;  // inputs of each kind, of the slow tests

// What both processes see.
struct Progress {
    unsigned long next = 0, accepted = 0, failed = 0;
    double slowest = 0;
    unsigned long slowest_number = 0;
};

struct Job {
    const InputKind& kind;
    unsigned long first = 0, end = 0;
    Setup setup{};
    std::string keep{};
};

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string run_one(const Fuzzer& fuzzer, const Job& job, unsigned long number, Progress& progress) {
    Random random(static_cast<Random::result_type>(number));
    const Input input = fuzzer.make(random);
    if (!job.keep.empty()) write_file(job.keep, input.bytes);
    const double begin = seconds_now();
    Verdict verdict;
    try {
        verdict = fuzzer.run(input, random);
    } catch (const std::exception& error) {
        verdict.wrong = std::string("it throws: ") + error.what();
    }
    const double seconds = seconds_now() - begin;
    if (seconds > progress.slowest) progress.slowest = seconds, progress.slowest_number = number;
    progress.accepted += verdict.is_accepted;
    if (!job.keep.empty() && !verdict.said.empty()) std::printf("%s\n", verdict.said.c_str());
    return verdict.wrong;
}

void run_all(const Job& job, Progress& progress) {
    const Fuzzer fuzzer = job.kind.open(job.setup);
    while (progress.next < job.end) {
        alarm(kMostSeconds);
        const unsigned long number = progress.next;
        const std::string wrong = run_one(fuzzer, job, number, progress);
        alarm(0);
        if (!wrong.empty()) {
            ++progress.failed;
            std::printf("%s %lu: %s\n", job.kind.name.data(), number, wrong.c_str());
            std::fflush(stdout);
        }
        ++progress.next;
    }
}

// The report of a sanitizer, or the last lines of what was said.
std::string last_of(const std::string& log) {
    constexpr std::size_t kMost = 3000;
    const std::size_t report = std::min(log.find("==ERROR"), log.find("runtime error"));
    if (report != log.npos) return log.substr(report - std::min<std::size_t>(report, 100), kMost) + "\n";
    return log.size() < 300 ? log : log.substr(log.size() - 300);
}

// True if nothing failed.
bool watch(const Job& job) {
    void* const shared = mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) return false;
    Progress& progress = *new (shared) Progress{.next = job.first};
    const double begin = seconds_now();
    const fs::path log = job.setup.scratch / "log";
    while (progress.next < job.end) {
        std::fflush(stdout);
        const pid_t child = fork();
        if (child < 0) return false;
        if (child == 0) {
            // Libraries complain of each file; a sanitizer's report comes last.
            if (!std::freopen(log.c_str(), "w", stderr)) std::_Exit(1);
            run_all(job, progress);
            std::fflush(stdout);
            std::_Exit(0);
        }
        int status = 0;
        waitpid(child, &status, 0);
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0) continue;
        ++progress.failed;
        const bool is_late = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
        std::printf("%s %lu: %s\n", job.kind.name.data(), progress.next,
                    is_late               ? "it takes more than a minute"
                    : WIFSIGNALED(status) ? strsignal(WTERMSIG(status))
                                          : "the process ends");
        std::fputs(last_of(read_file(log)).c_str(), stdout);
        ++progress.next;
    }
    const unsigned long count = job.end - job.first;
    std::printf("%s: %lu inputs, %lu accepted, %lu failures; %.0f s, the slowest (%lu) took %.0f ms\n",
                job.kind.name.data(), count, progress.accepted, progress.failed, seconds_now() - begin,
                progress.slowest_number, progress.slowest * 1000);
    // A kind of which all inputs are refused says nothing of what happens to others.
    const bool is_tried = count < 100 || (progress.accepted > 0 && progress.accepted < count);
    if (!is_tried) std::printf("%s: all inputs are alike\n", job.kind.name.data());
    const bool is_good = progress.failed == 0 && is_tried;
    munmap(shared, sizeof(Progress));
    return is_good;
}

int usage() {
    std::fputs("usage: fuzz KIND|all [quick|slow|COUNT] [FIRST] [--seeds FOLDER] [--keep FILE], or fuzz --list\n",
               stderr);
    return 2;
}

int run(std::vector<std::string> words) {
    std::vector<InputKind> kinds;
    for (const auto& some : {text_kinds(), picture_kinds(), model_kinds()})
        kinds.insert(kinds.end(), some.begin(), some.end());
    Setup setup;
    std::string keep;
    for (auto [option, to] : {std::pair<std::string_view, std::string*>{"--keep", &keep}, {"--seeds", nullptr}}) {
        const auto found = std::find(words.begin(), words.end(), option);
        if (found == words.end()) continue;
        if (found + 1 == words.end()) return usage();
        if (to)
            *to = found[1];
        else
            setup.seeds = found[1];
        words.erase(found, found + 2);
    }
    if (words.empty() || words.size() > 3) return usage();
    if (words[0] == "--list") {
        for (const InputKind& kind : kinds) std::printf("%-12s %s\n", kind.name.data(), kind.what.data());
        return 0;
    }
    std::string name = (fs::temp_directory_path() / "patina_fuzz_XXXXXX").string();
    setup.scratch = mkdtemp(name.data());
    bool is_good = true, is_known = false;
    for (const InputKind& kind : kinds) {
        if (words[0] != "all" && words[0] != kind.name) continue;
        is_known = true;
        const std::string count = words.size() > 1 ? words[1] : "quick";
        const unsigned long total = count == "quick"  ? kind.quick
                                    : count == "slow" ? kSlow
                                                      : std::strtoul(count.c_str(), nullptr, 10);
        const unsigned long first = words.size() > 2 ? std::strtoul(words[2].c_str(), nullptr, 10) : 0;
        is_good = watch({.kind = kind, .first = first, .end = first + total, .setup = setup, .keep = keep}) && is_good;
    }
    fs::remove_all(setup.scratch);
    if (!is_known) return usage();
    return is_good ? 0 : 1;
}

}  // namespace
}  // namespace patina::fuzz

int main(int count, char** arguments) {
    return patina::fuzz::run({arguments + 1, arguments + count});
}
