#include "runtime/frame/lighting_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace patina::runtime {
namespace {

bool reads_material(const Reflection& reflection, const Pass& pass) {
    auto is_read = [](const std::vector<std::string>& names, const auto& item) {
        return item.is_material && std::find(names.begin(), names.end(), item.name) != names.end();
    };
    return std::any_of(reflection.blocks.begin(), reflection.blocks.end(),
                       [&](const Block& block) { return is_read(pass.blocks, block); }) ||
           std::any_of(reflection.textures.begin(), reflection.textures.end(),
                       [&](const Texture& texture) { return is_read(pass.textures, texture); });
}

std::string fragment_key(const DrawnPass& drawn) {
    if (!drawn.fragment.empty()) return std::string(drawn.fragment);
    const std::span<const std::uint32_t> spirv = drawn.stages.fragment_spirv;
    if (spirv.empty()) return fmt::format("{}", static_cast<const void*>(drawn.stages.program));
    std::string bytes(spirv.size_bytes(), '\0');
    std::memcpy(bytes.data(), spirv.data(), spirv.size_bytes());
    return bytes;
}

}  // namespace

bool is_masked(const Pass& pass) {
    return pass.stencil.is_of_lighting() && pass.stencil.test != Compare::Always;
}

std::string lighting_key(std::span<const DrawnMaterial> materials, std::size_t material, const Pass& pass) {
    const DrawnMaterial& drawn = materials[material];
    std::string owner = reads_material(*drawn.reflection, pass) ? fmt::format("{}", material) : "";
    return fmt::format("{}\n{}\n", pass.name, owner) + fragment_key(drawn.passes.at(pass.name));
}

std::optional<int> LightingGroups::number(int phase, std::size_t material) {
    auto [known, is_new] = known_.try_emplace({phase, material}, 0);
    if (is_new) {
        bool uses_reference = false;
        std::string key = fmt::format("{}\n", phase);
        for (const Pass& pass : materials_[material].reflection->passes) {
            uses_reference |= pass.stencil.is_of_lighting();
            if (pass.draws == PassDraws::Objects || !is_masked(pass)) continue;
            const std::string one = lighting_key(materials_, material, pass);
            key += fmt::format("{}\n", one.size()) + one;
        }
        const auto next = static_cast<int>(numbers_.size()) + 1;
        if (uses_reference) known->second = numbers_.try_emplace(std::move(key), next).first->second;
    }
    if (known->second > kMostLightingGroups) return std::nullopt;
    return known->second;
}

}  // namespace patina::runtime
