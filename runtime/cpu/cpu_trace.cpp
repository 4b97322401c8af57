#include "runtime/cpu/cpu_trace.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <thread>

#include "runtime/cpu/cpu_step.h"
#include "runtime/frame/frame_check.h"
#include "runtime/picture/image.h"

namespace patina::runtime {
namespace {

// A fragment of an object, at one sample of the pixel.
struct Hit {
    std::size_t step = 0;  // index into Frame::steps
    std::size_t object = 0;
    CpuFragment fragment{};

    // Or drawn over, until hide() has run.
    bool is_drawn() const { return !fragment.is_discarded && !fragment.is_hidden; }
    double depth() const { return fragment.quad.depth[std::size_t(fragment.lane)]; }
};
using Hits = std::vector<Hit>;  // of one sample, in the order of the steps

// True for each target that a step reads, and for those that are drawn at the same time.
std::vector<bool> whole_targets(const Frame& frame) {
    std::vector<bool> whole(frame.targets.size(), false);
    for (const FrameStep& step : frame.steps)
        for (const FrameRead& read : step.reads) whole[read.target] = true;
    for (bool changes = true; changes;) {
        changes = false;
        for (const FrameStep& step : frame.steps) {
            const std::vector<std::size_t> drawn = attachments(step);
            const auto is_whole = [&](std::size_t target) { return whole[target]; };
            if (std::none_of(drawn.begin(), drawn.end(), is_whole) || std::all_of(drawn.begin(), drawn.end(), is_whole))
                continue;
            for (std::size_t target : drawn) whole[target] = true;
            changes = true;
        }
    }
    return whole;
}

// For each target, the number of steps up to the last one that reads it.
std::vector<std::size_t> ends_of_reading(const Frame& frame) {
    std::vector<std::size_t> ends(frame.targets.size(), 0);
    for (std::size_t i = 0; i < frame.steps.size(); i++)
        for (const FrameRead& read : frame.steps[i].reads) ends[read.target] = i + 1;
    return ends;
}

// Nothing behind it is seen any more.
bool replaces(const Pass& pass) {
    const auto blends = [](const RenderTarget& target) { return target.blend.is_on(); };
    return pass.targets.empty() ? pass.depth_write : std::none_of(pass.targets.begin(), pass.targets.end(), blends);
}

class Tracer {
public:
    Tracer(const Frame& frame, const TraceWish& wish)
        : frame_(frame),
          wish_(wish),
          window_{.left = wish.x * frame.samples,
                  .top = wish.y * frame.samples,
                  .right = (wish.x + 1) * frame.samples,
                  .bottom = (wish.y + 1) * frame.samples},
          ends_(ends_of_reading(frame)),
          hits_(std::size_t(frame.samples) * frame.samples) {}

    Outcome<PixelTrace> run() {
        if (std::string error = draw(); !error.empty()) return Failure{error};
        for (Hits& hits : hits_) hide(hits);
        PixelTrace trace;
        const Image samples = shown_samples();
        copy_color(box_filtered(samples, frame_.samples).at(0, 0), trace.color);
        const Hit* hit = choose(samples, trace);
        if (!hit) return trace;
        trace.is_covered = true;
        trace.is_discarded = hit->fragment.is_discarded;
        trace.is_hidden = hit->fragment.is_hidden;
        copy_color(samples.at(trace.sample_x, trace.sample_y), trace.sample_color);
        trace_stages(*hit, trace);
        return trace;
    }

private:
    static void copy_color(std::span<const float> from, std::array<float, 4>& to) {
        std::copy_n(from.begin(), to.size(), to.begin());
    }

    const FrameTarget& shown() const { return frame_.targets[frame_.shown]; }

    // Empty, or what is wrong.
    std::string draw() {
        const std::vector<bool> whole = whole_targets(frame_);
        for (std::size_t i = 0; i < whole.size(); i++) {
            const FrameTarget& target = frame_.targets[i];
            const PixelBounds all{.right = target.width, .bottom = target.height};
            targets_.push_back(make_cpu_target(target, whole[i] ? all : window_));
        }
        kept_.resize(frame_.steps.size());
        for (std::size_t i = 0; i < frame_.steps.size(); i++) {
            if (std::string error = draw_step(i); !error.empty()) return error;
            if (frame_.progress) frame_.progress(double(i + 1) / double(frame_.steps.size()));
        }
        return "";
    }

