// A material as a MaterialX document, for programs that read these. `patina import` reads the same material back from
// it.
//
//   patina::MtlxExport made = patina::export_mtlx(compiler, "rust.graph.json", {.folder = "out"});
//   if (made.ok) save("out/rust.mtlx", made.text);
#pragma once

#include "patina/patina.h"

namespace patina {

// Where the document will be, and what is read.
struct MtlxOptions {
    std::string folder{};                     // of the document: files of pictures are named from there; empty: "."
    std::vector<std::string> include_dirs{};  // as CompileOptions::include_dirs
    FileSystem files{};                       // as CompileOptions::files
};
// The document, and what it does not say as the graph does.
struct MtlxExport {
    bool ok = false;                        // there are no errors; else there is no text
    std::string text;                       // XML, version 1.39
    std::vector<Diagnostic> diagnostics;    // errors: "no-counterpart"; warnings: "export-differs"
    std::vector<std::string> dependencies;  // files that were read
    std::vector<std::string> missing;       // files that were looked for and are not there, sorted
};
// Writes the material of a graph as a document: its surface as a surface shader, what the surface reads as one node
// graph, and its properties as inputs of that.
PATINA_API MtlxExport export_mtlx(const Compiler& compiler, const std::string& path, const MtlxOptions& options = {});

}  // namespace patina
