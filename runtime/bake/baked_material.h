// Turns the pictures of the pass `bake` or `bake-specular` (nodes/passes/bake.pass.hlsl) into a glTF material: a value
// that is the same everywhere becomes a factor, any other a texture.
//
//   BakedMaterial made = baked_material("rust", drawn, {}, state);
//   Outcome<std::string> png = encode_map(made.maps[0]);
#pragma once

#include <string>
#include <vector>

#include "patina/words.h"
#include "runtime/bake/texels.h"
#include "runtime/gltf/gltf_writer.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

// The targets of the pass, all of one size.
struct BakedTargets {
    Image color, reflection, normal, emission, cutoff;
};

// An input of the lighting model that the graph sets, from the pass `bake-value`. If it is the same everywhere, it has
// one texel. Its numbers are finite.
struct LayerValue {
    std::string input{};
    Image image{};
    NotFinite not_finite{};  // texels that were not
};

// What the pass does not draw.
struct BakedState {
    SurfaceKind surface = SurfaceKind::Opaque;
    bool is_unlit = false;
    bool is_double_sided = false;
    bool is_specular = false;  // KHR_materials_pbrSpecularGlossiness
};

struct BakedMap {
    std::string name;       // "baseColor"
    bool is_color = false;  // encoded as sRGB in a file of 8 bits
    Image image;            // linear; what a texture of glTF holds
};

struct BakedMaterial {
    WrittenMaterial material;    // its textures are indices into `maps`
    std::vector<BakedMap> maps;  // padded
    // What is lost, with the reason: "the base colour above 1", "...".
    struct Loss {
        std::string what, why;
    };
    std::vector<Loss> losses;
    NotFinite not_finite{};  // texels of the targets with a number that is not finite, which becomes 0
};

BakedMaterial baked_material(const std::string& name, BakedTargets drawn, const std::vector<LayerValue>& layers,
                             const BakedState& state);

Outcome<std::string> encode_map(const BakedMap& map);  // a PNG file

}  // namespace patina::runtime
