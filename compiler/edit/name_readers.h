// Finds the readers of the names of a graph: nodes are read as `name`, properties and the inputs of a sub-graph as
// `$name`, and the inputs of a lighting graph as `@surface.name`.
//
//   for (const NameReader& reader : name_readers(*text->graph)) print(to_string(reader.path));
#pragma once

#include <optional>
#include <span>

#include "compiler/edit/changes.h"

namespace patina::edit {

enum class ReadAs { Node, Dollar, Surface };

// The lists whose things have names: "nodes", "properties", "inputs"; of a lighting graph "surface".
constexpr std::string_view kNameLists[] = {"nodes", "properties", "inputs", "surface"};
std::optional<ReadAs> read_as(std::string_view list);

// The names of a list, in the order of the text.
std::vector<std::string_view> names_of(const format::Graph& graph, std::string_view list);

// The list of a graph that has the name.
std::string list_of(const format::Graph& graph, const std::pair<ReadAs, std::string_view>& name);

// All names that are read as those of the list are: a property and an input of a sub-graph are both `$name`.
std::vector<std::string_view> names_read_like(const format::Graph& graph, std::string_view list);

using Name = std::pair<ReadAs, std::string_view>;
std::optional<ReadAs> read_as(const nodelang::Expr& expr);  // nothing: it reads no name

template <class Visit>
void for_each_name(const nodelang::Expr& expr, const Visit& visit) {
    if (const std::optional<ReadAs> as = read_as(expr)) visit(expr, *as);
    for (const nodelang::Expr* argument : expr.args) for_each_name(*argument, visit);
}

// A place, and the names that its expression reads, in the order of the expression.
struct NameReader {
    Path path;
    std::vector<Name> names;

    bool reads(const Name& name) const;
};
std::vector<NameReader> name_readers(const format::Graph& graph);

// The changes of things with one of the names, and the changes of values that read one of the names in one of the
// graphs.
std::vector<TreeChange> changes_about(std::span<const TreeChange> changes, const std::set<Name>& names,
                                      std::initializer_list<const format::Graph*> graphs);

}  // namespace patina::edit
