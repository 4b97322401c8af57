// Writes shader graphs for tests, in both layouts.
//
//   ShaderGraphText text{.nodes = {{.id = "a", .kind = "AddNode", .slots = {{0}, {1}, {.id = 2, .is_input = false}}}},
//                        .edges = {{"a", 2, "BaseColor"}}};
//   save("x.shadergraph", text.new_layout());
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace patina::importers {

struct SlotText {
    int id = 0;
    std::string kind = "DynamicVector";
    bool is_input = true;
    std::string value = R"({"x":0.0,"y":0.0,"z":0.0,"w":0.0})";
    std::string name{};
    std::string more{};  // further members: "\"m_Channel\":1"
};
struct NodeText {
    std::string id, kind;
    std::vector<SlotText> slots{};
    std::string more{};
    int version = 0;
    std::string name{}, property{}, group{};
};
struct EdgeText {
    std::string from;
    int from_slot;
    std::string to;  // a node, or a block
    int to_slot = 0;
};
struct PropertyText {
    std::string id, kind, name, value;
    std::string more{};
    std::string reference{};
};
struct BlockText {
    std::string name, kind;  // "SurfaceDescription.BaseColor", "ColorRGB"
    std::string value = R"({"x":0.5,"y":0.5,"z":0.5,"w":1.0})";
};

struct ShaderGraphText {
    std::vector<PropertyText> properties{};
    std::vector<PropertyText> keywords{}, dropdowns{};
    std::vector<NodeText> nodes{};
    std::vector<EdgeText> edges{};
    std::vector<BlockText> blocks = {{"SurfaceDescription.BaseColor", "ColorRGB"}};
    std::vector<SlotText> outputs{};  // not empty: it is a sub-graph
    std::string target{};             // settings: "\"m_SurfaceType\":1"
    std::string material = "UniversalUnlitSubTarget";
    std::string material_settings{};
    std::string more_objects{}, more_of_graph{};

    std::string new_layout() const {
        std::string objects, nodes_list, blocks_list, properties_list;
        const auto add = [&](std::string_view type, const std::string& id, const std::string& members,
                             int version = 0) {
            objects += fmt::format("\n\n{{\"m_SGVersion\":{},\"m_Type\":\"{}\",\"m_ObjectId\":\"{}\"{}{}}}", version,
                                   type, id, members.empty() ? "" : ",", members);
        };
        const auto reference = [](std::string& list, const std::string& id) {
            list += fmt::format("{}{{\"m_Id\":\"{}\"}}", list.empty() ? "" : ",", id);
        };
        const auto add_node = [&](const NodeText& node) {
            std::string slots;
            for (const SlotText& slot : node.slots) {
                const std::string id = fmt::format("{}.{}", node.id, slot.id);
                reference(slots, id);
                add("UnityEditor.ShaderGraph." + slot.kind + "MaterialSlot", id, slot_members(slot));
            }
            reference(nodes_list, node.id);
            std::string members = fmt::format(R"("m_Name":"{}","m_Group":{{"m_Id":"{}"}},"m_Slots":[{}])",
                                              node.name.empty() ? node.kind : node.name, node.group, slots);
            if (!node.property.empty())
                members += fmt::format(R"(,"{}":{{"m_Id":"{}"}})", property_key(node), node.property);
            if (!node.more.empty()) members += "," + node.more;
            add("UnityEditor.ShaderGraph." + node.kind, node.id, members, node.version);
        };
        for (const NodeText& node : nodes) add_node(node);
        for (const BlockText& block : blocks) {
            if (!outputs.empty()) break;
            const std::string id = block.name.substr(block.name.find('.') + 1);
            reference(blocks_list, id);
            add_node({.id = id,
                      .kind = "BlockNode",
                      .slots = {{.id = 0, .kind = block.kind, .value = block.value}},
                      .more = fmt::format(R"("m_SerializedDescriptor":"{}")", block.name)});
        }
        if (!outputs.empty()) add_node({.id = "output", .kind = "SubGraphOutputNode", .slots = outputs});
        std::string lists[3];
        const std::vector<PropertyText>* all[] = {&properties, &keywords, &dropdowns};
        for (int i = 0; i < 3; ++i)
            for (const PropertyText& each : *all[i]) {
                reference(lists[i], each.id);
                const std::string type =
                    i == 1   ? "UnityEditor.ShaderGraph.ShaderKeyword"
                    : i == 2 ? "UnityEditor.ShaderGraph.ShaderDropdown"
                             : fmt::format("UnityEditor.ShaderGraph.Internal.{}ShaderProperty", each.kind);
                add(type, each.id, property_members(each));
            }
        std::string edge_list;
        for (const EdgeText& edge : edges)
            edge_list += fmt::format(
                R"({}{{"m_OutputSlot":{{"m_Node":{{"m_Id":"{}"}},"m_SlotId":{}}},"m_InputSlot":{{"m_Node":{{"m_Id":"{}"}},"m_SlotId":{}}}}})",
                edge_list.empty() ? "" : ",", edge.from, edge.from_slot, edge.to, edge.to_slot);
        add("UnityEditor.Rendering.Universal.ShaderGraph.UniversalTarget", "target",
            R"("m_ActiveSubTarget":{"m_Id":"material"})" + (target.empty() ? "" : "," + target));
        add("UnityEditor.Rendering.Universal.ShaderGraph." + material, "material", material_settings);
        return fmt::format(
                   R"({{"m_SGVersion":3,"m_Type":"UnityEditor.ShaderGraph.GraphData","m_ObjectId":"graph","m_Properties":[{}],"m_Keywords":[{}],"m_Dropdowns":[{}],"m_Nodes":[{}],"m_Edges":[{}],"m_FragmentContext":{{"m_Blocks":[{}]}},"m_OutputNode":{{"m_Id":"{}"}},"m_ActiveTargets":[{{"m_Id":"target"}}]{}}})",
                   lists[0], lists[1], lists[2], nodes_list, edge_list, blocks_list, outputs.empty() ? "" : "output",
                   more_of_graph.empty() ? "" : "," + more_of_graph) +
               objects + more_objects + "\n";
    }

    // The same with an unlit master node, whose input 0 is BaseColor.
    std::string old_layout() const {
        const auto element = [](const std::string& type, const std::string& json) {
            return fmt::format(R"({{"typeInfo":{{"fullName":"UnityEditor.ShaderGraph.{}"}},"JSONnodeData":{}}})", type,
                               quoted(json));
        };
        std::string all_nodes, all_edges, all_properties;
        const auto add_node = [&](const NodeText& node) {
            std::string slots;
            for (const SlotText& slot : node.slots)
                slots +=
                    (slots.empty() ? "" : ",") + element(slot.kind + "MaterialSlot", "{" + slot_members(slot) + "}");
            std::string members =
                fmt::format(R"("m_GuidSerialized":"{}","m_Name":"{}","m_NodeVersion":{},"m_SerializableSlots":[{}])",
                            node.id, node.name.empty() ? node.kind : node.name, node.version, slots);
            if (!node.property.empty()) members += fmt::format(R"(,"m_PropertyGuidSerialized":"{}")", node.property);
            if (!node.more.empty()) members += "," + node.more;
            all_nodes += (all_nodes.empty() ? "" : ",") + element(node.kind, "{" + members + "}");
        };
        for (const NodeText& node : nodes) add_node(node);
        add_node({.id = "master", .kind = "UnlitMasterNode", .slots = {{.id = 0, .kind = "ColorRGB"}}, .more = target});
        for (const EdgeText& edge : edges) {
            const std::string to = edge.to == "BaseColor" ? "master" : edge.to;
            all_edges +=
                (all_edges.empty() ? "" : ",") +
                element(
                    "Edge",
                    fmt::format(
                        R"({{"m_OutputSlot":{{"m_SlotId":{},"m_NodeGUIDSerialized":"{}"}},"m_InputSlot":{{"m_SlotId":{},"m_NodeGUIDSerialized":"{}"}}}})",
                        edge.from_slot, edge.from, edge.to_slot, to));
        }
        for (const PropertyText& each : properties)
            all_properties +=
                (all_properties.empty() ? "" : ",") +
                element(each.kind + "ShaderProperty",
                        fmt::format(R"({{"m_Guid":{{"m_GuidSerialized":"{}"}},{}}})", each.id, property_members(each)));
        return fmt::format(R"({{"m_SerializedProperties":[{}],"m_SerializableNodes":[{}],"m_SerializableEdges":[{}]}})",
                           all_properties, all_nodes, all_edges);
    }

private:
    static std::string property_key(const NodeText& node) {
        return node.kind == "KeywordNode" ? "m_Keyword" : node.kind == "DropdownNode" ? "m_Dropdown" : "m_Property";
    }
    static std::string slot_members(const SlotText& slot) {
        const std::string name = slot.name.empty() ? fmt::format("S{}", slot.id) : slot.name;
        return fmt::format(
            R"("m_Id":{},"m_DisplayName":"{}","m_SlotType":{},"m_ShaderOutputName":"{}","m_Value":{}{}{})", slot.id,
            name, slot.is_input ? 0 : 1, name, slot.value, slot.more.empty() ? "" : ",", slot.more);
    }
    static std::string property_members(const PropertyText& each) {
        return fmt::format(R"("m_Name":"{}","m_DefaultReferenceName":"{}","m_Value":{}{}{})", each.name,
                           each.reference.empty() ? "_" + each.name : each.reference, each.value,
                           each.more.empty() ? "" : ",", each.more);
    }
    static std::string quoted(const std::string& text) {
        std::string made = "\"";
        for (const char c : text)
            made += c == '"' || c == '\\' ? std::string("\\") + c : c == '\n' ? "\\n" : std::string(1, c);
        return made + "\"";
    }
};

// A folder of the test's own; the path of the file in it.
inline std::string save_shader_graph(const std::string& name, const std::string& text, const std::string& guid = {}) {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "shadergraph" / test->name();
    std::filesystem::create_directories(folder);
    const std::string path = (folder / name).string();
    std::ofstream(path, std::ios::binary) << text;
    if (!guid.empty()) std::ofstream(path + ".meta") << "fileFormatVersion: 2\nguid: " << guid << "\n";
    return path;
}

}  // namespace patina::importers
