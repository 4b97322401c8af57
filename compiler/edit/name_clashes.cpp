#include "compiler/edit/name_clashes.h"

#include <algorithm>
#include <map>

namespace patina::edit {
namespace {

class Clashes {
public:
    Clashes(const SameNames& names, const SideChanges& changes) : names_(names), changes_(changes) {
        for (const NameReader& reader : name_readers(*names_.base->graph)) {
            for (const Name& name : reader.names) read_at_[name].push_back(reader.path);
        }
    }

    // The changes that go with things that clash.
    std::vector<TreeChange> readers_of(const std::set<Path>& places) const {
        std::set<Name> removed_by_ours, removed_by_theirs, of_two_things;
        for (const Path& place : places) {
            const std::optional<ReadAs> as = place.size() == 2 ? read_as(place[0]) : std::nullopt;
            if (!as) continue;
            const Name name{*as, place[1]};
            const TreeValue base = find(*names_.base, place), ours = find(*names_.ours, place),
                            theirs = find(*names_.theirs, place);
            if (base && !ours && theirs) removed_by_ours.insert(name);
            if (base && ours && !theirs) removed_by_theirs.insert(name);
            if (!base && ours && theirs && !is_same(ours, theirs)) add_other_names(name, of_two_things);
        }
        add_names_in_place_of(removed_by_ours, *names_.ours->graph);
        add_names_in_place_of(removed_by_theirs, *names_.theirs->graph);
        removed_by_ours.insert(of_two_things.begin(), of_two_things.end());
        removed_by_theirs.insert(of_two_things.begin(), of_two_things.end());
        std::vector<TreeChange> all = changes_about_any(changes_.ours, removed_by_ours);
        const std::vector<TreeChange> more = changes_about_any(changes_.theirs, removed_by_theirs);
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

private:
    // A side that renamed something to this name has another name for this thing than the other side. Both may have
    // renamed it.
    void add_other_names(const Name& name, std::set<Name>& names) const {
        names.insert(name);
        for_each_held([&](const Rename& rename) {
            if (read_as(rename.list) != name.first || rename.to != name.second) return;
            names.emplace(name.first, rename.from);
            for_each_held([&](const Rename& same) {
                if (same.list == rename.list && same.from == rename.from) names.emplace(name.first, same.to);
            });
        });
    }

    template <class Visit>
    void for_each_held(const Visit& visit) const {
        for (const Rename& rename : names_.held_of_ours) visit(rename);
        for (const Rename& rename : names_.held_of_theirs) visit(rename);
    }

    // Finds the names that a side added, and that are now read in place of a removed name.
    void add_names_in_place_of(std::set<Name>& gone, const format::Graph& side) const {
        if (gone.empty()) return;
        std::map<Path, std::vector<Name>> now;
        for (NameReader& reader : name_readers(side)) now.emplace(std::move(reader.path), std::move(reader.names));
        std::set<Name> added;
        for (const Name& name : gone) {
            const auto places = read_at_.find(name);
            if (places == read_at_.end()) continue;
            for (const Path& place : places->second) {
                const auto reader = now.find(place);
                if (reader == now.end()) continue;
                for (const Name& other : reader->second) {
                    if (other.first == name.first && list_of(*names_.base->graph, other).empty()) added.insert(other);
                }
            }
        }
        gone.insert(added.begin(), added.end());
    }

    std::vector<TreeChange> changes_about_any(std::span<const TreeChange> changes, const std::set<Name>& names) const {
        if (names.empty()) return {};
        return changes_about(changes, names,
                             {names_.base->graph.get(), names_.ours->graph.get(), names_.theirs->graph.get()});
    }

    const SameNames& names_;
    const SideChanges& changes_;
    std::map<Name, std::vector<Path>> read_at_{};  // in the base
};

}  // namespace

void add_readers(const SameNames& names, const SideChanges& changes, std::set<Path>& clashing) {
    if (clashing.empty() || !names.base->graph || !names.ours->graph || !names.theirs->graph) return;
    const Clashes clashes(names, changes);
    for (std::set<Path> waiting = clashing; !waiting.empty();) {
        std::set<Path> brought;
        for (const TreeChange& change : clashes.readers_of(waiting)) {
            if (clashing.insert(change.path).second) brought.insert(change.path);
        }
        waiting = std::move(brought);
    }
}

}  // namespace patina::edit
