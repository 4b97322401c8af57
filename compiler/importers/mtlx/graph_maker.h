// Makes the graph of one material. It starts at the inputs of the material's surface shader and evaluates what they
// read; a node comes after those that it reads. Node graphs are not kept: what is in them becomes nodes of the graph,
// and what their interfaces set becomes its properties. A node whose definition is in the document is replaced by what
// implements it, once for each use.
//
//   graph_maker.cpp     makes the nodes in order and names them; the remarks
//   connections.cpp     which value an input has: interfaces, definitions, outputs
//   inputs.cpp          what is wrong with the inputs of a node
//   library.cpp         definitions of the standard library
//   rules.cpp           nodes of the table
//   special_nodes.cpp   nodes that no row can say, by a list of functions
//   noise.cpp           noise, whose nodes the library has
//   textures.cpp        pictures
//   surface.cpp         what the shader gets
//   refusals.cpp        what the compiler would refuse of the result
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>

#include "compiler/importers/imported_graph.h"
#include "compiler/importers/importer.h"
#include "compiler/importers/mtlx/node_table.h"
#include "compiler/importers/mtlx/read/document.h"
#include "compiler/importers/terms.h"

namespace patina::importers::mtlx {

using terms::Term;
using terms::Type;

// What the graphs of one document share.
struct Import {
    const Document& document;
    std::string path{}, folder{};        // of the document; that will be written to
    std::vector<std::string> folders{};  // that are searched for pictures
    std::vector<Remark> remarks{};
    terms::Names file_names{};
    std::set<const Element*> reached{};
    std::unordered_map<const Element*, std::size_t> order{};  // of all elements in the document; empty: not asked yet
    bool has_refused = false;
    std::string error{};  // the document cannot be imported: a node reads itself
};

// A node graph, or the document, as it is used in one place.
struct Scope {
    const Element* element = nullptr;
    Scope* around = nullptr;              // in which a node graph stands
    const Element* definition = nullptr;  // the nodedef that it implements
    const Element* instance = nullptr;    // the node that it replaces, which stands in
    Scope* caller = nullptr;              // this scope
    std::size_t number = 0;
    std::map<std::string, std::size_t, std::less<>>
        uses{};  // how often something is read: "mask", "$input", "graph/output"
};

// The input that says a value at last, after all interfaces.
struct Source {
    const Element* input = nullptr;  // null: nothing says it
    Scope* scope = nullptr;          // in which its connections are looked for
    bool is_interface = false;       // it is an input of a node graph that nothing connects: a property
};

// How a picture is read.
struct Sampling {
    std::string wrap = "repeat", filter = "linear";
    bool is_normal = false;
};

class GraphMaker {
public:
    GraphMaker(Import& import, std::string name);

    // The graph of a surface shader, which stands in the document or in a node graph. `material`: for the report.
    void make(const Element& material, const Element& shader, Scope& scope);
    ImportedGraph& file() { return file_; }
    Scope& document_scope() { return *scopes_.front(); }

    // --- for those who evaluate nodes
    Import& import() { return import_; }
    Source source_of(Scope& scope, const Element& node, std::string_view input);
    bool is_set(Scope& scope, const Element& node, std::string_view input);
    // The type of an input that is set; empty, if it is not.
    std::string type_of(Scope& scope, const Element& node, std::string_view input);
    // A string, a number or a switch that is stated, and not computed.
    std::string word_of(Scope& scope, const Element& node, std::string_view input);
    // The value of an input, in its type. `may_stay_number`: who takes it converts numbers to vectors.
    Term input(Scope& scope, const Element& node, const Port& port, bool may_stay_number = false);
    Term geometry(std::string_view property, Type type);  // "UV0", "Nworld"
    // A link to the term, which becomes a node of its own unless it is a link already.
    Term named(const Term& term);
    std::string add_node(const Element& node, ImportedNode made, std::string_view wanted = {});
    void written(const Term& term, std::string_view where);
    void refuse(const Element& node, std::string reason);
    void approximate(const Element& node, std::string difference);
    Term magenta(const Element& node, Type type, std::string_view reason);
    void remark(Remark::Kind kind, std::string part, std::string text, const Element& place);
    // The texture of a node, sampled.
    Term sampled(Scope& scope, const Element& node, Term coordinates, std::string_view file_input = "file",
                 std::string_view wrap_input = "uaddressmode", std::string_view other_wrap_input = "vaddressmode");
    // By the words of the node. What a sampler cannot do is said.
    Sampling sampling_of(Scope& scope, const Element& node, std::string_view wrap_input = "uaddressmode",
                         std::string_view other_wrap_input = "vaddressmode");
    // What a property of the interface shows that names no picture: "black"; empty: it names one, or is no property, or
    // the node has another colour then.
    std::string shown_without_file(Scope& scope, const Element& node, std::string_view file_input, bool is_normal);
    // The texture's property: "$_Wood".
    std::string texture(Scope& scope, const Element& node, std::string_view file_input, const Sampling& sampling);
    // "label", "group" and "help" of a property.
    static void describe(const Element& input, ImportedProperty& property);

