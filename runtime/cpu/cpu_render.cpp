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

// Draws the tiles of a frame, one after the other. The stages, and the targets that all tiles share, stay.
class TiledDraw {
public:
    TiledDraw(const Frame& frame, Precision precision)
        : frame_(frame), precision_(precision), targets_(frame.targets.size()) {}

    // The tile's pixels of all targets that are shown, samples averaged.
    Outcome<std::vector<Image>> draw(const PixelArea& tile, std::size_t index, std::size_t count) {
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
        std::vector<Image> shown = {box_filtered(image_of(targets_[frame_.shown]), frame_.samples)};
        for (const std::size_t target : frame_.also_shown)
            shown.push_back(box_filtered(image_of(targets_[target]), frame_.samples));
        return shown;
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
        if (std::string error = shade_error(made.value); !error.empty()) return error;
        for (std::size_t target : step.targets) targets_[target].version++;
        if (step.depth >= 0 && step.pass->depth_write) targets_[std::size_t(step.depth)].version++;
        return "";
    }

    const Frame& frame_;
    Precision precision_;
    std::vector<CpuTarget> targets_;
    CpuStageCache cache_;
};

}  // namespace

Outcome<Image> cpu_draw(const Frame& frame, Precision precision) {
    Outcome<std::vector<Image>> drawn = cpu_draw_all(frame, precision);
    if (!drawn) return Failure{drawn.error};
    return std::move(drawn.value.front());
}

Outcome<std::vector<Image>> cpu_draw_all(const Frame& frame, Precision precision) {
    if (std::string error = frame_error(frame); !error.empty()) return Failure{error};
    TiledDraw drawing(frame, precision);
    const std::vector<PixelArea> tiles = tiles_of(frame);
    const FrameTarget& shown = frame.targets[frame.shown];
    std::vector<Image> pictures;
    for (std::size_t k = 0; k <= frame.also_shown.size(); k++)
        if (tiles.size() > 1) pictures.push_back(make_image(shown.width / frame.samples, shown.height / frame.samples));
    for (std::size_t i = 0; i < tiles.size(); i++) {
        Outcome<std::vector<Image>> parts = drawing.draw(tiles[i], i, tiles.size());
        if (!parts || tiles.size() == 1) return parts;
        for (std::size_t k = 0; k < pictures.size(); k++)
            put_tile(parts.value[k], tiles[i].x / frame.samples, tiles[i].y / frame.samples, pictures[k]);
    }
    return pictures;
}

Outcome<Image> cpu_draw(const Draw& draw, Precision precision) {
    Outcome<const Pass*> pass = drawable_pass(draw);
    if (!pass) return Failure{pass.error};
    return cpu_draw(frame_of(draw, *pass.value), precision);
}

}  // namespace patina::runtime
