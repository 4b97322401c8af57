// The texture coordinates of a mesh as a map to draw into: their errors, and the texels that they cover.
//
//   Outcome<UvLayout> layout = uv_layout(mesh, 1024);
//   if (layout && layout.value.overlap > 0) warn(...);
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/mesh/mesh.h"
#include "runtime/outcome.h"

namespace patina::runtime {

struct UvLayout {
    // The mesh with triangles that all turn the same way in the texture, like front faces. Otherwise a mirrored chart
    // would count as seen from behind. Triangles without area in the texture are left out.
    Mesh mesh;
    double overlap = 0;  // share of the covered texels that more than one triangle covers
};

// Fails if uv0 covers no area, is not finite, or leaves the square from 0 to 1. `size`: texels along a side.
Outcome<UvLayout> uv_layout(const Mesh& mesh, int size);

}  // namespace patina::runtime
