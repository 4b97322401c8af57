#include "compiler/edit/merge_report.h"

#include <algorithm>
#include <iterator>

#include "compiler/format/read_graph.h"
#include "compiler/json/json_text.h"
#include "patina/complaints.h"

namespace patina::edit {

// What a side did, and where.
struct ConflictReport::Did {
    std::string what;
    FileLocation place;
};

namespace {

// The location of a value; if the value is missing, of the object that lacks it.
FileLocation place_in(const GraphText& text, Path path) {
    bool is_there = true;
    for (;;) {
        if (const TreeValue value = find(text, path)) {
            const Span span = value.json->span;
            const bool is_long =
                value.json->kind == json::Json::Kind::Object || value.json->kind == json::Json::Kind::Array;
            return format::place_of(text.sources, is_there && !is_long ? span : Span{span.begin, span.begin + 1});
        }
        is_there = false;
        path.pop_back();
    }
}

Diagnostic note_at(const FileLocation& place, std::string message) {
    Diagnostic note = diagnostic_at(place, {}, std::move(message));
    note.severity = Severity::Note;
    return note;
}

}  // namespace

std::string one_line(const TreeValue& value) {
    std::string text;
    json::append_one_line(text, *value.json, value.text->sources);
    return json::shown(text);
}

ConflictReport::Did ConflictReport::did(Side side, const Path& path) const {
    const bool ours = side == Side::Ours;
    const GraphText& text = ours ? *original_.ours : *original_.theirs;
    // Names of this side's file: without what came from the other side.
    const Path own = before_renames(path, ours ? names_.from_theirs : names_.from_ours);
    const TreeValue before = find(*names_.base, path), after = find(ours ? *names_.ours : *names_.theirs, path);
    const TreeValue after_own = find(text, own);
    std::string what = ours ? "ours: " : "theirs: ";
    const std::vector<Rename>& held = ours ? names_.held_of_ours : names_.held_of_theirs;
    const auto rename = std::find_if(held.begin(), held.end(), [&](const Rename& each) {
        const std::string& name = after ? each.to : each.from;
        return !before != !after && own == Path{each.list, name};
    });
    if (rename != held.end()) {
        what += fmt::format("renames '{}.{}' to '{}'", rename->list, rename->from, rename->to);
        return {std::move(what), place_in(text, {rename->list, rename->to})};
    }
    if (!after) {
        what += fmt::format("removes '{}'", to_string(own));
    } else if (!before) {
        what += fmt::format("adds '{}': {}", to_string(own), one_line(after_own ? after_own : after));
    } else if (is_same(before, after)) {
        what += fmt::format("keeps '{}'", to_string(own));
    } else {
        // The first change inside of it. For a whole node, this is the change that a reader would search for.
        std::vector<TreeChange> changes;
        std::copy_if(changes_of(side).begin(), changes_of(side).end(), std::back_inserter(changes),
                     [&](const TreeChange& change) { return starts_with(change.path, path); });
        if (!changes.empty() && changes.front().path != path) {
            Did first = did(side, changes.front().path);
            if (changes.size() > 1)
                first.what += fmt::format(", and {} more in '{}'", changes.size() - 1, to_string(own));
            return first;
        }
        what += fmt::format("changes '{}' from {} to {}", to_string(own), one_line(before),
                            one_line(after_own ? after_own : after));
    }
    return {std::move(what), place_in(text, own)};
}

const std::vector<TreeChange>& ConflictReport::changes_of(Side side) const {
    std::optional<std::vector<TreeChange>>& changes = side == Side::Ours ? by_ours_ : by_theirs_;
    if (!changes) changes = find_changes(*names_.base, side == Side::Ours ? *names_.ours : *names_.theirs);
    return *changes;
}

void ConflictReport::add(std::string message, const std::vector<Did>& all) {
    Diagnostic& diagnostic = diagnostics_.emplace_back(
        diagnostic_at(all.front().place, std::string(code_of(Complaint::MergeConflict)), std::move(message)));
    for (const Did& did : all) diagnostic.notes.push_back(note_at(did.place, did.what));
}

void ConflictReport::add_some(Side side, const std::vector<TreeChange>& changes, std::vector<Did>& all) const {
    constexpr std::size_t kMost = 4;
    for (std::size_t i = 0; i < std::min(changes.size(), kMost); ++i) all.push_back(did(side, changes[i].path));
}

void ConflictReport::both_renamed(const NameConflict& conflict) {
    const auto did = [&](const GraphText& text, const char* side, const std::string& name) {
        return Did{fmt::format("{}: calls it '{}'", side, name), place_in(text, {conflict.list, name})};
    };
    add(fmt::format("both sides rename '{}.{}'", conflict.list, conflict.from),
        {did(*original_.ours, "ours", conflict.ours), did(*original_.theirs, "theirs", conflict.theirs)});
}

void ConflictReport::renamed_and_removed(const LostName& lost) {
    const bool ours = lost.renamed_by == Side::Ours;
    const GraphText& renaming = ours ? *original_.ours : *original_.theirs;
    const GraphText& removing = ours ? *original_.theirs : *original_.ours;
    const char *by = ours ? "ours" : "theirs", *other = ours ? "theirs" : "ours";
    std::vector<Did> all = {
        {fmt::format("{}: calls it '{}'", by, lost.to), place_in(renaming, {lost.list, lost.to})},
        {fmt::format("{}: removes '{}.{}'", other, lost.list, lost.from), place_in(removing, {lost.list, lost.from})}};
    if (!ours) std::swap(all[0], all[1]);
    add(fmt::format("{} renames '{}.{}', which {} removes", by, lost.list, lost.from, other), all);
}

void ConflictReport::reused(const Reuse& reuse) {
    std::vector<Did> all;
    for (const Side side : {Side::Ours, Side::Theirs}) {
        const bool ours = side == Side::Ours;
        std::vector<Rename> renames = (ours ? names_.reused_by_ours : names_.reused_by_theirs).moves;
        const std::vector<Rename>& held = ours ? names_.held_of_ours : names_.held_of_theirs;
        renames.insert(renames.end(), held.begin(), held.end());
        const std::size_t before = all.size();
        for (const Rename& rename : renames) {
            if (rename.list != reuse.list || (rename.from != reuse.name && rename.to != reuse.name)) continue;
            all.push_back({fmt::format("{}: renames '{}.{}' to '{}'", ours ? "ours" : "theirs", rename.list,
                                       rename.from, rename.to),
                           place_in(ours ? *original_.ours : *original_.theirs, {rename.list, rename.to})});
        }
        if (all.size() == before) add_some(side, ours ? reuse.ours : reuse.theirs, all);
    }
    const bool ours = reuse.by == Side::Ours;
    const char *by = ours ? "ours" : "theirs", *other = ours ? "theirs" : "ours";
    const std::string name = fmt::format("{}.{}", reuse.list, reuse.name);
    std::string message = fmt::format("'{}' names another thing in {}, and {} uses the name", name, by, other);
    if (reuse.lacks_other) {
        message = fmt::format("{} renames '{}', which {} removes or renames", by, name, other);
    } else if (reuse.lacks_by) {
        message = fmt::format("{} renames '{}' to the old name of another thing, and {} uses it", by, name, other);
    }
    add(std::move(message), all);
}

void ConflictReport::conflict(const TreeConflict& conflict) {
    const std::string name = to_string(conflict.path);
    std::string message;
    switch (conflict.kind) {
        case TreeConflict::Kind::BothChanged: message = fmt::format("both sides change '{}'", name); break;
        case TreeConflict::Kind::BothAdded: message = fmt::format("both sides add '{}'", name); break;
        case TreeConflict::Kind::OursRemoved:
            message = fmt::format("ours removes '{}', which theirs changes", name);
            break;
        case TreeConflict::Kind::TheirsRemoved:
            message = fmt::format("theirs removes '{}', which ours changes", name);
            break;
        case TreeConflict::Kind::BothReordered:
            message = fmt::format("both sides put '{}' into another order", name);
            break;
    }
    std::vector<Did> all = {did(Side::Ours, conflict.path), did(Side::Theirs, conflict.path)};
    const Side adding = conflict.kind == TreeConflict::Kind::OursRemoved ? Side::Ours : Side::Theirs;
    for (const Path& added : conflict.added) all.push_back(did(adding, added));
    add(std::move(message), all);
}

void ConflictReport::clash(const Diagnostic& error, const std::vector<TreeChange>& ours,
                           const std::vector<TreeChange>& theirs) {
    std::vector<Did> all;
    add_some(Side::Ours, ours, all);
    add_some(Side::Theirs, theirs, all);
    if (all.empty()) all.push_back({"", place_in(*original_.ours, {})});
    add(fmt::format("with the changes of both sides, {}", error.message), all);
}

}  // namespace patina::edit
