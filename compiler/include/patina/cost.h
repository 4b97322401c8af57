// Measures what shaders cost: instructions of optimised SPIR-V by kind, the share of each node, and whether a stage
// costs more than its budget. One measurement for all commands. Links glslang and SPIRV-Tools; the core library does
// not.
//
//   for (const MeasuredPass& pass : measure(compiled)) print(pass.name, pass.cost.fragment.total().instructions);
#pragma once

#include <span>
#include <string>
#include <vector>

#include "patina/patina.h"

namespace patina {

// What a part of a material adds to a stage. The shares of a stage sum to its cost.
struct CostShare {
    // Node: one node of the graph. The share of a sub-graph includes all of its nodes. Surface: expressions at the
    // inputs of the surface. Lighting: the workflow and the lighting model. Pass: everything else.
    enum class Part { Node, Surface, Lighting, Pass };
    Part part = Part::Pass;          // which of them it is
    std::string node{};              // the id of the node
    CostCounts once{}, per_light{};  // as in StageCost
};

// A stage that was measured.
struct MeasuredStage {
    bool ok = false;   // the stage could be measured; else all figures are zero
    StageCost cost{};  // of the stage
    // All nodes of the graph, in its order, also if they add nothing; then the other parts.
    std::vector<CostShare> shares{};
};

// A pass that was measured.
struct MeasuredPass {
    std::string name;                    // "forward"
    PassCost cost{};                     // of both stages
    MeasuredStage vertex{}, fragment{};  // with the shares
};

// Measures the stages of the default engine, in the order of the reflection's passes: in GLSL if that is a target, else
// in HLSL. Empty if neither is a target.
std::vector<MeasuredPass> measure(const Result& compiled);

// Why stages were not measured: glslang refuses them, or they would be very long with all calls written out. Empty if
// all passes were measured. `passes` is the result of measure(compiled).
std::vector<Diagnostic> refusals(const Result& compiled, std::span<const MeasuredPass> passes);

// Measures one stage of a pass, also if another program made it.
StageCost measure(const Shader& shader);

// An error for each stage of a pass that costs more. If the limit is from a graph, the error is at the number there.
std::vector<Diagnostic> over_budget(std::span<const MeasuredPass> passes, const Budget& budget);

}  // namespace patina
