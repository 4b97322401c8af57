// A page of the reference as data, and its text for a terminal. scripts/reference makes the pages of docs/ from the
// JSON of the same nodes and models.
//
//   const Page page = node_page(*compiler.node("Lerp"), "Lerp");
//   print(to_terminal(console, page));
#pragma once

#include <string>
#include <vector>

#include "compiler/cli/console.h"

namespace patina::cli {

// A port, a choice or a node: a name with a line or two about it.
struct Entry {
    std::string name{};
    std::string type{};
    std::string facts{};  // "0 to 1; default 0.5"
    std::string doc{};
    std::vector<std::pair<std::string, std::string>> choices{};  // of an enum: name, what it is
};

// Text, code and entries, in this order; each may be empty.
struct Section {
    std::string title{};  // "Inputs"; empty: the page's first words
    std::string text{};   // paragraphs of plain text
    std::string code{};   // printed unchanged
    std::vector<Entry> entries{};
};

struct Page {
    std::string title{};  // "DistributionGGX"
    std::string place{};  // "Lighting/Distribution"
    std::vector<Section> sections{};
};

std::string to_terminal(const Console& console, const Page& page);

// The first sentence of a text, on one line and without its full stop: for lists.
std::string first_sentence(std::string_view text);

}  // namespace patina::cli
