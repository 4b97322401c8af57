// A text that has been read: the JSON tree, and the graph that it means. Two trees are compared here by meaning. Nodes,
// properties and ports are matched by id or name. Numbers and colours are equal by value, and expressions by their
// syntax trees, in which 1 is an integer and 1.0 a float.
//
//   const std::unique_ptr<GraphText> text = read_graph_text("rust.graph.json", bytes);
//   if (text->ok && is_same(text->root(), other->root())) ...
#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/format/graph.h"
#include "compiler/format/keys.h"
#include "compiler/json/json.h"

namespace patina::edit {

struct GraphText;

// A value of a text, and what the format says of its place.
struct TreeValue {
    const GraphText* text = nullptr;
    const json::Json* json = nullptr;                    // null: there is none
    format::ObjectKind kind = format::ObjectKind::Free;  // of the object, or of the objects in the array
    bool is_set = false;                                 // the order of the array has no meaning

    explicit operator bool() const { return json != nullptr; }
};

struct GraphText {
    SourceMap sources{};
    nodelang::Ast ast{};
    Diagnostics diagnostics{};
    std::uint32_t base = 0;
    std::unique_ptr<json::Json> json{};
    format::ObjectKind kind = format::ObjectKind::Material;
    std::shared_ptr<const format::Graph> graph{};                       // null: a scene
    std::unordered_map<std::uint32_t, const nodelang::Expr*> values{};  // by the first byte of the JSON value
    // For each list and object that was searched: the index of each child by its name.
    mutable std::unordered_map<const json::Json*, std::unordered_map<std::string, std::size_t>> children{};
    bool ok = false;  // a graph or a scene without errors in its form

    std::string_view all() const { return sources.file_text(base); }
    TreeValue root() const { return {this, json.get(), kind, false}; }
};
std::unique_ptr<GraphText> read_graph_text(const std::string& path, std::string text);

// --- trees

// How the children of a value are matched with those of another one.
enum class Shape {
    Whole,       // not at all
    ByKey,       // an object
    ByName,      // an array of objects with names or ids
    ByContent,   // an array whose order has no meaning
    ByPosition,  // another array of objects
};
Shape shape_of(const TreeValue& value);

struct TreeChild {
    std::string name;  // by which it is matched
    TreeValue value;
};
// In the order of the text.
std::vector<TreeChild> children_of(const TreeValue& value);

// Names that the graph `a` has and the graph `b` has under another name.
struct NamePairs {
    std::unordered_map<std::string_view, std::string_view> pairs{};
    // A name of the first set matches any name of the second set that is in no pair.
    std::set<std::string_view> any_of_a{}, any_of_b{};

    bool match(std::string_view a, std::string_view b) const;
};
struct Renaming {
    NamePairs nodes{}, dollar{}, surface{};  // read as `name`, as `$name` and as `@surface.name`
};
bool is_same(const TreeValue& a, const TreeValue& b, const Renaming& renaming = {});

// --- places in a tree: {"nodes", "rust", "in", "level"}
using Path = std::vector<std::string>;
std::string to_string(const Path& path);  // "nodes.rust.in.level"
bool starts_with(const Path& path, const Path& start);
TreeValue find(const GraphText& text, const Path& path);
// The path of the innermost value that holds the offset.
Path path_at(const GraphText& text, std::uint32_t offset);

// The expressions of a graph, each with its path; without those of inline lighting graphs, which have nodes of their
// own.
struct PlacedExpr {
    Path path;
    const nodelang::Expr* expr;
};
std::vector<PlacedExpr> expressions_of(const format::Graph& graph);
// True for `@surface.name`.
bool reads_surface(const nodelang::Expr& expr);

}  // namespace patina::edit
