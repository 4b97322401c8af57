// What a reader sees of the graph beside its values: the order of the nodes, groups, notes and positions; and the
// remark of each node.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/letters.h"
#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

// The names in an expression, which can be ids of nodes.
void add_names(const nodelang::Expr& expr, std::set<std::string, std::less<>>& into) {
    if (expr.kind == nodelang::Expr::Kind::Name) into.emplace(expr.text);
    for (const nodelang::Expr* const each : expr.args) add_names(*each, into);
}

void add_names(std::string_view expression, std::set<std::string, std::less<>>& into) {
    if (const terms::Tree tree = nodelang::parsed_tree(expression)) add_names(*tree, into);
}

// The same of values: links and expressions.
void add_value(const GraphValue& value, std::set<std::string, std::less<>>& into) {
    if (value.kind() == GraphValue::Kind::Text) {
        std::string_view text = value.text();
        if (text.starts_with('=')) text.remove_prefix(1);
        add_names(text, into);
    }
    for (const GraphValue& each : value.items()) add_value(each, into);
}

// The id of the node with texture coordinates of a set.
std::string uv_node(std::size_t set) {
    return set == 0 ? "uv" : fmt::format("uv{}", set);
}

GraphValue place(double x, double y) {
    return GraphValue::list({std::round(x), std::round(y)});
}

}  // namespace

// What nothing reads is no part of the graph. What refused nodes read is.
void GraphMaker::drop_unread() {
    std::map<std::string, const ImportedNode*, std::less<>> unread;
    for (const ImportedNode& each : file_.nodes) unread[each.id] = &each;
    std::set<std::string, std::less<>> names, known;
    for (const std::string& each : kept_) add_names(each, names);
    const auto add = [&](const GraphMembers& members) {
        for (const GraphMember& each : members) add_value(each.value, names);
    };
    for (const GraphMembers* each : {&file_.surface, &file_.vertex, &file_.outputs, &file_.more}) add(*each);
    for (const ImportedNode& each : file_.nodes)
        if (!each.more.empty() && each.more.front().key == "stage") names.insert(each.id);
    while (!names.empty()) {
        const std::string name = names.extract(names.begin()).value();
        if (!known.insert(name).second) continue;
        for (std::size_t set = 0; set < reads_uv_.size(); ++set) reads_uv_[set] |= name == uv_node(set);
        const auto found = unread.find(name);
        if (found == unread.end()) continue;
        add_names(found->second->expression, names);
        add(found->second->inputs);
        unread.erase(found);
    }
    for (const auto& [id, each] : unread) {
        for (const std::size_t owner : file_.owners[id])
            if (file_.outcomes[owner].kind != Remark::Kind::LeftOut) file_.outcomes[owner].where = "nothing reads it";
    }
    std::erase_if(file_.nodes, [&](const ImportedNode& each) { return unread.contains(each.id); });
}

void GraphMaker::make_layout() {
    for (std::size_t set = reads_uv_.size(); set-- > 0;)
        if (reads_uv_[set])
            file_.nodes.insert(file_.nodes.begin(),
                               {.id = uv_node(set),
                                .expression = fmt::format("float2(@uv{0}.x, 1 - @uv{0}.y)", set),
                                .more = {{"note", "v counts from the bottom, as in the shader graph"}}});
    // Nodes of a group stay together, in the order in which the groups begin.
    std::vector<std::string> order;
    const auto group_of = [&](const ImportedNode& each) {
        const auto owner = file_.owners.find(each.id);
        return owner == file_.owners.end() ? std::string() : node(*owner->second.begin()).group;
    };
    const auto rank = [&](const ImportedNode& each) {
        const std::string group = group_of(each);
        return group.empty() ? order.begin() : std::ranges::find(order, group);
    };
    order.push_back("");
    for (const ImportedNode& each : file_.nodes)
        if (rank(each) == order.end()) order.push_back(group_of(each));
    std::ranges::stable_sort(file_.nodes,
                             [&](const ImportedNode& a, const ImportedNode& b) { return rank(a) < rank(b); });

    GraphMembers positions, ui;
    std::map<std::string, std::vector<GraphValue>> members;
    for (ImportedNode& each : file_.nodes) {
        const auto owner = file_.owners.find(each.id);
        if (owner == file_.owners.end()) continue;
        const Node& from = node(*owner->second.begin());
        positions.push_back({each.id, place(from.x, from.y)});
        if (from.group.empty()) continue;
        std::vector<GraphValue>& ids = members[from.group];
        const auto group = std::ranges::find(graph_.groups, from.group, &Group::id);
        if (ids.empty() && group != graph_.groups.end())
            each.comment = group->title.empty() ? "(a group without a title)" : group->title;
        ids.emplace_back(each.id);
    }
    std::vector<GraphValue> groups, notes;
    for (const Group& group : graph_.groups) {
        const std::string part = fmt::format("group '{}'", group.title);
        if (members[group.id].empty()) {
            remark(Remark::Kind::Taken, part, "its nodes are parts of others", group.place);
            continue;
        }
        groups.push_back(
            GraphValue::object({{"title", group.title}, {"nodes", GraphValue::list(std::move(members[group.id]))}}));
        remark(Remark::Kind::Taken, part, "'ui.groups', and a comment above its nodes", group.place);
    }
    for (const Note& note : graph_.notes) {
        notes.push_back(GraphValue::object({{"title", note.title},
                                            {"text", note.text},
                                            {"at", place(note.x, note.y)},
                                            {"size", place(note.width, note.height)}}));
        remark(note.misread.empty() ? Remark::Kind::Taken : Remark::Kind::Changed, fmt::format("note '{}'", note.title),
               "'ui.notes'" + (note.misread.empty() ? "" : ": " + note.misread), note.place);
    }
    if (!positions.empty()) ui.push_back({"nodes", GraphValue::object(positions)});
    if (!groups.empty()) ui.push_back({"groups", GraphValue::list(std::move(groups))});
    if (!notes.empty()) ui.push_back({"notes", GraphValue::list(std::move(notes))});
    if (!ui.empty()) file_.more.push_back({"ui", GraphValue::object(ui)});
}

void GraphMaker::report_nodes() {
    std::vector<bool> is_read(graph_.nodes.size(), false), is_output(graph_.nodes.size(), false);
    for (const std::size_t each : order_) is_read[each] = true;
    for (const Block& block : graph_.blocks) is_output[block.node] = true;
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
        const ImportedGraph::Outcome& outcome = file_.outcomes[i];
        if (is_output[i] && outcome.text.empty()) continue;  // its inputs have remarks
        std::string what = !is_read[i] ? "nothing reads it" : outcome.where.empty() ? "its value" : outcome.where;
        if (!outcome.text.empty())
            what = outcome.kind == Remark::Kind::LeftOut || is_output[i] ? outcome.text : what + ": " + outcome.text;
        remark(outcome.kind, part_of(i), std::move(what), node(i).place);
    }
}

std::string GraphMaker::part_of(std::size_t index) const {
    const Node& at = node(index);
    if (!at.part.empty()) return at.part;
    if (const Property* read = property(at.refers))
        return fmt::format("node '{}' ({})", at.name.empty() ? at.kind : at.name, read->name);
    return fmt::format("node '{}'", at.name.empty() ? at.kind : at.name);
}

}  // namespace patina::importers::shadergraph
