// Lets textures share samplers if a pass would need more of them than the engine has. Direct3D 11 has 16 samplers in a
// stage, and 128 textures. A file declares each texture once, so its passes share in the same way.
#pragma once

#include "compiler/writers/shaderlab/shader_file.h"

namespace patina::writers::shaderlab {

// The samplers of a file's fragment stages.
struct SamplerUse {
    struct OfPass {
        std::size_t of_engine = 0;    // in the engine's own text: [text("sampler", ...)]
        std::size_t of_material = 0;  // a sampler for each texture
        std::size_t shared = 0;       // of these, the ones that the pass does without

        std::size_t wanted() const { return of_engine + of_material; }
        std::size_t count() const { return wanted() - shared; }
    };
    std::vector<OfPass> passes;
    // Names of samplers that the file does without, and of the ones that are used instead. Both textures have the same
    // sampler in the graph, no vertex stage reads them, and each pass that reads the first reads the second.
    std::vector<std::pair<std::string, std::string>> shared;
};

// Shares only as many as the limit requires. If not enough can be shared, the count of a pass is above `most`.
SamplerUse sampler_use(std::span<const LinkedPass> passes, std::size_t most);
// Replaces the samplers in a stage of one of the passes.
void share_samplers(ir::Module& stage, const SamplerUse& use);

}  // namespace patina::writers::shaderlab
