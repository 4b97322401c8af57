#include "runtime/sheet/cost.h"

#include <algorithm>

#include "patina/spirv_size.h"
#include "patina/validate.h"

namespace patina::runtime {
namespace {

StageCost stage_cost(const Shader& shader) {
    const Validated validated = validate(shader);
    if (!validated.ok) return {};
    const SpirvSize size = size_of(optimised(validated.spirv));
    return {.instructions = size.in_functions, .per_light = size.in_loops};
}

}  // namespace

std::vector<PassCost> costs(const Result& compiled) {
    std::vector<PassCost> made;
    for (const Pass& pass : compiled.reflection.passes) {
        PassCost cost{.pass = pass.name};
        for (const Shader& shader : compiled.shaders) {
            if (shader.pass != pass.name || shader.target != Target::Glsl) continue;
            (shader.stage == Stage::Vertex ? cost.vertex : cost.fragment) = stage_cost(shader);
            cost.lines += std::size_t(std::ranges::count(shader.text, '\n'));
        }
        cost.textures = pass.textures.size();
        for (const Block& block : compiled.reflection.blocks)
            if (block.is_material && std::ranges::find(pass.blocks, block.name) != pass.blocks.end())
                cost.uniform_bytes += block.size;
        made.push_back(std::move(cost));
    }
    return made;
}

}  // namespace patina::runtime
