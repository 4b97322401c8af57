// Describes a compiled material for a renderer: blocks and their layout, textures, samplers, vertex inputs and render
// state. It is plain data. `to_json` writes the text of NAME.reflect.json, and `from_json` reads it back.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "patina/diagnostic.h"
#include "patina/export.h"
#include "patina/words.h"

namespace patina {

// A member of a uniform block.
struct BlockMember {
    std::string name;                   // in the shaders
    ValueType type = ValueType::Float;  // of an array: of one element
    std::uint32_t offset = 0;       // bytes from the start of the block; the same in GLSL std140 and in an HLSL cbuffer
    std::uint32_t size = 0;         // bytes; of an array: of the whole array
    std::uint32_t array_count = 0;  // 0: not an array
    std::uint32_t array_stride = 0;  // bytes from one element of the array to the next
    bool is_of_instance = false;     // an array with an element for each instance of a draw
};

// A uniform block: std140 in GLSL, a cbuffer in HLSL.
struct Block {
    std::string name;                             // in the shaders
    bool is_material = false;                     // the graph's own properties; other blocks are the engine's
    std::uint32_t set = 0;                        // Vulkan descriptor set = HLSL register space
    std::uint32_t binding = 0;                    // Vulkan binding, of GLSL and of HLSL after the shifts
    std::string hlsl_register;                    // "b0, space1"
    std::uint32_t size = 0;                       // bytes, a multiple of 16
    MatrixOrder matrices = MatrixOrder::Columns;  // whether 16 bytes hold a column or a row
    std::vector<BlockMember> members;             // in the order of their offsets
};

// How a texture is sampled.
struct Sampler {
    Wrap wrap = Wrap::Repeat;        // beyond its edges, in every direction
    Filter filter = Filter::Linear;  // between its texels and its levels
    int anisotropy = 1;              // 1 to 16
    // True if all three are equal.
    friend bool operator==(const Sampler&, const Sampler&) = default;
};

// A sampler that has a name: "trilinearRepeat". Textures can share it, nodes can read a texture with it, and it can be
// the value of a property of the type sampler.
struct NamedSampler {
    std::string_view name;  // a filter, then a wrap mode
    Sampler sampler;        // its modes
};
// All samplers that have a name.
inline constexpr std::array kNamedSamplers = {
    NamedSampler{"trilinearRepeat", {Wrap::Repeat, Filter::Linear, 1}},
    NamedSampler{"trilinearClamp", {Wrap::Clamp, Filter::Linear, 1}},
    NamedSampler{"trilinearMirror", {Wrap::Mirror, Filter::Linear, 1}},
    NamedSampler{"nearestRepeat", {Wrap::Repeat, Filter::Nearest, 1}},
    NamedSampler{"nearestClamp", {Wrap::Clamp, Filter::Nearest, 1}},
    NamedSampler{"nearestMirror", {Wrap::Mirror, Filter::Nearest, 1}},
    NamedSampler{"anisotropic4Repeat", {Wrap::Repeat, Filter::Linear, 4}},
    NamedSampler{"anisotropic4Clamp", {Wrap::Clamp, Filter::Linear, 4}},
    NamedSampler{"anisotropic4Mirror", {Wrap::Mirror, Filter::Linear, 4}},
    NamedSampler{"anisotropic16Repeat", {Wrap::Repeat, Filter::Linear, 16}},
    NamedSampler{"anisotropic16Clamp", {Wrap::Clamp, Filter::Linear, 16}},
    NamedSampler{"anisotropic16Mirror", {Wrap::Mirror, Filter::Linear, 16}},
};
// Null if no sampler has the name.
constexpr const NamedSampler* find_sampler(std::string_view name) {
    for (const NamedSampler& each : kNamedSamplers) {
        if (each.name == name) return &each;
    }
    return nullptr;
}
// The name of a sampler; empty if it has none.
constexpr std::string_view name_of(const Sampler& sampler) {
    for (const NamedSampler& each : kNamedSamplers) {
        if (each.sampler == sampler) return each.name;
    }
    return {};
}

// A texture with its sampler: a property of the graph, or the engine's own.
struct Texture {
    std::string name;        // the property's, or the engine's
    std::string identifier;  // in the shaders: the name, or another one if the name is taken
    TextureDimension dimension = TextureDimension::Flat;  // how its texels are arranged
    TextureUsage usage = TextureUsage::Color;             // what its texels hold
    // The shaders apply `handedness` and `swizzle` to every texel that they read, so a program binds the picture as its
    // file has it.
    Handedness handedness = Handedness::OpenGL;  // of a normal map
    std::string swizzle{};                       // four of r, g, b, a, 0 and 1; empty: the channels of the file
    std::array<int, 2> grid{1, 1};  // of an array and a volume: columns and rows of layers in a picture's file
    TextureDefault default_texture = TextureDefault::None;  // the texture to bind if a material sets none
    // Of TextureDefault::File: its path, relative to the compiled graph's folder. If it is a URI, or
    // FileSystem::resolve is the program's own, it is the path that the compiler found.
    std::string default_file{};
    // The default as the JSON writes it: "white", or the path of the file; empty: none.
    std::string default_text() const {
        return default_texture == TextureDefault::File ? default_file : std::string(to_string(default_texture));
    }
    bool is_material = true;            // false: the engine's own, which has no default
    std::string reads{};                // the target of another pass that must be bound here: "gbufferNormal", "depth"
    std::uint32_t set = 0;              // Vulkan descriptor set = HLSL register space
    std::uint32_t binding = 0;          // Vulkan binding, of GLSL and of HLSL after the shifts
    std::string hlsl_register;          // "t0, space1"
    std::string sampler_name;           // textures that share a sampler have the same name and binding
    std::uint32_t sampler_binding = 0;  // in the same set
    std::string sampler_register;       // "s0, space1"
    std::string tiling;                 // member of the material's block: float4 scale and offset; empty: has none
    std::array<double, 4> tiling_default{1, 1, 0, 0};  // the default of that member
    Sampler sampler;                                   // from the graph
    FileLocation place{};                              // of the property in its graph; not in the JSON
};

// A sampler that nodes use instead of a texture's own: a property of the type sampler, or one of kNamedSamplers.
// Textures that share such a sampler have its binding as their sampler's.
struct BoundSampler {
    std::string name;           // the property's, or "trilinearRepeat"
    std::string identifier;     // in the shaders
    bool is_property = false;   // a program can set it
    std::uint32_t set = 0;      // Vulkan descriptor set = HLSL register space
    std::uint32_t binding = 0;  // Vulkan binding, of GLSL and of HLSL after the shifts
    std::string hlsl_register;  // "s0, space1"
    Sampler sampler;            // of a property: its default
};

// A value of a material that a program can set.
struct Property {
    std::string name;                         // in the graph: "_Tint"
    std::string identifier;                   // in the shaders: the name, or another one if the name is taken
    PropertyType type = PropertyType::Float;  // of the value
    std::array<double, 4> value{};            // default; colours linear; bool 0 or 1; enum: index
    // The default of a matrix, by rows; or of a gradient or a curve, as in its array of the block; else empty.
    std::vector<double> numbers{};
    Sampler sampler{};  // the default of a sampler: one of kNamedSamplers
    // Specialization: a constant that is set when a pipeline is made. Variant: the shaders are compiled for `value`
    // only.
    Binding binding = Binding::Uniform;
    std::optional<std::uint32_t> constant_id{};  // of a specialization constant; the same in all passes and variants
    std::optional<std::array<double, 2>> range;  // the lowest and the highest value
    bool hard = false;                           // the range is a limit, not a hint
    std::vector<std::string> values;             // of an enum: its words, by index
    std::string label, group, help;              // for an editor: its title, the heading above it, a tip
    std::string block;                           // its block; empty for textures, specialization constants and variants
    std::uint32_t offset = 0;                    // bytes from the start of that block
    std::uint32_t size = 0;                      // bytes in that block
    std::uint32_t instance_stride = 0;           // bytes to the next instance's value; 0: all instances share one
};

// A vertex attribute of the mesh, which the vertex stage reads.
struct VertexInput {
    std::string name;  // positionOS, normalOS, tangentOS (w: handedness of the bitangent), uv0.., vertexColor
    ValueType type = ValueType::Float;  // in the stage
    std::uint32_t location = 0;         // of GLSL, and of HLSL in Vulkan
    std::string hlsl_semantic;          // "TEXCOORD0"
};

// How a pixel is mixed with the target's pixel.
struct Blend {
    BlendFactor source = BlendFactor::One, destination = BlendFactor::Zero;              // of the colour
    BlendFactor source_alpha = BlendFactor::One, destination_alpha = BlendFactor::Zero;  // of alpha
    // True if all factors are equal.
    friend bool operator==(const Blend&, const Blend&) = default;
    // False if a pixel replaces the target's pixel.
    bool is_on() const { return *this != Blend{}; }
};

// An image that a pass draws into. Passes that name the same target draw into the same image.
struct RenderTarget {
    std::string name;                             // "color": the picture
    std::uint32_t location = 0;                   // of the fragment stage's output
    TargetFormat format = TargetFormat::Rgba16F;  // how it holds a pixel
    Blend blend{};                                // how a pixel is mixed with the target's pixel
};

// The stencil test of a pass, which is the same for both faces.
struct Stencil {
    Compare test = Compare::Always;                      // (reference & read_mask) to (stencil & read_mask)
    StencilOp pass = StencilOp::Keep;                    // if both tests pass
    StencilReference reference = StencilReference::Own;  // Own: it is `value`
    StencilOp fail = StencilOp::Keep;                    // if the stencil test fails
    StencilOp depth_fail = StencilOp::Keep;              // if only the depth test fails
    int value = 0, read_mask = 255, write_mask = 255;    // 0 to 255

