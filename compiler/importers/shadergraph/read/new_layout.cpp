// The layout of 2020.2 and later: several objects, which name each other by "m_Id".
#include <fmt/format.h>

#include <unordered_map>

#include "compiler/importers/shadergraph/read/shader_graph.h"

namespace patina::importers::shadergraph {
namespace {

class Reader {
public:
    Reader(const Documents& documents, ShaderGraph& graph) : documents_(documents), graph_(graph) {}

    void read() {
        for (const Json* root : documents_.roots) {
            const std::string id(text_of(root, "m_ObjectId"));
            if (id.empty() || by_id_.try_emplace(id, root).second) continue;
            const Place at = documents_.place(*root);
            graph_.error =
                fmt::format("{}:{}:{}: a second object has the id '{}'", graph_.path, at.line, at.column, id);
            return;
        }
        for (const Json* root : documents_.roots)
            if (short_class(text_of(root, "m_Type")) == "GraphData") graph_.json = root;
        if (!graph_.json) {
            graph_.error = graph_.path + ": it has no object of the type GraphData";
            return;
        }
        constexpr int kNewest = 3;
        if (const int version = whole_of(graph_.json, "m_SGVersion"); version > kNewest)
            graph_.problems.push_back(
                {"the file",
                 fmt::format("it is of version {}; {} is the newest that is known: read as that", version, kNewest),
                 documents_.place(*graph_.json->find("m_SGVersion"))});
        read_nodes();
        read_edges();
        read_blackboard();
        read_notes();
        read_outputs();
    }

private:
    void lost(std::string part, std::string text, const Json& at) {
        graph_.problems.push_back({std::move(part), std::move(text), documents_.place(at), true});
    }
    // The object that a reference names; null if it names none. `what`: "a node".
    const Json* target(const Json& reference, std::string_view what) {
        if (reference.kind != Json::Kind::Object) note_broken(reference, what, "a reference");
        const std::string id(text_of(&reference, "m_Id"));
        if (id.empty()) return nullptr;
        const auto found = by_id_.find(id);
        if (found != by_id_.end()) return found->second;
        lost(std::string(what), fmt::format("the file has no object '{}'", id), reference);
        return nullptr;
    }
    template <class Each>
    void for_each(const Json* object, std::string_view path, std::string_view what, const Each& each) {
        for (const Json& reference : elements_of(object, path))
            if (const Json* found = target(reference, what)) each(*found);
    }

    void read_nodes() {
        for_each(graph_.json, "m_Nodes", "a node", [&](const Json& json) {
            Node node{.id = std::string(text_of(&json, "m_ObjectId")),
                      .kind = std::string(short_class(text_of(&json, "m_Type"))),
                      .name = std::string(text_of(&json, "m_Name")),
                      .version = whole_of(&json, "m_SGVersion"),
                      .group = std::string(text_of(&json, "m_Group.m_Id")),
                      .json = &json,
                      .place = documents_.place(json)};
            for (const std::string_view key : {"m_Property.m_Id", "m_Keyword.m_Id", "m_Dropdown.m_Id"})
                if (node.refers.empty()) node.refers = text_of(&json, key);
            for (const Json& reference : elements_of(&json, "m_Slots")) {
                const auto slot = by_id_.find(std::string(text_of(&reference, "m_Id")));
                if (slot != by_id_.end()) {
                    node.slots.push_back(read_slot(*slot->second, text_of(slot->second, "m_Type")));
                } else {
                    const Place at = documents_.place(reference);
                    node.lost = fmt::format("the file does not have its slot '{}' ({}:{})", text_of(&reference, "m_Id"),
                                            at.line, at.column);
                }
            }
            read_layout(node);
            if (nodes_.try_emplace(node.id, graph_.nodes.size()).second) graph_.nodes.push_back(std::move(node));
        });
    }

