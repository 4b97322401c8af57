// Where a compilation finds files: sub-graphs, lighting graphs, node files and pass files, whose texts it reads, and
// textures, which it never reads. The default is the disk.
//
//   options.files.read = [&](const std::string& path) { return pack.find(path); };  // std::optional<std::string>
//
// Each function may be called from any thread that compiles, also from several at the same time. Within one compilation
// each file is asked for once. A function may throw: the exception becomes the error `cannot-read` at the place that
// names the file, with its what(), and the compilation goes on to find other errors.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "patina/export.h"

namespace patina {

struct FileSystem {
    // The path of the file that `name` means in the file `from`, or, if `from` ends with '/', below that folder of
    // CompileOptions::include_dirs. A path is any text that the program wants: a URI, an id. It is given to `exists`
    // and `read` as it is, and names the file in diagnostics, dependencies and the reflection. Default: paths and URIs
    // are joined as usual: "../rust.png" in "pack://stone/wet/a.graph.json" is "pack://stone/rust.png".
    std::function<std::string(const std::string& from, const std::string& name)> resolve{};
    // True if the file is there. Textures are asked for by this function alone. Default: the file system that `read`
    // reads; if that is the program's own, a file is there if `read` returns a text.
    std::function<bool(const std::string& path)> exists{};
    // The text of the file; nothing if there is no such file. Throws an exception if the file is there and cannot be
    // read; its what() says why. Default: the disk.
    std::function<std::optional<std::string>(const std::string& path)> read{};
};

// The disk, with all three functions set: for a file system that adds to it.
PATINA_API FileSystem disk();

}  // namespace patina
