// What a reader sees of the graph beside its values: the order of the nodes, groups, notes and positions; and the
// remark of each node.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/letters.h"
#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

// The words of a text that can be ids of nodes: not "@uv", "$_Tint", "a.uv", "uv(" or a key.
std::set<std::string_view> words_of(std::string_view text) {
    std::set<std::string_view> made;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && is_word_letter(text[end])) ++end;
        const char before = at > 0 ? text[at - 1] : ' ', after = end < text.size() ? text[end] : ' ';
        const bool is_key = text.substr(end).starts_with("\":");
        if (end > at && !is_key && before != '@' && before != '$' && before != '.' && after != '(')
            made.insert(text.substr(at, end - at));
        at = std::max(end, at + 1);
    }
    return made;
}

// The id of the node with texture coordinates of a set.
std::string uv_node(std::size_t set) {
    return set == 0 ? "uv" : fmt::format("uv{}", set);
}

Value place(double x, double y) {
    return list({number(std::round(x)), number(std::round(y))});
}

}  // namespace

// What nothing reads is no part of the graph. What refused nodes read is.
void GraphMaker::drop_unread() {
    std::map<std::string, const GraphNode*, std::less<>> unread;
    for (const GraphNode& each : file_.nodes) unread[each.id] = &each;
    std::vector<std::string_view> texts;
    const auto add = [&](const std::vector<Member>& members) {
        for (const Member& each : members)
            if (each.key != "inputs") texts.push_back(each.value.json);
    };
    texts.assign(kept_.begin(), kept_.end());
    add(file_.surface);
    add(file_.more);
    for (const GraphNode& each : file_.nodes)
        if (!each.more.empty() && each.more.front().key == "stage") texts.push_back(each.id);
    while (!texts.empty()) {
        const std::set<std::string_view> words = words_of(texts.back());
        texts.pop_back();
        for (const std::string_view word : words) {
            for (std::size_t set = 0; set < reads_uv_.size(); ++set) reads_uv_[set] |= word == uv_node(set);
            const auto found = unread.find(word);
            if (found == unread.end()) continue;
            texts.push_back(found->second->expression);
            add(found->second->inputs);
            unread.erase(found);
        }
    }
    for (const auto& [id, each] : unread) {
        Outcome& outcome = outcomes_[owners_[id]];
        if (outcome.kind != Remark::Kind::LeftOut) outcome.where = "nothing reads it";
    }
    std::erase_if(file_.nodes, [&](const GraphNode& each) { return unread.contains(each.id); });
}

void GraphMaker::make_layout() {
    for (std::size_t set = reads_uv_.size(); set-- > 0;)
        if (reads_uv_[set])
            file_.nodes.insert(file_.nodes.begin(),
                               {.id = uv_node(set),
                                .expression = fmt::format("float2(@uv{0}.x, 1 - @uv{0}.y)", set),
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
        if (ids.empty() && group != graph_.groups.end())
            each.comment = group->title.empty() ? "(a group without a title)" : group->title;
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
        remark(note.misread.empty() ? Remark::Kind::Taken : Remark::Kind::Changed, fmt::format("note '{}'", note.title),
               "'ui.notes'" + (note.misread.empty() ? "" : ": " + note.misread), note.place);
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
        const Outcome& outcome = outcomes_[i];
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