    void read_edges() {
        for (const Json& json : elements_of(graph_.json, "m_Edges")) {
            graph_.edges.push_back({.from_id = std::string(text_of(&json, "m_OutputSlot.m_Node.m_Id")),
                                    .to_id = std::string(text_of(&json, "m_InputSlot.m_Node.m_Id")),
                                    .from_slot = id_of(&json, "m_OutputSlot.m_SlotId"),
                                    .to_slot = id_of(&json, "m_InputSlot.m_SlotId"),
                                    .place = documents_.place(json)});
        }
    }

    void read_blackboard() {
        for (const std::string_view key : {"m_Properties", "m_Keywords", "m_Dropdowns"})
            for_each(graph_.json, key, "a property", [&](const Json& json) {
                Property property = read_property(json, text_of(&json, "m_Type"), documents_);
                property.id = text_of(&json, "m_ObjectId");
                graph_.properties.push_back(std::move(property));
            });
        for_each(graph_.json, "m_CategoryData", "a category", [&](const Json& json) {
            for (const Json& child : elements_of(&json, "m_ChildObjectList"))
                for (Property& property : graph_.properties)
                    if (property.id == text_of(&child, "m_Id")) property.group = text_of(&json, "m_Name");
        });
    }

    void read_notes() {
        for_each(graph_.json, "m_GroupDatas", "a group", [&](const Json& json) {
            graph_.groups.push_back({.id = std::string(text_of(&json, "m_ObjectId")),
                                     .title = std::string(text_of(&json, "m_Title")),
                                     .place = documents_.place(json)});
        });
        for_each(graph_.json, "m_StickyNoteDatas", "a note", [&](const Json& json) {
            Note note{.group = std::string(text_of(&json, "m_Group.m_Id")), .place = documents_.place(json)};
            read_note(note, json);
            graph_.notes.push_back(std::move(note));
        });
    }

    void read_outputs() {
        const auto output = nodes_.find(std::string(text_of(graph_.json, "m_OutputNode.m_Id")));
        if (output != nodes_.end()) {
            graph_.is_subgraph = true;
            const Node& node = graph_.nodes[output->second];
            for (const Slot& slot : node.slots)
                if (slot.is_input)
                    graph_.blocks.push_back(
                        {.name = slot.name, .node = output->second, .slot = slot.id, .place = node.place});
        }
        for (const std::string_view context : {"m_VertexContext.m_Blocks", "m_FragmentContext.m_Blocks"})
            for (const Json& reference : elements_of(graph_.json, context)) {
                const std::string id(text_of(&reference, "m_Id"));
                const auto found = nodes_.find(id);
                if (found == nodes_.end()) {
                    if (by_id_.contains(id)) lost("a block", fmt::format("the graph has no node '{}'", id), reference);
                    continue;
                }
                const Node& node = graph_.nodes[found->second];
                const std::string_view name = text_of(node.json, "m_SerializedDescriptor");
                graph_.blocks.push_back({.name = std::string(name.substr(name.find('.') + 1)),
                                         .is_vertex = name.starts_with("Vertex"),
                                         .node = found->second,
                                         .slot = node.slots.empty() ? 0 : node.slots.front().id,
                                         .place = node.place});
            }
        for_each(graph_.json, "m_ActiveTargets", "a target", [&](const Json& json) {
            TargetSettings made{.kind = std::string(short_class(text_of(&json, "m_Type"))),
                                .json = &json,
                                .place = documents_.place(json)};
            if (const Json* reference = member(&json, "m_ActiveSubTarget"))
                made.material_json = target(*reference, "a material");
            made.material = short_class(text_of(made.material_json, "m_Type"));
            for_each(&json, "m_Datas", "settings", [&](const Json& data) { made.data.push_back(&data); });
            graph_.targets.push_back(std::move(made));
        });
    }

    const Documents& documents_;
    ShaderGraph& graph_;
    std::unordered_map<std::string, const Json*> by_id_;
    std::unordered_map<std::string, std::size_t> nodes_;
};

}  // namespace

void read_new_layout(const Documents& documents, ShaderGraph& graph) {
    Reader(documents, graph).read();
}

}  // namespace patina::importers::shadergraph
