// The files of a folder and of the folders below it.
//
//   Outcome<std::vector<std::string>> files = files_below("art");   // "art/metal/rust.graph.json", ...
//   for (const UnreadFolder& folder : look_below("art").unread) ...   // the files of the others are there
#pragma once

#include <string>
#include <vector>

#include "runtime/outcome.h"

namespace patina::runtime {

struct UnreadFolder {
    std::string path{};
    std::string why{};  // "Permission denied"
};

struct FolderContents {
    std::vector<std::string> files{};
    std::vector<std::string> folders{};  // the folder itself, and those that were looked into
    std::vector<UnreadFolder> unread{};  // those of them that cannot be read, or not to the end
};

// Normal paths that begin with the folder's, sorted. Not hidden files, nor those of hidden folders or of folders behind
// symbolic links; no FIFOs and devices. A folder that is removed meanwhile has none.
FolderContents look_below(const std::string& folder);
// The files alone. A failure says which folder cannot be read.
Outcome<std::vector<std::string>> files_below(const std::string& folder);

}  // namespace patina::runtime
