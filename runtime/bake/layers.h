// The layers above the base of glTF's material: what an input of the lighting model `gltf` becomes in which extension.
//
//   Layers made = layers_of(values, covered);
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/bake/baked_material.h"

namespace patina::runtime {

// True if an extension has a place for this input.
bool is_layer(std::string_view input);

struct Layers {
    std::vector<WrittenExtension> extensions;  // their textures are indices into `maps`
    std::vector<BakedMap> maps;
    std::vector<BakedMaterial::Loss> losses;
};

Layers layers_of(const std::vector<LayerValue>& values, const std::vector<std::uint8_t>& covered);

}  // namespace patina::runtime
