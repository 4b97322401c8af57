// Materials that share a lighting pass. A full-screen pass or light volume with the stencil reference "lighting" is
// drawn once for each group, on the pixels that the group's materials have marked with its number.
//
//   LightingGroups groups(materials);
//   std::optional<int> number = groups.number(0, 3);   // of material 3, among the objects that are drawn first
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "runtime/frame/frame_plan.h"

namespace patina::runtime {

inline constexpr int kMostLightingGroups = 255;

// The pass takes its pixels from the stencil.
bool is_masked(const Pass& pass);

// What a pass that draws no object does: equal for materials that can be drawn at once. It is the fragment shader, and
// the material itself where the shader reads the material's own values or textures.
std::string lighting_key(std::span<const DrawnMaterial> materials, std::size_t material, const Pass& pass);

class LightingGroups {
public:
    explicit LightingGroups(std::span<const DrawnMaterial> materials) : materials_(materials) {}

    // The stencil value, 1 to kMostLightingGroups: the same for materials whose masked passes do the same. Objects of
    // different phases have different ones, since each phase is lit before the next is drawn. 0: no pass of the
    // material uses a reference. None: there are too many groups.
    std::optional<int> number(int phase, std::size_t material);

private:
    std::span<const DrawnMaterial> materials_;
    std::map<std::pair<int, std::size_t>, int> known_{};  // phase, material
    std::map<std::string, int> numbers_{};
};

}  // namespace patina::runtime
