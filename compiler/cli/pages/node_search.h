// Finds nodes of the library by a name, however it is spelled, or by words about what they do.
//
//   const NodeInfo* node = find_named(compiler.nodes(), "sample texture 2d");  // SampleTexture2D; "Mix" is Lerp
//   for (const NodeInfo* node : search_nodes(compiler.nodes(), "round corners")) ...
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "patina/patina.h"

namespace patina::cli {

// Capitals, spaces and _ do not count; another program's name for a node does. Null if there is none.
const NodeInfo* find_named(std::span<const NodeInfo> nodes, std::string_view name);

// The nodes that have each of the words, or one that begins with it, in their names, category or texts. The best comes
// first: a name counts more than a summary, and that more than the rest.
std::vector<const NodeInfo*> search_nodes(std::span<const NodeInfo> nodes, std::string_view words);

}  // namespace patina::cli
