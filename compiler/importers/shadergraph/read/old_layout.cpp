// The layout until 2020.1: one object, whose elements are JSON in strings. A master node stands for the target.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>

#include "compiler/importers/shadergraph/read/shader_graph.h"

namespace patina::importers::shadergraph {
namespace {

constexpr std::string_view kNoGuid = "00000000-0000-0000-0000-000000000000";

struct MasterSlot {
    int id;
    std::string_view block;
    bool is_vertex = false;
};
// The inputs of the master nodes, by the numbers of their slots.
constexpr MasterSlot kPbr[] = {{0, "BaseColor"},      {1, "Normal"},        {2, "Metallic"},
                               {3, "Specular"},       {4, "Emission"},      {5, "Smoothness"},
                               {6, "Occlusion"},      {7, "Alpha"},         {8, "AlphaClipThreshold"},
                               {9, "Position", true}, {10, "Normal", true}, {11, "Tangent", true}};
constexpr MasterSlot kUnlit[] = {{0, "BaseColor"},      {7, "Alpha"},         {8, "AlphaClipThreshold"},
                                 {9, "Position", true}, {10, "Normal", true}, {11, "Tangent", true}};
constexpr MasterSlot kSpriteLit[] = {{0, "SpriteColor"},    {1, "SpriteMask"},    {2, "NormalTS"},
                                     {9, "Position", true}, {10, "Normal", true}, {11, "Tangent", true}};
constexpr MasterSlot kSpriteUnlit[] = {
    {0, "SpriteColor"}, {9, "Position", true}, {10, "Normal", true}, {11, "Tangent", true}};

std::span<const MasterSlot> slots_of(std::string_view master) {
    if (master == "PBRMasterNode") return kPbr;
    if (master == "UnlitMasterNode") return kUnlit;
    if (master == "SpriteLitMasterNode") return kSpriteLit;
    if (master == "SpriteUnlitMasterNode") return kSpriteUnlit;
    return {};
}

class Reader {
public:
    Reader(Documents& documents, ShaderGraph& graph) : documents_(documents), graph_(graph) {}

    void read() {
        graph_.json = documents_.roots.front();
        graph_.is_old = true;
        if (documents_.roots.size() > 1) {
            const Place at = documents_.place(*documents_.roots[1]);
            graph_.error = fmt::format("{}:{}:{}: objects follow the graph, which is one object in this layout",
                                       graph_.path, at.line, at.column);
            return;
        }
        read_nodes();
        read_edges();
        for (const std::string_view key : {"m_SerializedProperties", "m_SerializedKeywords"})
            for (const Json& element : elements_of(graph_.json, key)) {
                const auto [json, type] = inner(element, "a property");
                if (!json) continue;
                Property property = read_property(*json, type, documents_);
                property.id = property.guid;
                graph_.properties.push_back(std::move(property));
            }
        for (const Json& json : elements_of(graph_.json, "m_Groups"))
            graph_.groups.push_back({.id = std::string(text_of(&json, "m_GuidSerialized")),
                                     .title = std::string(text_of(&json, "m_Title")),
                                     .place = documents_.place(json)});
        for (const Json& json : elements_of(graph_.json, "m_StickyNotes")) {
            Note note{.group = std::string(text_of(&json, "m_GroupGuidSerialized")), .place = documents_.place(json)};
            if (note.group == kNoGuid) note.group.clear();
            read_note(note, json);
            graph_.notes.push_back(std::move(note));
        }
        read_outputs();
    }

private:
    std::pair<const Json*, std::string_view> inner(const Json& element, std::string_view what) {
        const Json* text = member(&element, "JSONnodeData");
        const Json* json = text ? documents_.inner(*text) : nullptr;
        if (!json)
            graph_.problems.push_back({std::string(what), "its JSON cannot be read", documents_.place(element), true});
        return {json, json ? text_of(&element, "typeInfo.fullName") : std::string_view()};
    }

    void read_nodes() {
        for (const Json& element : elements_of(graph_.json, "m_SerializableNodes")) {
            const auto [json, type] = inner(element, "a node");
            if (!json) continue;
            Node node{.id = std::string(text_of(json, "m_GuidSerialized")),
                      .kind = std::string(short_class(type)),
                      .name = std::string(text_of(json, "m_Name")),
                      .version = whole_of(json, "m_NodeVersion"),
                      .group = std::string(text_of(json, "m_GroupGuidSerialized")),
                      .json = json,
                      .place = documents_.place(*json)};
            if (node.group == kNoGuid) node.group.clear();
            for (const std::string_view key : {"m_PropertyGuidSerialized", "m_KeywordGuidSerialized"})
                if (node.refers.empty()) node.refers = text_of(json, key);
            for (const Json& slot : elements_of(json, "m_SerializableSlots")) {
                const Json* text = member(&slot, "JSONnodeData");
                const Json* slot_json = text ? documents_.inner(*text) : nullptr;
                if (slot_json) {
                    node.slots.push_back(read_slot(*slot_json, text_of(&slot, "typeInfo.fullName")));
                } else {
                    const Place at = documents_.place(slot);
                    node.lost = fmt::format("the JSON of its slot cannot be read ({}:{})", at.line, at.column);
                }
            }
            read_layout(node);
            if (!nodes_.try_emplace(node.id, graph_.nodes.size()).second) {
                graph_.error = fmt::format("{}:{}:{}: a second node has the id '{}'", graph_.path, node.place.line,
                                           node.place.column, node.id);
                return;
            }
            graph_.nodes.push_back(std::move(node));
        }
    }

