#include "compiler/edit/name_readers.h"

#include <algorithm>

namespace patina::edit {

using nodelang::Expr;

std::optional<ReadAs> read_as(std::string_view list) {
    if (list == "nodes") return ReadAs::Node;
    if (list == "properties" || list == "inputs") return ReadAs::Dollar;
    if (list == "surface") return ReadAs::Surface;
    return std::nullopt;
}

std::optional<ReadAs> read_as(const Expr& expr) {
    if (expr.kind == Expr::Kind::Name) return ReadAs::Node;
    if (expr.kind == Expr::Kind::Property) return ReadAs::Dollar;
    if (reads_surface(expr)) return ReadAs::Surface;
    return std::nullopt;
}

std::vector<std::string_view> names_of(const format::Graph& graph, std::string_view list) {
    std::vector<std::string_view> names;
    if (list == "nodes") {
        for (const format::Node& node : graph.nodes) names.push_back(node.id);
    } else if (list == "properties") {
        for (const format::Property& property : graph.properties) names.push_back(property.name);
    } else if (graph.kind == (list == "inputs" ? format::GraphKind::Subgraph : format::GraphKind::Lighting)) {
        for (const format::Input& input : graph.inputs) names.push_back(input.name);
    }
    return names;
}

std::vector<std::string_view> names_read_like(const format::Graph& graph, std::string_view list) {
    std::vector<std::string_view> names;
    for (const std::string_view each : kNameLists) {
        if (read_as(each) != read_as(list)) continue;
        const std::vector<std::string_view> more = names_of(graph, each);
        names.insert(names.end(), more.begin(), more.end());
    }
    return names;
}

std::string list_of(const format::Graph& graph, const Name& name) {
    for (const std::string_view each : kNameLists) {
        const std::vector<std::string_view> names = names_of(graph, each);
        if (read_as(each) == name.first && std::find(names.begin(), names.end(), name.second) != names.end())
            return std::string(each);
    }
    return {};
}

bool NameReader::reads(const Name& name) const {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<NameReader> name_readers(const format::Graph& graph) {
    std::vector<NameReader> readers;
    for (PlacedExpr& placed : expressions_of(graph)) {
        NameReader& reader = readers.emplace_back();
        reader.path = std::move(placed.path);
        for_each_name(*placed.expr, [&](const Expr& name, ReadAs as) { reader.names.emplace_back(as, name.text); });
    }
    return readers;
}

std::vector<TreeChange> changes_about(std::span<const TreeChange> changes, const std::set<Name>& names,
                                      std::initializer_list<const format::Graph*> graphs) {
    std::set<Path> places;
    for (const format::Graph* graph : graphs) {
        for (NameReader& reader : name_readers(*graph)) {
            const bool reads = std::any_of(reader.names.begin(), reader.names.end(),
                                           [&](const Name& name) { return names.count(name) != 0; });
            if (reads) places.insert(std::move(reader.path));
        }
    }
    const bool has_properties =
        std::any_of(names.begin(), names.end(), [](const Name& name) { return name.first == ReadAs::Dollar; });
    std::vector<TreeChange> about;
    for (const TreeChange& change : changes) {
        if (change.is_order) continue;
        const Path& path = change.path;
        const std::optional<ReadAs> as = path.size() < 2 ? std::nullopt : read_as(path[0]);
        const bool is_about = (as && names.count({*as, path[1]})) || (has_properties && path[0] == "variants") ||
                              std::any_of(places.begin(), places.end(), [&](const Path& place) {
                                  return starts_with(place, path) || starts_with(path, place);
                              });
        if (is_about) about.push_back(change);
    }
    return about;
}

}  // namespace patina::edit
