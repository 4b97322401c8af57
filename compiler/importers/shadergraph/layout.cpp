// What a reader sees of the graph beside its values: the order of the nodes, groups, notes and positions; and the
// remark of each node.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// The word stands in the text by itself, not as "@uv" or "a.uv".
bool has_word(std::string_view text, std::string_view word) {
    for (std::size_t at = 0; (at = text.find(word, at)) != text.npos; ++at) {
        const char before = at > 0 ? text[at - 1] : ' ',
                   after = at + word.size() < text.size() ? text[at + word.size()] : ' ';
        if (!is_word(before) && before != '@' && before != '$' && before != '.' && !is_word(after) && after != '(')
            return true;
    }
    return false;
}

bool reads(const GraphFile& file, std::string_view word) {
    const auto in = [&](const std::vector<Member>& members) {
        return std::ranges::any_of(members, [&](const Member& each) { return has_word(each.value.json, word); });
    };
    return in(file.surface) || in(file.more) || std::ranges::any_of(file.nodes, [&](const GraphNode& each) {
               return has_word(each.expression, word) || in(each.inputs);
           });
}

Value place(double x, double y) {
    return list({number(std::round(x)), number(std::round(y))});
}

}  // namespace

void GraphMaker::make_layout() {
    for (const std::string_view each : {"uv1", "uv"})
        if (reads(file_, each))
            file_.nodes.insert(file_.nodes.begin(),
                               {.id = std::string(each),
                                .expression = fmt::format("float2(@{0}.x, 1 - @{0}.y)", each == "uv" ? "uv0" : "uv1"),
                                .more = {{"note", text("v counts from the bottom, as in the shader graph")}}});
    // Nodes of a group stay together, in the order in which the groups begin.
    std::vector<std::string> order;
    const auto group_of = [&](const GraphNode& each) {
        const auto owner = owners_.find(each.id);
        return owner == owners_.end() ? std::string() : node(owner->second).group;
    };
    const auto rank = [&](const GraphNode& each) {
        const std::string group = group_of(each);
        return group.empty() ? order.begin() : std::ranges::find(order, group);
    };
    order.push_back("");
    for (const GraphNode& each : file_.nodes)
        if (rank(each) == order.end()) order.push_back(group_of(each));
    std::ranges::stable_sort(file_.nodes, [&](const GraphNode& a, const GraphNode& b) { return rank(a) < rank(b); });

    std::vector<Member> positions, ui;
    std::map<std::string, std::string> members;
    for (GraphNode& each : file_.nodes) {
        const auto owner = owners_.find(each.id);
        if (owner == owners_.end()) continue;
        const Node& from = node(owner->second);
        positions.push_back({each.id, place(from.x, from.y)});
        if (from.group.empty()) continue;
        std::string& ids = members[from.group];
        const auto group = std::ranges::find(graph_.groups, from.group, &Group::id);
        if (ids.empty() && group != graph_.groups.end()) each.comment = group->title;
        ids += (ids.empty() ? "" : ", ") + text(each.id).json;
    }
    std::string groups, notes;
    for (const Group& group : graph_.groups) {
        const std::string part = fmt::format("group '{}'", group.title);
        if (members[group.id].empty()) {
            remark(Remark::Kind::Taken, part, "its nodes are parts of others", group.place);
            continue;
        }
        groups +=
            (groups.empty() ? "" : ", ") +
            object(std::vector<Member>{{"title", text(group.title)}, {"nodes", {"[" + members[group.id] + "]"}}}).json;
        remark(Remark::Kind::Taken, part, "'ui.groups', and a comment above its nodes", group.place);
    }
    for (const Note& note : graph_.notes) {
        notes += (notes.empty() ? "" : ", ") + object(std::vector<Member>{{"title", text(note.title)},
                                                                          {"text", text(note.text)},
                                                                          {"at", place(note.x, note.y)},
                                                                          {"size", place(note.width, note.height)}})
                                                   .json;
        remark(Remark::Kind::Taken, fmt::format("note '{}'", note.title), "'ui.notes'", note.place);
    }
    if (!positions.empty()) ui.push_back({"nodes", object(positions)});
    if (!groups.empty()) ui.push_back({"groups", {"[" + groups + "]"}});
    if (!notes.empty()) ui.push_back({"notes", {"[" + notes + "]"}});
    if (!ui.empty()) file_.more.push_back({"ui", object(ui)});
}

void GraphMaker::report_nodes() {
    std::vector<bool> is_read(graph_.nodes.size(), false), is_output(graph_.nodes.size(), false);
    for (const std::size_t each : order_) is_read[each] = true;
    for (const Block& block : graph_.blocks) is_output[block.node] = true;
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
        if (is_output[i]) continue;  // its inputs have remarks
        const Outcome& outcome = outcomes_[i];
        std::string what = !is_read[i] ? "nothing reads it" : outcome.where.empty() ? "its value" : outcome.where;
        if (!outcome.text.empty())
            what = outcome.kind == Remark::Kind::LeftOut ? outcome.text : what + ": " + outcome.text;
        if (is_read[i] && whole_of(node(i).json, "m_Precision") == 2 && outcome.kind == Remark::Kind::Taken &&
            !has_precision_.contains(i)) {
            remark(Remark::Kind::Changed, part_of(i), what + ": computed in float, not in half", node(i).place);
            continue;
        }
        remark(outcome.kind, part_of(i), std::move(what), node(i).place);
    }
}

std::string GraphMaker::part_of(std::size_t index) const {
    const Node& at = node(index);
    if (const Property* read = property(at.refers))
        return fmt::format("node '{}' ({})", at.name.empty() ? at.kind : at.name, read->name);
    return fmt::format("node '{}'", at.name.empty() ? at.kind : at.name);
}

}  // namespace patina::importers::shadergraph
