#include "compiler/edit/merge_texts.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>

#include "compiler/edit/blame.h"
#include "compiler/edit/merge_comments.h"
#include "compiler/edit/merge_names.h"
#include "compiler/edit/merge_trees.h"
#include "compiler/edit/name_clashes.h"
#include "compiler/format/canonical_form.h"
#include "compiler/format/read_graph.h"
#include "patina/text_diff.h"

namespace patina::edit {
namespace {

// --- canonical form

std::string formatted(const std::string& text) {
    SourceMap sources;
    Diagnostics diagnostics;
    return format::format_graph(sources, sources.add("", text), diagnostics).text;
}

// --- markers

std::string with_markers(std::string_view ours, std::string_view theirs, const MergeOptions& options) {
    std::string made, mine, other;
    const auto marker = [&](char c, const std::string& label) {
        made.append(options.marker_size, c);
        if (!label.empty()) made += ' ' + label;
        made += '\n';
    };
    const auto flush = [&] {
        if (mine.empty() && other.empty()) return;
        marker('<', options.ours_label);
        made += mine;
        marker('=', "");
        made += other;
        marker('>', options.theirs_label);
        mine.clear();
        other.clear();
    };
    for (const DiffLine& line : all_lines(ours, theirs)) {
        if (line.kind == DiffLine::Kind::Same) {
            flush();
            made += line.text + '\n';
        } else {
            (line.kind == DiffLine::Kind::Removed ? mine : other) += line.text + '\n';
        }
    }
    flush();
    return made;
}

// --- errors

auto key_of(const Diagnostic& error) {
    return std::tie(error.code, error.message, error.node, error.port);
}

bool holds(const std::vector<Diagnostic>& errors, const Diagnostic& error) {
    return std::any_of(errors.begin(), errors.end(),
                       [&](const Diagnostic& each) { return key_of(each) == key_of(error); });
}

// --- the merge

class Merging {
public:
    Merging(const SameNames& names, const std::string& path, const MergeCheck& check, ConflictReport& report)
        : names_(names), path_(path), check_(check), report_(report) {
        by_ours_ = find_changes(*names_.base, *names_.ours);
        by_theirs_ = find_changes(*names_.base, *names_.theirs);
        for (const LostName& lost : names_.lost) clashing_.insert({lost.list, lost.to});
        find_reuses(Side::Ours, names_.reused_by_ours);
        find_reuses(Side::Theirs, names_.reused_by_theirs);
        add_readers(names_, {by_ours_, by_theirs_}, clashing_);
    }

    // The text in which conflicts have the side of OURS, and the errors that no side has alone. Reports all conflicts.
    std::string merge_for_ours() {
        MergeWish wish{.prefer = Side::Ours, .decided = clashing_};
        MergedTrees merged = merged_trees(wish);
        for (const NameConflict& conflict : names_.conflicts) report_.both_renamed(conflict);
        for (const LostName& lost : names_.lost) report_.renamed_and_removed(lost);
        for (const ConflictReport::Reuse& reuse : reuses_) report_.reused(reuse);
        for (const TreeConflict& conflict : merged.conflicts) {
            report_.conflict(conflict);
            if (conflict.path.size() == 2) clashing_.insert(conflict.path);
        }
        add_readers(names_, {by_ours_, by_theirs_}, clashing_);
        if (clashing_ != wish.decided) {
            wish.decided = clashing_;
            merged = merged_trees(wish);
        }
        return settle(std::move(merged.text), wish, by_theirs_, true);
    }

    // The text in which conflicts have the side of THEIRS.
    std::string merge_for_theirs() {
        MergeWish wish{.prefer = Side::Theirs, .decided = clashing_};
        MergedTrees merged = merged_trees(wish);
        std::string text = settle(std::move(merged.text), wish, by_ours_, false);
        std::vector<Rename> back;
        for (const NameConflict& conflict : names_.conflicts)
            back.push_back({conflict.list, conflict.ours, conflict.theirs});
        if (back.empty()) return text;
        const std::unique_ptr<GraphText> read = read_graph_text(path_, std::move(text));
        return apply(read->sources, read->base, rename_edits(*read, back));
    }

