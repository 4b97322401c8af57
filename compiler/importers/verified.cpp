// The last look at an import: what would be written is read by the compiler, graphs and scenes.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/disk/disk.h"
#include "compiler/importers/imported_graph.h"

namespace patina::importers {
namespace {

constexpr std::string_view kScene = ".scene.json", kSubgraph = ".subgraph.json", kGraph = ".graph.json";

// The files that would be written, and graphs that the folder has already. All other files count as there: pictures
// and models are read by those who draw.
FileSystem files_of(const Imported& made, const std::string& folder) {
    const auto written = [&made, folder](const std::string& path) -> const TextFile* {
        for (const TextFile& each : made.graphs)
            if (path == folder + each.name || path == each.name) return &each;
        return nullptr;
    };
    FileSystem files;
    files.exists = [written](const std::string& path) {
        return !path.ends_with(kGraph) || written(path) || is_on_disk(path);
    };
    files.read = [written](const std::string& path) -> std::optional<std::string> {
        if (const TextFile* const file = written(path)) return file->text;
        return read_disk(path, kMostTextBytes).bytes;
    };
    return files;
}

}  // namespace

Imported read_verified(const Importer& importer, const Source& source, const Options& options) {
    Imported made = importer.read(source, options);
    if (!made.error.empty()) return made;
    const std::string folder = options.folder.empty() ? std::string() : options.folder + "/";
    CompileOptions checking{.targets = {}};
    checking.accept_parts = true;
    checking.files = files_of(made, folder);
    for (const TextFile& each : made.graphs) {
        const std::string path = folder + each.name;
        std::vector<Diagnostic> found;
        if (each.name.ends_with(kScene))
            found = library().read_scene(path, checking).diagnostics;
        else if (each.name.ends_with(kGraph) || each.name.ends_with(kSubgraph))
            found = library().compile_text(path, each.text, checking).diagnostics;
        const auto wrong = std::ranges::find(found, Severity::Error, &Diagnostic::severity);
        if (wrong == found.end()) continue;
        return {.error = fmt::format("{}: '{}' would not be valid: {}", source.path, each.name, wrong->message)};
    }
    return made;
}

}  // namespace patina::importers
