// Lets textures share samplers if a pass would need more of them than the engine has. Direct3D 11 has 16 samplers in a
// stage, and 128 textures.
#pragma once

#include "compiler/engines/shaderlab/shader_file.h"

namespace patina::engines::shaderlab {

// The samplers of a pass's fragment stage.
struct SamplerUse {
    std::size_t of_engine = 0;    // in the engine's own text: [text("sampler", ...)]
    std::size_t of_material = 0;  // a sampler for each texture
    // Samplers that the pass does without, and the ones that are used instead: indices of globals. Both textures have
    // the same sampler in the graph, and the vertex stage samples neither.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> shared;

    std::size_t count() const { return of_engine + of_material - shared.size(); }
};

// Shares only as many as the limit requires. If not enough can be shared, count() is above `most`.
SamplerUse sampler_use(const LinkedPass& pass, std::size_t most);
// Replaces the samplers in a stage of that pass.
void share_samplers(ir::Module& stage, const SamplerUse& use);

}  // namespace patina::engines::shaderlab