    // True if the reference is a number that the materials of one lighting pass share.
    bool is_of_lighting() const { return reference == StencilReference::Lighting; }
    // False if the test rejects no pixel and does not change the stencil.
    bool is_used() const {
        return test != Compare::Always || pass != StencilOp::Keep || fail != StencilOp::Keep ||
               depth_fail != StencilOp::Keep || is_of_lighting();
    }
};

// The bounds of the drawn vertices in object space: a box, or a margin around the mesh's own bounds.
struct Bounds {
    double margin = 0;                                          // metres, on all sides
    std::optional<std::array<std::array<double, 3>, 2>> box{};  // lowest and highest corner; replaces the margin
};

// A file that holds a stage of a pass.
struct ShaderFile {
    Stage stage = Stage::Vertex;  // what it holds
    std::string language;         // "glsl"
    std::string file;             // its name: "rust.forward.frag.glsl"
};

// SPIR-V instructions after `spirv-opt -O`, without declarations. `instructions` includes the other four.
struct CostCounts {
    std::uint32_t instructions = 0;    // of functions' bodies
    std::uint32_t arithmetic = 0;      // sums, products, comparisons, conversions, choices
    std::uint32_t transcendental = 0;  // roots, powers, exponentials, logarithms, trigonometry
    std::uint32_t textures = 0;        // texture reads
    std::uint32_t derivatives = 0;     // by screen coordinates
    // True if all counts are equal.
    friend bool operator==(const CostCounts&, const CostCounts&) = default;
};

// A row for each count: tables, JSON and sums go through these rows.
struct CostFigure {
    const char* name;                  // the key in JSON, and the title of a column: "textures"
    std::uint32_t CostCounts::*count;  // the member of CostCounts
    std::string_view doc;              // "of them: texture reads"
};
// In the order in which they are shown.
inline constexpr CostFigure kCostFigures[] = {
    {"instructions", &CostCounts::instructions, "SPIR-V instructions after spirv-opt -O, without declarations"},
    {"arithmetic", &CostCounts::arithmetic, "of them: sums, products, comparisons, conversions, choices"},
    {"transcendental", &CostCounts::transcendental, "of them: roots, powers, exponentials, logarithms, trigonometry"},
    {"textures", &CostCounts::textures, "of them: texture reads"},
    {"derivatives", &CostCounts::derivatives, "of them: derivatives by screen coordinates"}};
static_assert(sizeof kCostFigures / sizeof *kCostFigures * sizeof(std::uint32_t) == sizeof(CostCounts),
              "each count needs a row");

// Adds each count.
inline CostCounts& operator+=(CostCounts& to, const CostCounts& added) {
    for (const CostFigure& figure : kCostFigures) to.*figure.count += added.*figure.count;
    return to;
}

// What a stage of a pass costs.
struct StageCost {
    CostCounts once{};            // for each vertex or pixel: all that is outside of loops over lights
    CostCounts per_light{};       // for each light: one round of those loops. Of other loops, one round counts, too
    std::uint32_t varyings = 0;   // components that go from the vertex stage to the fragment stage
    std::uint32_t registers = 0;  // components of values that are live at the worst point
    // True if all figures are equal.
    friend bool operator==(const StageCost&, const StageCost&) = default;
    // With one light.
    CostCounts total() const {
        CostCounts sum = once;
        return sum += per_light;
    }
};

// What a pass costs.
struct PassCost {
    StageCost vertex{}, fragment{};   // its stages
    std::uint32_t uniform_bytes = 0;  // of the material's blocks that it reads
    // True if all figures are equal.
    friend bool operator==(const PassCost&, const PassCost&) = default;
};

// A pass of the material: two stages and the fixed-function state that goes with them.
struct Pass {
    std::string name;                             // "forward", unique in the material
    bool is_extra = false;                        // an extra pass of the material; it is drawn by its own queue
    PassDraws draws = PassDraws::Objects;         // what it draws
    PassEach each = PassEach::Once;               // how often
    PassLights lights = PassLights::All;          // the lights that it gets
    PassCamera camera = PassCamera::Any;          // with another camera, the path `fallback` is needed
    std::string fallback;                         // a path; empty if there is none
    Cull cull = Cull::Back;                       // the faces that are not drawn; front faces are counter-clockwise
    std::string depth_target = "depth";           // the image that holds the depth
    bool depth_write = true;                      // its depth replaces the stored depth
    Compare depth_test = Compare::LessEqual;      // compares its depth with the stored depth
    double depth_bias = 0, depth_slope_bias = 0;  // as Vulkan's: in units of the depth format, and times the slope
    Stencil stencil;                              // the material's, or the pass's own
    int queue = 2000;                             // lower ones are drawn first
    // The pass reads, or may read, a target of the picture's size at other pixels than its own. Then the picture cannot
    // be drawn in tiles.
    bool reads_elsewhere = false;
    bool moves_vertices = false;             // in the graph's vertex stage: the drawn bounds are not the mesh's own
    std::optional<Bounds> bounds{};          // for an extra pass: as in Reflection
    std::vector<RenderTarget> targets;       // empty: depth only
    std::vector<VertexInput> vertex_inputs;  // of its vertex stage
    std::vector<ShaderFile> shaders{};       // its stages in each compiled language; empty: one file has all passes
    std::vector<std::string> blocks;         // names of the blocks that either stage reads
    std::vector<std::string> textures;       // names of the textures that either stage reads
    std::vector<std::string> samplers{};     // names of Reflection::samplers that either stage reads
    // The blocks, textures and samplers that each stage reads, for the stage flags of their bindings.
    std::vector<std::string> vertex_reads{}, fragment_reads{};
    std::vector<std::string> keywords{};  // properties that either stage reads as specialization constants or keywords
    // The hash of the pass's computations, which does not depend on the graph's names. Empty without
    // CompileOptions::hashes.
    std::string hash{};
    // Its cost, if a program has measured it. The compiler measures nothing.
    std::optional<PassCost> cost{};
};

// A function for an engine's own shaders. Types are spelled as in HLSL.
struct ShaderFunction {
    std::string name;               // prefix included
    Stage stage = Stage::Fragment;  // where it can be called
    bool is_engines = false;        // the engine provides it
    std::string result;             // its type
    // What it is called with.
    struct Parameter {
        std::string name, type;  // as the text has them
    };
    std::vector<Parameter> parameters;  // in order
};

// An optional part of the passes: shadows, fog.
struct Switch {
    std::string name;    // in CompileOptions::switches: "shadows"
    bool value = false;  // the value for which the shaders were compiled
};

// A descriptor set. Sets with equal hashes have equal blocks and bindings.
struct SetLayout {
    std::uint32_t set = 0;  // Vulkan descriptor set = HLSL register space
    std::string hash;       // 16 hexadecimal digits
};

// A file that was written with a reflection.
struct WrittenFile {
    std::string file;  // its name: "rust.forward.frag.glsl"
    std::string hash;  // file_hash() of its bytes
};
// A hash of the bytes of a file: FNV-1a of 64 bits, as 16 hexadecimal digits. It distinguishes the files of two runs.
// It does not protect against an attacker.
PATINA_API std::string file_hash(std::string_view bytes);

struct ReadReflection;

// Everything that a renderer must know about a compiled material.
struct PATINA_API Reflection {
    std::string name;                           // the graph's
    std::string workflow, lighting;             // as the graph, or CompileOptions::lighting, names them
    SurfaceKind surface = SurfaceKind::Opaque;  // how it covers what is behind it
    std::string path = "forward";               // the rendering path that the passes belong to
    bool moves_vertices = false;                // in the graph's vertex stage: the drawn bounds are not the mesh's own
    std::optional<Bounds> bounds{};             // the bounds of the drawn vertices, if the graph sets them
    // The order of depth in the camera's view. The passes' depth tests and biases agree with it; shadow maps are near
    // to far.
    ClipDepth clip_depth = ClipDepth::NearToFar;
    std::uint32_t most_instances = 0;  // how many instances one draw can hold; 0: a draw draws one object
    std::vector<Switch> switches{};    // the optional parts of the passes
    std::vector<Property> properties;  // in the order of the graph
    // The lighting model's variants, with the values for which the shaders were compiled. Only CompileOptions::switches
    // can set them, so they are not in the JSON.
    std::vector<Property> lighting_options{};
    std::vector<Block> blocks;                // of all passes
    std::vector<Texture> textures;            // of all passes: the material's, then the engine's
    std::vector<BoundSampler> samplers{};     // the samplers that nodes name, in the order of their bindings
    std::vector<Pass> passes;                 // in the order in which they are drawn
    std::vector<ShaderFunction> functions{};  // replace the passes
    std::string layout_hash;                  // of blocks and bindings: layouts with equal hashes are equal
    std::vector<SetLayout> sets{};            // the sets that have a block or a texture, ascending
    // The numbers that glslang adds to the HLSL registers of a set to get bindings.
    struct Shifts {
        std::uint32_t set = 0;                                  // Vulkan descriptor set = HLSL register space
        std::uint32_t textures = 0, samplers = 0, buffers = 0;  // to registers t, s and b
    };
    std::vector<Shifts> hlsl_shifts;  // for each set
    std::string meta;                 // the graph's "meta", unchanged, as JSON; or empty
    // The files that belong to the reflection, if a program has written files: the compiler writes none. If a reader
    // finds a file with another hash, another run was writing at the same time, and the reader must read again.
    std::vector<WrittenFile> files{};

    // The text of NAME.reflect.json: all but Texture::place and `lighting_options`.
    std::string to_json() const;
    // Reads the text of to_json(). Texts of later versions may have more keys. `file` names the text in diagnostics.
    static ReadReflection from_json(std::string_view text, std::string file = "reflection");
    // JSON Schema (draft 2020-12) of the text of to_json().
    static std::string schema();
    // The key "patina" of the text. It changes when programs that read the text must change.
    static constexpr int kVersion = 1;
};

// The result of read_array_value().
struct ReadNumbers {
    bool ok = false;                      // there are no errors
    std::vector<double> numbers;          // as Property::numbers
    std::vector<Diagnostic> diagnostics;  // what is wrong, with its place in the text
};

// Reads a value of a matrix, a gradient or a curve, as graphs write them: "[[1, 0], [0, 1]]".
PATINA_API ReadNumbers read_array_value(PropertyType type, std::string_view json);

// The result of Reflection::from_json().
struct ReadReflection {
    bool ok = false;                      // there are no errors
    Reflection reflection;                // complete if it is ok
    std::vector<Diagnostic> diagnostics;  // what is wrong, with its place in the text
};

}  // namespace patina
