// The reflection probes that an object reads: at most two, and the share of each.
//
// A probe counts fully inside its box, and less and less over `blend` metres outside of it. Of the probes that count at
// the object's centre, two are read. They are sorted by importance, then by how much they count, then by the size of
// their box, the smaller one first. A more important probe hides the other one as far as it counts. Two probes of equal
// importance share by how much they count. If there is only one, what is around has the rest.
//
//   const ProbeChoice choice = choose_probes(scene.probes, bounds.center);
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "runtime/scene/scene.h"

namespace patina::runtime {

struct ProbeChoice {
    const Probe* first = nullptr;   // null: what is around, alone
    const Probe* second = nullptr;  // null: what is around
    float share = 0;                // of the first, 0 to 1
};

// How much a probe counts at a point, 0 to 1.
float weight_at(const Probe& probe, glm::vec3 point);

ProbeChoice choose_probes(std::span<const Probe> probes, glm::vec3 point);

}  // namespace patina::runtime
