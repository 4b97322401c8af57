// Names of files as graphs write them, and paths: a path is one of the disk, or a URI ("pack://stone/rust.png").
//
//   is_file_name("./rust.png"), is_file_name("pack://rust.png")    // true; "Lerp" and "mask.r" are no files
//   join_names("pack://stone/wet/a.graph.json", "../rust.png")     // "pack://stone/rust.png"
#pragma once

#include <string>
#include <string_view>

namespace patina {

// "pack://stone/rust.png" -> "pack://"; empty for a path of the disk.
std::string_view scheme_of(std::string_view path);

// True for what graphs take as the name of a file: "./x", "../x", "/x" and URIs.
bool is_file_name(std::string_view text);

// The path that `name` means in the file `from`, or in the folder `from`, which ends with '/'. An absolute name stays
// as it is. Of a URI, everything after the scheme is a path, and ".." does not leave it.
std::string join_names(const std::string& from, const std::string& name);

// A name for files whose characters every system takes: `<>:"/\|?*`, control characters and bytes that are not UTF-8
// become '_'. If Windows reserves the name for a device ("con", "nul", "com1"), its first letter becomes '_'. An empty
// name becomes "graph". Another name has as many bytes as before: a long one is not shortened.
std::string portable_name(std::string name);

}  // namespace patina
