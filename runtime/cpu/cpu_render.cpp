#include "runtime/cpu/cpu_render.h"

#include <algorithm>
#include <thread>

#include "runtime/cpu/cpu_step.h"
#include "runtime/frame/frame_check.h"
#include "runtime/frame/tiles.h"

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

// Draws the tiles of a frame, one after the other. The stages, and the targets that all tiles share, stay.
class TiledDraw {
public:
    TiledDraw(const Frame& frame, Precision precision)
        : frame_(frame), precision_(precision), targets_(frame.targets.size()) {}

    // The tile's pixels, samples averaged.
    Outcome<Image> draw(const PixelArea& tile, std::size_t index, std::size_t count) {
        const auto is_drawn = [&](bool of_picture) { return of_picture || index == 0; };
        for (std::size_t i = 0; i < targets_.size(); i++) {
            const FrameTarget& wanted = frame_.targets[i];
            if (is_drawn(wanted.is_of_picture)) targets_[i] = make_cpu_target(wanted, window_of(wanted, tile));
        }
        for (std::size_t i = 0; i < frame_.steps.size(); i++) {
            if (!is_drawn(is_of_picture(frame_, frame_.steps[i]))) continue;
            const auto report = [&](double share) {
                const double of_tile = (double(i) + share) / double(frame_.steps.size());
                frame_.progress((double(index) + of_tile) / double(count));
            };
            FrameStep step = frame_.steps[i];
            if (frame_.tile != 0)
                step.blocks = blocks_at(step, {.x = tile.x, .y = tile.y, .width = tile.width, .height = tile.height});
            if (std::string error = draw(step, report); !error.empty()) return Failure{error};
        }
        return box_filtered(image_of(targets_[frame_.shown]), frame_.samples);
    }

private:
    PixelBounds window_of(const FrameTarget& target, const PixelArea& tile) const {
        if (frame_.tile == 0 || !target.is_of_picture) return {.right = target.width, .bottom = target.height};
        return {.left = tile.x, .top = tile.y, .right = tile.x + tile.width, .bottom = tile.y + tile.height};
    }

    // Empty, or what is wrong.
    std::string draw(const FrameStep& step, const std::function<void(double)>& report) {
        CpuStages& stages =
            cache_.try_emplace({step.stages.program, step.pass}, stages_for(thread_count())).first->second;
        Outcome<CpuStep> made = make_cpu_step(frame_, step, targets_, stages, precision_);
        if (!made) return made.error;
        if (frame_.progress) made.value.progress = report;
        shade(made.value, stages);
        for (std::size_t target : step.targets) targets_[target].version++;
        if (step.depth >= 0 && step.pass->depth_write) targets_[std::size_t(step.depth)].version++;
        return "";
    }

    const Frame& frame_;
    Precision precision_;
    std::vector<CpuTarget> targets_;
    CpuStageCache cache_;
};

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
    TiledDraw drawing(frame, precision);
    const std::vector<PixelArea> tiles = tiles_of(frame);
    const FrameTarget& shown = frame.targets[frame.shown];
    Image picture;
    if (tiles.size() > 1) picture = make_image(shown.width / frame.samples, shown.height / frame.samples);
    for (std::size_t i = 0; i < tiles.size(); i++) {
        Outcome<Image> part = drawing.draw(tiles[i], i, tiles.size());
        if (!part || tiles.size() == 1) return part;
        put_tile(part.value, tiles[i].x / frame.samples, tiles[i].y / frame.samples, picture);
    }
    return picture;
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
    const int samples = frame.samples;
    Frame pixel = frame;  // only the pixel's targets exist, however large the picture is
    for (FrameTarget& target : pixel.targets) target.width = target.height = samples;
    if (std::string error = frame_error(pixel); !error.empty()) return Failure{error};
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
