#include "compiler/edit/renames.h"

#include <algorithm>
#include <map>
#include <optional>

namespace patina::graph {
namespace {

using nodelang::Expr;

constexpr std::size_t kMostPairs = 250'000;  // that are compared; of more names, none is taken as a rename

// How the names of a list are read.
enum class ReadAs { Node, Dollar, Surface };
struct List {
    std::string_view name;
    ReadAs as;
};
constexpr List kLists[] = {
    {"nodes", ReadAs::Node}, {"properties", ReadAs::Dollar}, {"inputs", ReadAs::Dollar}, {"surface", ReadAs::Surface}};

ReadAs read_as(std::string_view list) {
    return std::find_if(std::begin(kLists), std::end(kLists), [&](const List& each) { return each.name == list; })->as;
}

// An expression that reads a name.
std::optional<ReadAs> read_as(const Expr& expr) {
    if (expr.kind == Expr::Kind::Name) return ReadAs::Node;
    if (expr.kind == Expr::Kind::Property) return ReadAs::Dollar;
    if (reads_surface(expr)) return ReadAs::Surface;
    return std::nullopt;
}

template <class Visit>
void for_each_name(const Expr& expr, const Visit& visit) {
    if (const std::optional<ReadAs> as = read_as(expr)) visit(expr, *as);
    for (const Expr* argument : expr.args) for_each_name(*argument, visit);
}

// The places that read each name of a list.
std::map<std::string_view, std::set<std::string>> readers_of(const Graph& graph, std::string_view list) {
    std::map<std::string_view, std::set<std::string>> readers;
    for (const PlacedExpr& placed : expressions_of(graph)) {
        for_each_name(*placed.expr, [&](const Expr& name, ReadAs as) {
            if (as == read_as(list)) readers[name.text].insert(to_string(placed.path));
        });
    }
    return readers;
}

class Finder {
public:
    Finder(const GraphText& before, const GraphText& after) : before_(before), after_(after) {}

    std::vector<Rename> find() {
        for (const List& list : kLists) find_names_that_changed(list.name);
        std::vector<Candidate> candidates;
        for (const List& list : kLists) find_candidates(list.name, candidates);
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](const Candidate& a, const Candidate& b) { return a.common > b.common; });
        choose(candidates);
        // With the pairs alone, what is called alike must still be alike.
        for (NamePairs* names : {&renaming_.nodes, &renaming_.dollar, &renaming_.surface}) names->any_of_a.clear();
        while (drop_false_pairs()) {
        }
        std::sort(chosen_.begin(), chosen_.end(), [](const Candidate& a, const Candidate& b) {
            return a.before.json->span.begin < b.before.json->span.begin;
        });
        std::vector<Rename> renames;
        for (const Candidate& pair : chosen_)
            renames.push_back({std::string(pair.list), std::string(pair.from), std::string(pair.to)});
        return renames;
    }

private:
    struct Candidate {
        std::string_view list, from, to;
        TreeValue before{}, after{};
        std::size_t common = 0;  // readers
    };

    NamePairs& pairs_of(std::string_view list) {
        switch (read_as(list)) {
            case ReadAs::Node: return renaming_.nodes;
            case ReadAs::Dollar: return renaming_.dollar;
            case ReadAs::Surface: break;
        }
        return renaming_.surface;
    }

    void find_names_that_changed(std::string_view list) {
        const std::vector<std::string_view> a = names_of(*before_.graph, list), b = names_of(*after_.graph, list);
        const std::set<std::string_view> in_a(a.begin(), a.end()), in_b(b.begin(), b.end());
        for (const std::string_view name : a) {
            if (in_b.count(name) == 0) pairs_of(list).any_of_a.insert(name);
        }
        for (const std::string_view name : b) {
            if (in_a.count(name) == 0) pairs_of(list).any_of_b.insert(name);
        }
    }

    void find_candidates(std::string_view list, std::vector<Candidate>& candidates) {
        const TreeValue before = graph::find(before_, {std::string(list)}),
                        after = graph::find(after_, {std::string(list)});
        if (!before || !after) return;
        const NamePairs& names = pairs_of(list);
        if (names.any_of_a.size() * names.any_of_b.size() > kMostPairs) return;
        const auto readers_before = readers_of(*before_.graph, list), readers_after = readers_of(*after_.graph, list);
        const std::vector<std::string_view> before_names = names_of(*before_.graph, list);
        const std::vector<std::string_view> after_names = names_of(*after_.graph, list);
        const std::vector<TreeChild> old_children = children_of(before), new_children = children_of(after);
        // The surface of a material has values, and no names that something reads.
        if (before_names.size() != old_children.size() || after_names.size() != new_children.size()) return;
        for (std::size_t i = 0; i < old_children.size(); ++i) {
            if (names.any_of_a.count(before_names[i]) == 0) continue;
            for (std::size_t j = 0; j < new_children.size(); ++j) {
                if (names.any_of_b.count(after_names[j]) == 0) continue;
                if (!is_same(old_children[i].value, new_children[j].value, renaming_)) continue;
                const auto old_readers = readers_before.find(before_names[i]);
                const auto new_readers = readers_after.find(after_names[j]);
                std::size_t common = 0;
                if (old_readers != readers_before.end() && new_readers != readers_after.end()) {
                    for (const std::string& reader : old_readers->second) common += new_readers->second.count(reader);
                }
                // Two nodes that compute the same can stand for each other. Two properties with one declaration are
                // often different ones: a reader tells.
                const bool is_read = old_readers != readers_before.end();
                if (is_read && common == 0 && read_as(list) != ReadAs::Node) continue;
                candidates.push_back(
                    {list, before_names[i], after_names[j], old_children[i].value, new_children[j].value, common});
            }
        }
    }

