#include "compiler/edit/merge_names.h"

#include <algorithm>

namespace patina::edit {
namespace {

bool has_name(const GraphText& text, std::string_view list, std::string_view name) {
    const std::vector<std::string_view> names = names_read_like(*text.graph, list);
    return std::find(names.begin(), names.end(), name) != names.end();
}

const Rename* find_rename(const std::vector<Rename>& renames, const Rename& like) {
    const auto found = std::find_if(renames.begin(), renames.end(), [&](const Rename& each) {
        return each.list == like.list && each.from == like.from;
    });
    return found == renames.end() ? nullptr : &*found;
}

std::unique_ptr<GraphText> renamed(std::unique_ptr<GraphText> text, std::span<const Rename> renames) {
    if (renames.empty()) return text;
    return read_graph_text(std::string(text->sources.file(text->base)),
                           apply(text->sources, text->base, rename_edits(*text, renames)));
}

}  // namespace

SameNames unify_names(std::unique_ptr<GraphText> base, std::unique_ptr<GraphText> ours,
                      std::unique_ptr<GraphText> theirs) {
    SameNames same;
    std::vector<Rename> of_base, of_ours, of_theirs;  // that each text gets
    if (base->graph && ours->graph && theirs->graph) {
        const std::vector<Rename> by_ours = find_renames(*base, *ours), by_theirs = find_renames(*base, *theirs);
        ReusedNames ours_reuses = find_reused_names(*base, *ours, by_ours);
        ReusedNames theirs_reuses = find_reused_names(*base, *theirs, by_theirs);
        if (ours_reuses != theirs_reuses) {
            same.reused_by_ours = std::move(ours_reuses);
            same.reused_by_theirs = std::move(theirs_reuses);
        }
        for (const Rename& rename : by_ours) {
            // That name is the one of another thing there.
            if (same.reused_by_theirs.holds(rename)) {
                same.held_of_ours.push_back(rename);
                continue;
            }
            const Rename* other = find_rename(by_theirs, rename);
            if (other && other->to == rename.to) {
                of_base.push_back(rename);
                continue;
            }
            // A name that the other side took for something else is no rename to carry over.
            if (has_name(*theirs, rename.list, rename.to) || (other && has_name(*ours, rename.list, other->to))) {
                same.held_of_ours.push_back(rename);
                continue;
            }
            of_base.push_back(rename);
            if (other) {
                same.conflicts.push_back({rename.list, rename.from, rename.to, other->to});
                of_theirs.push_back({rename.list, other->to, rename.to});
            } else if (!has_name(*theirs, rename.list, rename.from)) {
                same.lost.push_back({rename.list, rename.from, rename.to, Side::Ours});
            } else {
                of_theirs.push_back(rename);
                same.from_ours.push_back(rename);
            }
        }
        for (const Rename& rename : by_theirs) {
            if (same.reused_by_ours.holds(rename)) {
                same.held_of_theirs.push_back(rename);
                continue;
            }
            if (const Rename* other = find_rename(by_ours, rename)) {
                const bool is_held = other->to != rename.to && (has_name(*ours, rename.list, rename.to) ||
                                                                has_name(*theirs, rename.list, other->to));
                if (is_held) same.held_of_theirs.push_back(rename);
                continue;
            }
            if (has_name(*ours, rename.list, rename.to)) {
                same.held_of_theirs.push_back(rename);
                continue;
            }
            of_base.push_back(rename);
            if (!has_name(*ours, rename.list, rename.from)) {
                same.lost.push_back({rename.list, rename.from, rename.to, Side::Theirs});
            } else {
                of_ours.push_back(rename);
                same.from_theirs.push_back(rename);
            }
        }
    }
    same.base = renamed(std::move(base), of_base);
    same.ours = renamed(std::move(ours), of_ours);
    same.theirs = renamed(std::move(theirs), of_theirs);
    return same;
}

Path before_renames(Path path, std::span<const Rename> renames) {
    if (path.size() < 2) return path;
    for (const Rename& rename : renames) {
        if (path[0] == rename.list && path[1] == rename.to) {
            path[1] = rename.from;
            break;
        }
    }
    return path;
}

}  // namespace patina::edit
