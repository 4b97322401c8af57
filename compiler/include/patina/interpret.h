// The CPU reference: runs a stage of a compiled material on 2x2 pixel quads, directly from the unoptimised IR, in float
// or double. Folding, identities and printers, which the GPU's shaders went through, are not used here. It is slow and
// exact, and it is not a renderer: the runtime's `--via cpu` adds a rasteriser.
//
//   Result r = compiler.compile_file(path, {.keep_programs = true});
//   Interpreter fragment(*r.program, "forward", Stage::Fragment, Precision::Double);
//   fragment.set_block("Material", bytes);
//   QuadOutputs out = fragment.run(quad);
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "patina/patina.h"

namespace patina {

// The numbers that the interpreter computes in: 32 or 64 bits.
enum class Precision { Float, Double };

// A texture that the interpreter reads: linear RGBA texels, level 0 first; rows from the top, as a GPU stores them.
// Layers follow each other. Each level of a cube has its six faces in order: +X, -X, +Y, -Y, +Z, -Z, with Vulkan's
// layout.
struct TextureLevel {
    int width = 0, height = 0;  // texels
    std::vector<float> texels;  // 4 * width * height, for each layer
    int depth = 1;              // of a 3D texture: its layers; smaller levels have fewer
};
// A texture with its levels, and how it is sampled.
struct TextureData {
    std::vector<TextureLevel> levels;  // the finest first
    Sampler sampler;                   // how points between and beyond the texels are read
    int layers = 1;                    // of an array; 6: also of a cube, whose sides are square
};

// The values of all stage inputs for the four pixels of a quad (0 1 / 2 3: right is +x, down is +y): their components,
// in the order of inputs(). In a vertex stage the four lanes are independent vertices.
struct QuadInputs {
    std::array<std::vector<double>, 4> lanes;  // of each pixel, or vertex
};
// What a stage computes for a quad.
struct QuadOutputs {
    std::array<std::vector<double>, 4> lanes;  // components of outputs(), in order
    std::array<bool, 4> discarded{};           // pixels that are not drawn
    bool is_over_budget = false;               // the run ended early, and all components are 0
};

// An input or an output of a stage.
struct StageValue {
    std::string name;         // input: positionOS, uv0, a varying's name; or frontFacing, fragCoord
    unsigned components = 1;  // 1 to 4
    bool is_builtin = false;  // "position" output; "frontFacing" (0, 1), "fragCoord", "vertexIndex", "instanceIndex"
    bool is_flat = false;     // whole numbers: one value for a triangle
};

// The value of one port of a graph for a quad.
struct TracedValue {
    // What has the value.
    enum class Kind {
        Node,    // `node` is an id path: "rust", "rust/height" in the sub-graph of the node "rust"
        Output,  // of the graph itself: "surface" and the input's name, "direct", "indirect", "final", "vertex"
        Given,   // passed to the graph: "@light", "@sum"
    };
    Kind kind = Kind::Node;      // what has the value
    std::string graph;           // "material", "workflow" or "lighting"
    std::string node;            // as `kind` says
    std::string port;            // "out", or the output's name
    std::string type;            // "float3"
    std::vector<double> values;  // components; matrices row by row; bool 0 or 1
    int light = -1;              // index of the light, if the value depends on it; else -1
    std::string file;            // the location in the graph's text
    int line = 0, column = 0;    // of that location, from 1
};
// The kind as a word: "node", "output", "given".
PATINA_API std::string_view to_string(TracedValue::Kind kind);

// Runs one stage of a pass. Only one thread at a time may use an interpreter.
class PATINA_API Interpreter {
public:
    // The stage of a pass, as Result::reflection names it. The program must live as long as the interpreter. If the
    // program has no such stage, the interpreter has no inputs and outputs.
    Interpreter(const Program& program, std::string_view pass, Stage stage, Precision precision);
    ~Interpreter();
    Interpreter(Interpreter&&) noexcept;  // what was moved from can only be destroyed

    const std::vector<StageValue>& inputs() const;   // the values that a quad must have, in order
    const std::vector<StageValue>& outputs() const;  // the values that the stage computes, in order

    // Sets the bytes of a uniform block, in the layout of the reflection; missing bytes are 0. Names that the stage
    // does not know are ignored, here and below.
    void set_block(std::string_view name, std::span<const std::byte> bytes);
    // Sets one member of a uniform block, or a specialization constant, by its name. The components keep the precision
    // of a double.
    void set_value(std::string_view name, std::span<const double> components);
    // Sets a texture and its sampler, by Texture::identifier. A texture that is not set has 1 in all texels.
    void set_texture(std::string_view name, std::shared_ptr<const TextureData> texture);
    // Sets one of Reflection::samplers, by its identifier. If it is not set, textures are read with their own samplers.
    void set_sampler(std::string_view name, const Sampler& sampler);

    // The limit of operations for one run. A material has some thousands; only a loop that does not end has more.
    static constexpr std::uint64_t kMostSteps = std::uint64_t{1} << 24;
    // Runs the four lanes of a quad. Missing components are 0. After kMostSteps operations the run ends:
    // `is_over_budget` is true, and all outputs are 0.
    QuadOutputs run(const QuadInputs& quad);
    // Runs the quad and returns every node's value in one lane (0 to 3): graph after graph in the order of execution,
    // each node after those that it reads, and values that depend on the light after the others. Nodes that this stage
    // does not need are missing.
    std::vector<TracedValue> trace(const QuadInputs& quad, unsigned lane);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace patina
