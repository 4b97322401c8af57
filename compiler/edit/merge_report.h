// Reports the conflicts of a merge: the changes of both sides, with the locations in their files.
//
//   ConflictReport report(original, names);
//   report.conflict({.kind = TreeConflict::Kind::BothChanged, .path = {"surface", "roughness"}});
#pragma once

#include <optional>

#include "compiler/edit/changes.h"
#include "compiler/edit/merge_names.h"
#include "compiler/edit/merge_trees.h"
#include "patina/patina.h"

namespace patina::edit {

// The three texts of a merge as they were given.
struct Sides {
    std::unique_ptr<GraphText> base, ours, theirs;
};

class ConflictReport {
public:
    // `names`: the texts of which the conflicts are.
    ConflictReport(const Sides& original, const SameNames& names) : original_(original), names_(names) {}

    void both_renamed(const NameConflict& conflict);
    void renamed_and_removed(const LostName& lost);
    // `by` gave a name to another thing, and the other side uses the name: what both did.
    struct Reuse {
        std::string list, name;
        Side by;
        // Which sides no longer have the name. `by` renamed the thing; the other side uses, renamed or removed it.
        bool lacks_by = false, lacks_other = false;
        std::vector<TreeChange> ours{}, theirs{};
    };
    void reused(const Reuse& reuse);
    void conflict(const TreeConflict& conflict);
    // Changes that do not go together.
    void clash(const Diagnostic& error, const std::vector<TreeChange>& ours, const std::vector<TreeChange>& theirs);

    const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

private:
    struct Did;
    Did did(Side side, const Path& path) const;
    void add(std::string message, const std::vector<Did>& all);
    void add_some(Side side, const std::vector<TreeChange>& changes, std::vector<Did>& all) const;
    const std::vector<TreeChange>& changes_of(Side side) const;

    const Sides& original_;
    const SameNames& names_;
    std::vector<Diagnostic> diagnostics_{};
    mutable std::optional<std::vector<TreeChange>> by_ours_{}, by_theirs_{};  // found when first needed
};

// A value on one line, for messages; a long one is cut.
std::string one_line(const TreeValue& value);

}  // namespace patina::edit
