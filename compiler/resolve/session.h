// The room `resolve` finds what a material is made of (files, nodes, models, properties) and checks it. It reports
// unknown names and circles. It checks no types, makes no IR, and does not know how a pass is drawn.
//
// A Session is the state of one compilation: its sources, diagnostics, the files that it read, and the graphs and node
// files that it loaded. Files are searched in the folder of the file that names them, then in the include folders.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>

#include "compiler/resolve/library.h"
#include "patina/patina.h"

namespace patina::graph {

struct CheckedGraph;

struct NodeFile {
    nodelang::Ast ast;
    nodelang::Declarations declarations;
    const nodelang::FunctionDecl* node = nullptr;  // the function marked [node]
};

// Selects all paths of the library at once.
inline constexpr std::string_view kAllPaths = "all";

// A user's .pass.hlsl, in addition to the library.
struct PassFile {
    nodelang::Ast ast;
    nodelang::Declarations declarations;
    PathDeclarations paths;  // those of the library, and the file's
};

struct Session {
    Session(const Library& library, const CompileOptions& options);

    const Library& library;
    const CompileOptions& options;
    const engines::Engine& engine;  // the engine of all requested targets
    // The library's, unless the requested path is a file.
    const nodelang::Declarations* declarations;
    const PathDeclarations* paths;
    std::string path;  // the name of the requested path
    std::unique_ptr<PassFile> pass_file;
    SourceMap sources;
    Diagnostics diagnostics;
    nodelang::Ast ast;
    std::vector<std::string> dependencies;
    std::map<std::string, std::optional<std::string>> loaded;  // by path: of the loader, or given to compile_text()
    std::deque<CheckedGraph> checked;
    std::map<std::string, const CheckedGraph*> graphs;  // by path
    std::map<std::string, std::unique_ptr<NodeFile>> node_files;
    std::deque<Property> file_properties;  // textures that are files named at a port
    std::vector<std::string> active;       // paths of the sub-graphs that are being loaded, to find recursion
};

// The path of the file that `name` in the file `from` means, or empty. Only sources get their text loaded.
std::string find_file(Session& session, const std::string& name, const std::string& from);
// Reports that find_file() found nothing: the file does not exist, or it is a folder.
void report_not_found(Session& session, const std::string& name, const std::string& from, Span where);
// Loads a file's text into the source map and adds the file to the dependencies. Reports CannotRead at `where`.
std::optional<std::uint32_t> load_source(Session& session, const std::string& path, Span where);
// Finds the requested path in the library, or reads the file that holds it. Reports errors.
void find_path(Session& session);
// "dir/x.graph.json" -> "x"
std::string file_stem(std::string_view path);

}  // namespace patina::graph
