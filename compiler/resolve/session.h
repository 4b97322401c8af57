// The room `resolve` finds what a material is made of (files, nodes, models, properties) and checks it. It reports
// unknown names and circles. It checks no types, makes no IR, and does not know how a pass is drawn.
//
// A Session is the state of one compilation: its sources, its diagnostics, the files that it read, and the graphs and
// node files that it loaded. Files are searched in the folder of the file that names them, then in the include folders.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>

#include "compiler/base/cancellation.h"
#include "compiler/resolve/files.h"
#include "compiler/resolve/library.h"
#include "patina/patina.h"

namespace patina::resolve {

struct CheckedGraph;

struct NodeFile {
    nodelang::Ast ast;
    nodelang::Declarations declarations;
    const nodelang::FunctionDecl* node = nullptr;  // the function marked [node]
};

// Selects all paths of the library at once.
inline constexpr std::string_view kAllPaths = "all";

// A user's .pass.hlsl, or an engine's, in addition to the library.
struct PassFile {
    nodelang::Ast ast;
    nodelang::Declarations declarations;
    paths::PathDeclarations paths;  // those of the library, and the file's
};

// CompileOptions::request, for those who need a part of it. What a list names twice is in it once.
struct Request {
    explicit Request(const CompileOptions& options);

    std::string path;                      // empty for functions
    std::vector<std::string> passes;       // empty: those of the path
    std::vector<std::string> folders;      // CompileOptions::include_dirs, with a "/" at the end
    std::optional<std::string> functions;  // their prefix
    std::optional<std::string> preview;    // the port
};

struct Session {
    // `files`: what compilations for other engines or of other variants have asked for already.
    Session(const Library& library, const CompileOptions& options, Files* files = nullptr);

    const Library& library;
    const CompileOptions& options;
    Cancellation cancellation;  // of this thread, while the session lives
    const Request request;
    const engines::Engine& engine;  // the engine of all requested targets
    // The library's, unless the requested path is a file.
    const nodelang::Declarations* declarations;
    const paths::PathDeclarations* paths;
    std::string path;  // the name of the requested path
    std::shared_ptr<const PassFile> pass_file;
    SourceMap sources;
    Diagnostics diagnostics;
    nodelang::Ast ast;
    std::vector<std::string> dependencies;
    bool stopped = false;  // an error has been reported, and no further work is wanted
    Growth growth{.most = options.limits.instructions};
    std::optional<Files> own_files;
    Files& files;
    std::deque<CheckedGraph> checked;
    std::map<std::string, const CheckedGraph*> graphs;  // by path
    std::map<std::string, std::unique_ptr<NodeFile>> node_files;
    std::deque<format::Property> file_properties;  // textures that are files named at a port
    std::vector<std::string> active;               // paths of the sub-graphs that are being loaded, to find recursion
    std::set<std::string> missing;                 // files that were searched for and do not exist
};

// The path of the file that `name` in the file `from` means. Empty if there is none. Reports at `where` if the caller's
// file system fails.
std::string find_file(Session& session, const std::string& name, const std::string& from, Span where);
// The same for a file that must be there: reports if there is none. A source is read at once, and not asked for before.
std::string require_file(Session& session, const std::string& name, const std::string& from, Span where);
std::string require_source(Session& session, const std::string& name, const std::string& from, Span where);
// The same for a graph that is compiled later, by its path alone.
std::string require_graph(Session& session, const std::string& name, const std::string& from, Span where);
// Loads a file's text into the source map and adds the file to the dependencies. Reports at `where` if it cannot be
// read. A file of the disk that a text names (`where` is set) can be any file of the machine. If it is not a file of
// Patina, it is refused completely, so that no message quotes it.
std::optional<std::uint32_t> load_source(Session& session, const std::string& path, Span where);
// Reports at `where` that the texts are more than the program allows. True if they are.
bool is_over_bytes(Session& session, Span where);
// True if the compilation is to end: a budget is exceeded, or the program says so when it is asked here, which is
// reported.
bool must_stop(Session& session);
// Calls a function of the program's. False: it has thrown, which ends the compilation as `cancelled` does, and is
// reported.
bool call_program(Session& session, const std::function<void()>& function);
// Reports what ended the work, unless that is done.
void report_stop(Session& session, const Stopped& stopped);
// Does the work, which may end early.
template <class Work>
void until_stopped(Session& session, const Work& work) {
    try {
        work();
    } catch (const Stopped& stopped) {
        report_stop(session, stopped);
    }
}
// Finds the requested path in the library, or reads the file that holds it. Reports errors.
void find_path(Session& session);
// "dir/x.graph.json" -> "x"
std::string file_stem(std::string_view path);

}  // namespace patina::resolve
