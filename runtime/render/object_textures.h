// The textures of objects of a world: lightmaps and shadow masks. Each file is loaded once.
//
//   ObjectTextures loaded = load_object_textures(world);
//   if (loaded.ok) use(loaded.textures[object]);
#pragma once

#include <vector>

#include "patina/patina.h"
#include "runtime/scene/world.h"
#include "runtime/values/textures.h"

namespace patina::runtime {

struct ObjectTextures {
    bool ok = true;
    std::vector<std::vector<LoadedTexture>> textures{};  // by object: "lightmapTexture", "shadowMaskTexture"
    std::vector<std::string> files{};                    // that were read
    std::vector<Diagnostic> diagnostics{};               // of each file that cannot be loaded, at its place
};
ObjectTextures load_object_textures(const World& world);

}  // namespace patina::runtime
