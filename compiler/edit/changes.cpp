#include "compiler/edit/changes.h"

#include <algorithm>
#include <unordered_map>

namespace patina::edit {
namespace {

class Comparison {
public:
    explicit Comparison(std::vector<TreeChange>& changes) : changes_(changes) {}

    void compare(const TreeValue& before, const TreeValue& after) {
        if (is_same(before, after)) return;
        const Shape shape = shape_of(before);
        if (shape == Shape::Whole || shape != shape_of(after) || before.kind != after.kind) {
            changes_.push_back({path_, before, after});
        } else if (shape == Shape::ByPosition) {
            compare_positions(children_of(before), children_of(after));
        } else {
            compare_names(before, after);
        }
    }

private:
    void compare_names(const TreeValue& before, const TreeValue& after) {
        std::unordered_map<std::string, TreeValue> old_values, new_values;
        for (TreeChild& child : children_of(before)) old_values.emplace(child.name, child.value);
        for (TreeChild& child : children_of(after)) new_values.emplace(child.name, child.value);
        for (const TreeChild& child : children_of(before)) {
            const auto other = new_values.find(child.name);
            visit(child.name, child.value, other == new_values.end() ? TreeValue{} : other->second);
        }
        for (const TreeChild& child : children_of(after)) {
            if (old_values.find(child.name) == old_values.end()) visit(child.name, {}, child.value);
        }
        if (shape_of(before) == Shape::ByName && format::is_ordered(before.kind) &&
            !is_in_order(order_like(before, after)))
            changes_.push_back({path_, before, after, true});
    }

    // Equal children at the beginning and at the end are the same ones.
    void compare_positions(const std::vector<TreeChild>& before, const std::vector<TreeChild>& after) {
        std::size_t begin = 0, old_end = before.size(), new_end = after.size();
        while (begin < std::min(old_end, new_end) && is_same(before[begin].value, after[begin].value)) ++begin;
        while (old_end > begin && new_end > begin && is_same(before[old_end - 1].value, after[new_end - 1].value)) {
            --old_end;
            --new_end;
        }
        for (std::size_t i = begin; i < std::max(old_end, new_end); ++i) {
            visit(std::to_string(i), i < old_end ? before[i].value : TreeValue{},
                  i < new_end ? after[i].value : TreeValue{});
        }
    }

    void visit(const std::string& name, const TreeValue& before, const TreeValue& after) {
        if (path_.empty() && (name == "ui" || name == "$schema")) return;
        path_.push_back(name);
        if (before && after) {
            compare(before, after);
        } else {
            changes_.push_back({path_, before, after});
        }
        path_.pop_back();
    }

    Path path_{};
    std::vector<TreeChange>& changes_;
};

}  // namespace

std::vector<TreeChange> find_changes(const GraphText& before, const GraphText& after) {
    std::vector<TreeChange> changes;
    Comparison(changes).compare(before.root(), after.root());
    return changes;
}

std::vector<std::size_t> order_like(const TreeValue& value, const TreeValue& wanted) {
    const std::vector<TreeChild> children = children_of(value);
    std::unordered_map<std::string, std::size_t> index;
    for (std::size_t i = 0; i < children.size(); ++i) index.emplace(children[i].name, i);
    std::vector<std::size_t> common;  // in the wanted order
    std::vector<bool> is_common(children.size(), false);
    for (const TreeChild& child : children_of(wanted)) {
        const auto found = index.find(child.name);
        if (found == index.end()) continue;
        common.push_back(found->second);
        is_common[found->second] = true;
    }
    std::vector<std::size_t> order;
    std::size_t next = 0;
    for (std::size_t i = 0; i < children.size(); ++i) order.push_back(is_common[i] ? common[next++] : i);
    return order;
}

bool is_in_order(const std::vector<std::size_t>& order) {
    return std::is_sorted(order.begin(), order.end());
}

}  // namespace patina::edit
