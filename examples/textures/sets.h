// The sets of textures that the example graphs use, one function and one file each. Within a set, the maps come from
// the same height field, so that bumps, colours and gloss agree.
#pragma once

#include <string>
#include <vector>

#include "examples/textures/picture.h"

namespace textures {

struct Texture {
    std::string name;  // file name without ".png"
    int channels = 3;
    Picture picture;
};
using Set = std::vector<Texture>;

inline constexpr int kSize = 256;

// steel_color, steel_orm (red: occlusion, green: roughness, blue: metallic), steel_normal: scratched steel, rusting
Set rusted_steel();
// tiles_color, tiles_specgloss (rgb: specular colour, alpha: gloss), tiles_normal: painted square tiles with grout
Set painted_tiles();
// rock_color, rock_normal, moss_color, moss_normal; alpha of the normal maps: height
Set mossy_rock();
// leaves (alpha: cut-out), leaves_normal
Set ivy_leaves();
// bricks_color, bricks_height (1: the foremost face), bricks_normal: worn bricks in running bond
Set bricks();
// quilt_normal, quilt_mask (alpha: 0 on the seams), weave_color (a factor around 0.5), weave_normal: quilted cloth
Set quilt();
// light_ramps: tones of light for a lighting graph, cold in the first row and warm in the last
Set light_ramps();
// lit_ball: a mirroring ball in a studio, for matcaps
Set lit_ball();

// A table as `patina import` makes it of a measured material. An error message, or empty.
std::string save_satin_paint(const std::string& path);

}  // namespace textures
