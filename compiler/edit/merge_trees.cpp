#include "compiler/edit/merge_trees.h"

#include <unordered_map>

#include "compiler/base/file_names.h"
#include "compiler/edit/changes.h"
#include "compiler/edit/text_edits.h"

namespace patina::edit {
namespace {

using Kind = TreeConflict::Kind;

// One value as the three texts have it; each may be absent.
struct Three {
    TreeValue base{}, ours{}, theirs{};
};

// The children of one value in the three texts, by name.
class Children {
public:
    explicit Children(const Three& parent)
        : base_(list(parent.base)), ours_(list(parent.ours)), theirs_(list(parent.theirs)) {
        for (const TreeChild& child : base_) by_name_[child.name].base = child.value;
        for (std::size_t i = 0; i < ours_.size(); ++i) {
            by_name_[ours_[i].name].ours = ours_[i].value;
            index_.emplace(ours_[i].name, i);
        }
        for (const TreeChild& child : theirs_) by_name_[child.name].theirs = child.value;
    }

    const std::vector<TreeChild>& ours() const { return ours_; }
    const std::vector<TreeChild>& theirs() const { return theirs_; }
    const Three& operator[](const std::string& name) const { return by_name_.at(name); }

    // For each child that OURS lacks: the index of the child of OURS that it follows. What OURS itself added behind
    // that comes first.
    std::size_t last_of_ours(const std::string& name) const {
        std::size_t i = index_.at(name);
        while (i + 1 < ours_.size()) {
            const Three& next = by_name_.at(ours_[i + 1].name);
            if (next.base || next.theirs) break;
            ++i;
        }
        return i;
    }

private:
    static std::vector<TreeChild> list(const TreeValue& value) {
        return value ? children_of(value) : std::vector<TreeChild>();
    }

    std::vector<TreeChild> base_, ours_, theirs_;
    std::unordered_map<std::string, Three> by_name_{};
    std::unordered_map<std::string, std::size_t> index_{};
};

class Merge {
public:
    Merge(const MergeWish& wish, const SourceMap& ours, std::vector<TreeConflict>& conflicts)
        : wish_(wish), sources_(ours), conflicts_(conflicts) {}

    std::vector<TextEdit> edits{};

    void merge(const Three& values) {
        const auto& [base, ours, theirs] = values;
        if (wish_.decided.count(path_)) return take(values);
        if (is_same(ours, theirs) || (base && is_same(base, theirs) && !takes_theirs_below())) return;
        if (may_merge_children(values)) {
            merge_children(values);
        } else if (base && is_same(base, ours)) {
            replace_value(sources_, *ours.json, {*theirs.json, theirs.text->sources}, edits);
        } else {
            conflict(base ? Kind::BothChanged : Kind::BothAdded, values);
        }
    }

private:
    // What THEIRS did not change is decided for its side all the same: a change of OURS is undone.
    bool takes_theirs_below() const {
        if (wish_.prefer == Side::Ours) return false;
        const auto next = wish_.decided.lower_bound(path_);
        return next != wish_.decided.end() && starts_with(*next, path_);
    }

    static bool may_merge_children(const Three& values) {
        const Shape shape = shape_of(values.ours);
        if (shape == Shape::Whole || shape != shape_of(values.theirs) || values.ours.kind != values.theirs.kind)
            return false;
        // A node that both sides added is one thing.
        if (!values.base && shape == Shape::ByKey && !format::identity_of(values.ours.kind).empty()) return false;
        if (shape != Shape::ByPosition) return true;
        if (!values.base || shape_of(values.base) != shape) return false;
        const std::size_t count = values.base.json->elements.size();
        const bool same_count =
            values.ours.json->elements.size() == count && values.theirs.json->elements.size() == count;
        return same_count || is_same(values.base, values.ours);
    }

    void merge_children(const Three& values) {
        Three parents = values;
        if (parents.base &&
            (shape_of(parents.base) != shape_of(parents.ours) || parents.base.kind != parents.ours.kind))
            parents.base = {};
        const Children children(parents);
        const Replaced replaced = find_replaced(*values.ours.text, children);
        ChildEdits changes;
        for (std::size_t i = 0; i < children.ours().size(); ++i) {
            path_.push_back(children.ours()[i].name);
            if (merge_child_of_ours(children[path_.back()], replaced)) changes.removed.push_back(i);
            path_.pop_back();
        }
        std::size_t after = NewChild::kFirst;
        for (const TreeChild& child : children.theirs()) {
            const Three& each = children[child.name];
            if (each.ours) {
                after = children.last_of_ours(child.name);
                continue;
            }
            path_.push_back(child.name);
            if (takes_child_of_theirs(each, replaced))
                changes.added.push_back({after, child.name, {*child.value.json, child.value.text->sources}});
            path_.pop_back();
        }
        if (!changes.removed.empty() || !changes.added.empty())
            edit_children(sources_, *values.ours.json, changes, edits);
    }

    // One side replaced inputs that the other side changed. A node's file may have renamed its inputs, and takes either
    // the old ones or the new ones.
    struct Replaced {
        std::vector<Path> by_ours{}, by_theirs{};
    };

