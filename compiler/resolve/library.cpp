#include "compiler/resolve/library.h"

#include <algorithm>

#include "compiler/base/cancellation.h"
#include "compiler/engines/read_engine.h"
#include "compiler/format/read_graph.h"
#include "compiler/json/json.h"
#include "compiler/nodelang/parse.h"

namespace patina::resolve {
namespace {

std::string_view stem_of(std::string_view path) {
    const std::size_t slash = path.rfind('/') + 1;
    return path.substr(slash, path.find('.', slash) - slash);
}

bool is_workflow(std::string_view path) {
    return path.ends_with(".workflow.json");
}

// Models are named by the stem of their file, as users name them: "unity-brdf1".
void add_graph(Library& library, std::uint32_t base, std::string_view path) {
    auto& graphs = is_workflow(path) ? library.workflows : library.lighting_models;
    const std::string name(stem_of(path));
    if (!graphs.try_emplace(name, library.sources, base, std::string(path)).second)
        library.diagnostics.report(Code::DuplicateId, {base, base}, is_workflow(path) ? "workflow" : "lighting model",
                                   name);
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
    const std::unique_ptr<json::Json> json = json::parse_json(library.sources, base, library.diagnostics);
    if (const json::Json* word = json ? json->find("default") : nullptr) library.default_engine = word->string;
}

// False if the file must be read at once.
bool leave_unread(Library& library, std::uint32_t base) {
    const std::size_t first = library.unread.size();
    if (!nodelang::split({.text = library.sources.file_text(base), .base = base}, library.unread)) return false;
    auto& names = library.declarations.unread;
    for (std::size_t i = first; i < library.unread.size(); ++i) {
        if (names.try_emplace(library.unread[i].name(), &library.unread[i]).second) continue;
        // Declared twice: the file is read, which is reported.
        for (std::size_t k = first; k < i; ++k) names.erase(library.unread[k].name());
        while (library.unread.size() > first) library.unread.pop_back();
        return false;
    }
    return true;
}

// --- the overlay

constexpr std::string_view kEndings[] = {".node.hlsl", ".pass.hlsl", ".lighting.json", ".workflow.json"};

// The library has no second file of a name, and no second path, which a pass file names.
bool is_name_free(Library& library, const std::string& name, std::uint32_t base) {
    const bool is_path = name.ends_with(".pass.hlsl");
    for (const std::uint32_t known : library.files) {
        const std::string_view path = library.sources.file(known);
        const bool is_same = path == name;
        if (!is_same && !(is_path && path.ends_with(".pass.hlsl") && stem_of(path) == stem_of(name))) continue;
        library.diagnostics
            .report(Code::DuplicateId, {base, base}, is_same ? "file of the library" : "rendering path",
                    is_same ? std::string_view(name) : stem_of(name))
            .note({known, known}, "the first is here");
        return false;
    }
    return true;
}

void add_overlay_file(Library& library, const LibraryFile& file,
                      std::vector<std::pair<std::uint32_t, std::string_view>>& graphs) {
    const std::uint32_t base = library.sources.add(file.name, file.text);
    library.overlay_begin = std::min(library.overlay_begin, base);
    const bool is_known = std::any_of(std::begin(kEndings), std::end(kEndings),
                                      [&](std::string_view ending) { return file.name.ends_with(ending); });
    if (!is_known) {
        library.diagnostics.report(Code::UnknownWord, {base, base}, file.name, "a file of a library")
            .note("end its name with .node.hlsl, .pass.hlsl, .lighting.json or .workflow.json");
        return;
    }
    if (!is_name_free(library, file.name, base)) return;
    library.files.push_back(base);
    if (file.name.ends_with(".json"))
        graphs.emplace_back(base, file.name);
    else
        nodelang::parse_file({.text = library.sources.file_text(base), .base = base}, library.ast, library.diagnostics);
}

}  // namespace

const std::shared_ptr<format::Graph>& LibraryGraph::get() const {
    return read().graph;
}

const LibraryGraph::Read& LibraryGraph::read() const {
    return read_.get([this] {
        const Cancellation nobody;
        auto made = std::make_unique<Read>();
        const std::unique_ptr<json::Json> json = json::parse_json(sources_, base_, made->diagnostics);
        const format::GraphKind kind = is_workflow(path_) ? format::GraphKind::Workflow : format::GraphKind::Lighting;
        if (json) made->graph = format::read_graph(*json, path_, sources_, made->ast, made->diagnostics, kind);
        return made;
    });
}

const engines::Engine& LibraryEngine::get() const {
    return read().engine;
}

const LibraryEngine::Read& LibraryEngine::read() const {
    return read_.get([this] {
        const Cancellation nobody;
        auto made = std::make_unique<Read>();
        const auto find = [&](std::string_view name) -> std::optional<std::uint32_t> {
            const auto found = files_.find(name);
            return found == files_.end() ? std::nullopt : std::optional(found->second);
        };
        if (const std::optional<std::uint32_t> base = find("engine.json"))
            made->engine = engines::read_engine(sources_, *base, name_, find, printable_, made->diagnostics);
        return made;
    });
}

std::shared_ptr<const PassFile> LibraryEngine::passes(const std::string& path) const {
    const std::lock_guard lock(mutex_);
    const auto found = passes_.find(path);
    return found == passes_.end() ? nullptr : found->second;
}

void LibraryEngine::keep_passes(const std::string& path, std::shared_ptr<const PassFile> file) const {
    const auto& paths = get().paths;  // only of these, so that a program cannot ask for any number of them
    if (std::find(paths.begin(), paths.end(), path) == paths.end()) return;
    const std::lock_guard lock(mutex_);
    passes_.try_emplace(path, std::move(file));
}

const engines::Engine* Library::engine(std::string_view name) const {
    const auto found = engines.find(name.empty() ? std::string_view(default_engine) : name);
    return found == engines.end() ? nullptr : &found->second.get();
}

std::unique_ptr<Library> load_library(std::span<const nodelang::EmbeddedFile> files, engines::Printable printable,
                                      const LibraryOverlay& overlay, Declared declared) {
    const bool is_whole = declared == Declared::Whole || !overlay.files.empty();
    auto library = std::make_unique<Library>();
    library->printable = std::move(printable);
    std::vector<std::pair<std::uint32_t, std::string_view>> graphs;
    for (const nodelang::EmbeddedFile& file : files) {
        const std::uint32_t base = library->sources.add_view(std::string(file.path), file.text);
        library->files.push_back(base);
        if (file.path.starts_with(kEngines)) {
            add_engine_file(*library, base, file.path);
        } else if (file.path.ends_with(".json")) {
            graphs.emplace_back(base, file.path);
        } else if (is_whole || !leave_unread(*library, base)) {
            nodelang::parse_file({.text = library->sources.file_text(base), .base = base}, library->ast,
                                 library->diagnostics, nodelang::Bodies::WhenAsked);
        }
    }
    library->overlay_functions = library->ast.functions.size();
    for (const LibraryFile& file : overlay.files) add_overlay_file(*library, file, graphs);
    nodelang::index_declarations(library->ast, library->declarations, library->diagnostics);
    collect(library->ast, library->declarations, library->sources, library->paths, library->diagnostics);
    for (const auto& [base, path] : graphs) add_graph(*library, base, path);
    return library;
}

std::vector<const nodelang::FunctionDecl*> all_functions(const Library& library) {
    std::vector<const nodelang::FunctionDecl*> all;
    for (const nodelang::FunctionDecl& function : library.ast.functions) all.push_back(&function);
    for (const nodelang::Unread& unread : library.unread) {
        for (const nodelang::FunctionDecl& function : unread.ast().functions) all.push_back(&function);
    }
    std::sort(all.begin(), all.end(), [](const auto* a, const auto* b) { return a->span.begin < b->span.begin; });
    return all;
}

std::unique_ptr<Library> read_whole(const Library& library) {
    std::vector<nodelang::EmbeddedFile> files;
    for (const std::uint32_t file : library.files)
        files.push_back({library.sources.file(file), library.sources.file_text(file)});
    return load_library(files, library.printable, {}, Declared::Whole);
}

}  // namespace patina::resolve