    void read_edges() {
        for (const Json& element : elements_of(graph_.json, "m_SerializableEdges")) {
            const auto [json, type] = inner(element, "an edge");
            if (!json) continue;
            graph_.edges.push_back({.from_id = std::string(text_of(json, "m_OutputSlot.m_NodeGUIDSerialized")),
                                    .to_id = std::string(text_of(json, "m_InputSlot.m_NodeGUIDSerialized")),
                                    .from_slot = id_of(json, "m_OutputSlot.m_SlotId"),
                                    .to_slot = id_of(json, "m_InputSlot.m_SlotId"),
                                    .place = documents_.place(*json)});
        }
    }

    // The node that is the result: the one that is marked, else the first that can be.
    void read_outputs() {
        const auto can_be = [](std::string_view kind) {
            return kind.ends_with("MasterNode") || kind == "SubGraphOutputNode";
        };
        const auto marked = nodes_.find(std::string(text_of(graph_.json, "m_ActiveOutputNodeGuidSerialized")));
        std::size_t output = graph_.nodes.size();
        if (marked != nodes_.end() && can_be(graph_.nodes[marked->second].kind)) output = marked->second;
        for (std::size_t i = 0; i < graph_.nodes.size() && output == graph_.nodes.size(); ++i)
            if (can_be(graph_.nodes[i].kind)) output = i;
        if (output == graph_.nodes.size()) {
            const Place at = documents_.place(*graph_.json->find("m_SerializableNodes"));
            graph_.error =
                fmt::format("{}:{}:{}: it has neither a master node nor an output", graph_.path, at.line, at.column);
            return;
        }
        const Node& node = graph_.nodes[output];
        graph_.is_subgraph = node.kind == "SubGraphOutputNode";
        if (!graph_.is_subgraph)
            graph_.targets.push_back({.kind = node.kind,
                                      .material = node.kind,
                                      .json = node.json,
                                      .material_json = node.json,
                                      .place = node.place});
        const std::span<const MasterSlot> known = slots_of(node.kind);
        // An input that an edge leads to, and whose slot cannot be read.
        for (const MasterSlot& each : known) {
            const bool is_linked = std::ranges::any_of(
                graph_.edges, [&](const Edge& edge) { return edge.to_id == node.id && edge.to_slot == each.id; });
            if (is_linked && !node.slot(each.id) && each.block != "Normal")
                graph_.blocks.push_back({.name = std::string(each.block),
                                         .is_vertex = each.is_vertex,
                                         .node = output,
                                         .slot = each.id,
                                         .place = node.place});
        }
        for (const Slot& slot : node.slots) {
            if (!slot.is_input) continue;
            Block block{.name = slot.name, .node = output, .slot = slot.id, .place = node.place};
            for (const MasterSlot& each : known) {
                if (each.id != slot.id) continue;
                block.name = each.block;
                block.is_vertex = each.is_vertex;
            }
            if (block.name == "Normal" && !block.is_vertex && !graph_.is_subgraph) {
                static constexpr std::string_view kSpaces[] = {"NormalTS", "NormalOS", "NormalWS"};
                block.name = kSpaces[whole_in(node.json, "m_NormalDropOffSpace", 0, 0, 2)];
            }
            if (!graph_.is_subgraph &&
                known.empty()) {  // a master node of another pipeline: by the names of its inputs
                std::erase(block.name, ' ');
                block.is_vertex = block.name.starts_with("Vertex");
                if (block.is_vertex) block.name = block.name.substr(6);
                if (block.name == "Color") block.name = "BaseColor";
                if (block.name == "SpecularColor") block.name = "Specular";
                if (block.name == "Emissive") block.name = "Emission";
                if (block.name == "AlphaThreshold") block.name = "AlphaClipThreshold";
            }
            graph_.blocks.push_back(std::move(block));
        }
    }

    Documents& documents_;
    ShaderGraph& graph_;
    std::unordered_map<std::string, std::size_t> nodes_;
};

}  // namespace

void read_old_layout(Documents& documents, ShaderGraph& graph) {
    Reader(documents, graph).read();
}

}  // namespace patina::importers::shadergraph