    void choose(const std::vector<Candidate>& candidates) {
        std::set<std::pair<ReadAs, std::string_view>> old_names, new_names;
        for (const Candidate& candidate : candidates) {
            const ReadAs as = read_as(candidate.list);
            if (old_names.count({as, candidate.from}) || new_names.count({as, candidate.to})) continue;
            old_names.insert({as, candidate.from});
            new_names.insert({as, candidate.to});
            pairs_of(candidate.list).pairs.emplace(candidate.from, candidate.to);
            chosen_.push_back(candidate);
        }
    }

    bool drop_false_pairs() {
        const auto is_false = [&](const Candidate& pair) { return !is_same(pair.before, pair.after, renaming_); };
        const auto found = std::find_if(chosen_.begin(), chosen_.end(), is_false);
        if (found == chosen_.end()) return false;
        pairs_of(found->list).pairs.erase(found->from);
        chosen_.erase(found);
        return true;
    }

    const GraphText& before_;
    const GraphText& after_;
    Renaming renaming_{};
    std::vector<Candidate> chosen_{};
};

}  // namespace

std::vector<std::string_view> names_of(const Graph& graph, std::string_view list) {
    std::vector<std::string_view> names;
    if (list == "nodes") {
        for (const Node& node : graph.nodes) names.push_back(node.id);
    } else if (list == "properties") {
        for (const Property& property : graph.properties) names.push_back(property.name);
    } else if (graph.kind == (list == "inputs" ? GraphKind::Subgraph : GraphKind::Lighting)) {
        for (const Input& input : graph.inputs) names.push_back(input.name);
    }
    return names;
}

std::vector<std::string_view> names_read_like(const Graph& graph, std::string_view list) {
    std::vector<std::string_view> names;
    for (const List& each : kLists) {
        if (each.as != read_as(list)) continue;
        const std::vector<std::string_view> more = names_of(graph, each.name);
        names.insert(names.end(), more.begin(), more.end());
    }
    return names;
}

std::vector<Rename> find_renames(const GraphText& before, const GraphText& after) {
    if (!before.graph || !after.graph || before.graph->kind != after.graph->kind) return {};
    return Finder(before, after).find();
}

std::vector<TextEdit> rename_edits(const GraphText& text, std::span<const Rename> renames) {
    if (!text.graph || renames.empty()) return {};
    using Name = std::pair<ReadAs, std::string_view>;
    std::map<Name, std::string_view> names;
    for (const Rename& rename : renames) names.emplace(Name(read_as(rename.list), rename.from), rename.to);
    std::map<std::uint32_t, TextEdit> edits;  // by place: a pass reads the values of the material
    const auto edit = [&](Span span, std::string_view name, ReadAs as) {
        const auto found = names.find({as, name});
        if (found != names.end()) edits.emplace(span.begin, TextEdit{span, std::string(found->second)});
    };
    const Graph& graph = *text.graph;
    for (const Node& node : graph.nodes) edit(node.id_span, node.id, ReadAs::Node);
    for (const Property& property : graph.properties) edit(property.name_span, property.name, ReadAs::Dollar);
    for (const Input& input : graph.inputs) {
        if (graph.kind == GraphKind::Subgraph) edit(input.name_span, input.name, ReadAs::Dollar);
        if (graph.kind == GraphKind::Lighting) edit(input.name_span, input.name, ReadAs::Surface);
    }
    for (const ListedVariant& variant : graph.variants) {
        for (const ListedVariant::Value& value : variant.values) edit(value.name_span, value.name, ReadAs::Dollar);
    }
    for (const PlacedExpr& placed : expressions_of(graph)) {
        for_each_name(*placed.expr, [&](const Expr& name, ReadAs as) {
            Span span = as == ReadAs::Surface ? name.name_span : name.span;
            if (as == ReadAs::Dollar && text.sources.text(span).substr(0, 1) == "$") ++span.begin;
            edit(span, name.text, as);
        });
    }
    std::vector<TextEdit> all;
    for (auto& [place, made] : edits) all.push_back(std::move(made));
    return all;
}

}  // namespace patina::graph
