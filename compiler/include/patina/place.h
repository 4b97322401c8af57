// The place of a statement in a graph or a scene, for diagnostics of what only a renderer can check.
//
//   diagnostics.push_back(patina::diagnostic_at(texture.place, "bad-texture", error));
#pragma once

#include <string>

namespace patina {

struct FilePlace {
    std::string file;
    int line = 0, column = 0;  // from 1; columns in bytes
    int end_line = 0, end_column = 0;
    std::string source_line;  // empty if it is very long
};

}  // namespace patina
