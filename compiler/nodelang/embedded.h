// Declares the node library's files, which are built into the program (scripts/embed_nodes.cmake writes the table from
// nodes/**).
#pragma once

#include <span>
#include <string_view>

namespace patina::nodelang {

struct EmbeddedFile {
    std::string_view path;  // "nodes/math/basic.node.hlsl"
    std::string_view text;
};
std::span<const EmbeddedFile> embedded_files();

}  // namespace patina::nodelang
