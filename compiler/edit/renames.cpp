#include "compiler/edit/renames.h"

#include <algorithm>
#include <map>

namespace patina::edit {
namespace {

using nodelang::Expr;

constexpr std::size_t kMostPairs = 250'000;  // that are compared; of more names, none is taken as a rename

// The readers of a graph, by their places.
using Readers = std::map<Path, std::vector<Name>>;
Readers readers_of(const format::Graph& graph) {
    Readers readers;
    for (NameReader& reader : name_readers(graph)) {
        if (!reader.names.empty()) readers[std::move(reader.path)] = std::move(reader.names);
    }
    return readers;
}

bool reads(const std::vector<Name>& names, const Name& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// The things of a list, by name.
using Things = std::map<std::string_view, TreeValue>;
Things things_of(const GraphText& text, std::string_view list) {
    Things things;
    const std::vector<std::string_view> names = names_of(*text.graph, list);
    const TreeValue value = find(text, {std::string(list)});
    if (!value) return things;
    const std::vector<TreeChild> children = children_of(value);
    // The surface of a material has values, and no names that something reads.
    if (names.size() != children.size()) return things;
    for (std::size_t i = 0; i < names.size(); ++i) things.emplace(names[i], children[i].value);
    return things;
}

// Two nodes of one node type, two properties of one type.
bool is_of_one_kind(const TreeValue& a, const TreeValue& b) {
    for (const char* key : {"node", "type"}) {
        const json::Json *left = a.json->find(key), *right = b.json->find(key);
        if (!left != !right || (left && left->string != right->string)) return false;
    }
    return true;
}

class Finder {
public:
    Finder(const GraphText& before, const GraphText& after)
        : before_(before),
          after_(after),
          readers_before_(readers_of(*before.graph)),
          readers_after_(readers_of(*after.graph)) {
        for (const std::string_view list : kNameLists) {
            things_before_[list] = things_of(before, list);
            things_after_[list] = things_of(after, list);
        }
    }

    // Pairs of names: only the first text has the first name, and only the second text has the second.
    std::vector<Rename> find() {
        open_names([](const TreeValue&, const TreeValue&) { return false; });
        find_pairs();
        drop_false_pairs();
        return renames();
    }

    // Names that both texts have, and that mean different things there.
    ReusedNames find_reused(std::span<const Rename> known) {
        for (const Rename& rename : known) {
            names_of_list(rename.list).pairs.emplace(rename.from, rename.to);
            known_.emplace(Name(*read_as(rename.list), rename.from), Name(*read_as(rename.list), rename.to));
            known_new_.emplace(*read_as(rename.list), rename.to);
        }
        const Renaming plain = renaming_;
        open_names([&](const TreeValue& a, const TreeValue& b) { return !is_same(a, b, plain); });
        close_names_that_stay();
        find_pairs();
        const auto is_wrong = [&](const Candidate& pair) {
            const ReadAs as = *read_as(pair.list);
            if (stays({as, pair.from}) || stays({as, pair.to})) return true;
            // Of what nothing reads, another value is no sign of another thing.
            const auto may_stay = [&](std::string_view name) {
                const Things &old_things = things_before_[pair.list], &new_things = things_after_[pair.list];
                const auto old_thing = old_things.find(name), new_thing = new_things.find(name);
                return old_thing != old_things.end() && new_thing != new_things.end() && !is_read({as, name}) &&
                       is_of_one_kind(old_thing->second, new_thing->second);
            };
            return pair.common == 0 && !is_read({as, pair.from}) && (may_stay(pair.from) || may_stay(pair.to));
        };
        const auto wrong = std::stable_partition(chosen_.begin(), chosen_.end(),
                                                 [&](const Candidate& pair) { return !is_wrong(pair); });
        for (auto pair = wrong; pair != chosen_.end(); ++pair) names_of_list(pair->list).pairs.erase(pair->from);
        chosen_.erase(wrong, chosen_.end());
        drop_false_pairs();

        ReusedNames reused{.moves = renames()};
        for (const Rename& move : reused.moves) {
            const ReadAs as = *read_as(move.list);
            if (things_after_[move.list].count(move.from)) reused.taken.emplace(as, move.from);
            if (things_before_[move.list].count(move.to)) reused.taken.emplace(as, move.to);
        }
        add_twins(reused);
        if (reused.taken.empty()) return {};
        reused.all = reused.taken;
        for (const Rename& move : reused.moves) {
            reused.all.emplace(*read_as(move.list), move.from);
            reused.all.emplace(*read_as(move.list), move.to);
        }
        return reused;
    }

private:
    struct Candidate {
        std::string_view list, from, to;
        TreeValue before{}, after{};
        std::size_t common = 0;  // readers
    };

    NamePairs& names_of_list(std::string_view list) {
        switch (*read_as(list)) {
            case ReadAs::Node: return renaming_.nodes;
            case ReadAs::Dollar: return renaming_.dollar;
            case ReadAs::Surface: break;
        }
        return renaming_.surface;
    }

    // The names that may be those of other things: names that one text lacks, and names whose thing differs.
    template <class IsOther>
    void open_names(const IsOther& is_other) {
        for (const std::string_view list : kNameLists) {
            NamePairs& names = names_of_list(list);
            const ReadAs as = *read_as(list);
            const Things &old_things = things_before_[list], &new_things = things_after_[list];
            for (const auto& [name, thing] : old_things) {
                const auto other = new_things.find(name);
                if (other != new_things.end() && !is_other(thing, other->second)) continue;
                if (!known_.count({as, name})) names.any_of_a.insert(name);
            }
            for (const auto& [name, thing] : new_things) {
                const auto other = old_things.find(name);
                if (other != old_things.end() && !is_other(other->second, thing)) continue;
                if (!known_new_.count({as, name})) names.any_of_b.insert(name);
            }
        }
    }

    // A thing keeps its name if it differs only by the names that it reads.
    void close_names_that_stay() {
        std::vector<std::pair<NamePairs*, std::string_view>> closed;
        for (const std::string_view list : kNameLists) {
            NamePairs& names = names_of_list(list);
            for (const auto& [name, thing] : things_before_[list]) {
                if (!names.any_of_a.count(name) || !names.any_of_b.count(name)) continue;
                if (is_same(thing, things_after_[list].at(name), renaming_)) closed.emplace_back(&names, name);
            }
        }
        for (const auto& [names, name] : closed) {
            names->any_of_a.erase(name);
            names->any_of_b.erase(name);
        }
    }

    // Chooses the pairs; those with the most readers in common come first.
    void find_pairs() {
        std::vector<Candidate> candidates;
        for (const std::string_view list : kNameLists) find_candidates(list, candidates);
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](const Candidate& a, const Candidate& b) { return a.common > b.common; });
        choose(candidates);
        // With the pairs alone, what is called alike must still be alike.
        for (NamePairs* names : {&renaming_.nodes, &renaming_.dollar, &renaming_.surface}) names->any_of_a.clear();
    }

