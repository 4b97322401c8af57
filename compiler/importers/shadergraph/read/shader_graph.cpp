#include "compiler/importers/shadergraph/read/shader_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <unordered_map>

namespace patina::importers::shadergraph {
namespace {

std::string without(std::string_view word, std::string_view ending) {
    if (word.ends_with(ending)) word.remove_suffix(ending.size());
    return std::string(word);
}

// The graph is drawn from left to right, so whatever reads itself is a mistake. Removes nothing: it only finds.
void find_circles(ShaderGraph& graph) {
    std::vector<std::vector<std::size_t>> reads(graph.nodes.size());
    for (const Edge& edge : graph.edges) reads[edge.to].push_back(edge.from);
    enum class State { New, Open, Done };
    std::vector<State> states(graph.nodes.size(), State::New);
    for (std::size_t start = 0; start < graph.nodes.size(); ++start) {
        std::vector<std::pair<std::size_t, std::size_t>> path;  // node, next edge
        if (states[start] == State::New) path.push_back({start, 0});
        while (!path.empty()) {
            auto& [node, next] = path.back();
            states[node] = State::Open;
            if (next == reads[node].size()) {
                states[node] = State::Done;
                path.pop_back();
                continue;
            }
            const std::size_t from = reads[node][next++];
            if (states[from] == State::Open) {
                const Place at = graph.nodes[from].place;
                graph.error = fmt::format("{}:{}:{}: the node '{}' reads itself, through '{}'", graph.path, at.line,
                                          at.column, graph.nodes[from].name, graph.nodes[node].name);
                return;
            }
            if (states[from] == State::New) path.push_back({from, 0});
        }
    }
}

// How a message calls the end of an edge: "'Lerp' (T)".
std::string end_of(const ShaderGraph& graph, const std::string& id, int slot_id) {
    const auto node = std::ranges::find(graph.nodes, id, &Node::id);
    if (node == graph.nodes.end()) return fmt::format("the node '{}' (slot {})", id, slot_id);
    const Slot* slot = node->slot(slot_id);
    return fmt::format("'{}' ({})", node->name.empty() ? node->kind : node->name,
                       slot ? slot->name : fmt::format("slot {}", slot_id));
}

// An edge whose beginning is not there begins at a node that is lost: it is refused as other nodes are.
void find_ends(ShaderGraph& graph) {
    std::unordered_map<std::string, std::size_t> nodes;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) nodes.emplace(graph.nodes[i].id, i);
    std::vector<Edge> known;
    std::vector<Node> lost;
    for (Edge& edge : graph.edges) {
        const auto from = nodes.find(edge.from_id), to = nodes.find(edge.to_id);
        const auto has_slot = [&](const auto& node, int slot) {
            return node != nodes.end() && graph.nodes[node->second].slot(slot);
        };
        const bool has_from = has_slot(from, edge.from_slot), has_to = has_slot(to, edge.to_slot);
        const std::string part = fmt::format("edge from {} to {}", end_of(graph, edge.from_id, edge.from_slot),
                                             end_of(graph, edge.to_id, edge.to_slot));
        const auto why = [](bool has_node, std::string_view which) {
            return fmt::format("the {} at its {} does not exist", has_node ? "slot" : "node", which);
        };
        if (!has_to) {
            graph.problems.push_back({part, why(to != nodes.end(), "end"), edge.place, true});
            continue;
        }
        edge.to = to->second;
        if (has_from) {
            edge.from = from->second;
        } else {
            const Node& reader = graph.nodes[edge.to];
            edge.from = graph.nodes.size() + lost.size();
            lost.push_back({.id = fmt::format("{} {}", edge.from_id, edge.from_slot),
                            .kind = "MissingNode",
                            .name = "Missing",
                            .slots = {{.id = edge.from_slot, .name = "Out", .kind = reader.slot(edge.to_slot)->kind}},
                            .group = reader.group,
                            .x = reader.x - 200,
                            .y = reader.y,
                            .lost = why(from != nodes.end(), "beginning"),
                            .part = part,
                            .place = edge.place});
        }
        known.push_back(std::move(edge));
    }
    graph.edges = std::move(known);
    graph.nodes.insert(graph.nodes.end(), std::make_move_iterator(lost.begin()), std::make_move_iterator(lost.end()));
}

}  // namespace