    // Errors of a text that a side has alone, too.
    const std::vector<Diagnostic>& old_errors() const { return old_errors_; }

private:
    // If one side uses a name for another thing, and the other side reads the name or changes the old thing, then these
    // changes conflict.
    void find_reuses(Side by, const ReusedNames& reused) {
        const bool ours = by == Side::Ours;
        const GraphText &side = ours ? *names_.ours : *names_.theirs, &other = ours ? *names_.theirs : *names_.ours;
        bool is_used = false;
        for (const auto& [as, name] : reused.all) {
            // For each remaining name: both sides renamed the thing, or one side removed it, or both sides took the
            // same new name, or only this side renamed it.
            const std::string in_base = list_of(*names_.base->graph, {as, name});
            const std::string in_other = list_of(*other.graph, {as, name});
            const bool is_taken = reused.taken.count({as, name}) != 0;
            if (!is_taken && in_base.empty() && in_other.empty()) continue;
            const std::string& list = in_base.empty() ? in_other : in_base;
            ConflictReport::Reuse reuse{.list = list, .name = name, .by = by};
            if (!is_taken && !in_base.empty()) reuse.lacks_by = true, reuse.lacks_other = in_other.empty();
            const std::set<Name> names{{as, name}};
            std::vector<TreeChange>& uses = ours ? reuse.theirs : reuse.ours;
            uses = changes_about(ours ? by_theirs_ : by_ours_, names, {other.graph.get()});
            if (uses.empty()) continue;
            is_used = true;
            for (const TreeChange& change : uses) clashing_.insert(change.path);
            (ours ? reuse.ours : reuse.theirs) =
                changes_about(ours ? by_ours_ : by_theirs_, names, {names_.base->graph.get(), side.graph.get()});
            reuses_.push_back(std::move(reuse));
        }
        if (!is_used) return;
        const std::set<Name> all(reused.all.begin(), reused.all.end());
        const std::vector<TreeChange>& changes = ours ? by_ours_ : by_theirs_;
        for (const TreeChange& change : changes_about(changes, all, {names_.base->graph.get(), side.graph.get()}))
            clashing_.insert(change.path);
        for (const TreeChange& change : changes) {
            if (!change.is_order) continue;
            const bool is_theirs = std::any_of(reused.moves.begin(), reused.moves.end(),
                                               [&](const Rename& move) { return Path{move.list} == change.path; });
            if (is_theirs) clashing_.insert(change.path);
        }
    }

    // Withdraws changes of one side, until the text has no error that the other side does not have alone.
    std::string settle(std::string text, MergeWish& wish, const std::vector<TreeChange>& changes, bool reports) {
        std::vector<Diagnostic> errors = new_errors(text);
        for (std::size_t round = 0; !errors.empty() && round <= changes.size(); ++round) {
            const std::unique_ptr<GraphText> merged = read_graph_text(path_, text);
            const GraphText* others[] = {names_.base.get(), names_.ours.get(), names_.theirs.get()};
            const MergeError where{errors.front(), *merged, others};
            std::vector<std::size_t> withdrawn = suspects_of(where, changes, wish);
            if (withdrawn.empty()) break;
            if (round == kMostRounds) {  // one by one would take too long
                withdrawn.resize(changes.size());
                std::iota(withdrawn.begin(), withdrawn.end(), std::size_t{0});
            }
            if (reports && !follows_from_withdrawn(where, wish)) {
                const std::vector<std::size_t> others_changes = suspects_of(where, by_ours_, {.prefer = Side::Theirs});
                report_.clash(errors.front(), pick(by_ours_, others_changes), pick(by_theirs_, withdrawn));
                for (const std::size_t i : others_changes) clashing_.insert(by_ours_[i].path);
            }
            for (const std::size_t i : withdrawn) {
                wish.decided.insert(changes[i].path);
                if (reports) clashing_.insert(changes[i].path);
            }
            text = merged_trees(wish).text;
            errors = new_errors(text);
        }
        return text;
    }