    std::string draw_step(std::size_t index) {
        const FrameStep& step = frame_.steps[index];
        const std::vector<std::size_t> drawn = attachments(step);
        const bool is_read =
            std::any_of(drawn.begin(), drawn.end(), [&](std::size_t target) { return ends_[target] > index + 1; });
        const FrameTarget& first = frame_.targets[drawn.front()];
        const bool is_of_picture = first.width == shown().width && first.height == shown().height;
        if (!is_of_picture && !is_read) return "";  // shadow maps that no material looks at
        const int threads = int(std::clamp(std::thread::hardware_concurrency(), 1u, 8u));
        CpuStages& stages = stages_.try_emplace({step.stages.program, step.pass}, stages_for(threads)).first->second;
        Outcome<CpuStep> made = make_cpu_step(frame_, step, targets_, stages, wish_.precision);
        if (!made) return made.error;
        if (is_of_picture && !is_read) made.value.bounds = within_window(made.value.bounds);
        const bool is_seen = is_of_picture && step.object && step.pass->draws == PassDraws::Objects;
        if (is_seen) {
            made.value.on_fragment = [this, index, &step](const CpuFragment& fragment) {
                add({.step = index, .object = *step.object, .fragment = fragment});
            };
        }
        shade(made.value, stages);
        if (std::string error = shade_error(made.value); !error.empty()) return error;
        for (std::size_t target : step.targets) targets_[target].version++;
        if (step.depth >= 0 && step.pass->depth_write) targets_[std::size_t(step.depth)].version++;
        if (hit_step_ == index) kept_[index] = std::move(made.value);
        return "";
    }

    PixelBounds within_window(const PixelBounds& bounds) const {
        return {.left = std::max(bounds.left, window_.left),
                .top = std::max(bounds.top, window_.top),
                .right = std::min(bounds.right, window_.right),
                .bottom = std::min(bounds.bottom, window_.bottom)};
    }

    // Each thread has rows of its own, so the hits of one sample come in order.
    void add(const Hit& hit) {
        const int x = hit.fragment.quad.x + hit.fragment.lane % 2, y = hit.fragment.quad.y + hit.fragment.lane / 2;
        if (!window_.holds(x, y)) return;
        const std::lock_guard lock(mutex_);
        hit_step_ = hit.step;
        hits_[std::size_t(y - window_.top) * std::size_t(frame_.samples) + std::size_t(x - window_.left)].push_back(
            hit);
    }

    Image shown_samples() const {
        Image made = make_image(frame_.samples, frame_.samples);
        const CpuTarget& target = targets_[frame_.shown];
        for (int y = 0; y < frame_.samples; y++) {
            for (int x = 0; x < frame_.samples; x++) {
                const glm::vec4 color = target.load(window_.left + x, window_.top + y);
                for (int c = 0; c < 4; c++) made.at(x, y)[std::size_t(c)] = color[c];
            }
        }
        return made;
    }

    // --- which fragment

    // A fragment is hidden if a later step draws over it, or if it fails the depth test.
    void hide(Hits& hits) const {
        bool is_replaced = false;
        for (auto hit = hits.rbegin(); hit != hits.rend(); ++hit) {
            if (!hit->is_drawn()) continue;
            hit->fragment.is_hidden = is_replaced;
            is_replaced |= replaces(*frame_.steps[hit->step].pass);
        }
    }

    bool is_wanted(const Hit& hit) const { return !wish_.object || hit.object == *wish_.object; }
    bool is_nearer(const Hit& a, const Hit& b) const {
        const bool is_reversed = frame_.steps[a.step].clip_depth() == ClipDepth::Reversed;
        return is_reversed ? a.depth() > b.depth() : a.depth() < b.depth();
    }

    // The last visible hit; if none is visible, the nearest of the hits that are hidden or discarded.
    const Hit* front_of(const Hits& hits) const {
        const Hit *drawn = nullptr, *hidden = nullptr, *discarded = nullptr;
        for (const Hit& hit : hits) {
            if (!is_wanted(hit)) continue;
            if (hit.is_drawn()) {
                drawn = &hit;
            } else if (hit.fragment.is_discarded) {
                if (!discarded || is_nearer(hit, *discarded)) discarded = &hit;
            } else if (!hidden || is_nearer(hit, *hidden)) {
                hidden = &hit;
            }
        }
        // If the request names no object, hidden hits are not searched: something is drawn before them.
        return drawn ? drawn : hidden && wish_.object ? hidden : discarded;
    }

    // The sample nearest to the middle of the pixel for which `has` is true; -1: there is none.
    template <class Predicate>
    int most_central(Predicate has) const {
        const int samples = frame_.samples;
        int best = -1;
        double least = 0;
        for (int i = 0; i < samples * samples; i++) {
            const double x = i % samples + 0.5 - samples * 0.5, y = i / samples + 0.5 - samples * 0.5;
            if (!has(i) || (best >= 0 && x * x + y * y >= least)) continue;
            best = i;
            least = x * x + y * y;
        }
        return best;
    }

