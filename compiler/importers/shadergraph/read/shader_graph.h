// A shader graph as its file says it, the same for both layouts: nodes with slots, edges, the blackboard, and what the
// graph gives to its target. Nothing has a meaning yet: classes of nodes are words, settings stay JSON.
//
//   Documents documents = read_documents(path, text);
//   const Misreads misreads(documents);
//   ShaderGraph graph = read_shader_graph(documents, misreads);
//   if (!graph.error.empty()) ...
#pragma once

#include "compiler/importers/shadergraph/read/documents.h"
#include "compiler/importers/shadergraph/read/misreads.h"

namespace patina::importers::shadergraph {

struct Slot {
    int id = 0;          // unique in its node
    std::string name{};  // that people see: "Base Color"
    std::string kind{};  // its class: "Vector1", "DynamicVector", "Texture2DInput"
    bool is_input = false;
    const Json* json = nullptr;
};
struct Node {
    std::string id{};
    std::string kind{};  // its class without name space: "MultiplyNode"
    std::string name{};  // that people see
    int version = 0;     // of its class: settings of older versions mean something else
    std::vector<Slot> slots{};
    std::string refers{};  // id of the property, keyword or dropdown that it reads
    std::string group{};   // id; empty: none
    double x = 0, y = 0;
    std::string misread{};  // what of it could not be taken, in words
    std::string lost{};     // why it cannot be known; empty: it is known
    std::string part{};     // in the report; empty: by its name
    const Json* json = nullptr;
    Place place{};

    const Slot* slot(int slot_id) const;
};
struct Edge {
    std::string from_id{}, to_id{};  // of nodes
    int from_slot = 0, to_slot = 0;
    Place place{};
    std::size_t from = 0, to = 0;  // the nodes, once all are read
};
struct Property {
    std::string id{};
    std::string kind{};       // "Vector1", "Color", "Texture2D", "Keyword", "Dropdown"
    std::string name{};       // that people see
    std::string reference{};  // in the shader
    std::string guid{};       // by which nodes that use a sub-graph name its inputs
    std::string group{};      // heading
    bool is_exposed = true, is_hidden = false;
    std::string misread{};
    const Json* json = nullptr;
    Place place{};
};
struct Group {
    std::string id{}, title{};
    Place place{};
};
struct Note {
    std::string title{}, text{}, group{};
    double x = 0, y = 0, width = 0, height = 0;
    std::string misread{};
    Place place{};
};
// An input of the target, or of the sub-graph's output.
struct Block {
    std::string name{};  // "BaseColor", "Position"; of a sub-graph the name of the output
    bool is_vertex = false;
    std::size_t node = 0;  // whose slot it is
    int slot = 0;
    Place place{};
};
struct TargetSettings {
    std::string kind{};          // "UniversalTarget"
    std::string material{};      // "UniversalLitSubTarget"
    const Json* json = nullptr;  // settings of the target
    const Json* material_json = nullptr;
    std::vector<const Json*> data{};  // further settings
    Place place{};
};

struct ShaderGraph {
    std::string error{};
    std::string path{};
    bool is_subgraph = false;
    bool is_old = false;  // one object with JSON in strings
    std::vector<Node> nodes{};
    std::vector<Edge> edges{};
    std::vector<Property> properties{};
    std::vector<Group> groups{};
    std::vector<Note> notes{};
    std::vector<Block> blocks{};
    std::vector<TargetSettings> targets{};  // of an old file: its master node
    const Json* json = nullptr;             // the graph's own object
    struct Problem {
        std::string part, text;
        Place place{};
        bool is_lost = false;  // it is no part of the graph
    };
    std::vector<Problem> problems{};
};

ShaderGraph read_shader_graph(Documents& documents, const Misreads& misreads);

// "UnityEditor.ShaderGraph.MultiplyNode" -> "MultiplyNode"
std::string_view short_class(std::string_view full);

// What both layouts say in the same way.
Slot read_slot(const Json& json, std::string_view full_class);
Property read_property(const Json& json, std::string_view full_class, const Documents& documents);
void read_layout(Node& node);  // position, from its JSON
void read_note(Note& note, const Json& json);

// The two layouts.
void read_new_layout(const Documents& documents, ShaderGraph& graph);
void read_old_layout(Documents& documents, ShaderGraph& graph);

}  // namespace patina::importers::shadergraph
