// diff_graphs(): reads two texts and lists what changed between them.
#include <algorithm>

#include "compiler/api/report.h"
#include "compiler/edit/changes.h"
#include "compiler/edit/merge_names.h"
#include "compiler/format/read_graph.h"
#include "compiler/json/json_text.h"
#include "compiler/seam/seam.h"
#include "patina/graph_diff.h"

namespace patina {
namespace {

using edit::GraphText;
using edit::TreeValue;

std::unique_ptr<GraphText> read(const GraphVersion& version) {
    std::unique_ptr<GraphText> text = edit::read_graph_text(version.name, version.text.empty() ? "{}" : version.text);
    if (version.text.empty()) text->ok = true;
    return text;
}

void add_errors(const GraphText& text, GraphDiff& diff) {
    for (Diagnostic& each : to_public(text.diagnostics, text.sources)) {
        if (each.severity == Severity::Error) diff.diagnostics.push_back(std::move(each));
    }
}

std::string json_of(const TreeValue& value) {
    std::string text;
    if (value) json::append_one_line(text, *value.json, value.text->sources);
    return text;
}

// The names of a list, for a change of its order.
std::string names_of(const TreeValue& list) {
    std::string text;
    for (const edit::TreeChild& child : edit::children_of(list)) {
        text += text.empty() ? "[" : ", ";
        json::append_quoted(text, child.name);
    }
    return text + "]";
}

FileLocation place_in(const GraphText& text, const edit::Path& path) {
    const TreeValue value = edit::find(text, path);
    return value ? format::place_of(text.sources, value.json->span) : FileLocation{};
}

GraphDiff diff(const GraphVersion& before, const GraphVersion& after) {
    GraphDiff diff;
    const std::unique_ptr<GraphText> old_text = read(before), new_text = read(after);
    for (const auto& [text, other] : {std::pair(&old_text, &new_text), std::pair(&new_text, &old_text)}) {
        if (!(*text)->ok) add_errors(**text, diff);
        if ((*text)->json && (*text)->json->members.empty()) (*text)->kind = (*other)->kind;
    }
    if (!old_text->ok || !new_text->ok) return diff;
    diff.ok = true;

    // A rename is one change, for all readers of the name.
    const std::vector<edit::Rename> renames = edit::find_renames(*old_text, *new_text);
    for (const edit::Rename& rename : renames) {
        diff.changes.push_back({.kind = GraphChangeKind::Renamed,
                                .path = {rename.list, rename.to},
                                .before = rename.from,
                                .after = rename.to,
                                .before_location = place_in(*old_text, {rename.list, rename.from}),
                                .after_location = place_in(*new_text, {rename.list, rename.to})});
    }
    const std::unique_ptr<GraphText> renamed = edit::read_graph_text(
        before.name, edit::apply(old_text->sources, old_text->base, edit::rename_edits(*old_text, renames)));
    renamed->kind = old_text->kind;
    for (const edit::TreeChange& each : edit::find_changes(*renamed, *new_text)) {
        const edit::Path old_path = edit::before_renames(each.path, renames);
        const TreeValue old_value = each.before ? edit::find(*old_text, old_path) : TreeValue{};
        GraphChange& change = diff.changes.emplace_back();
        change.kind = each.is_order  ? GraphChangeKind::Reordered
                      : !each.before ? GraphChangeKind::Added
                      : !each.after  ? GraphChangeKind::Removed
                                     : GraphChangeKind::Changed;
        change.path = each.path;
        change.before = each.is_order ? names_of(old_value) : json_of(old_value);
        change.after = each.is_order ? names_of(each.after) : json_of(each.after);
        change.before_location = old_value ? place_in(*old_text, old_path) : FileLocation{};
        change.after_location = each.after ? place_in(*new_text, each.path) : FileLocation{};
    }
    return diff;
}

}  // namespace

GraphDiff diff_graphs(const GraphVersion& before, const GraphVersion& after, const Limits& limits) {
    return guarded<GraphDiff>(after.name, [&](Trail&) {
        return within<GraphDiff>(limits, before.text.size() + after.text.size(), [&] { return diff(before, after); });
    });
}

}  // namespace patina
