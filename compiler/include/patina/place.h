// The place of a statement in a graph or a scene, for diagnostics of what only a renderer can check.
//
//   diagnostics.push_back(patina::diagnostic_at(texture.place, "bad-texture", error));
#pragma once

#include <string>

namespace patina {

// A range of text in a file.
struct FilePlace {
    std::string file;                  // its path; empty: no place
    int line = 0, column = 0;          // from 1; columns in bytes
    int end_line = 0, end_column = 0;  // behind the last byte
    std::string source_line;           // empty if it is very long
};

}  // namespace patina
