// What the shaders of a compiled material cost: SPIR-V instructions, registers, and the share of each node. Links
// glslang and SPIRV-Tools; the core library does not, so the reflection has no cost unless somebody adds it.
//
//   const MaterialCost cost = measure_cost(compiled);
//   for (const PassCost& pass : cost.passes) print(pass.name, pass.fragment.once.total());
//   reflection = with_cost(compiled.reflection.to_json(), cost);
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "patina/graph_view.h"

namespace patina {

// Numbers of SPIR-V instructions after `spirv-opt -O`, by what computes them. Labels and declarations are none.
struct Instructions {
    std::uint32_t arithmetic = 0;      // sums, products, comparisons, conversions, min, mix, dot, matrices
    std::uint32_t transcendental = 0;  // roots, powers, exponentials, angles, lengths, divisions
    std::uint32_t texture = 0;         // reads of textures
    std::uint32_t derivative = 0;      // with respect to the pixel
    std::uint32_t other = 0;           // reads and writes of variables, parts of vectors, branches

    std::uint32_t total() const { return arithmetic + transcendental + texture + derivative + other; }
    Instructions& operator+=(const Instructions& more);
    friend bool operator==(const Instructions&, const Instructions&) = default;
};

// The part of a stage's cost that comes from one node.
struct NodeCost {
    std::string node;    // "albedo", "layers/mask" inside a sub-graph
    std::string source;  // if no node computes it, what the graph says there: "= albedo.rgb * 0.5"
    std::string file;    // the graph; empty: the rendering path, its lights, and the values of mesh and camera
    int line = 0;
    Instructions once{}, per_light{};
    std::uint32_t total() const { return once.total() + per_light.total(); }
};

// An inner loop counts one round, and a branch counts as if it were taken.
struct StageCost {
    Instructions once{};            // for a vertex or a pixel
    Instructions per_light{};       // and for each light
    std::uint32_t varyings = 0;     // numbers that the vertex stage writes, or that the fragment stage reads
    std::uint32_t registers = 0;    // numbers that are kept at the same time, where they are most
    std::vector<NodeCost> nodes{};  // the heaviest first; their sums are `once` and `per_light`

    std::uint32_t total() const { return once.total() + per_light.total(); }  // with one light
};

struct PassCost {
    std::string name;
    StageCost vertex{}, fragment{};
    std::uint32_t textures = 0;       // that either stage reads
    std::uint32_t uniform_bytes = 0;  // of the material's own blocks
};

struct MaterialCost {
    bool ok = false;
    std::vector<PassCost> passes{};         // in the reflection's order
    std::vector<Diagnostic> diagnostics{};  // why a stage could not be measured
};

// Of the result's GLSL for the default engine. Thread-safe.
MaterialCost measure_cost(const Result& compiled);
// Of one stage. Without a line map no node has a share. Nothing if glslang refuses it; `diagnostics` say why.
std::optional<StageCost> measure_cost(const Shader& shader, std::vector<Diagnostic>& diagnostics);

// An error for each pass that costs more than the budget, with the heaviest nodes.
std::vector<Diagnostic> over_budget(const MaterialCost& cost, const Budget& budget);

// A JSON object with all of it. `graph`: the file that it is about.
std::string to_json(const MaterialCost& cost, std::string_view graph);
// The reflection's JSON with a key "cost": a list of the passes.
std::string with_cost(std::string reflection_json, const MaterialCost& cost);

}  // namespace patina
