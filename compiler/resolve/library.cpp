#include "compiler/resolve/library.h"

#include <algorithm>

#include "compiler/engines/read_engine.h"
#include "compiler/format/read_graph.h"
#include "compiler/json/json.h"
#include "compiler/nodelang/parse.h"

namespace patina::graph {
namespace {

// Models are named by the stem of their file, as users name them: "unity-brdf1".
void add_graph(Library& library, std::uint32_t base, std::string_view path) {
    const std::size_t slash = path.rfind('/') + 1;
    auto& graphs = path.ends_with(".workflow.json") ? library.workflows : library.lighting_models;
    graphs.try_emplace(std::string(path.substr(slash, path.find('.', slash) - slash)), library.sources, base,
                       std::string(path));
}

constexpr std::string_view kEngines = "nodes/engines/";

// "nodes/engines/vulkan/engine.json" is a file of an engine. A file directly in nodes/engines names the default engine.
void add_engine_file(Library& library, std::uint32_t base, std::string_view path) {
    const std::string_view name = path.substr(kEngines.size());
    if (const std::size_t slash = name.find('/'); slash != name.npos) {
        const std::string folder(name.substr(0, slash));
        const auto [engine, is_new] = library.engines.try_emplace(folder, library.sources, folder, library.printable);
        engine->second.add_file(name.substr(slash + 1), base);
        return;
    }
    const std::unique_ptr<Json> json = parse_json(library.sources, base, library.diagnostics);
    if (const Json* word = json ? json->find("default") : nullptr) library.default_engine = word->string;
}

}  // namespace

const std::shared_ptr<Graph>& LibraryGraph::get() const {
    std::call_once(once_, [this] {
        const std::unique_ptr<Json> json = parse_json(sources_, base_, diagnostics_);
        if (json) graph_ = read_graph(*json, path_, sources_, ast_, diagnostics_, {});
    });
    return graph_;
}

const engines::Engine& LibraryEngine::get() const {
    std::call_once(once_, [this] {
        const auto find = [&](std::string_view name) -> std::optional<std::uint32_t> {
            const auto found = files_.find(name);
            return found == files_.end() ? std::nullopt : std::optional(found->second);
        };
        if (const std::optional<std::uint32_t> base = find("engine.json"))
            engine_ = engines::read_engine(sources_, *base, name_, find, printable_, diagnostics_);
    });
    return engine_;
}

const engines::Engine* Library::engine(std::string_view name) const {
    const auto found = engines.find(name.empty() ? std::string_view(default_engine) : name);
    return found == engines.end() ? nullptr : &found->second.get();
}

std::unique_ptr<Library> load_library(std::span<const nodelang::EmbeddedFile> files, engines::Printable printable) {
    auto library = std::make_unique<Library>();
    library->printable = std::move(printable);
    std::vector<std::pair<std::uint32_t, std::string_view>> graphs;
    for (const nodelang::EmbeddedFile& file : files) {
        const std::uint32_t base = library->sources.add(std::string(file.path), std::string(file.text));
        if (file.path.starts_with(kEngines)) {
            add_engine_file(*library, base, file.path);
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
