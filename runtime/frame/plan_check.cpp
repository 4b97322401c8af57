#include "runtime/frame/plan_check.h"

#include <fmt/format.h>

#include "runtime/frame/frame_builder.h"
#include "runtime/lights/shadow_view.h"
#include "runtime/scene/view.h"

namespace patina::runtime {
namespace {

// Inputs that a list of draws cannot provide.
std::string check_state(const Pass& pass) {
    if (pass.draws != PassDraws::Objects && is_shadow_pass(pass))
        return "draws from the lights, so it must draw objects";
    if (pass.draws == PassDraws::LightVolumes && pass.lights != PassLights::Local)
        return "draws light volumes, so its lights must be 'local': directional ones have no volume";
    return "";
}

std::string check_material(const World& world, std::size_t index, const DrawnMaterial& material) {
    const std::string& name = world.materials[index].name;
    if (!material.reflection) return fmt::format("the material '{}' was not compiled", name);
    for (const Pass& pass : material.reflection->passes) {
        const std::string subject = fmt::format("pass '{}' of the material '{}'", pass.name, name);
        if (std::string error = check_state(pass); !error.empty()) return subject + " " + error;
        if (!material.passes.contains(pass.name)) return subject + " has no shaders";
        if (pass.camera != PassCamera::Perspective || is_shadow_pass(pass) || !camera_view(world.view).is_parallel)
            continue;
        const std::string fallback = path_for(world.view.camera, *material.reflection);
        return subject + " needs a perspective camera" +
               (fallback.empty() ? "" : fmt::format("; compile it for the path '{}'", fallback));
    }
    return "";
}

}  // namespace

std::string plan_error(const World& world, std::span<const DrawnMaterial> materials, const FrameOptions& options) {
    if (materials.size() != world.materials.size())
        return fmt::format("{} materials were compiled, the scene has {}", materials.size(), world.materials.size());
    if (world.view.lights.size() > kMostLights)
        return fmt::format("the scene has {} lights; a pass sees {} at most", world.view.lights.size(), kMostLights);
    if (options.shadow_atlas_size < kSmallestShadowAtlas || options.shadow_atlas_size % 2 != 0)
        return fmt::format("the shadow atlas must have an even number of texels along a side, {} or more, not {}",
                           kSmallestShadowAtlas, options.shadow_atlas_size);
    for (const WorldObject& object : world.objects) {
        if (!object.mesh) return fmt::format("the object '{}' has no mesh", object.name);
        if (object.material >= materials.size()) return fmt::format("the object '{}' has no material", object.name);
        if (std::string error = check_material(world, object.material, materials[object.material]); !error.empty())
            return error;
    }
    return "";
}

}  // namespace patina::runtime