    Replaced find_replaced(const GraphText& ours, const Children& children) const {
        if (path_.size() != 3 || path_[0] != "nodes" || path_[2] != "in") return {};
        const TreeValue type = find(ours, {path_[0], path_[1], "node"});
        if (!type || type.json->kind != json::Json::Kind::String || !is_file_name(type.json->string)) return {};
        const auto below = [&](const TreeChild& child) {
            Path path = path_;
            path.push_back(child.name);
            return path;
        };
        Replaced replaced;
        bool ours_replaces = false, theirs_replaces = false;
        for (const TreeChild& child : children.ours()) {
            const Three& each = children[child.name];
            theirs_replaces |= each.base && !each.theirs && !is_same(each.base, each.ours);
            if (!each.base && !each.theirs) replaced.by_ours.push_back(below(child));
        }
        for (const TreeChild& child : children.theirs()) {
            const Three& each = children[child.name];
            ours_replaces |= each.base && !each.ours && !is_same(each.base, each.theirs);
            if (!each.base && !each.ours) replaced.by_theirs.push_back(below(child));
        }
        if (!ours_replaces) replaced.by_ours.clear();
        if (!theirs_replaces) replaced.by_theirs.clear();
        return replaced;
    }

    // True: it is removed.
    bool merge_child_of_ours(const Three& each, const Replaced& replaced) {
        if (each.theirs) {
            merge(each);
            return false;
        }
        if (wish_.decided.count(path_)) return wish_.prefer == Side::Theirs;
        if (!each.base) return wish_.prefer == Side::Theirs && !replaced.by_ours.empty();
        if (is_same(each.base, each.ours)) return true;
        return note(Kind::TheirsRemoved, replaced.by_theirs) && wish_.prefer == Side::Theirs;
    }

    bool takes_child_of_theirs(const Three& each, const Replaced& replaced) {
        if (wish_.decided.count(path_)) return wish_.prefer == Side::Theirs;
        if (!each.base) return wish_.prefer == Side::Theirs || replaced.by_theirs.empty();
        if (is_same(each.base, each.theirs)) return false;
        return note(Kind::OursRemoved, replaced.by_ours) && wish_.prefer == Side::Theirs;
    }

    // False: it is no matter of the graph.
    bool note(Kind kind, const std::vector<Path>& added) {
        if (path_.front() == "ui") return false;
        conflicts_.push_back({.kind = kind, .path = path_, .added = added});
        return true;
    }

    void conflict(Kind kind, const Three& values) {
        if ((path_.empty() || path_.front() != "ui")) {
            conflicts_.push_back({.kind = kind, .path = path_});
            take(values);
        }
    }

    void take(const Three& values) {
        if (wish_.prefer == Side::Theirs && !is_same(values.ours, values.theirs))
            replace_value(sources_, *values.ours.json, {*values.theirs.json, values.theirs.text->sources}, edits);
    }

    const MergeWish& wish_;
    const SourceMap& sources_;
    std::vector<TreeConflict>& conflicts_;
    Path path_{};
};

// --- order

// The names of a list that two others have, too.
std::vector<std::string> common_names(const TreeValue& list, const TreeValue& a, const TreeValue& b) {
    std::set<std::string> in_a, in_b;
    for (TreeChild& child : children_of(a)) in_a.insert(std::move(child.name));
    for (TreeChild& child : children_of(b)) in_b.insert(std::move(child.name));
    std::vector<std::string> names;
    for (TreeChild& child : children_of(list)) {
        if (in_a.count(child.name) && in_b.count(child.name)) names.push_back(std::move(child.name));
    }
    return names;
}

// The lists whose order THEIRS changed.
void find_order(Path path, const Three& values, const MergeWish& wish, std::vector<TextEdit>& edits,
                std::vector<TreeConflict>& conflicts) {
    const auto& [base, ours, theirs] = values;
    if (!ours || !theirs || shape_of(ours) != shape_of(theirs)) return;
    if (shape_of(ours) == Shape::ByName && format::is_ordered(ours.kind)) {
        const std::vector<std::size_t> order = order_like(ours, theirs);
        if (is_in_order(order)) return;
        std::vector<std::string> before;
        if (base && shape_of(base) == Shape::ByName) before = common_names(base, ours, theirs);
        const bool ours_moved = !base || common_names(ours, base, theirs) != before;
        const bool theirs_moved = !base || common_names(theirs, base, ours) != before;
        const bool is_decided = wish.decided.count(path) != 0;
        if (ours_moved && theirs_moved && !is_decided) conflicts.push_back({.kind = Kind::BothReordered, .path = path});
        const bool takes = (ours_moved && theirs_moved) || is_decided ? wish.prefer == Side::Theirs : theirs_moved;
        if (takes) reorder_children(ours.text->sources, *ours.json, order, edits);
        return;
    }
    if (shape_of(ours) != Shape::ByKey) return;
    const Children children({base && shape_of(base) == Shape::ByKey ? base : TreeValue{}, ours, theirs});
    for (const TreeChild& child : children.ours()) {
        Path of_child = path;
        of_child.push_back(child.name);
        find_order(std::move(of_child), children[child.name], wish, edits, conflicts);
    }
}

}  // namespace

MergedTrees merge_trees(const GraphText& base, const GraphText& ours, const GraphText& theirs, const MergeWish& wish) {
    MergedTrees merged;
    // The order comes first, so that a child that moves can also change.
    std::vector<TextEdit> moves;
    find_order({}, {base.root(), ours.root(), theirs.root()}, wish, moves, merged.conflicts);
    std::unique_ptr<GraphText> moved;
    if (!moves.empty()) {
        moved = read_graph_text(std::string(ours.sources.file(ours.base)),
                                apply(ours.sources, ours.base, std::move(moves)));
    }
    const GraphText& from = moved ? *moved : ours;
    Merge merge(wish, from.sources, merged.conflicts);
    merge.merge({base.root(), from.root(), theirs.root()});
    merged.text = apply(from.sources, from.base, std::move(merge.edits));
    return merged;
}

}  // namespace patina::edit
