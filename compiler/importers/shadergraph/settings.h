// The settings of a target: which workflow and render state a material has.
#pragma once

#include "compiler/importers/imported_graph.h"
#include "compiler/importers/importer.h"
#include "compiler/importers/shadergraph/read/shader_graph.h"

namespace patina::importers::shadergraph {

struct SettingRemark {
    Remark::Kind kind = Remark::Kind::Taken;
    std::string part{}, text{};
    Place place{};
};
struct Settings {
    bool is_lit = false, is_specular = false;
    std::string lighting{};  // a model; empty: the workflow's own
    bool is_blended = false, is_clipped = false;
    bool is_clipped_blend = false;  // both, which no kind of surface is
    bool is_overridable = false;    // by materials, which need the inputs of all kinds of surfaces
    bool is_tinted = false;         // multiplied by the colour of the vertices, as sprites are
    bool is_weighted = false;       // additive: the colour is multiplied by alpha
    bool is_faded = false;          // multiplied: alpha fades the colour to white
    bool has_metal = true;          // without a specular colour
    std::string lost_blocks{};      // that the target has and the surface lacks: "CoatMask CoatSmoothness"; "*": any
    std::string_view color_block = "BaseColor", normal_block = "NormalTS";  // the ones of several that count
    GraphMembers render{};
    std::vector<SettingRemark> remarks{};

    std::string_view workflow() const;         // its name in the library
    bool uses(std::string_view block) const;   // the target has this block with these settings
    bool loses(std::string_view block) const;  // the same, and the surface lacks it
};
// Of the target that counts: that of the universal pipeline, if there are several.
Settings read_settings(const ShaderGraph& graph);

}  // namespace patina::importers::shadergraph