    // The changes that are nearest to the error and, without which it would not be there. If none alone is enough, all
    // that are nearest.
    std::vector<std::size_t> suspects_of(const MergeError& where, const std::vector<TreeChange>& changes,
                                         const MergeWish& wish) {
        for (std::vector<std::size_t>& nearest : find_suspects(where, changes)) {
            const auto is_decided = [&](std::size_t i) { return wish.decided.count(changes[i].path) != 0; };
            nearest.erase(std::remove_if(nearest.begin(), nearest.end(), is_decided), nearest.end());
            if (nearest.empty()) continue;
            if (nearest.size() == 1) return with_thing_of(nearest.front(), changes);
            if (nearest.size() > kMostTries) return nearest;
            for (const std::size_t i : nearest) {
                const std::vector<std::size_t> group = with_thing_of(i, changes);
                MergeWish without = wish;
                for (const std::size_t each : group) without.decided.insert(changes[each].path);
                const MergedTrees merged = merged_trees(without);
                if (!holds(check_(merged.text), where.error)) return group;
            }
            return nearest;
        }
        return {};
    }

    // The keys of one node or property belong together: another type comes with other ports, or another default.
    static std::vector<std::size_t> with_thing_of(std::size_t change, const std::vector<TreeChange>& changes) {
        const Path& path = changes[change].path;
        if (path.size() != 3) return {change};
        const Path thing(path.begin(), path.begin() + 2);
        std::vector<std::size_t> group;
        for (std::size_t i = 0; i < changes.size(); ++i) {
            if (starts_with(changes[i].path, thing)) group.push_back(i);
        }
        return group;
    }

    // True if the error is about something that THEIRS brought and that has been withdrawn.
    bool follows_from_withdrawn(const MergeError& where, const MergeWish& wish) const {
        std::vector<TreeChange> changes = by_ours_;
        std::copy_if(by_theirs_.begin(), by_theirs_.end(), std::back_inserter(changes),
                     [&](const TreeChange& change) { return wish.decided.count(change.path) != 0; });
        if (changes.size() == by_ours_.size()) return false;
        const std::vector<std::size_t> nearest = find_suspects(where, changes).front();
        return std::none_of(nearest.begin(), nearest.end(), [&](std::size_t i) { return i < by_ours_.size(); });
    }

    MergedTrees merged_trees(const MergeWish& wish) const {
        return merge_trees(*names_.base, *names_.ours, *names_.theirs, wish);
    }

    static std::vector<TreeChange> pick(const std::vector<TreeChange>& changes, const std::vector<std::size_t>& which) {
        std::vector<TreeChange> picked;
        for (const std::size_t i : which) picked.push_back(changes[i]);
        return picked;
    }

    std::vector<Diagnostic> new_errors(const std::string& text) {
        std::vector<Diagnostic> errors = check_(text);
        old_errors_.clear();
        if (errors.empty()) return errors;
        if (!has_side_errors_) {
            has_side_errors_ = true;
            side_errors_ = check_(std::string(names_.ours->all()));
            const std::vector<Diagnostic> of_theirs = check_(std::string(names_.theirs->all()));
            side_errors_.insert(side_errors_.end(), of_theirs.begin(), of_theirs.end());
        }
        const auto is_old = [&](const Diagnostic& error) { return holds(side_errors_, error); };
        std::copy_if(errors.begin(), errors.end(), std::back_inserter(old_errors_), is_old);
        errors.erase(std::remove_if(errors.begin(), errors.end(), is_old), errors.end());
        return errors;
    }

    static constexpr std::size_t kMostTries = 32, kMostRounds = 64;

