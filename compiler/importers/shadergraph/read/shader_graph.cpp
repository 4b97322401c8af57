#include "compiler/importers/shadergraph/read/shader_graph.h"

#include <fmt/format.h>

#include <algorithm>

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
    return {.id = whole_of(&json, "m_Id"),
            .name = std::string(text_of(&json, "m_DisplayName")),
            .kind = without(short_class(full_class), "MaterialSlot"),
            .is_input = whole_of(&json, "m_SlotType") == 0,
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
    return made;
}

void read_layout(Node& node) {
    node.x = number_of(node.json, "m_DrawState.m_Position.x");
    node.y = number_of(node.json, "m_DrawState.m_Position.y");
}

void read_note(Note& note, const Json& json) {
    note.title = text_of(&json, "m_Title");
    note.text = text_of(&json, "m_Content");
    note.x = number_of(&json, "m_Position.x");
    note.y = number_of(&json, "m_Position.y");
    note.width = number_of(&json, "m_Position.width");
    note.height = number_of(&json, "m_Position.height");
}

ShaderGraph read_shader_graph(Documents& documents) {
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
        made.error =
            made.path + ": it is no shader graph: its object has neither \"m_Type\" nor \"m_SerializableNodes\"";
    }
    if (made.error.empty()) find_circles(made);
    return made;
}

}  // namespace patina::importers::shadergraph
