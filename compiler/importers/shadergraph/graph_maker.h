// Makes a graph of Patina from a shader graph. It evaluates one node after the other; a node comes after those that it
// reads. The parts of this work lie in files of their own:
//
//   graph_maker.cpp      the order; what an input is; which value gets a name
//   node_rules.cpp       nodes of the table
//   special_nodes.cpp    nodes that no row can say, by a list of functions
//   blackboard.cpp       properties, keywords, inputs of sub-graphs
//   textures.cpp         textures and samplers
//   surface.cpp          what the target gets, and its settings
//   refusals.cpp         what the compiler would refuse of the result
//   layout.cpp           positions, groups, notes; the remarks of nodes
//   code/                custom functions
//   values/              types, and values as text
//   read/                the file, and files that it names
#pragma once

#include <array>
#include <map>
#include <set>
#include <span>

#include "compiler/importers/imported_graph.h"
#include "compiler/importers/shadergraph/node_table.h"
#include "compiler/importers/shadergraph/project.h"
#include "compiler/importers/shadergraph/values/types.h"
#include "compiler/importers/terms.h"

namespace patina::importers::shadergraph {

// Where the node of a keyword is used, and the engine does not declare the keyword: its last entry counts there.
enum class KeywordUse { Declared, Off, OffInVertex, OffInFragment };

// What the texels of a texture are.
enum class TextureMeaning { Color, Data, Normal };

class GraphMaker {
public:
    GraphMaker(Project& project, const ShaderGraph& graph, std::string name);

    // Empty, or why there is no graph.
    std::string make();
    ImportedGraph& file() { return file_; }
    SubgraphPorts& ports() { return ports_; }

    // --- for those who evaluate nodes
    const ShaderGraph& graph() const { return graph_; }
    const Node& node(std::size_t index) const { return graph_.nodes[index]; }
    Project& project() { return project_; }
    bool is_linked(std::size_t node, int slot) const { return edges_.contains({node, slot}); }
    bool is_used(std::size_t node, int slot) const { return uses_.contains({node, slot}); }
    std::size_t uses(std::size_t node, int slot) const;
    bool is_in_fragment(std::size_t node) const { return in_fragment_.contains(node); }
    KeywordUse keyword_use(std::size_t node, const Property& keyword) const;
    // The type of a slot, which for a dynamic one follows from what is connected to the node.
    Type type_of(std::size_t node, const Slot& slot) const;
    // The value at an input, in the type of its slot. `may_stay_number`: who takes it converts numbers to vectors.
    Term input(std::size_t node, int slot, bool may_stay_number = false);
    // The value of an input whose slot the file lacks.
    Term without_slot(std::size_t node, int slot);
    // The same as it comes, in whatever type; nothing if the input is not connected.
    std::optional<Term> linked_term(std::size_t node, int slot) const;
    // `is_handed_on`: it is the value of an input, and keeps the name that it would have there.
    void set(std::size_t node, int slot, Term term, bool is_handed_on = false);
    // A link to the term, which becomes a node of its own unless it is a link already.
    Term named(const Term& term);
    // Names for the longest of them, if a line of the node with all of them and `length` more characters gets too long.
    void shorten(std::size_t node, std::vector<Term>& terms, std::size_t length);
    // Adds a node that stands for this one, and returns its id.
    std::string add_node(std::size_t node, ImportedNode made, std::string_view wanted = {});
    // Notes where the nodes that the term holds have gone.
    void written(const Term& term, std::string_view where);
    void refuse(std::size_t node, std::string reason);
    void approximate(std::size_t node, std::string difference);
    void taken(std::size_t node, std::string where);
    void remark(Remark::Kind kind, std::string part, std::string text, Place place);

    // Texture coordinates of the mesh, as the engine counts them.
    Term coordinates(std::size_t node, int channel);
    // A value of the mesh or the camera, in a space.
    Term bound(std::size_t node, const Slot& slot, const Term& otherwise);
    // The texture that a slot or an asset holds, as a property of its own.
    Term texture_constant(std::size_t node, Type type, const Json* holder, std::string_view key, int default_type);
    // Notes what the texels are for a node.
    void sample(const Term& texture, TextureMeaning meaning);
    // The sampler that is connected to the node; nothing if the texture's own counts.
    std::optional<Term> linked_sampler(std::size_t node) const;
    Term property_term(std::size_t node);
    const Property* property(std::string_view id) const;
    std::string property_name(const Property& property) const;
    // For a node that samples the texture "_MainTex": "mainTex"; after the name that is shown, if Unity made the other.
    std::string name_for_texture(std::string_view property) const;
    // The id of the node that holds a custom interpolator of the vertex block.
    const std::string& interpolator(std::string_view name) const { return interpolators_.find(name)->second; }
    // In a sub-graph: the input that says whether that one is connected.
    std::string connected_input(const Property& property);
    // The name of a file with a function; the same for the same text.
    std::string node_file(const std::string& function, const std::string& text);
    void keep_node_file(const std::string& file, const std::string& text);

private:
    using Key = std::pair<std::size_t, int>;
    struct TextureUse {
        bool is_normal = false, is_color = false, is_data = false;
        bool is_linear = false;            // its default says so
        const Picture* picture = nullptr;  // that it shows; null: none
        std::string renamed{};             // from what, in words
        std::size_t node = 0;              // of a texture that is no property: which one holds it
    };

