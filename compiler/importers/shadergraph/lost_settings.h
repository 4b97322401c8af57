// What a target does by its settings and the surface of a graph does not: what is lost, and the blocks that the target
// has for it.
#pragma once

#include <span>
#include <string_view>

#include "compiler/importers/shadergraph/read/shader_graph.h"

namespace patina::importers::shadergraph {

struct LostSetting {
    // What else must be set, or the setting has no effect.
    enum class Needs { Nothing, Blending, Clipping, Specular };

    std::string_view key, label;
    double otherwise;       // the value with which nothing is lost
    std::string_view text;  // what is lost with another one
    std::string_view blocks = {};
    double with = -1;  // the value with which the target has these blocks; below 0: every other one
    Needs needs = Needs::Nothing;
};
std::span<const LostSetting> lost_settings();

// The material types of the high definition pipeline's Lit.
struct MaterialType {
    std::string_view name, lost;  // empty: nothing is
    std::string_view blocks;
    bool has_metal;
};
enum class Lit { Standard, Subsurface, Anisotropy, Iridescence, SpecularColor, Translucent, ColoredTranslucent };
const MaterialType& material_type(Lit type);

// Whether the unconnected slot of a block has the block's default.
bool has_default(const Slot& slot, std::string_view block);
// Whether "CoatMask CoatSmoothness" names the block.
bool names(std::string_view blocks, std::string_view block);

}  // namespace patina::importers::shadergraph