    const Hit* choose(const Image& samples, PixelTrace& trace) const {
        std::vector<const Hit*> fronts;
        for (const Hits& hits : hits_) fronts.push_back(front_of(hits));
        const auto is_finite = [&](int i) {
            const std::span<const float> color = samples.at(i % frame_.samples, i / frame_.samples);
            return std::all_of(color.begin(), color.end(), [](float value) { return std::isfinite(value); });
        };
        const auto is_drawn = [&](int i) { return fronts[std::size_t(i)] && fronts[std::size_t(i)]->is_drawn(); };
        int chosen = most_central([&](int i) { return is_drawn(i) && !is_finite(i); });
        if (chosen < 0) chosen = most_central(is_drawn);
        if (chosen < 0) {
            chosen = most_central(
                [&](int i) { return fronts[std::size_t(i)] && fronts[std::size_t(i)]->fragment.is_hidden; });
        }
        if (chosen < 0) chosen = most_central([&](int i) { return fronts[std::size_t(i)] != nullptr; });
        const int shown = chosen < 0 ? most_central([](int) { return true; }) : chosen;
        trace.sample_x = shown % frame_.samples;
        trace.sample_y = shown / frame_.samples;
        const Hits& hits = hits_[std::size_t(shown)];
        for (auto hit = hits.rbegin(); hit != hits.rend(); ++hit) {
            const bool is_known = std::find(trace.seen.begin(), trace.seen.end(), hit->object) != trace.seen.end();
            if (hit->is_drawn() && !is_known) trace.seen.push_back(hit->object);
        }
        if (chosen < 0) return nullptr;
        return &first_of_path(hits, *fronts[std::size_t(chosen)]);
    }

    // If a path draws one object with several passes, the first of them: the others only add to it.
    const Hit& first_of_path(const Hits& hits, const Hit& front) const {
        if (frame_.steps[front.step].pass->is_extra || !front.is_drawn()) return front;
        for (const Hit& hit : hits) {
            const FrameStep &step = frame_.steps[hit.step], &last = frame_.steps[front.step];
            if (hit.object == front.object && step.first_instance == last.first_instance && hit.is_drawn() &&
                !step.pass->is_extra && hit.fragment.triangle->index == front.fragment.triangle->index &&
                hit.fragment.triangle->instance == front.fragment.triangle->instance)
                return hit;
        }
        return front;
    }

    // --- its values

    void trace_stages(const Hit& hit, PixelTrace& trace) {
        const CpuStep& step = *kept_[hit.step];
        const CpuTriangle& triangle = *hit.fragment.triangle;
        CpuStages& stages = stages_.at({step.step->stages.program, step.step->pass});
        trace.object = hit.object;
        trace.instance = step.step->first_instance + triangle.instance;
        trace.pass = step.step->pass->name;
        trace.is_extra = step.step->pass->is_extra;
        QuadInputs inputs;
        gather_inputs(step.sources, triangle.screen, hit.fragment.quad, wish_.precision, inputs);
        trace.values = fragment_stage(step, stages, 0).trace(inputs, unsigned(hit.fragment.lane));
        name_lights(*step.step, trace.values);
        Interpreter& vertex = vertex_stage(step, stages);
        const Mesh& mesh = *step.step->mesh;
        for (std::size_t corner = 0; corner < 3; corner++) {
            const std::uint32_t index = mesh.indices[3 * triangle.index + corner];
            trace.corners[corner] = trace_vertex(vertex, mesh, index, triangle.instance);
            name_lights(*step.step, trace.corners[corner]);
        }
    }

    // Shaders number the lights of a step; people number those of the scene.
    static void name_lights(const FrameStep& step, std::vector<TracedValue>& values) {
        for (TracedValue& value : values)
            if (value.light >= 0 && std::size_t(value.light) < step.lights.size())
                value.light = int(step.lights[std::size_t(value.light)]);
    }

    const Frame& frame_;
    TraceWish wish_;
    PixelBounds window_;  // the samples of the pixel
    std::vector<std::size_t> ends_;
    std::vector<Hits> hits_;
    std::vector<CpuTarget> targets_{};
    CpuStageCache stages_{};
    std::vector<std::optional<CpuStep>> kept_{};  // steps whose fragments are in `hits_`
    std::optional<std::size_t> hit_step_{};       // the last of them
    std::mutex mutex_{};
};

}  // namespace

Outcome<PixelTrace> cpu_trace(const Frame& frame, const TraceWish& wish) {
    // Of targets that nothing reads only the pixel exists, however large the picture is.
    Frame made = frame;
    const std::vector<bool> whole = whole_targets(frame);
    for (std::size_t i = 0; i < whole.size(); i++) {
        if (!whole[i]) made.targets[i].width = made.targets[i].height = frame.samples;
    }
    if (std::string error = frame_error(made); !error.empty()) return Failure{error};
    return Tracer(frame, wish).run();
}

}  // namespace patina::runtime