    void read_precision();
    void find_order();
    std::set<std::size_t> nodes_of_stage(bool is_vertex) const;
    void evaluate(std::size_t node);
    std::string kept_inputs(std::size_t node);
    void say_misread(std::size_t node, std::string misread);
    void read_blackboard();
    void finish_textures();
    void declare_texture(ImportedProperty& made, TextureUse& use, const Property& source, std::string& difference);
    void make_surface();
    Term block_value(const Block& block, Type type);
    void weigh(const Term& color, const Term& alpha, bool is_faded);
    void add_pinned(std::string id, const Block& block);
    void say_block(std::string part, std::string text, Place place);
    void say_unread(const Block& block, const std::string& part, bool is_there, std::string_view lost);
    void make_outputs();
    void drop_unread();
    void make_layout();
    std::string refuse_invalid();
    void report_nodes();
    std::string name_of_node(std::size_t node, std::string_view wanted);
    GraphMembers of_precision(std::size_t node) const;
    std::string_view own_precision(std::size_t node) const;  // if it is not that of the graph
    std::string part_of(std::size_t node) const;

    Project& project_;
    const ShaderGraph& graph_;
    std::string name_;
    bool is_half_ = false;  // the precision of the graph
    ImportedGraph file_;
    SubgraphPorts ports_{};

    std::map<Key, Key> edges_{};         // input -> output
    std::map<Key, std::size_t> uses_{};  // of outputs, by nodes that count
    std::vector<std::size_t> order_{};
    std::set<std::size_t> in_fragment_{};  // nodes that something but the vertex block reads
    std::set<std::size_t> in_vertex_{};    // that the vertex block reads
    std::map<Key, Term> terms_{};          // outputs
    struct DynamicTypes {
        Type vector = Type::Float, matrix = Type::Matrix2;
    };
    std::vector<DynamicTypes> dynamic_types_{};           // of each node that was evaluated
    std::vector<std::string> kept_{};                     // texts of what refused nodes read
    std::array<bool, 4> reads_uv_{};                      // by set: something reads the node of its coordinates
    std::map<std::string, std::string> properties_{};     // id of the property -> name
    std::map<std::string, TextureUse> textures_{};        // by name of the property
    std::map<std::string, std::string> texture_names_{};  // GUID -> property
    std::map<std::string, std::string, std::less<>> interpolators_{};  // name of a custom interpolator -> id
};

// An entry of a keyword that is a list. Unity's symbol is the keyword's reference name, "_", and the entry's.
struct KeywordEntry {
    std::string word{};        // in the graph: its reference name
    std::string difference{};  // from the reference name, in words
    std::string shown{};       // in an inspector
    int id = 0;                // of the slot that it chooses
};
// What a graph does not say of where the property's value comes from, in words.
std::string_view scope_difference(const Property& property);
std::string_view hidden_difference(const Property& property);
std::vector<KeywordEntry> keyword_entries(const Property& keyword);  // empty: it is a switch

// Why a node is refused that is neither in the table nor has a function of its own.
std::string reason_for_unknown(const Node& node);

// Evaluates a node by the table; false: it is not in the table.
bool apply_rule(GraphMaker& maker, std::size_t node);
// Evaluates a node that has a function of its own; false: it has none.
bool apply_special(GraphMaker& maker, std::size_t node);
// The classes that have one.
std::vector<std::string_view> special_classes();

// The sampler nearest to a state of Unity's, and how it differs, in words.
struct NearestSampler {
    std::string_view name{};
    std::string difference{};
};
// 0 linear, 1 point, 2 trilinear; 0 repeat, 1 clamp, 2 mirror, 3 mirror once; 0 none, 1 to 4: 2, 4, 8 and 16.
NearestSampler nearest_sampler(int filter, int wrap, int anisotropy);

Gradient gradient_of(const Json* json);  // as a slot or a property holds it
void make_gradient(GraphMaker& maker, std::size_t node);
void make_sample_gradient(GraphMaker& maker, std::size_t node);
// Nodes with files of their own.
void make_subgraph_node(GraphMaker& maker, std::size_t node);
void make_custom_function(GraphMaker& maker, std::size_t node);

}  // namespace patina::importers::shadergraph
