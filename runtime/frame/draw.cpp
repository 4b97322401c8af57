#include "runtime/frame/draw.h"

#include <algorithm>

#include "runtime/frame/tiles.h"

namespace patina::runtime {

Outcome<const Pass*> drawable_pass(const Draw& draw) {
    for (const Pass& pass : draw.reflection->passes) {
        if (pass.name != draw.pass) continue;
        if (pass.draws != PassDraws::Objects) return Failure{"the pass '" + pass.name + "' does not draw meshes"};
        if (pass.targets.size() != 1)
            return Failure{"the pass '" + pass.name + "' writes " + std::to_string(pass.targets.size()) +
                           " targets; one that can be seen writes 1"};
        const Scene& scene = *draw.scene;
        int limit = kLargestInTiles / std::max(scene.samples, 1);
        if (scene.samples < 1 || scene.width < 1 || scene.height < 1 || scene.width > limit || scene.height > limit)
            return Failure{"a picture of " + std::to_string(scene.width) + " x " + std::to_string(scene.height) +
                           " pixels with " + std::to_string(scene.samples) +
                           " samples along each axis is not between 1 and " + std::to_string(kLargestInTiles) +
                           " samples wide and high"};
        if (scene.mesh.indices.empty()) return Failure{"the scene has no mesh"};
        return &pass;
    }
    return Failure{"the material has no pass '" + draw.pass + "'"};
}

Frame frame_of(const Draw& draw, const Pass& pass) {
    const Scene& scene = *draw.scene;
    const int width = scene.width * scene.samples, height = scene.height * scene.samples;
    FrameTarget color{
        .name = "color", .format = TargetFormat::Rgba32F, .width = width, .height = height, .clear = scene.background};
    FrameTarget depth{.name = "depth",
                      .format = TargetFormat::Depth,
                      .width = width,
                      .height = height,
                      .clear = glm::vec4(farthest(draw.reflection->clip_depth))};
    StagePair stages{.vertex_spirv = draw.vertex_spirv, .fragment_spirv = draw.fragment_spirv, .program = draw.program};
    FrameStep step{.reflection = draw.reflection,
                   .pass = &pass,
                   .stages = stages,
                   .mesh = &scene.mesh,
                   .blocks = {draw.blocks.begin(), draw.blocks.end()},
                   .constants = draw.constants,
                   .textures = draw.textures,
                   .targets = {0},
                   .depth = 1};
    return {.targets = {color, depth}, .steps = {step}, .samples = scene.samples, .progress = draw.progress};
}

}  // namespace patina::runtime
