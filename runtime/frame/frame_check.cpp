#include "runtime/frame/frame_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/frame/tiles.h"
#include "runtime/picture/image.h"

namespace patina::runtime {
namespace {

template <class Range>
bool has_named(const Range& range, const std::string& name) {
    return std::any_of(range.begin(), range.end(), [&](const auto& item) { return item.name == name; });
}

std::string target_error(const Frame& frame, const FrameTarget& target) {
    const int largest = frame.tile != 0 && target.is_of_picture ? kLargestInTiles : kLargestImage;
    if (target.width < 1 || target.height < 1 || target.width > largest || target.height > largest)
        return fmt::format("the target '{}' of {} x {} pixels is not between 1 and {} pixels wide and high",
                           target.name, target.width, target.height, largest);
    return "";
}

// Of what the step draws into; the indices are good.
std::string attachment_error(const Frame& frame, const FrameStep& step) {
    const std::string& pass = step.pass->name;
    const std::vector<std::size_t> attached = attachments(step);
    if (attached.empty()) return fmt::format("the pass '{}' has no targets to draw into", pass);
    if (step.targets.size() != step.pass->targets.size())
        return fmt::format("the pass '{}' writes {} targets and is given {}", pass, step.pass->targets.size(),
                           step.targets.size());
    const FrameTarget& first = frame.targets[attached.front()];
    for (std::size_t i = 0; i < attached.size(); i++) {
        const FrameTarget& target = frame.targets[attached[i]];
        if (target.width != first.width || target.height != first.height)
            return fmt::format("the pass '{}' draws into '{}' and '{}', which differ in size", pass, first.name,
                               target.name);
        const bool wants_depth = i >= step.targets.size();
        if ((target.format == TargetFormat::Depth) != wants_depth)
            return fmt::format("the pass '{}' takes '{}' for {}", pass, target.name,
                               wants_depth ? "depth" : "a colour");
        if (std::count(attached.begin(), attached.begin() + std::ptrdiff_t(i), attached[i]))
            return fmt::format("the pass '{}' draws into '{}' twice", pass, target.name);
    }
    const PixelArea area = full_area(step, frame);
    if (area.x < 0 || area.y < 0 || area.width < 1 || area.height < 1 || area.width > first.width - area.x ||
        area.height > first.height - area.y)
        return fmt::format("the pass '{}' draws an area that is not inside '{}'", pass, first.name);
    return "";
}

// Of what the step is given.
std::string input_error(const FrameStep& step) {
    const Reflection& reflection = *step.reflection;
    if (step.mesh->indices.empty()) return fmt::format("the pass '{}' has no mesh", step.pass->name);
    for (const Block& block : reflection.blocks)
        if (!has_named(step.blocks, block.name)) return fmt::format("the block '{}' is not filled", block.name);
    const auto is_read = [&](const std::string& name) {
        return std::any_of(step.reads.begin(), step.reads.end(),
                           [&](const FrameRead& read) { return read.texture == name; });
    };
    for (const Texture& texture : reflection.textures) {
        const std::vector<std::string>& used = step.pass->textures;
        if (!std::count(used.begin(), used.end(), texture.name)) continue;
        if (!has_named(step.textures, texture.name) && !is_read(texture.name))
            return fmt::format("the texture '{}' is not loaded", texture.name);
    }
    for (const FrameRead& read : step.reads)
        if (!has_named(reflection.textures, read.texture))
            return fmt::format("the material has no texture '{}' to read a target through", read.texture);
    return "";
}

std::string step_error(const Frame& frame, const FrameStep& step) {
    const auto is_target = [&](std::size_t index) { return index < frame.targets.size(); };
    const bool all_there = std::all_of(step.targets.begin(), step.targets.end(), is_target) &&
                           std::all_of(step.reads.begin(), step.reads.end(),
                                       [&](const FrameRead& read) { return is_target(read.target); }) &&
                           (step.depth < 0 || is_target(std::size_t(step.depth)));
    if (!all_there) return fmt::format("the pass '{}' names a target that the frame does not have", step.pass->name);
    if (std::string error = attachment_error(frame, step); !error.empty()) return error;
    return input_error(step);
}

}  // namespace

std::vector<std::size_t> attachments(const FrameStep& step) {
    std::vector<std::size_t> result = step.targets;
    if (step.depth >= 0) result.push_back(std::size_t(step.depth));
    return result;
}

PixelArea full_area(const FrameStep& step, const Frame& frame) {
    if (step.area.width != 0) return step.area;
    const FrameTarget& target = frame.targets[attachments(step).front()];
    return {.width = target.width, .height = target.height};
}

std::string frame_error(const Frame& frame) {
    if (frame.shown >= frame.targets.size()) return "the frame shows a target that it does not have";
    for (const std::size_t target : frame.also_shown)
        if (target >= frame.targets.size() || !frame.targets[target].is_of_picture)
            return "the frame shows a target that is not of the picture";
    if (frame.samples < 1) return "a frame needs at least one sample per pixel";
    for (const FrameTarget& target : frame.targets)
        if (std::string error = target_error(frame, target); !error.empty()) return error;
    for (const FrameStep& step : frame.steps)
        if (std::string error = step_error(frame, step); !error.empty()) return error;
    return tile_error(frame);
}

}  // namespace patina::runtime
