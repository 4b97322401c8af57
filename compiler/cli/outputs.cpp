#include "compiler/cli/outputs.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

namespace patina::cli {
namespace {

namespace fs = std::filesystem;
using runtime::Destination;
using runtime::destination_of;

constexpr std::string_view kStandardOutput = "-";

// The snapshot, graph or scene that a file is the reference of, or nothing. Of several pictures of a snapshot, each has
// a word of its own: rust.deferred.reference.png.
std::string snapshot_of(const std::string& path) {
    std::error_code ignored;
    std::string name = fs::path(path).filename().string();
    const std::size_t reference = name.rfind(".reference.");
    if (reference == std::string::npos) return {};
    const fs::path folder = fs::path(path).parent_path();
    for (std::size_t end = reference; end != std::string::npos && end > 0; end = name.rfind('.', end - 1)) {
        for (const char* ending : {".snapshot.json", ".graph.json", ".scene.json"}) {
            const std::string shown = name.substr(0, end) + ending;
            if (fs::exists(folder / shown, ignored)) return shown;
        }
    }
    return {};
}

bool is_one_of(const std::string& path, std::span<const std::string> files) {
    return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
        std::error_code ignored;
        return fs::equivalent(path, file, ignored);
    });
}

}  // namespace

bool Outputs::write(const std::string& source, const OutputFiles& files, std::span<const std::string> inputs) {
    const std::optional<Diagnostic> obstacle = try_write(source, files, inputs);
    if (obstacle) report(console_, {&*obstacle, 1});
    return !obstacle;
}

std::optional<Diagnostic> Outputs::try_write(const std::string& source, const OutputFiles& files,
                                             std::span<const std::string> inputs) {
    if (files.files.size() == 1 && files.files.front().path == kStandardOutput) {
        print(files.files.front().bytes);  // run() reports it if that fails
        return std::nullopt;
    }
    for (const runtime::OutputFile& file : files.files) {
        if (std::optional<Diagnostic> obstacle = take(source, file.path, inputs)) return obstacle;
    }
    const std::string error = runtime::write_files(files.files);
    if (error.empty()) return std::nullopt;
    return complaint(Complaint::CannotWrite, {error});
}

bool Outputs::is_possible(const std::string& path) const {
    if (path == kStandardOutput) return true;
    if (const std::string error = runtime::obstacle_to(path); !error.empty()) {
        complain(console_, Complaint::CannotWrite, {error});
        return false;
    }
    const std::string snapshot = snapshot_of(destination_of(path).path);
    if (!snapshot.empty()) complain(console_, Complaint::ReferencePicture, {path, snapshot});
    return snapshot.empty();
}

std::optional<Diagnostic> Outputs::take(const std::string& source, const std::string& path,
                                        std::span<const std::string> inputs) {
    const Destination to = destination_of(path);
    // The other checks look at the file, which may be outside of the root.
    if (!to.error.empty()) return complaint(Complaint::CannotWrite, {"cannot write '" + path + "': " + to.error});
    if (to.kind != Destination::Kind::File) return std::nullopt;
    const auto [there, is_new] = written_.try_emplace(to.path, Written{source, path});
    if (!is_new && there->second.path == path)
        return complaint(Complaint::SameOutput, {there->second.source, source, path});
    if (!is_new) return complaint(Complaint::OneOutput, {path, source, there->second.path});
    if (const std::string snapshot = snapshot_of(to.path); !snapshot.empty())
        return complaint(Complaint::ReferencePicture, {path, snapshot});
    if (is_one_of(to.path, inputs)) return complaint(Complaint::OverwritesInput, {path, source});
    return std::nullopt;
}

void say(const Console& console, const OutputFiles& files) {
    for (const runtime::OutputFile& file : files.files) {
        if (!is_standard_output(file.path)) say(console, file.path);
    }
}

bool is_standard_output(const std::string& path) {
    if (path == kStandardOutput) return true;
    const Destination to = destination_of(path);
    return to.kind == Destination::Kind::Descriptor && to.descriptor == STDOUT_FILENO;
}

bool is_taken(const std::string& path) {
    const Destination to = destination_of(path);
    if (!to.error.empty()) return false;  // writing says it
    std::error_code ignored;
    return to.kind == Destination::Kind::Folder || (to.kind == Destination::Kind::File && fs::exists(to.path, ignored));
}

bool is_stream(const std::string& path) {
    const Destination::Kind kind = destination_of(path).kind;
    return kind == Destination::Kind::Stream || kind == Destination::Kind::Descriptor;
}

std::string is_folder_name(const std::string& word) {
    if (word != kStandardOutput) return {};
    return "'-' is standard output, which cannot hold several files: name a folder ('./-' for one of this name)";
}

}  // namespace patina::cli
