#include "runtime/snapshot/find_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "patina/complaints.h"
#include "runtime/files/find_files.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kReferenceEnding = ".reference.png";

struct Files {
    std::vector<std::string> snapshots, shown, references;  // `shown`: graphs and scenes
};

Outcome<Files> list(const std::string& folder) {
    Outcome<std::vector<std::string>> paths = files_below(folder);
    if (!paths) return Failure{paths.error};
    Files files;
    for (std::string& path : paths.value) {
        if (path.ends_with(kSnapshotEnding))
            files.snapshots.push_back(std::move(path));
        else if (path.ends_with(".graph.json") || path.ends_with(".scene.json"))
            files.shown.push_back(std::move(path));
        else if (path.ends_with(kReferenceEnding))
            files.references.push_back(std::move(path));
    }
    return files;
}

std::string without(std::string path, std::string_view ending) {
    path.resize(path.size() - ending.size());
    return path;
}

// One name for a file, for all paths and links that lead to it.
std::string same_for_all(const std::string& path) {
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(path, error);
    return error ? path : canonical.string();
}

class Search {
public:
    explicit Search(const std::string& folder) : folder_(folder), root_(fs::path(folder).lexically_normal()) {}

    FoundCases run(const Files& files) {
        for (const std::string& file : files.snapshots) add_snapshot(file);
        for (const std::string& file : files.shown)
            if (!shown_.contains(same_for_all(file))) add_bare(file);
        std::ranges::stable_sort(found_.cases, {}, &PlannedCase::name);
        for (const std::string& reference : files.references)
            if (is_orphan(without(reference, kReferenceEnding))) found_.orphans.push_back(reference);
        return std::move(found_);
    }

private:
    // Which pictures a broken file has is not known, so each that may be of it is left alone.
    bool is_orphan(const std::string& stem) const {
        if (stems_.contains(stem)) return false;
        return std::ranges::none_of(broken_, [&](const std::string& each) { return stem.starts_with(each + "."); });
    }

    void add_snapshot(const std::string& file) {
        ReadSnapshot read = read_snapshot(file);
        const std::string stem = without(file, kSnapshotEnding);
        if (!read.file) {
            // Its graph is not a case of its own, because the settings in the file are not known.
            for (const char* ending : {".graph.json", ".scene.json"}) shown_.insert(same_for_all(stem + ending));
            broken_.push_back(stem);
            add({.file = file, .stem = stem, .problem = std::move(read.error)}, "");
            return;
        }
        shown_.insert(same_for_all(read.file->request.graph));
        for (Variation& each : variations(*read.file)) {
            add({.file = file,
                 .stem = stem,
                 .request = std::move(each.request),
                 .tolerance = read.file->tolerance,
                 .text = read.file->text,
                 .places = read.places},
                each.name);
        }
    }

    void add_bare(const std::string& file) {
        PlannedCase made{.file = file,
                         .stem = without(file, file.ends_with(".scene.json") ? ".scene.json" : ".graph.json")};
        made.request = default_request();
        made.request.graph = file;
        add(std::move(made), "");
    }

    void add(PlannedCase made, const std::string& variation) {
        made.base = fs::path(made.stem).lexically_relative(root_).generic_string();
        made.name = made.base;
        made.folder = folder_;
        if (!variation.empty()) {
            made.name += "." + variation;
            made.stem += "." + variation;
        }
        const auto [there, is_new] = stems_.try_emplace(made.stem, made.file);
        if (!is_new) {
            made.problem = complaint(
                Complaint::Snapshot,
                {fmt::format("'{}' and '{}' would have the same reference '{}': give one of them a snapshot file of "
                             "another name, with the key \"graph\"",
                             there->second, made.file, made.picture())});
            made.problem->file = made.file;
        }
        found_.cases.push_back(std::move(made));
    }

    std::string folder_;
    fs::path root_;
    FoundCases found_{};
    std::vector<std::string> broken_{};           // stems of snapshot files that cannot be read
    std::set<std::string> shown_{};               // graphs and scenes of snapshot files
    std::map<std::string, std::string> stems_{};  // -> the file that has it
};

}  // namespace

FoundCases find_cases(const std::string& folder) {
    const Outcome<Files> files = list(folder);
    if (!files) return {.error = files.error};
    FoundCases found = Search(folder).run(files.value);
    if (found.cases.empty()) found.error = "there is no graph, no scene and no *.snapshot.json in '" + folder + "'";
    return found;
}

}  // namespace patina::runtime
