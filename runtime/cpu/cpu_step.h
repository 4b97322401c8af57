// Draws one step of a frame on the CPU: the vertex stage and everything up to the pixels, then rows of pixels, which
// threads share. Stages are reused for later steps, because creating one costs more than drawing a small triangle.
//
//   CpuStages stages{.fragments = std::vector<std::optional<Interpreter>>(1)};
//   Outcome<CpuStep> made = make_cpu_step(frame, step, targets, stages, precision);
//   shade_rows(made.value, fragment_stage(made.value, stages, 0), 0, 1);
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "runtime/cpu/cpu_stage.h"
#include "runtime/cpu/cpu_target.h"
#include "runtime/frame/frame.h"

namespace patina::runtime {

// The stages of one pass of one material: the fragment stage once for each thread.
struct CpuStages {
    std::optional<Interpreter> vertex;
    std::vector<std::optional<Interpreter>> fragments;
};
using CpuStageCache = std::map<std::pair<const Program*, const Pass*>, CpuStages>;

// A triangle that may be seen.
struct CpuTriangle {
    ScreenTriangle screen;
    std::size_t index = 0;  // among the mesh's
    std::uint32_t instance = 0;
    double depth_offset = 0;  // by the pass's bias
};

// A sample that a triangle covers, and what computed it.
struct CpuFragment {
    const CpuTriangle* triangle = nullptr;
    Quad quad;
    int lane = 0;
    bool is_discarded = false;
    bool is_hidden = false;  // it failed the test of depth or stencil
};

// Everything that the threads share and only read; each thread writes its own rows of the targets.
struct CpuStep {
    const FrameStep* step = nullptr;
    Precision precision = Precision::Float;
    PixelBounds bounds{};
    glm::ivec2 origin{0};  // of a tile, in the picture
    std::vector<CpuTarget*> colors{};
    CpuTarget* depth = nullptr;
    std::vector<LoadedTexture> textures{};  // loaded ones, and targets as they were when the step began
    std::vector<InputSource> sources{};
    std::vector<CpuTriangle> triangles{};
    // A quad needed more steps than Interpreter::run() takes: nothing else is drawn. Shared by copies of the step.
    std::shared_ptr<std::atomic<bool>> is_over_budget = std::make_shared<std::atomic<bool>>(false);
    std::function<void(double)> progress{};                 // called by the thread that has row 0
    std::function<void(const CpuFragment&)> on_fragment{};  // called for each fragment, by the thread that has its row
};

// The frame must have no frame_error(). In a frame with tiles, the targets of the picture are those of one tile, and
// `step` has its blocks (blocks_at()). `stages` are those of this pass; the first fragment stage exists afterwards.
Outcome<CpuStep> make_cpu_step(const Frame& frame, const FrameStep& step, std::vector<CpuTarget>& targets,
                               CpuStages& stages, Precision precision);

// The fragment stage number `thread`, with the step's blocks and textures.
Interpreter& fragment_stage(const CpuStep& step, CpuStages& stages, std::size_t thread);

// The same of the vertex stage, once the step is made.
Interpreter& vertex_stage(const CpuStep& step, CpuStages& stages);

// Rows `first_row`, `first_row` + `row_step` ... of quads from the top of the targets.
void shade_rows(const CpuStep& step, Interpreter& fragment, int first_row, int row_step);

CpuStages stages_for(int threads);
// All rows, shared by as many threads as there are fragment stages. No two threads touch one pixel, so the picture does
// not depend on their number.
void shade(const CpuStep& step, CpuStages& stages);
// Empty, or why it could not be shaded.
std::string shade_error(const CpuStep& step);

}  // namespace patina::runtime
