// The room `format` reads graphs and scenes, writes their canonical text and makes their JSON Schema. It checks keys,
// JSON types and words. It resolves no name, opens no file that a graph names, and knows no types.
//
// A Graph is a graph as its file states it. The values at ports are syntax trees of the node language (nodelang/ast.h),
// which get their types in lower/lower.h.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/base/source.h"
#include "compiler/nodelang/ast.h"
#include "patina/reflection.h"
#include "patina/words.h"

namespace patina::format {

enum class GraphKind { Material, Subgraph, Lighting, Workflow };

// name: value, as in "in": { "uv": "@uv0" }
struct PortValue {
    std::string name;
    Span name_span;
    Span value_span;                        // the JSON value
    const nodelang::Expr* value = nullptr;  // null: it cannot be read, which has been reported
};

enum class Precision { Inherit, Float, Half };
// The stage that computes a node: the stage of its readers, or the stage in its key "stage".
enum class NodeStage { OfReaders, Fragment, Vertex };

struct Node {
    std::string id;
    Span id_span;
    Span span;         // the whole object
    std::string type;  // library node, "./x.subgraph.json" or "./x.node.hlsl"; empty for an expression
    Span type_span;
    std::vector<PortValue> inputs;
    const nodelang::Expr* expr = nullptr;
    Span expr_span;
    bool is_expression = false;
    NodeStage stage = NodeStage::OfReaders;
    Span stage_span;
    Precision precision = Precision::Inherit;
    std::string note;
};

// A property with this binding is known before a shader runs, so it has no member in the material's block.
constexpr bool is_keyword(Binding binding) {
    return binding == Binding::Specialization || binding == Binding::Variant;
}

// How a gradient goes from key to key: in a straight line, at once, or in a straight line in OkLab.
enum class GradientBlend { Linear, Fixed, Perceptual };

struct Property {
    std::string name;
    Span name_span;
    Span span;
    PropertyType type = PropertyType::Float;
    std::array<double, 4> value{};  // default; colours linear; bool 0 or 1; enum: index
    std::vector<double> numbers;    // default of a matrix, by rows, or of a gradient or a curve, as the shader holds it
    std::string texture;            // default texture: "white", "black", "gray", "bump", or a file "./x.png" as written
    Span default_span;
    std::optional<std::array<double, 2>> range;
    bool hard = false;                // values outside the range are refused
    std::vector<std::string> values;  // of an enum
    std::vector<Span> value_spans;    // of each
    std::string label, group, help;
    Span label_span, group_span;
    TextureUsage usage = TextureUsage::Color;
    std::optional<Span> usage_span;  // where it is set
    bool tiling = false;
    Handedness handedness = Handedness::OpenGL;  // of a normal map
    std::string swizzle;                         // "bgra": four of r, g, b, a, 0 and 1; empty: as the file has them
    Span handedness_span, swizzle_span;
    std::array<int, 2> grid{1, 1};  // of a texture2dArray and a texture3d: columns and rows of layers in the picture
    Sampler sampler;                // of a texture; or the default of a sampler
    std::string shared_sampler;     // the name of that; empty: a texture has its own
    Span sampler_span;
    Binding binding = Binding::Uniform;  // Specialization and Variant: bool and enum
    Span binding_span;
};

// An input of a sub-graph, a workflow or (declared under "surface") a lighting model.
struct Input {
    std::string name;
    Span name_span;
    std::string type;  // "float", "float3", "color", "texture2d", ...
    Span type_span;
    const nodelang::Expr* value = nullptr;  // default; null: must be given
    Span default_span;
    std::optional<std::array<double, 2>> range;
    bool hard = false;
    std::string help;
    // Workflows only: a material may set this input instead of the one named `gives`. The expression `as`, which reads
    // $name, converts its value.
    std::string gives;
    const nodelang::Expr* as = nullptr;
};

struct Graph;

// "unity-brdf1", "./toon.lighting.json", { "use": ..., "in": {...} }, or a graph inline.
struct LightingUse {
    std::string use;  // name or file; empty if inline or absent
    Span span;
    std::vector<PortValue> inputs;
    std::shared_ptr<Graph> inlined;
    bool present = false;
};

struct StencilState {
    int reference = 0, read_mask = 255, write_mask = 255;
    Compare test = Compare::Always;
    StencilOp pass = StencilOp::Keep, fail = StencilOp::Keep, depth_fail = StencilOp::Keep;
    Span span;

    bool changes() const { return pass != StencilOp::Keep || fail != StencilOp::Keep || depth_fail != StencilOp::Keep; }
};
struct RenderState {
    SurfaceKind surface = SurfaceKind::Opaque;
    Span surface_span;  // of the value of "surface"; empty if there is none
    Cull cull = Cull::Back;
    std::optional<bool> depth_write;
    bool allows_override = false;  // "materialOverride": a material can have another kind, other faces and depth
    bool is_overridable = false;   // the same, in an engine that can do it (resolve/surface_choices.cpp)
    std::optional<Compare> depth_test;
    std::optional<std::array<double, 2>> depth_offset;  // factor, units
    std::optional<StencilState> stencil;
    std::optional<int> queue;
    std::optional<Bounds> bounds;
    Span span;
};

// A combination of variants that the graph lists: "variants": [ { "_DETAIL": true } ].
struct ListedVariant {
    struct Value {
        std::string name;
        Span name_span;
        std::string word;      // "true", "Wet"
        bool is_bool = false;  // true or false, not a string
        Span value_span;
    };
    std::vector<Value> values;
    Span span;
};

// An element of "passes": another surface of a material, drawn in addition to the material's own. It is a graph that
// has the material's nodes and properties. It inherits every key that it does not state from the material.
struct ExtraPass {
    std::string name;
    Span name_span;
    std::shared_ptr<Graph> graph;
};

// The most that a stage of a pass may cost. Compiling does not measure: `patina check` does.
struct Budget {
    struct Limit {
        int most = 0;
        Span span;
    };
    std::optional<Limit> instructions, textures;
};

struct Graph {
    GraphKind kind = GraphKind::Material;
    std::string path;  // as the file was named; "" for an inline graph
    std::string name;  // "name", or the file's stem
    Span name_span;    // of the value; empty if the name is the file's
    std::string help;  // what a lighting model, a workflow or a sub-graph is for
    Span span;
    std::string workflow;
    Span workflow_span;
    LightingUse lighting;
    Precision precision = Precision::Float;
    std::vector<Property> properties;
    std::vector<Node> nodes;
    std::vector<Input> inputs;       // sub-graph, workflow; in a lighting graph: the "surface" declarations
    std::vector<PortValue> vertex;   // material
    std::vector<PortValue> surface;  // material: surface inputs; workflow: members of the lighting surface
    std::vector<PortValue> outputs;  // sub-graph; in a lighting graph: direct, indirect, final
    // Workflow: the input that shows a previewed node ("preview": "color"). A workflow that shows a value as it is has
    // no lighting.
    std::string preview_input;
    RenderState render;
    std::vector<ExtraPass> passes;        // material
    std::vector<ListedVariant> variants;  // material
    Budget budget;                        // material
    std::string meta;                     // raw JSON text of "meta"; carried to the reflection

    bool is_lit() const { return preview_input.empty(); }  // of a workflow
};

}  // namespace patina::format