    Term sampled_normal(const Element& node, const Term& texel, const Term& scale);
    std::size_t uses(const Scope& scope, const Element& node) const;
    // Its number among the nodes of terms; it is reported.
    std::size_t note(const Element& node);
    Term literal(const Element& input, std::string_view type, std::string_view text);
    // The text with its placeholders filled in.
    Term filled(Scope& scope, const Element& node, const NodeRule& rule, const std::string& text, Type type,
                std::map<std::string, std::size_t>& counts, const Term& self = {});
    Scope& scope_of(const Element& graph, Scope& around, const Element* definition = nullptr,
                    const Element* instance = nullptr, Scope* caller = nullptr);
    const Element* find(Scope& scope, std::string_view name) const;
    const Element* implementation(const Element& node, const Element*& definition) const;
    Term evaluate(Scope& scope, const Element& node, std::string_view output);

private:
    using Key = std::tuple<std::size_t, const Element*, std::string>;
    struct Texture {
        std::string property{};
        bool is_normal = false;
    };

    const Element& stated(Scope& scope, const Element& input) const;
    Term value_at(Scope& scope, const Element& input, Type type);
    Term connected(Scope& scope, const Element& input);
    Term output_of(const Element& graph, Scope& around, std::string_view output, const Element& reader);
    Term computed(Scope& scope, const Element& node, std::string_view output);
    std::string kept_inputs(const Element& node);
    static const Element* implementation_in(const Element& root, const Element& node, const Element*& definition);
    void check_inputs(Scope& scope, const Element& node);
    Term property_of(const Element& input);
    void make_surface(Scope& scope, const Element& shader);
    bool has_effect(Scope& scope, const Element& shader, const Port& port);
    bool is_default(Scope& scope, const Element& shader, const SurfaceRule::Ignored& ignored);
    void add_to_surface(const std::string& key, const Term& value);
    void refuse_invalid(const Element& shader, std::size_t first_remark);
    void sort_properties();
    void report_nodes();
    std::size_t number_of(const Element& node);
    // A node with one input, "in". It is reported as `place`, and lives as long as this.
    const Element& node_with(Element input, const Element& place);

    Import& import_;
    std::string name_;
    ImportedGraph file_;
    std::vector<std::unique_ptr<Scope>> scopes_{};
    std::map<Key, Term> values_{};
    std::set<Key> open_{};
    std::vector<const Element*> elements_{};  // by number
    std::deque<Element> made_{};              // elements that no document has
    std::map<const Element*, std::size_t> numbers_{};
    std::map<const Element*, Term> properties_{};    // of inputs of node graphs
    std::vector<const Element*> property_places_{};  // of the properties, in their order: what says them
    std::map<std::string, Texture> textures_{};      // by file and how it is read
    std::map<std::string, std::string> samples_{};   // by texture and coordinates: the node
    Scope* scope_ = nullptr;                         // of the node that is evaluated
    std::size_t depth_ = 0, evaluated_ = 0;
    std::string scope_label_{};
};

// The inputs that a row of the table reads, each as often as it does.
std::vector<std::string> inputs_in(std::string_view text);
// Evaluates a node by the table; nothing: it is not in the table.
std::optional<Term> apply_rule(GraphMaker& maker, Scope& scope, const Element& node, std::string_view output);
// Evaluates a node that has a function of its own; nothing: it has none.
std::optional<Term> apply_special(GraphMaker& maker, Scope& scope, const Element& node, std::string_view output);
std::vector<std::string_view> special_nodes();

Type type_of_word(std::string_view type);  // "color3"; None: it is no value of a graph
bool is_color(std::string_view type);
bool is_input(const Element& element);
const Element* input_of(const Element& node, std::string_view name);  // null: it is not stated
void count_uses(const Element& around, std::map<std::string, std::size_t, std::less<>>& uses);

}  // namespace patina::importers::mtlx