    void find_candidates(std::string_view list, std::vector<Candidate>& candidates) {
        const NamePairs& names = names_of_list(list);
        if (names.any_of_a.size() * names.any_of_b.size() > kMostPairs) return;
        const ReadAs as = *read_as(list);
        const Things &old_things = things_before_[list], &new_things = things_after_[list];
        for (const std::string_view from : names_of(*before_.graph, list)) {
            if (names.any_of_a.count(from) == 0) continue;
            const TreeValue& thing = old_things.at(from);
            for (const std::string_view to : names_of(*after_.graph, list)) {
                if (from == to || names.any_of_b.count(to) == 0) continue;
                const TreeValue& other = new_things.at(to);
                if (!is_same(thing, other, renaming_)) continue;
                const std::size_t common = common_readers({as, from}, {as, to});
                // Two nodes that compute the same are interchangeable. Two properties with one declaration are often
                // different ones: a reader tells.
                if (common == 0 && as != ReadAs::Node && is_read({as, from})) continue;
                candidates.push_back({list, from, to, thing, other, common});
            }
        }
    }

    bool is_read(const Name& name) const {
        return std::any_of(readers_before_.begin(), readers_before_.end(),
                           [&](const auto& each) { return reads(each.second, name); });
    }

    // The number of places that read the one name before, and the other name after. If a place reads as many names as
    // before, the other name must be in the position of the first.
    std::size_t common_readers(const Name& from, const Name& to) const {
        std::size_t common = 0;
        for (const auto& [path, names] : readers_before_) {
            if (!reads(names, from)) continue;
            const auto after = readers_after_.find(path);
            if (after == readers_after_.end() || !reads(after->second, to)) continue;
            const bool is_in_place = std::equal(names.begin(), names.end(), after->second.begin(), after->second.end(),
                                                [&](const Name& a, const Name& b) { return (a == from) == (b == to); });
            common += names.size() != after->second.size() || is_in_place;
        }
        return common;
    }

    // True if the other text has the name, too, and some place reads the same names in both texts, and this name is one
    // of them. So a side that swaps two values differs from one that swaps two names.
    bool stays(const Name& name) const {
        for (const auto& [path, names] : readers_before_) {
            if (!reads(names, name)) continue;
            const auto after = readers_after_.find(path_after(path));
            if (after == readers_after_.end()) continue;
            const bool is_same_reader = std::equal(names.begin(), names.end(), after->second.begin(),
                                                   after->second.end(), [&](const Name& a, const Name& b) {
                                                       const auto renamed = known_.find(a);
                                                       return (renamed == known_.end() ? a : renamed->second) == b;
                                                   });
            if (is_same_reader && reads(after->second, name)) return true;
        }
        return false;
    }

    Path path_after(Path path) const {
        if (path.size() < 2 || path[0] != "nodes") return path;
        const auto renamed = known_.find({ReadAs::Node, path[1]});
        if (renamed != known_.end()) path[1] = renamed->second.second;
        return path;
    }

