// What one compilation gathers: its sources, complaints, files read, and the graphs and node files that it has loaded.
// Finds files: beside the file that names them, then in the include folders.
#pragma once

#include <deque>
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

// Stands for every path of the library at once.
inline constexpr std::string_view kAllPaths = "all";

// A user's .pass.hlsl, on top of the library.
struct PassFile {
    nodelang::Ast ast;
    nodelang::Declarations declarations;
    PathDeclarations paths;  // the library's, and what the file adds
};

struct Session {
    Session(const Library& library, const CompileOptions& options);

    const Library& library;
    const CompileOptions& options;
    const engines::Engine& engine;  // of all targets that are asked for
    // Of the library, unless the wanted path is a file.
    const nodelang::Declarations* declarations;
    const PathDeclarations* paths;
    std::string path;  // the name of the wanted path
    std::unique_ptr<PassFile> pass_file;
    SourceMap sources;
    Diagnostics diagnostics;
    nodelang::Ast ast;
    std::vector<std::string> dependencies;
    std::deque<CheckedGraph> checked;
    std::map<std::string, const CheckedGraph*> graphs;  // by path
    std::map<std::string, std::unique_ptr<NodeFile>> node_files;
    std::deque<Property> file_properties;  // textures that are files named at a port
    std::vector<std::string> active;       // paths of the sub-graphs being loaded, for recursion
};

// The path of the file that `name` means when the file `from` says it, or empty. Text is loaded only for sources.
std::string find_file(Session& session, const std::string& name, const std::string& from);
// Reports that find_file() found nothing: there is no such file, or a folder where it should be.
void report_not_found(Session& session, const std::string& name, const std::string& from, Span where);
// Loads a file's text into the source map and notes the dependency. Reports CannotRead at `where`.
std::optional<std::uint32_t> load_source(Session& session, const std::string& path, Span where);
// Makes the wanted path known: one of the library, or of a file, which is read. Reports what is wrong with it.
void find_path(Session& session);
// "dir/x.graph.json" -> "x"
std::string file_stem(std::string_view path);

}  // namespace patina::graph
