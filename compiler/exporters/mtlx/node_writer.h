// The room `exporters/mtlx` writes materials as MaterialX documents. It reads the IR of a material's surface, before it
// is linked, and knows the nodes and surface shaders of MaterialX. It reads no documents: compiler/importers/mtlx does.
//
// This file: values of the surface as nodes of a node graph. A node is written when something first reads it.
//
//   export_mtlx.cpp   the steps, and the document
//   surface.cpp       what the surface shader gets
//   node_writer.cpp   arithmetic, by the table ops.def
//   conditions.cpp    choices: MaterialX compares and chooses in one node
//   values.cpp        properties, and values of the mesh and of the engine
//   pictures.cpp      pictures and normal maps
//   calls.cpp         functions that MaterialX has a node for, by the table nodes.def
#pragma once

#include <map>
#include <optional>

#include "compiler/exporters/mtlx/document.h"
#include "compiler/ir/ir.h"
#include "compiler/lower/lower.h"

namespace patina::exporters::mtlx {

// A value in the node graph: a number, the output of a node, or an input of the graph.
struct Ref {
    enum class Kind { Numbers, Node, Input };
    Kind kind = Kind::Numbers;
    std::string name{};             // of the node or input
    std::string type{};             // "color3"; of numbers: empty, they have the type of their reader
    std::vector<double> numbers{};  // one for each component

    bool is_number() const { return kind == Kind::Numbers; }
    bool is_color() const { return type.starts_with("color"); }
    bool is_all(double number) const;
};
struct Argument {
    std::string name{};
    Ref value{};
    std::string type{};
    std::string colorspace{};  // of a picture: programs read it where the picture is read
};
// "float", "vector3", "color3".
std::string type_word(unsigned width, bool is_color = false);
unsigned width_of(std::string_view type);

class NodeWriter {
public:
    NodeWriter(resolve::Session& session, const resolve::Material& material, const lower::Lowered& lowered,
               const ir::Function& function, std::string folder);

    Ref value(ir::Value value);
    // The same in another type; a scalar becomes a vector of equal components.
    Ref as(const Ref& ref, const std::string& type);
    Ref component(const Ref& ref, unsigned index);
    // Joins floats.
    Ref join(const std::vector<Ref>& parts, bool is_color = false);
    // "NUMBER op in": of floats and vectors.
    Ref combine(std::string_view category, const Ref& a, const Ref& b);
    Ref one(std::string_view category, const Ref& in);  // a node with one input
    Ref truncated(const Ref& in);                       // towards 0
    Ref node(std::string_view category, std::string type, std::vector<Argument> arguments,
             std::vector<std::pair<std::string, std::string>> words = {});
    // The value that a condition chooses; `index`: the component of a vector of conditions.
    Ref choose(ir::Value condition, unsigned index, const Ref& yes, const Ref& no);
    // For shaders that take a normal in tangent space; nothing: it is not in that space.
    std::optional<Ref> tangent_normal(ir::Value world);
    // An input of an element: its value, or what it reads.
    static void write_input(Element& element, const Argument& argument);

    // What reads the values from now on: a value that comes from no node is reported there, and called after it.
    void set_reader(Span span, std::string_view input) {
        reader_ = span;
        reader_name_ = input;
    }
    void refuse(ir::Value value, std::string_view what);
    void differs(Span span, std::string_view text);
    // The node of the graph that the value comes from.
    Span span_of(ir::Value value) const;

    const ir::Function& function() const { return function_; }
    const ir::Inst& operator[](ir::Value value) const { return function_[value]; }
    std::optional<std::vector<double>> constant(ir::Value value) const;
    std::string_view semantic(ir::Value value) const;  // its name; empty: it is none
    std::string_view callee(ir::Value value) const;    // its name; empty: it is no call
    Element& graph() { return graph_; }

private:
    Ref made(ir::Value value);
    std::optional<Ref> arithmetic(ir::Value value);
    std::optional<Ref> composed(ir::Value value);
    std::optional<Ref> parts(ir::Value value);
    Ref semantic_value(ir::Value value);
    Ref global_value(ir::Value value);
    Ref property_value(const format::Property& property);
    Ref sampled(ir::Value value);
    Ref picture(ir::Value texture, ir::Value at, std::string type);
    Ref turned(const Ref& coordinates);
    Ref coordinates(std::uint32_t index);
    Ref unpacked_normal(ir::Value value);
    Ref world_normal(ir::Value value);
    std::optional<Ref> called(ir::Value value);
    Argument picture_input(const resolve::MaterialProperty& property);
    void describe(Element& input, const format::Property& property) const;

    resolve::Session& session_;
    const resolve::Material& material_;
    const lower::Lowered& lowered_;
    const ir::Module& module_;
    const ir::Function& function_;
    std::string folder_;
    Element graph_{};
    Names names_{};
    std::map<std::uint32_t, Ref> values_{};
    std::map<std::string, Ref> nodes_{};                // by what they are
    std::map<std::string, Ref> turned_{};               // by turned coordinates: what they were
    std::map<std::string, std::vector<Ref>> joined_{};  // by the name of the node: its components
    std::map<std::string, Ref> whole_{};   // by the name of the node that makes a float of it: a whole number
    std::map<std::string, Ref> inputs_{};  // by the property's name
    ir::Value current_{};                  // what the next node is called after
    std::string wanted_{};                 // unless this is its name
    Span reader_{};
    std::string reader_name_{};
    std::set<std::string> reported_{};
};

}  // namespace patina::exporters::mtlx
