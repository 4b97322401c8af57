// The samplers that textures can share, by name: "sampler": "trilinearRepeat". All textures of a material that name the
// same one are read through one sampler.
//
//   const SharedSampler* shared = find_shared_sampler("trilinearClamp");
//   if (shared) property.sampler = shared->sampler;
#pragma once

#include <array>
#include <string_view>

#include "patina/reflection.h"

namespace patina::graph {

struct SharedSampler {
    std::string_view name;
    Sampler sampler;
};
inline constexpr std::array kSharedSamplers = {
    SharedSampler{"trilinearRepeat", {Wrap::Repeat, Filter::Linear, 1}},
    SharedSampler{"trilinearClamp", {Wrap::Clamp, Filter::Linear, 1}},
    SharedSampler{"trilinearMirror", {Wrap::Mirror, Filter::Linear, 1}},
    SharedSampler{"nearestRepeat", {Wrap::Repeat, Filter::Nearest, 1}},
    SharedSampler{"nearestClamp", {Wrap::Clamp, Filter::Nearest, 1}},
    SharedSampler{"nearestMirror", {Wrap::Mirror, Filter::Nearest, 1}},
    SharedSampler{"anisotropic4Repeat", {Wrap::Repeat, Filter::Linear, 4}},
    SharedSampler{"anisotropic4Clamp", {Wrap::Clamp, Filter::Linear, 4}},
    SharedSampler{"anisotropic4Mirror", {Wrap::Mirror, Filter::Linear, 4}},
    SharedSampler{"anisotropic16Repeat", {Wrap::Repeat, Filter::Linear, 16}},
    SharedSampler{"anisotropic16Clamp", {Wrap::Clamp, Filter::Linear, 16}},
    SharedSampler{"anisotropic16Mirror", {Wrap::Mirror, Filter::Linear, 16}},
};

constexpr const SharedSampler* find_shared_sampler(std::string_view name) {
    for (const SharedSampler& each : kSharedSamplers) {
        if (each.name == name) return &each;
    }
    return nullptr;
}
constexpr std::array<std::string_view, kSharedSamplers.size()> shared_sampler_names() {
    std::array<std::string_view, kSharedSamplers.size()> names{};
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = kSharedSamplers[i].name;
    return names;
}

}  // namespace patina::graph
