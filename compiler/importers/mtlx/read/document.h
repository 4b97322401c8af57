// A MaterialX document as a tree of elements that know their places, with the documents that it includes. Nothing is
// known here of nodes, but where files are and what colours mean, which elements inherit from those around them.
//
//   Document document;
//   if (std::string error = read_document("wood.mtlx", {}, document); !error.empty()) return error;
//   for (const Element& each : document.root.children) each.category;   // "nodegraph", "standard_surface"
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace patina::importers::mtlx {

struct Element {
    std::string category{};  // the name of the tag
    std::vector<std::pair<std::string, std::string>> attributes{};
    std::deque<Element> children{};  // they are referred to by their addresses
    int line = 0, column = 0;        // of the main document; 0: of an included one
    // Its own, or those of the nearest element around it that has some.
    std::string colorspace{}, fileprefix{}, folder{};
    bool is_in_names = false;  // a token that names of files have

    // Empty, if there is none.
    std::string_view attribute(std::string_view name) const;
    bool has(std::string_view name) const;
    std::string_view name() const { return attribute("name"); }
    std::string_view type() const { return attribute("type"); }
    const Element* child(std::string_view category, std::string_view name) const;
};

struct Document {
    Element root{};
    double version = 0;  // 1.38; 0: it says none
    struct Problem {
        std::string part, text;
        bool is_lost = false;  // something is not there: refused
        int line = 0, column = 0;
    };
    std::vector<Problem> problems{};
};

// Empty, or what is wrong, with the file's name and the place. `folders`: where included files are searched, after the
// folder of the one that includes them.
std::string read_document(const std::string& path, const std::vector<std::string>& folders, Document& document);

}  // namespace patina::importers::mtlx
