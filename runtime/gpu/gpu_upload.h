// Uploads data to the device before a frame is drawn: textures, which stay for later frames, and the frame's meshes and
// uniform blocks, which do not stay.
//
//   TextureCache textures;
//   Outcome<BoundTexture> bound = textures.bind(gpu, loaded_texture);
//   FrameData data = make_frame_data(gpu, frame);
#pragma once

#include <map>
#include <memory>

#include "runtime/frame/frame.h"
#include "runtime/gpu/bindings.h"
#include "runtime/gpu/gpu.h"

namespace patina::runtime {

class TextureCache {
public:
    // Uploads what was not seen before. The handles are good until the next trim().
    Outcome<BoundTexture> bind(Gpu& gpu, const LoadedTexture& texture);
    // Between frames: lets go of everything if that has become a lot.
    void trim();

private:
    struct Cached {
        std::shared_ptr<const TextureData> data;  // keeps the key's address from being used again
        GpuImage image;
        SamplerHandle sampler;
    };
    std::map<std::pair<const TextureData*, TexelFormat>, Cached> textures_;
};

// All meshes and blocks of a frame in one buffer, each mesh once.
struct FrameData {
    struct MeshPlace {
        VkDeviceSize vertices = 0, indices = 0;
    };
    Buffer buffer;
    std::map<const Mesh*, MeshPlace> meshes;
    std::vector<std::vector<BoundBlock>> blocks;  // by step
};
FrameData make_frame_data(Gpu& gpu, const Frame& frame);

}  // namespace patina::runtime
