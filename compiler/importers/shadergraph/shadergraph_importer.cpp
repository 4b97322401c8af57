#include "compiler/importers/shadergraph/shadergraph_importer.h"

#include <algorithm>
#include <filesystem>

#include "compiler/base/letters.h"
#include "compiler/importers/shadergraph/project.h"

namespace patina::importers {
namespace {

bool recognises(const Source& source) {
    const std::string ending = small_letters(std::filesystem::path(source.path).extension().string());
    return ending == ".shadergraph" || ending == ".shadersubgraph";
}

Imported read(const Source& source, const Options& options) {
    const std::string name = options.name.empty() ? std::filesystem::path(source.path).stem().string() : options.name;
    const std::string folder =
        options.folder.empty() ? std::filesystem::path(source.path).parent_path().string() : options.folder;
    shadergraph::Project project(source.path, options.include_dirs, folder);
    Imported made;
    made.error = project.add_graph(source.path, name);
    if (!made.error.empty()) return made;
    made.graphs = std::move(project.files);
    made.remarks = std::move(project.remarks);
    made.has_refused = project.has_refused;
    return made;
}

}  // namespace

Importer shadergraph_importer() {
    return {.name = "shadergraph",
            .reads = "Unity's shader graphs (.shadergraph, .shadersubgraph)",
            .example = "patina import Rock.shadergraph -o rock --report",
            .makes_pictures = false,
            .keeps_report = true,
            .recognises = recognises,
            .read = read};
}

}  // namespace patina::importers