    const SameNames& names_;
    const std::string& path_;  // of the result, in the errors of the check
    const MergeCheck& check_;
    ConflictReport& report_;
    std::vector<TreeChange> by_ours_{}, by_theirs_{};
    std::vector<ConflictReport::Reuse> reuses_{};
    std::set<Path> clashing_{};  // changes of both sides that do not go together
    bool has_side_errors_ = false;
    std::vector<Diagnostic> side_errors_{}, old_errors_{};
};

// A side alone may lack another file, or have another version of it: while one file is merged, the others may not be.
bool may_lie_in_other_file(const Diagnostic& error, const GraphText& ours, const GraphText& theirs) {
    if (error.code == info(Code::MissingFile).name) return true;
    const auto is_file = [&](const GraphText& text) {
        if (!text.graph) return false;
        const auto node = std::find_if(text.graph->nodes.begin(), text.graph->nodes.end(),
                                       [&](const format::Node& each) { return each.id == error.node; });
        return node != text.graph->nodes.end() && node->type.find('/') != std::string::npos;
    };
    return is_file(ours) || is_file(theirs);
}

// A merge whose sides have errors of their own.
MergeState add_old_errors(const std::vector<Diagnostic>& errors, const Sides& original, MergeResult& result) {
    MergeState state = MergeState::Clean;
    for (Diagnostic error : errors) {
        Diagnostic note;
        note.severity = Severity::Note;
        if (may_lie_in_other_file(error, *original.ours, *original.theirs)) {
            error.severity = Severity::Warning;
            note.message = "a side alone has this error, too: run 'patina check' when the other files are merged";
        } else {
            state = MergeState::Conflicts;
            note.message = "a side alone has this error, too: both sides are merged, and this is left to repair";
        }
        error.notes.push_back(std::move(note));
        result.diagnostics.push_back(std::move(error));
    }
    return state;
}

// --- comments

// Says so if THEIRS wrote comments that the merge does not have.
void add_lost_comments(const Sides& original, const std::string& merged, MergeResult& result) {
    const std::vector<std::pair<std::string, Span>> lost = lost_comments(*original.base, *original.theirs, merged);
    if (lost.empty()) return;
    const Span place{lost.front().second.begin, lost.front().second.begin + 1};
    Diagnostic note =
        diagnostic_at(format::place_of(original.theirs->sources, place), {},
                      fmt::format("the merge keeps the comments of ours, and lacks {} of theirs: {}", lost.size(),
                                  json::shown(lost.front().first) + (lost.size() > 1 ? ", ..." : "")));
    note.severity = Severity::Note;
    result.diagnostics.push_back(std::move(note));
}

std::unique_ptr<GraphText> copy_of(const GraphText& text) {
    std::unique_ptr<GraphText> copy =
        read_graph_text(std::string(text.sources.file(text.base)), std::string(text.all()));
    copy->kind = text.kind;
    return copy;
}

}  // namespace

MergeResult take_text(const Sides& original, const std::string& text, const MergeCheck& check) {
    MergeResult result{.state = MergeState::Clean, .text = text};
    const std::vector<Diagnostic> errors = check(text);
    if (!errors.empty()) result.state = add_old_errors(errors, original, result);
    return result;
}

MergeResult merge_texts(const Sides& original, const MergeOptions& options, const MergeCheck& check) {
    // The originals stay as they are, because messages show them.
    const SameNames names = unify_names(copy_of(*original.base), copy_of(*original.ours), copy_of(*original.theirs));
    ConflictReport report(original, names);
    Merging merging(names, options.path, check, report);
    const std::string our_text(original.ours->all());
    const bool is_canonical = formatted(our_text) == our_text;
    const auto finished = [&](std::string text) {
        text = with_comments(names, std::move(text));
        return is_canonical ? formatted(text) : text;
    };

    const std::string merged = finished(merging.merge_for_ours());
    MergeResult result{.state = MergeState::Clean, .text = merged};
    const std::vector<Diagnostic> old_errors = merging.old_errors();
    result.diagnostics = report.diagnostics();
    if (!result.diagnostics.empty()) {
        result.state = MergeState::Conflicts;
        result.text = with_markers(result.text, finished(merging.merge_for_theirs()), options);
    } else if (!old_errors.empty()) {
        result.state = add_old_errors(old_errors, original, result);
    }
    add_lost_comments(original, merged, result);
    return result;
}

}  // namespace patina::edit
