#include "runtime/snapshot/snapshot.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kEnding = ".snapshot.json";

// Paths of the snapshot files in and below `dir`, without their ending, sorted.
Outcome<std::vector<fs::path>> find_cases(const std::string& dir) {
    std::vector<fs::path> cases;
    std::error_code error;
    for (fs::recursive_directory_iterator at(dir, error), end; !error && at != end; at.increment(error)) {
        std::string name = at->path().lexically_normal().string();
        if (name.ends_with(kEnding)) cases.emplace_back(name.substr(0, name.size() - kEnding.size()));
    }
    if (error) return Failure{"cannot read the folder '" + dir + "': " + error.message()};
    if (cases.empty()) return Failure{"there is no *.snapshot.json in '" + dir + "'"};
    std::sort(cases.begin(), cases.end());
    return cases;
}

// The result of the comparison and the tolerance.
std::string describe(const Comparison& c, const Tolerance& tolerance) {
    return fmt::format(
        "{:.3g} % of the pixels differ (limit {:.3g} %), the average error is {:.2g} (limit {:.2g}); the largest is "
        "{:.2g}, "
        "at {}, {}",
        c.share * 100, tolerance.share * 100, c.average, tolerance.average, c.largest, c.worst_x, c.worst_y);
}

bool passes(const Comparison& c, const Tolerance& tolerance) {
    return c.share <= tolerance.share && c.average <= tolerance.average;
}

// Writes a picture into the received folder and keeps its path in `written`; appends to `message` what went wrong.
void write_received(const fs::path& path, const Image& encoded, std::string& written, std::string& message) {
    const std::string problem = save_png_as_is(path.string(), encoded);
    if (problem.empty())
        written = path.string();
    else
        message += "; " + problem;
}

void accept(SnapshotCase& result, const Image& received) {
    std::string error = save_png_as_is(result.reference, received);
    result.state = error.empty() ? SnapshotState::Updated : SnapshotState::Failed;
    result.message = error;
}

// Reference pictures were once named NAME.png, which is now a picture that 'patina render' writes.
std::string advice_on(const SnapshotCase& result) {
    std::error_code ignored;
    const fs::path old = result.file.substr(0, result.file.size() - kEnding.size()) + ".png";
    if (!fs::exists(old, ignored)) return "";
    return fmt::format("; if '{}' is it, rename it", old.string());
}

// `received` is what an 8-bit file would hold, so that it can meet the reference exactly.
void judge(SnapshotCase& result, const Image& received, const SnapshotOptions& options) {
    fs::path kept = fs::path(options.received_dir) / (result.name + ".received.png");
    fs::path difference = fs::path(options.received_dir) / (result.name + ".difference.png");
    std::error_code ignored;
    fs::remove(kept, ignored);  // of an earlier run
    fs::remove(difference, ignored);

    if (!fs::exists(result.reference, ignored)) {
        if (options.update) return accept(result, received);
        result.state = SnapshotState::Missing;
        result.message = "there is no reference picture '" + result.reference + "' yet" + advice_on(result);
        write_received(kept, received, result.received, result.message);
        return;
    }
    Outcome<Image> reference = load_image(result.reference);
    if (!reference && options.update) return accept(result, received);
    if (!reference) {
        result.message = reference.error;
        return;
    }
    Comparison comparison = compare(reference.value, received, result.tolerance.pixel);
    if (comparison.same_size) result.comparison = comparison;
    if (result.comparison && passes(comparison, result.tolerance)) {
        result.state = SnapshotState::Passed;
        return;
    }
    if (options.update) return accept(result, received);
    result.message = result.comparison
                         ? describe(comparison, result.tolerance)
                         : fmt::format("the reference is {} x {} pixels and the picture {} x {}", reference.value.width,
                                       reference.value.height, received.width, received.height);
    write_received(kept, received, result.received, result.message);
    write_received(difference, difference_image(reference.value, received, result.tolerance.pixel), result.difference,
                   result.message);
}

SnapshotCase run_case(const Compiler& compiler, const fs::path& stem, const std::string& name,
                      const SnapshotOptions& options, RenderMachine& machine) {
    SnapshotCase result{
        .name = name, .file = stem.string() + std::string(kEnding), .reference = stem.string() + ".reference.png"};
    ReadSnapshot read = read_snapshot(result.file);
    if (!read.file) {
        result.diagnostics = {read.error};
        return result;
    }
    RenderRequest& request = read.file->request;
    if (!options.via.empty()) request.options.via = options.via;
    request.options.device = options.device;
    request.options.validation = options.validation;
    request.options.include_dirs = options.include_dirs;
    result.tolerance = read.file->tolerance;

    RenderOutcome outcome = render(compiler, request, machine);
    result.diagnostics = std::move(outcome.diagnostics);
    // Diagnostics without a place are about the path.
    for (Diagnostic& each : result.diagnostics) {
        if (!each.file.empty()) continue;
        Diagnostic placed = diagnostic_at(read.path_place, each.code, each.message);
        placed.severity = each.severity;
        placed.notes = std::move(each.notes);
        each = std::move(placed);
    }
    result.missing_machine = outcome.missing_machine;
    if (!outcome.ok) {
        result.message = outcome.error;
        return result;
    }
    encode_srgb(outcome.image);
    judge(result, quantized(outcome.image), options);
    return result;
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
    return error.empty() && std::all_of(cases.begin(), cases.end(), [](const SnapshotCase& each) {
               return each.state == SnapshotState::Passed || each.state == SnapshotState::Updated;
           });
}

SnapshotReport run_snapshots(const Compiler& compiler, const std::string& dir, const SnapshotOptions& options,
                             RenderMachine& machine) {
    SnapshotReport report;
    Outcome<std::vector<fs::path>> cases = find_cases(dir);
    if (!cases) {
        report.error = cases.error;
        return report;
    }
    for (const fs::path& stem : cases.value) {
        std::string name = stem.lexically_relative(fs::path(dir).lexically_normal()).generic_string();
        bool wanted = options.only.empty() || options.only == name || options.only == stem.filename();
        if (wanted) report.cases.push_back(run_case(compiler, stem, name, options, machine));
    }
    if (report.cases.empty()) report.error = "there is no case '" + options.only + "' in '" + dir + "'";
    return report;
}

}  // namespace patina::runtime
