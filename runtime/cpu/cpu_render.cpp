#include "runtime/cpu/cpu_render.h"

#include <algorithm>
#include <thread>

#include "runtime/cpu/cpu_step.h"
#include "runtime/frame/frame_check.h"

namespace patina::runtime {
namespace {

int thread_count() {
    return int(std::clamp(std::thread::hardware_concurrency(), 1u, 8u));
}

}  // namespace

Outcome<Image> cpu_draw(const Frame& frame, Precision precision) {
    if (std::string error = frame_error(frame); !error.empty()) return Failure{error};
    std::vector<CpuTarget> targets;
    for (const FrameTarget& target : frame.targets)
        targets.push_back(make_cpu_target(target, {.right = target.width, .bottom = target.height}));
    CpuStageCache cache;
    for (std::size_t i = 0; i < frame.steps.size(); i++) {
        const FrameStep& step = frame.steps[i];
        CpuStages& stages =
            cache.try_emplace({step.stages.program, step.pass}, stages_for(thread_count())).first->second;
        Outcome<CpuStep> made = make_cpu_step(frame, step, targets, stages, precision);
        if (!made) return Failure{made.error};
        if (frame.progress)
            made.value.progress = [&](double share) {
                frame.progress((double(i) + share) / double(frame.steps.size()));
            };
        shade(made.value, stages);
        for (std::size_t target : step.targets) targets[target].version++;
        if (step.depth >= 0 && step.pass->depth_write) targets[std::size_t(step.depth)].version++;
    }
    return box_filtered(image_of(targets[frame.shown]), frame.samples);
}

Outcome<Image> cpu_draw(const Draw& draw, Precision precision) {
    Outcome<const Pass*> pass = drawable_pass(draw);
    if (!pass) return Failure{pass.error};
    return cpu_draw(frame_of(draw, *pass.value), precision);
}

}  // namespace patina::runtime
