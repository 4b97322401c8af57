// The room `edit` changes the text of graphs and scenes only where their content changes. All other text stays as its
// author wrote it: comments, order and layout. It compares graphs by meaning, renames, and merges. It resolves no name
// and compiles nothing.
//
// An edit replaces a part of a text. The functions here make the edits for one change of a JSON tree. Callers that
// merge, rename or repair collect the edits and apply them together.
//
//   std::vector<TextEdit> edits;
//   replace_value(old_text, *old_text.json->find("workflow"), {*new_value, new_sources}, edits);
//   std::string text = apply(sources, base, edits);
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/base/source.h"
#include "compiler/json/json.h"

namespace patina::edit {

struct TextEdit {
    Span span;  // the text that is replaced; empty: an insertion
    std::string text;
};

// The file whose text starts at `base`, after all edits. No two of them overlap. Insertions at one place keep their
// order.
std::string apply(const SourceMap& sources, std::uint32_t base, std::vector<TextEdit> edits);

// A JSON value of this or another text.
struct ValueText {
    const json::Json& json;
    const SourceMap& sources;
};

// Puts a value in the place of another one. Comments around the old one stay.
void replace_value(const SourceMap& sources, const json::Json& old_value, const ValueText& new_value,
                   std::vector<TextEdit>& edits);

// A child of an object or of an array that is added, with its comments.
struct NewChild {
    std::size_t after = kFirst;  // the index of the old child that it follows; kFirst: none
    std::string key{};           // of an object's child
    ValueText value;

    static constexpr std::size_t kFirst = static_cast<std::size_t>(-1);
};
struct ChildEdits {
    std::vector<std::size_t> removed{};  // indices
    std::vector<NewChild> added{};       // in order, if several have one place
};
// Removes children with their comments, and adds others. The edits of children that stay can be made in addition.
void edit_children(const SourceMap& sources, const json::Json& container, const ChildEdits& changes,
                   std::vector<TextEdit>& edits);

// The comments of a child: those on the lines above it, and the comment behind it. Nothing: they stay as they are.
struct ChildComments {
    std::size_t child = 0;  // its index
    std::optional<std::vector<std::string>> before{};
    std::optional<std::string> trailing{};
};
// Gives children other comments, where these have lines of their own and the end of a line.
void replace_comments(const SourceMap& sources, const json::Json& container, const std::vector<ChildComments>& comments,
                      std::vector<TextEdit>& edits);

// Puts the children into another order: `order[i]` is the index of the child that comes to the place i. Comments move
// with their child.
void reorder_children(const SourceMap& sources, const json::Json& container, const std::vector<std::size_t>& order,
                      std::vector<TextEdit>& edits);

}  // namespace patina::edit
