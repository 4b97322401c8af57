#include "runtime/lights/probe_choice.h"

#include <algorithm>
#include <vector>

namespace patina::runtime {
namespace {

struct Candidate {
    const Probe* probe = nullptr;
    float weight = 0, volume = 0;
};

bool goes_before(const Candidate& a, const Candidate& b) {
    if (a.probe->importance != b.probe->importance) return a.probe->importance > b.probe->importance;
    return a.weight != b.weight ? a.weight > b.weight : a.volume < b.volume;
}

}  // namespace

float weight_at(const Probe& probe, glm::vec3 point) {
    const float outside = glm::distance(point, glm::clamp(point, probe.box_min, probe.box_max));
    if (outside <= 0) return 1;
    return probe.blend > 0 ? std::max(1 - outside / probe.blend, 0.0f) : 0;
}

ProbeChoice choose_probes(std::span<const Probe> probes, glm::vec3 point) {
    std::vector<Candidate> near;
    for (const Probe& probe : probes) {
        const glm::vec3 size = probe.box_max - probe.box_min;
        const float weight = weight_at(probe, point);
        if (weight > 0) near.push_back({.probe = &probe, .weight = weight, .volume = size.x * size.y * size.z});
    }
    if (near.empty()) return {};
    std::stable_sort(near.begin(), near.end(), goes_before);
    const Candidate& first = near[0];
    if (near.size() == 1) return {.first = first.probe, .share = first.weight};
    const Candidate& second = near[1];
    const bool is_alike = first.probe->importance == second.probe->importance;
    return {.first = first.probe,
            .second = second.probe,
            .share = is_alike ? first.weight / (first.weight + second.weight) : first.weight};
}

}  // namespace patina::runtime
