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

CpuStages stages_for(int threads) {
    return {.vertex = {}, .fragments = std::vector<std::optional<Interpreter>>(std::size_t(threads))};
}

// Rows of quads are dealt out in turn. No two threads touch one pixel, so the picture does not depend on their number.
void shade(const CpuStep& step, CpuStages& stages) {
    const int threads = int(stages.fragments.size());
    const auto share = [&](int i) { shade_rows(step, fragment_stage(step, stages, std::size_t(i)), i, threads); };
    std::vector<std::thread> others;
    for (int i = 1; i < threads; i++) others.emplace_back(share, i);
    share(0);
    for (std::thread& other : others) other.join();
}

// --- one pixel, watched

// The fragment that each sample of a pixel shows; if all were discarded, the nearest of them.
struct Sample {
    std::optional<CpuFragment> drawn, discarded;

    void add(const CpuFragment& fragment) {
        if (!fragment.is_discarded) {
            drawn = fragment;
        } else if (!discarded || fragment.quad.depth[fragment.lane] < discarded->quad.depth[discarded->lane]) {
            discarded = fragment;
        }
    }
};

// The sample nearest to the middle of the pixel for which `has` is true; -1: there is none.
template <class Predicate>
int most_central(int samples, Predicate has) {
    int best = -1;
    double least = 0;
    for (int i = 0; i < samples * samples; i++) {
        double x = i % samples + 0.5 - samples * 0.5, y = i / samples + 0.5 - samples * 0.5;
        if (!has(i) || (best >= 0 && x * x + y * y >= least)) continue;
        best = i;
        least = x * x + y * y;
    }
    return best;
}

// The values of the two stages for one fragment.
void trace_stages(const CpuStep& step, CpuStages& stages, const CpuFragment& fragment, PixelTrace& trace) {
    QuadInputs inputs;
    gather_inputs(step.sources, fragment.triangle->screen, fragment.quad, step.precision, inputs);
    trace.values = stages.fragments.front()->trace(inputs, unsigned(fragment.lane));
    const Mesh& mesh = *step.step->mesh;
    for (std::size_t corner = 0; corner < 3; corner++) {
        const std::uint32_t index = mesh.indices[3 * fragment.triangle->index + corner];
        trace.corners[corner] = trace_vertex(*stages.vertex, mesh.vertices[index]);
    }
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

Outcome<PixelTrace> cpu_trace(const Draw& draw, int x, int y, Precision precision) {
    Outcome<const Pass*> pass = drawable_pass(draw);
    if (!pass) return Failure{pass.error};
    const Frame frame = frame_of(draw, *pass.value);
    if (std::string error = frame_error(frame); !error.empty()) return Failure{error};
    const int samples = frame.samples;
    const PixelBounds window{
        .left = x * samples, .top = y * samples, .right = (x + 1) * samples, .bottom = (y + 1) * samples};
    std::vector<CpuTarget> targets;
    for (const FrameTarget& target : frame.targets) targets.push_back(make_cpu_target(target, window));
    CpuStages stages = stages_for(1);
    Outcome<CpuStep> made = make_cpu_step(frame, frame.steps.front(), targets, stages, precision);
    if (!made) return Failure{made.error};

    std::vector<Sample> shown(std::size_t(samples) * samples);
    made.value.on_fragment = [&](const CpuFragment& fragment) {
        const int column = fragment.quad.x + fragment.lane % 2 - window.left,
                  row = fragment.quad.y + fragment.lane / 2 - window.top;
        shown[std::size_t(row) * samples + column].add(fragment);
    };
    shade(made.value, stages);

    PixelTrace trace;
    const auto copy_color = [](std::span<const float> from, std::array<float, 4>& to) {
        std::copy_n(from.begin(), to.size(), to.begin());
    };
    const Image color = image_of(targets[frame.shown]);
    copy_color(box_filtered(color, samples).at(0, 0), trace.color);
    int sample = most_central(samples, [&](int i) { return shown[i].drawn.has_value(); });
    if (sample < 0) sample = most_central(samples, [&](int i) { return shown[i].discarded.has_value(); });
    if (sample < 0) return trace;
    trace.is_covered = true;
    trace.is_discarded = !shown[sample].drawn;
    trace.sample_x = sample % samples;
    trace.sample_y = sample / samples;
    copy_color(color.at(trace.sample_x, trace.sample_y), trace.sample_color);
    trace_stages(made.value, stages, trace.is_discarded ? *shown[sample].discarded : *shown[sample].drawn, trace);
    return trace;
}

}  // namespace patina::runtime
