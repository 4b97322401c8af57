// Files that a file of code includes, in the place where it includes them.
#pragma once

#include <span>
#include <string>

namespace patina::importers::shadergraph {

struct Included {
    std::string text{};
    int count = 0;  // of files
};
// Each file that lies beside the one that names it or in one of the folders is taken once. Others, such as the engine's
// own, stay as they are.
Included with_includes(const std::string& path, const std::string& text, std::span<const std::string> folders);

}  // namespace patina::importers::shadergraph
