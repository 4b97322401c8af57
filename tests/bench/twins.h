// The twins: shaders written by hand, as an expert would, in tests/bench/handwritten, for the graphs of the source
// documents and for a glTF material. Each reads what the shader of its graph reads, and draws the same picture;
// twins_test.cpp proves that. The shaders that Patina makes are measured against them.
//
//   const StageCost made = cost_of(stages_of(compiled(twin)).fragment), theirs = cost_of(by_hand(twin).fragment);
#pragma once

#include <string_view>

#include "patina/patina.h"

namespace patina::bench {

// Some share a vertex stage.
struct Twin {
    std::string_view name;    // of the fragment stage: handwritten/NAME.frag.glsl
    std::string_view vertex;  // handwritten/NAME.vert.glsl
    std::string_view graph;   // a path in the project
};

inline constexpr Twin kTwins[] = {
    {"diffuse-pixel-level", "mesh", "examples/sources/diffuse-pixel-level.graph.json"},
    {"half-lambert", "mesh", "examples/sources/half-lambert.graph.json"},
    {"lambert-glsl", "textured", "examples/sources/lambert-glsl.graph.json"},
    {"phong-glsl", "textured", "examples/sources/phong-glsl.graph.json"},
    {"specular-pixel-level", "mesh", "examples/sources/specular-pixel-level.graph.json"},
    {"blinn-phong-glsl", "textured", "examples/sources/blinn-phong-glsl.graph.json"},
    {"blinn-phong", "mesh", "examples/sources/blinn-phong.graph.json"},
    {"blinn-phong-built-in-functions", "mesh", "examples/sources/blinn-phong-built-in-functions.graph.json"},
    {"custom-standard", "textured", "examples/sources/custom-standard.graph.json"},
    {"cl-pbr-specular", "bumped", "examples/sources/cl-pbr-specular.graph.json"},
    {"pbr-direct-specular", "bumped", "examples/sources/pbr-direct-specular.graph.json"},
    {"pbr-direct-diffuse", "bumped", "examples/sources/pbr-direct-diffuse.graph.json"},
    {"pbr-indirect-specular", "bumped", "examples/sources/pbr-indirect-specular.graph.json"},
    {"pbr-indirect-diffuse", "bumped", "examples/sources/pbr-indirect-diffuse.graph.json"},
    {"standard", "textured", "examples/sources/standard.graph.json"},
    {"standard-cutout", "textured", "examples/sources/standard-cutout.graph.json"},
    {"standard-metallic-setup", "bumped", "examples/sources/standard-metallic-setup.graph.json"},
    {"standard-roughness-setup", "bumped", "examples/sources/standard-roughness-setup.graph.json"},
    {"standard-specular-setup", "bumped", "examples/sources/standard-specular-setup.graph.json"},
    {"boombox", "bumped", "tests/bench/handwritten/boombox.graph.json"},
};

// The two stages of a pass.
struct StageTexts {
    Shader vertex{}, fragment{};
};

// The graph in GLSL, by the pass `forward`. Not ok if it does not compile.
Result compiled(const Twin& twin);
StageTexts stages_of(const Result& result);
// The twin's own texts. Empty if a file cannot be read.
StageTexts by_hand(const Twin& twin);

// What a stage costs.
struct StageCost {
    std::size_t instructions = 0;  // of all functions, after `spirv-opt -O`; 0: the text does not compile
    std::size_t per_light = 0;     // of them in the loop over the lights
    std::size_t bytes = 0;         // of the text
};
StageCost cost_of(const Shader& shader);

}  // namespace patina::bench
