// Surfaces that blend and are cut out, too.
#pragma once

#include <algorithm>
#include <string_view>

#include "compiler/format/graph.h"

namespace patina::format {

// [static("surface", "clipped")]: true if the surface is such a one.
inline constexpr std::string_view kClippedKind = "clipped";

// True if the surface blends, and is not drawn where alpha is below the alphaClip that it states. Where materials
// choose the kind of surface, they choose this, too.
inline bool is_clipped_blend(const Graph& graph) {
    const SurfaceKind kind = graph.render.surface;
    return kind != SurfaceKind::Opaque && kind != SurfaceKind::Cutout && !graph.render.allows_override &&
           std::any_of(graph.surface.begin(), graph.surface.end(),
                       [](const PortValue& each) { return each.name == "alphaClip"; });
}

}  // namespace patina::format
