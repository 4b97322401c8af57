// Errors and warnings, with their locations. They are values: no function of the library throws because of its input.
// If a result has diagnostics, lack of memory is one of these diagnostics, too (the code `out-of-memory`).
//
//   for (const patina::Diagnostic& d : result.diagnostics) std::puts(patina::to_text(d).c_str());
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "patina/export.h"

namespace patina {

// The location of a value in a graph or a scene, for diagnostics that only a renderer can find.
struct FileLocation {
    std::string file;                  // its path; empty: there is no location
    int line = 0, column = 0;          // from 1; columns in bytes
    int end_line = 0, end_column = 0;  // behind the last byte
    std::string source_line;           // the text of `line`; empty if it has more than 64 KiB
};

// How bad it is. A note is only in Diagnostic::notes.
enum class Severity { Error, Warning, Note };

// An error or a warning, or a note that belongs to one.
struct Diagnostic {
    Severity severity = Severity::Error;  // a result with an error is not ok
    std::string code;                     // "unknown-node"; stable, for programs
    std::string message;                  // lower case, without a full stop; names are in quotation marks
    std::string file;                     // its path; empty: no location
    int line = 0;                         // from 1; 0: the file as a whole
    int column = 0;                       // from 1, in bytes
    int end_line = 0;                     // from 1
    int end_column = 0;                   // from 1, in bytes: behind the last byte
    std::string source_line;              // the text of `line`; empty if it has more than 64 KiB
    // The value in the graph, if known: a node's id and its port; or "surface", "vertex", "outputs", "properties" or
    // "inputs" and the name there.
    std::string node, port;
    std::vector<Diagnostic> notes;  // what to do, and other locations
};
// "file:3:14: error: there is no node 'Lrep' [unknown-node]", the line, a caret, and the notes. Colours are ANSI.
PATINA_API std::string to_text(const Diagnostic& diagnostic, bool colors = false);
// One JSON object on one line.
PATINA_API std::string to_json(const Diagnostic& diagnostic);
// A diagnostic at a location in a graph or a scene.
PATINA_API Diagnostic diagnostic_at(const FileLocation& place, std::string code, std::string message);
// "did you mean 'Lerp'?", or a list of the known words if it is short, or nothing. For words that a program reads
// itself.
PATINA_API std::string suggestion(std::string_view word, const std::vector<std::string>& known);
// "did you mean 'models/suzi.glb'?" if a file of nearly this name is in its folder; else nothing.
PATINA_API std::string file_suggestion(const std::string& path);

}  // namespace patina
