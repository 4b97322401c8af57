#include "compiler/edit/name_clashes.h"

#include <algorithm>

namespace patina::graph {
namespace {

// The names that the side added, and that stand now where the other name was read.
std::set<Name> names_in_place_of(const Name& gone, const Graph& base, const Graph& side) {
    const std::vector<NameReader> now = name_readers(side);
    std::set<Name> names;
    for (const NameReader& reader : name_readers(base)) {
        if (!reader.reads(gone)) continue;
        const auto after =
            std::find_if(now.begin(), now.end(), [&](const NameReader& each) { return each.path == reader.path; });
        if (after == now.end()) continue;
        for (const Name& name : after->names) {
            if (name.first == gone.first && list_of(base, name).empty() && !list_of(side, name).empty())
                names.insert(name);
        }
    }
    return names;
}

// What the side changed that removed the name, and what it put in its place.
void add_removal(const SameNames& names, const SideChanges& changes, const Name& gone, Side by,
                 std::set<Path>& clashing) {
    const bool ours = by == Side::Ours;
    const Graph &base = *names.base->graph, &side = ours ? *names.ours->graph : *names.theirs->graph;
    std::set<Name> about = names_in_place_of(gone, base, side);
    about.insert(gone);
    for (const TreeChange& change : changes_about(ours ? changes.ours : changes.theirs, about, {&base, &side}))
        clashing.insert(change.path);
}

}  // namespace

void add_readers(const SameNames& names, const SideChanges& changes, const TreeConflict& conflict,
                 std::set<Path>& clashing) {
    if (conflict.path.size() != 2 || !names.base->graph) return;
    const std::string &list = conflict.path[0], &name = conflict.path[1];
    const std::optional<ReadAs> as = read_as(list);
    if (!as) return;
    if (conflict.kind == TreeConflict::Kind::OursRemoved)
        return add_removal(names, changes, {*as, name}, Side::Ours, clashing);
    if (conflict.kind == TreeConflict::Kind::TheirsRemoved)
        return add_removal(names, changes, {*as, name}, Side::Theirs, clashing);
    if (conflict.kind != TreeConflict::Kind::BothAdded) return;
    std::set<Name> about{{*as, name}};
    // A side that renamed something to this name has another name for it than the other side.
    std::vector<Rename> held = names.held_of_ours;
    held.insert(held.end(), names.held_of_theirs.begin(), names.held_of_theirs.end());
    for (const Rename& rename : held) {
        if (read_as(rename.list) != as || rename.to != name) continue;
        for (const Rename& same : held) {  // both may have renamed it
            if (same.list != rename.list || same.from != rename.from) continue;
            about.emplace(*as, same.from);
            about.emplace(*as, same.to);
        }
    }
    const auto graphs = {names.base->graph.get(), names.ours->graph.get(), names.theirs->graph.get()};
    for (const auto side : {changes.ours, changes.theirs}) {
        for (const TreeChange& change : changes_about(side, about, graphs)) clashing.insert(change.path);
    }
}

void add_readers(const SameNames& names, const SideChanges& changes, const LostName& lost, std::set<Path>& clashing) {
    const Side removed_by = lost.renamed_by == Side::Ours ? Side::Theirs : Side::Ours;
    add_removal(names, changes, {*read_as(lost.list), lost.to}, removed_by, clashing);
}

}  // namespace patina::graph
