// Runs the two stages of a pass on the CPU: maps the inputs and outputs of the interpreter by name. The interpreter
// itself is patina/interpret.h; cpu_step.h processes the pixels.
//
//   Outcome<std::vector<ClipVertex>> vertices = run_vertices(vertex_stage, mesh);
//   Outcome<std::vector<InputSource>> sources = fragment_sources(vertex_stage, fragment_stage);
//   gather_inputs(sources.value, triangle, quad, precision, inputs);
#pragma once

#include <vector>

#include "patina/interpret.h"
#include "runtime/cpu/raster.h"
#include "runtime/mesh/mesh.h"
#include "runtime/outcome.h"

namespace patina::runtime {

// In the mesh's order. Varyings are the stage's outputs except the position, end to end. `instance`: the drawn one.
Outcome<std::vector<ClipVertex>> run_vertices(Interpreter& stage, const Mesh& mesh, std::uint32_t instance = 0);
// One vertex of a mesh that run_vertices() took.
std::vector<TracedValue> trace_vertex(Interpreter& stage, const Mesh& mesh, std::uint32_t vertex,
                                      std::uint32_t instance = 0);

// Where a fragment input comes from.
struct InputSource {
    enum class Kind { Varying, Flat, FrontFacing, FragCoord } kind = Kind::Varying;
    std::size_t offset = 0;  // in ClipVertex::varyings
    unsigned components = 1;
};
Outcome<std::vector<InputSource>> fragment_sources(const Interpreter& vertex, const Interpreter& fragment);

// Fills `inputs` for the quad of the triangle. `origin`: where the targets begin, from which fragCoord counts.
void gather_inputs(const std::vector<InputSource>& sources, const ScreenTriangle& triangle, const Quad& quad,
                   Precision precision, QuadInputs& inputs, glm::ivec2 origin = {0, 0});

}  // namespace patina::runtime
