#include "runtime/snapshot/snapshot.h"

#include <algorithm>
#include <filesystem>

#include "runtime/render/render_jobs.h"
#include "runtime/snapshot/find_cases.h"
#include "runtime/snapshot/run_case.h"

namespace patina::runtime {
namespace {

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
    report.cases.resize(cases.size());
    render_jobs(
        cases.size(), options.jobs,
        [&](std::size_t i, RenderMachine& machine) {
            report.cases[i] = run_case(compiler, cases[i], options, machine);
        },
        [&](std::size_t i) {
            if (options.on_case) options.on_case(report.cases[i], i, cases.size());
        });
    return report;
}

}  // namespace patina::runtime
