#include "compiler/resolve/library.h"

#include <algorithm>

#include "compiler/format/read_graph.h"
#include "compiler/json/json.h"
#include "compiler/nodelang/parse.h"

namespace patina::graph {
namespace {

// Models go by their file's stem, as users name them: "unity-brdf1".
void add_graph(Library& library, std::uint32_t base, std::string_view path) {
    const std::size_t slash = path.rfind('/') + 1;
    auto& graphs = path.ends_with(".workflow.json") ? library.workflows : library.lighting_models;
    graphs.try_emplace(std::string(path.substr(slash, path.find('.', slash) - slash)), library.sources, base,
                       std::string(path));
}

constexpr std::string_view kTools = "nodes/targets/";

void add_tool_file(Library& library, std::uint32_t base, std::string_view path) {
    const std::string_view name = path.substr(kTools.size());
    ToolFiles& tool = library.tools[std::string(name.substr(0, name.find('.')))];
    if (name.ends_with(".pass.hlsl")) {
        tool.passes = base;
    } else {
        tool.include = library.sources.file_text(base);
    }
}

}  // namespace

const std::shared_ptr<Graph>& LibraryGraph::get() const {
    std::call_once(once_, [this] {
        const std::unique_ptr<Json> json = parse_json(sources_, base_, diagnostics_);
        if (json) graph_ = read_graph(*json, path_, sources_, ast_, diagnostics_, {});
    });
    return graph_;
}

std::unique_ptr<Library> load_library(std::span<const nodelang::EmbeddedFile> files) {
    auto library = std::make_unique<Library>();
    std::vector<std::pair<std::uint32_t, std::string_view>> graphs;
    for (const nodelang::EmbeddedFile& file : files) {
        const std::uint32_t base = library->sources.add(std::string(file.path), std::string(file.text));
        if (file.path.starts_with(kTools)) {
            add_tool_file(*library, base, file.path);
        } else if (file.path.ends_with(".json")) {
            graphs.emplace_back(base, file.path);
        } else {
            nodelang::parse_file({.text = library->sources.file_text(base), .base = base}, library->ast,
                                 library->diagnostics, nodelang::Bodies::WhenAsked);
        }
    }
    nodelang::index_declarations(library->ast, library->declarations, library->diagnostics);
    collect(library->ast, library->declarations, library->sources, library->paths, library->diagnostics);
    for (const auto& [base, path] : graphs) add_graph(*library, base, path);
    return library;
}

}  // namespace patina::graph
