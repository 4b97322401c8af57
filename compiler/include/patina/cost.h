// Measures what shaders cost: instructions of optimised SPIR-V by kind, what each node of the graph adds, and whether
// a budget is kept. One measurement for all commands. Links glslang and SPIRV-Tools; the core library does not.
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
    // Node: one node of the graph; if it is a sub-graph, with all nodes in it. Surface: expressions at the inputs of
    // the surface, which belong to no node. Lighting: the workflow and the lighting model. Pass: everything else.
    enum class Part { Node, Surface, Lighting, Pass };
    Part part = Part::Pass;          // which of them it is
    std::string node{};              // the id of the node
    CostCounts once{}, per_light{};  // as in StageCost
};

// A stage that was measured.
struct MeasuredStage {
    bool ok = false;   // it could be measured; else all is zero
    StageCost cost{};  // of the stage
    // The graph's nodes in its order, also those that add nothing; then the other parts.
    std::vector<CostShare> shares{};
};

// A pass that was measured.
struct MeasuredPass {
    std::string name;                    // "forward"
    PassCost cost{};                     // of both stages
    MeasuredStage vertex{}, fragment{};  // with the shares
};

// The stages of the default engine, in GLSL if it is among the targets, else in HLSL. In the order of the reflection's
// passes; none if neither is there.
std::vector<MeasuredPass> measure(const Result& compiled);

// Why stages were not measured: glslang refuses them, or they would be very long with all calls written out. Empty if
// all passes were measured. `passes`: what measure() made of `compiled`.
std::vector<Diagnostic> refusals(const Result& compiled, std::span<const MeasuredPass> passes);

// One stage of a pass, whatever made it.
StageCost measure(const Shader& shader);

// An error for each stage of a pass that costs more, at the number in the graph if the limit is from one.
std::vector<Diagnostic> over_budget(std::span<const MeasuredPass> passes, const Budget& budget);

}  // namespace patina
