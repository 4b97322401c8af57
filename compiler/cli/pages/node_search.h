// Finds nodes of the library by a name, however it is spelled, or by words about what they do.
//
//   const NodeInfo* node = find_named(compiler.nodes(), "sample texture 2d");  // SampleTexture2D; "Mix" is Lerp
//   for (const NodeInfo* node : search_nodes(compiler.nodes(), "round corners")) ...
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "patina/complaints.h"
#include "patina/patina.h"

namespace patina::cli {

// Capitals, spaces and _ do not count; another program's name for a node does. Null if there is none.
const NodeInfo* find_named(std::span<const NodeInfo> nodes, std::string_view name);

// The nodes that have the words in their names, category or texts, the best first. A node's own name counts most; then
// its other names, its summary, and the rest of its text, in this order. A node that lacks a word is found, too, if the
// others say enough about it.
std::vector<const NodeInfo*> search_nodes(std::span<const NodeInfo> nodes, std::string_view words);

// At most three hints whose names consist of the words; or of them and as many others, if `by_half`.
std::vector<Hint> search_hints(std::string_view words, bool by_half);

}  // namespace patina::cli
