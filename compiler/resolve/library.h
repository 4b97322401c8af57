// Loads the built-in library and an embedder's overlay once; after that they are only read. It holds the declarations
// of nodes/**, the declarations of nodes/stage and nodes/passes (paths/declarations.h), the workflow and lighting
// graphs, and the engines. It knows none of them by name.
//
//   const auto library = load_library(nodelang::embedded_files(), writers::printable());
//   library.declarations.function("Lerp");
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <mutex>

#include "compiler/base/diagnostics.h"
#include "compiler/base/made_once.h"
#include "compiler/engines/engine.h"
#include "compiler/format/graph.h"
#include "compiler/nodelang/embedded.h"
#include "compiler/nodelang/library.h"
#include "compiler/paths/declarations.h"
#include "patina/patina.h"

namespace patina::resolve {

// A workflow or a lighting model of the library: read at the first request, from any thread.
class LibraryGraph {
public:
    LibraryGraph(const SourceMap& sources, std::uint32_t base, std::string path)
        : sources_(sources), base_(base), path_(std::move(path)) {}

    // Null if it cannot be read.
    const std::shared_ptr<format::Graph>& get() const;
    // The errors in the file.
    const Diagnostics& diagnostics() const { return read().diagnostics; }
    std::uint32_t base() const { return base_; }

private:
    struct Read {
        nodelang::Ast ast;
        Diagnostics diagnostics;
        std::shared_ptr<format::Graph> graph;
    };
    const Read& read() const;

    const SourceMap& sources_;
    std::uint32_t base_;
    std::string path_;
    MadeOnce<Read> read_;
};

struct PassFile;  // session.h

// An engine of the library: read at the first request, from any thread.
class LibraryEngine {
public:
    LibraryEngine(const SourceMap& sources, std::string name, const engines::Printable& printable)
        : sources_(sources), name_(std::move(name)), printable_(printable) {}

    void add_file(std::string_view name, std::uint32_t base) { files_.emplace(name, base); }
    const engines::Engine& get() const;
    // The errors in engine.json.
    const Diagnostics& diagnostics() const { return read().diagnostics; }
    // The engine's own passes for one of its paths, if a compilation has read the file without an error; else null.
    std::shared_ptr<const PassFile> passes(const std::string& path) const;
    void keep_passes(const std::string& path, std::shared_ptr<const PassFile> file) const;

private:
    struct Read {
        Diagnostics diagnostics;
        engines::Engine engine;
    };
    const Read& read() const;

    const SourceMap& sources_;
    std::string name_;
    const engines::Printable& printable_;
    std::map<std::string, std::uint32_t, std::less<>> files_;  // of its folder, in the sources
    MadeOnce<Read> read_;
    mutable std::mutex mutex_;
    mutable std::map<std::string, std::shared_ptr<const PassFile>> passes_;  // by path
};

struct Library {
    SourceMap sources;
    nodelang::Ast ast;                    // of what has been read at once
    std::deque<nodelang::Unread> unread;  // the other declarations
    Diagnostics diagnostics;
    nodelang::Declarations declarations;
    paths::PathDeclarations paths;
    engines::Printable printable;  // what an engine may choose from
    std::map<std::string, LibraryEngine, std::less<>> engines;
    std::string default_engine;
    std::map<std::string, LibraryGraph, std::less<>> workflows;
    std::map<std::string, LibraryGraph, std::less<>> lighting_models;
    std::vector<std::uint32_t> files;  // where each begins in the sources
    // The overlay comes last: its first file, and its first function in `ast`.
    std::uint32_t overlay_begin = std::numeric_limits<std::uint32_t>::max();
    std::size_t overlay_functions = 0;

    // Null if there is no engine of this name. An empty name means the default engine.
    const engines::Engine* engine(std::string_view name) const;
};

// Whether nodes and their helpers are parsed on demand, or all of them at once, to find their errors.
enum class Declared { WhenAsked, Whole };
// The texts of `files` must outlive the library. With an overlay, all is read at once.
std::unique_ptr<Library> load_library(std::span<const nodelang::EmbeddedFile> files, engines::Printable printable,
                                      const LibraryOverlay& overlay = {}, Declared declared = Declared::WhenAsked);
// In the order of the files.
std::vector<const nodelang::FunctionDecl*> all_functions(const Library& library);
// The library with all of its declarations read, from the same texts.
std::unique_ptr<Library> read_whole(const Library& library);

}  // namespace patina::resolve