    // Properties with equal declarations: if all places that read these now read others, their names may be swapped.
    void add_twins(ReusedNames& reused) {
        for (const std::string_view list : kNameLists) {
            const ReadAs as = *read_as(list);
            if (as == ReadAs::Node) continue;
            std::vector<std::string_view> restless;
            for (const auto& [name, thing] : things_before_[list]) {
                if (!known_.count({as, name}) && !stays({as, name})) restless.push_back(name);
            }
            if (restless.size() * restless.size() > kMostPairs) continue;
            for (const std::string_view name : restless) {
                if (!things_after_[list].count(name)) continue;
                for (const std::string_view twin : restless) {
                    if (twin == name || !is_read_in_place_of({as, twin}, {as, name})) continue;
                    Renaming pair;
                    (as == ReadAs::Dollar ? pair.dollar : pair.surface).pairs.emplace(twin, name);
                    if (!is_same(things_before_[list].at(twin), things_before_[list].at(name), pair)) continue;
                    reused.taken.emplace(as, name);
                    break;
                }
            }
        }
    }

    // True if a place reads as many names as before, and now reads `name` where it read `twin`.
    bool is_read_in_place_of(const Name& twin, const Name& name) const {
        return std::any_of(readers_before_.begin(), readers_before_.end(), [&](const auto& each) {
            const std::vector<Name>& names = each.second;
            const auto after = readers_after_.find(path_after(each.first));
            if (after == readers_after_.end() || after->second.size() != names.size()) return false;
            for (std::size_t i = 0; i < names.size(); ++i) {
                if (names[i] == twin && after->second[i] == name) return true;
            }
            return false;
        });
    }

    void choose(const std::vector<Candidate>& candidates) {
        std::set<Name> old_names, new_names;
        for (const Candidate& candidate : candidates) {
            const ReadAs as = *read_as(candidate.list);
            if (old_names.count({as, candidate.from}) || new_names.count({as, candidate.to})) continue;
            old_names.insert({as, candidate.from});
            new_names.insert({as, candidate.to});
            names_of_list(candidate.list).pairs.emplace(candidate.from, candidate.to);
            chosen_.push_back(candidate);
        }
    }

    void drop_false_pairs() {
        const auto is_false = [&](const Candidate& pair) { return !is_same(pair.before, pair.after, renaming_); };
        for (;;) {
            const auto found = std::find_if(chosen_.begin(), chosen_.end(), is_false);
            if (found == chosen_.end()) return;
            names_of_list(found->list).pairs.erase(found->from);
            chosen_.erase(found);
        }
    }

    // In the order of the text.
    std::vector<Rename> renames() {
        std::sort(chosen_.begin(), chosen_.end(), [](const Candidate& a, const Candidate& b) {
            return a.before.json->span.begin < b.before.json->span.begin;
        });
        std::vector<Rename> renames;
        for (const Candidate& pair : chosen_)
            renames.push_back({std::string(pair.list), std::string(pair.from), std::string(pair.to)});
        return renames;
    }

    const GraphText& before_;
    const GraphText& after_;
    const Readers readers_before_, readers_after_;
    std::map<std::string_view, Things> things_before_{}, things_after_{};  // by list
    std::map<Name, Name> known_{};                                         // renames that have been found before
    std::set<Name> known_new_{};
    Renaming renaming_{};
    std::vector<Candidate> chosen_{};
};

}  // namespace

std::vector<Rename> find_renames(const GraphText& before, const GraphText& after) {
    if (!before.graph || !after.graph || before.graph->kind != after.graph->kind) return {};
    return Finder(before, after).find();
}

ReusedNames find_reused_names(const GraphText& before, const GraphText& after, std::span<const Rename> renames) {
    if (!before.graph || !after.graph || before.graph->kind != after.graph->kind) return {};
    return Finder(before, after).find_reused(renames);
}

bool ReusedNames::holds(const Rename& rename) const {
    const ReadAs as = *read_as(rename.list);
    return all.count({as, rename.from}) || all.count({as, rename.to});
}

std::vector<TextEdit> rename_edits(const GraphText& text, std::span<const Rename> renames) {
    if (!text.graph || renames.empty()) return {};
    std::map<Name, std::string_view> names;
    for (const Rename& rename : renames) names.emplace(Name(*read_as(rename.list), rename.from), rename.to);
    std::map<std::uint32_t, TextEdit> edits;  // by place: a pass reads the values of the material
    const auto edit = [&](Span span, std::string_view name, ReadAs as) {
        const auto found = names.find({as, name});
        if (found != names.end()) edits.emplace(span.begin, TextEdit{span, std::string(found->second)});
    };
    const format::Graph& graph = *text.graph;
    for (const format::Node& node : graph.nodes) edit(node.id_span, node.id, ReadAs::Node);
    for (const format::Property& property : graph.properties) edit(property.name_span, property.name, ReadAs::Dollar);
    for (const format::Input& input : graph.inputs) {
        if (graph.kind == format::GraphKind::Subgraph) edit(input.name_span, input.name, ReadAs::Dollar);
        if (graph.kind == format::GraphKind::Lighting) edit(input.name_span, input.name, ReadAs::Surface);
    }
    for (const format::ListedVariant& variant : graph.variants) {
        for (const format::ListedVariant::Value& value : variant.values)
            edit(value.name_span, value.name, ReadAs::Dollar);
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

}  // namespace patina::edit
