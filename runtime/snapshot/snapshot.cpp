#include "runtime/snapshot/snapshot.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <thread>

#include "runtime/snapshot/find_cases.h"
#include "runtime/snapshot/run_case.h"

namespace patina::runtime {
namespace {

constexpr unsigned kMostJobs = 4;  // without a wish: each needs a device and its memory

bool is_wanted(const PlannedCase& planned, const std::string& only) {
    return only.empty() || only == planned.name || only == planned.base ||
           only == std::filesystem::path(planned.name).filename() ||
           only == std::filesystem::path(planned.base).filename();
}

// Cases in turn, so that each part has some of every folder.
std::vector<PlannedCase> part_of(std::vector<PlannedCase> cases, const Shard& shard) {
    std::vector<PlannedCase> part;
    for (std::size_t i = 0; i < cases.size(); i++)
        if (i % shard.count == shard.index - 1) part.push_back(std::move(cases[i]));
    return part;
}

// Runs the cases on several threads, each with a device of its own, and reports them in order.
class Run {
public:
    Run(const Compiler& compiler, const std::vector<PlannedCase>& planned, const SnapshotOptions& options)
        : compiler_(compiler), planned_(planned), options_(options), cases_(planned.size()), done_(planned.size()) {}

    std::vector<SnapshotCase> run() {
        const unsigned cores = std::clamp(std::thread::hardware_concurrency(), 1u, kMostJobs);
        const std::size_t wanted = options_.jobs > 0 ? std::size_t(options_.jobs) : cores;
        std::vector<std::thread> others;
        for (std::size_t i = 1; i < std::min(wanted, planned_.size()); i++) others.emplace_back([this] { work(); });
        work();
        for (std::thread& other : others) other.join();
        return std::move(cases_);
    }

private:
    void work() {
        RenderMachine machine;
        for (std::size_t i = next_++; i < planned_.size(); i = next_++) {
            SnapshotCase result = run_case(compiler_, planned_[i], options_, machine);
            const std::scoped_lock lock(mutex_);
            cases_[i] = std::move(result);
            done_[i] = true;
            for (; told_ < cases_.size() && done_[told_]; told_++)
                if (options_.on_case) options_.on_case(cases_[told_], told_, cases_.size());
        }
    }

    const Compiler& compiler_;
    const std::vector<PlannedCase>& planned_;
    const SnapshotOptions& options_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_{};  // of what follows
    std::vector<SnapshotCase> cases_;
    std::vector<bool> done_;
    std::size_t told_ = 0;
};

}  // namespace

std::string_view to_string(SnapshotState state) {
    switch (state) {
        case SnapshotState::Passed: return "passed";
        case SnapshotState::Failed: return "failed";
        case SnapshotState::Missing: return "missing";
        case SnapshotState::Updated: return "updated";
    }
    return "";
}

bool SnapshotReport::ok() const {
    return error.empty() && std::ranges::all_of(cases, &SnapshotCase::ok);
}

std::size_t SnapshotReport::count(SnapshotState state) const {
    return std::size_t(std::ranges::count(cases, state, &SnapshotCase::state));
}

SnapshotReport run_snapshots(const Compiler& compiler, const std::string& dir, const SnapshotOptions& options) {
    FoundCases found = find_cases(dir);
    SnapshotReport report{.error = std::move(found.error)};
    if (!report.error.empty()) return report;
    std::erase_if(found.cases, [&](const PlannedCase& each) { return !is_wanted(each, options.only); });
    if (found.cases.empty()) report.error = "there is no case '" + options.only + "' in '" + dir + "'";
    if (options.only.empty()) report.orphans = std::move(found.orphans);
    const std::vector<PlannedCase> cases = part_of(std::move(found.cases), options.shard);
    report.cases = Run(compiler, cases, options).run();
    return report;
}

}  // namespace patina::runtime
