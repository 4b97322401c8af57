// A page of the reference as data, and its two forms: text for a terminal and Markdown for docs/. Both are printed from
// the same data, so they say the same; only docs/ has pictures.
//
//   const Page page = node_page(*compiler.node("Lerp"), "Lerp");
//   print(to_terminal(console, page));
#pragma once

#include <array>
#include <string>
#include <vector>

#include "compiler/cli/console.h"

namespace patina::cli {

struct Page;

// A port, a choice or a node: a name with a line or two about it.
struct Entry {
    std::string name{};
    std::string type{};
    std::string link{};   // in docs/: a page about the type
    std::string facts{};  // "0 to 1; default 0.5"
    std::string doc{};
    std::vector<std::pair<std::string, std::string>> choices{};  // of an enum: name, what it is
};

struct Picture {
    std::string path{};  // from the page's folder
    std::string caption{};
};

// Text, code, entries and pictures, in this order; each may be empty.
struct Section {
    std::string title{};  // "Inputs"; empty: the page's first words
    std::string text{};   // paragraphs of plain text with `code`
    std::string link{};   // in docs/: the address that the text links to
    std::string code{};   // printed unchanged
    std::string language{};
    std::array<std::string, 4> columns{};  // headings of the entries' name, type, facts and doc
    std::vector<Entry> entries{};
    bool has_code_facts = false;  // the facts are expressions
    std::vector<Picture> pictures{};
};

struct Page {
    std::string title{};  // "DistributionGGX"
    std::string place{};  // "Lighting/Distribution"
    std::vector<Section> sections{};
};

// The first line of every Markdown page that is written from data.
inline constexpr std::string_view kWritten = "<!-- written by 'patina docs' -->\n";

std::string to_terminal(const Console& console, const Page& page);
// `index`: the page that lists pages like this one; linked on top.
std::string to_markdown(const Page& page, const std::string& index);

// Plain text as Markdown that shows the same. Text between `backquotes` stays unchanged.
std::string escaped(std::string_view text);
// The first sentence of a text, on one line and without its full stop: for lists.
std::string first_sentence(std::string_view text);
// "a, b and c"
std::string enumerate(std::span<const std::string_view> words);

}  // namespace patina::cli