const Slot* Node::slot(int slot_id) const {
    const auto found = std::ranges::find(slots, slot_id, &Slot::id);
    return found == slots.end() ? nullptr : &*found;
}

std::string_view short_class(std::string_view full) {
    full = full.substr(0, full.find(','));
    const std::size_t dot = full.rfind('.');
    return dot == full.npos ? full : full.substr(dot + 1);
}

Slot read_slot(const Json& json, std::string_view full_class) {
    return {.id = id_of(&json, "m_Id"),
            .name = std::string(text_of(&json, "m_DisplayName")),
            .kind = without(short_class(full_class), "MaterialSlot"),
            .is_input = whole_in(&json, "m_SlotType", 0, 0, 1) == 0,
            .json = &json};
}

Property read_property(const Json& json, std::string_view full_class, const Documents& documents) {
    std::string_view kind = short_class(full_class);
    if (kind == "FloatShaderProperty") kind = "Vector1ShaderProperty";
    if (kind == "TextureShaderProperty") kind = "Texture2DShaderProperty";
    if (kind == "ShaderKeyword") kind = "Keyword";
    if (kind == "ShaderDropdown") kind = "Dropdown";
    Property made{.kind = without(kind, "ShaderProperty"),
                  .name = std::string(text_of(&json, "m_Name")),
                  .reference = std::string(text_of(&json, "m_OverrideReferenceName")),
                  .guid = std::string(text_of(&json, "m_Guid.m_GuidSerialized")),
                  .is_exposed = flag_of(&json, "m_GeneratePropertyBlock", true),
                  .is_hidden = flag_of(&json, "m_Hidden"),
                  .json = &json,
                  .place = documents.place(json)};
    if (made.reference.empty()) made.reference = text_of(&json, "m_DefaultReferenceName");
    made.misread = take_misreads();
    return made;
}

void read_layout(Node& node) {
    node.x = number_of(node.json, "m_DrawState.m_Position.x");
    node.y = number_of(node.json, "m_DrawState.m_Position.y");
    node.misread = take_misreads();
}

void read_note(Note& note, const Json& json) {
    note.title = text_of(&json, "m_Title");
    note.text = text_of(&json, "m_Content");
    note.x = number_of(&json, "m_Position.x");
    note.y = number_of(&json, "m_Position.y");
    note.width = number_of(&json, "m_Position.width");
    note.height = number_of(&json, "m_Position.height");
    note.misread = take_misreads();
}

ShaderGraph read_shader_graph(Documents& documents, const Misreads& misreads) {
    ShaderGraph made{.path = documents.path()};
    if (!documents.error.empty()) {
        made.error = documents.error;
        return made;
    }
    const Json* first = documents.roots.front();
    if (first->find("m_SerializableNodes")) {
        read_old_layout(documents, made);
    } else if (first->find("m_Type") || documents.roots.size() > 1) {
        read_new_layout(documents, made);
    } else {
        const Place at = documents.place(*first);
        made.error = fmt::format(
            "{}:{}:{}: it is no shader graph: its object has neither \"m_Type\" nor \"m_SerializableNodes\"", made.path,
            at.line, at.column);
    }
    if (std::string wrong = take_misreads(); !wrong.empty())
        made.problems.push_back({.part = "the file", .text = std::move(wrong)});
    if (made.error.empty()) made.error = misreads.broken();
    if (!made.error.empty()) return made;
    find_ends(made);
    find_circles(made);
    return made;
}

}  // namespace patina::importers::shadergraph
