#include "runtime/values/engine_values.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>

#include "runtime/lights/light_split.h"

namespace patina::runtime {
namespace {

using Values = std::map<std::string, EngineValue>;

EngineValue scalar(double value) {
    return {1, {value}};
}

EngineValue vector(glm::vec3 v) {
    return {3, {v.x, v.y, v.z}};
}

void append(EngineValue& value, glm::vec4 v) {
    value.numbers.insert(value.numbers.end(), {v.x, v.y, v.z, v.w});
}

EngineValue vector(glm::vec4 v) {
    EngineValue result{4, {}};
    append(result, v);
    return result;
}

void append(EngineValue& value, const glm::mat4& m) {
    for (int column = 0; column < 4; column++) append(value, m[column]);
}

EngineValue matrix(const glm::mat4& m) {
    EngineValue result{4, {}};
    append(result, m);
    return result;
}

void add_camera(Values& values, const View& view) {
    glm::mat4 to_clip = view.view_to_clip * view.world_to_view;
    values["worldToClip"] = matrix(to_clip);
    // In double: near planes close to the camera leave the inverse few digits in float.
    values["clipToWorld"] = matrix(glm::mat4(glm::inverse(glm::dmat4(to_clip))));
    values["worldToView"] = matrix(view.world_to_view);
    values["cameraPositionWS"] = vector(view.position);
    values["cameraForwardWS"] = vector(view.forward);
    values["viewIsOrthographic"] = scalar(view.is_parallel ? 1 : 0);
    values["clipPlanes"] = {2, {view.near_plane, view.far_plane}};
    values["shadowBias"] = scalar(view.bias);
    values["shadowNormalBias"] = scalar(view.normal_bias);
}

void add_frame(Values& values, const Scene& scene) {
    values["time"] = scalar(scene.time);
    values["screenSize"] = {2, {double(scene.width) * scene.samples, double(scene.height) * scene.samples}};
    // Those of the picture as a whole: frame/tiles.h knows those of a tile.
    values["tile"] = vector(glm::vec4(0, 0, scene.width * scene.samples, scene.height * scene.samples));
    values["tileClip"] = vector(glm::vec4(1, 1, 0, 0));
    const Fog& fog = scene.fog;
    values["fogColor"] = vector(glm::vec4(fog.color, 1));
    values["fogSettings"] = vector(glm::vec4(static_cast<int>(fog.mode), fog.density, fog.start, fog.end));
}

// 1 in its channel of shadow masks; all 0: it has none.
glm::vec4 mask_of(std::span<const Light> lights, std::size_t index) {
    glm::vec4 mask(0);
    if (!lights[index].shadow.casts) return mask;
    const auto before = std::count_if(lights.begin(), lights.begin() + std::ptrdiff_t(index),
                                      [](const Light& light) { return light.shadow.casts; });
    if (before < 4) mask[int(before)] = 1;
    return mask;
}

// -1: the draw does not see the main light.
double main_slot(const Scene& scene, std::span<const SeenLight> lights) {
    const std::optional<std::size_t> main = main_light(scene.lights);
    for (std::size_t i = 0; main && i < lights.size(); i++)
        if (lights[i].index == *main) return double(i);
    return -1;
}

// The values of the lights that baked light needs.
void add_mixed_lighting(Values& values, const EngineScene& seen, std::span<const SeenLight> lights) {
    const Scene& scene = *seen.scene;
    const MixedLighting& mixed = scene.mixed_lighting;
    EngineValue masks{4, {}};
    for (const SeenLight& light : lights)
        append(masks, light.index < scene.lights.size() ? mask_of(scene.lights, light.index) : glm::vec4(0));
    values["lightMask"] = masks;
    values["mainLight"] = scalar(mixed.mode == LightMixing::Subtractive ? main_slot(scene, lights) : -1);
    values["shadowColor"] = vector(glm::vec4(mixed.shadow_color, 1));
    if (!mixed.shadow_distance) {
        values["shadowFade"] = {2, {0, 0}};
        return;
    }
    const double distance = *mixed.shadow_distance;
    const double length = std::max(double(mixed.shadow_fade.value_or(*mixed.shadow_distance / 5)), 1e-3);
    values["shadowFade"] = {2, {1 / length, (length - distance) / length}};
}

// The lights over which a pass loops, and after them those that it computes at vertices.
void add_lights(Values& values, const EngineScene& seen) {
    std::span<const SeenLight> lights = std::span(seen.lights).first(std::min(seen.lights.size(), kMostLights));
    const Light* cookie = cookie_light(lights);
    EngineValue position{4, {}}, color{4, {}}, axis{4, {}}, cone{4, {}};
    const auto add = [&](const SeenLight& seen_light) {
        const Light& light = *seen_light.light;
        glm::vec3 direction = glm::normalize(light.direction);
        bool is_directional = light.kind == LightKind::Directional;
        bool is_spot = light.kind == LightKind::Spot;
        append(position, is_directional ? glm::vec4(direction, 0) : glm::vec4(light.position, is_spot ? 2 : 1));
        append(color, glm::vec4(light.color, light.range));
        append(axis, glm::vec4(is_spot ? direction : glm::vec3(0, 0, -1), &light == cookie ? 1 : 0));
        double inner = std::cos(glm::radians(light.inner_angle)), outer = std::cos(glm::radians(light.outer_angle));
        append(cone, glm::vec4(inner, outer, seen_light.index, seen_light.shadow_map));
    };
    for (const SeenLight& light : lights) add(light);
    const std::size_t at_vertices =
        std::min({seen.vertex_lights.size(), kMostVertexLights, kMostLights - lights.size()});
    for (std::size_t i = 0; i < at_vertices; i++) add(seen.vertex_lights[i]);
    for (std::size_t i = lights.size() + at_vertices; i < kMostLights; i++) append(cone, glm::vec4(0, 0, 0, -1));
    values["lightCount"] = scalar(double(lights.size()));
    values["vertexLightCount"] = scalar(double(at_vertices));
    values["lightPosition"] = position;
    values["lightColor"] = color;
    values["lightAxis"] = axis;
    values["lightCone"] = cone;
    add_mixed_lighting(values, seen, lights);
    values["worldToCookie"] = matrix(cookie ? world_to_cookie(*cookie) : glm::mat4(1));
}

void add_shadow_maps(Values& values, std::span<const ShadowView> maps, int atlas_size) {
    EngineValue to_shadow{4, {}}, tile{4, {}};
    glm::vec4 strength(0);
    for (std::size_t i = 0; i < kMostShadowMaps; i++) {
        const ShadowView map = i < maps.size() ? maps[i] : ShadowView{};
        append(to_shadow, map.world_to_shadow);
        append(tile, map.tile);
        strength[static_cast<int>(i)] = i < maps.size() ? map.strength : 0;
    }
    values["worldToShadow"] = to_shadow;
    values["shadowTile"] = tile;
    values["shadowStrength"] = vector(strength);
    values["shadowTexel"] = scalar(1.0 / atlas_size);
}

void add_probes(Values& values, const ProbeChoice& probes) {
    EngineValue center{4, {}}, low{4, {}}, high{4, {}};
    for (const Probe* chosen : {probes.first, probes.second}) {
        const Probe probe = chosen ? *chosen : Probe{.box_min = {}, .box_max = {}, .is_box_projected = false};
        append(center, glm::vec4(probe.position, probe.is_box_projected ? 1 : 0));
        append(low, glm::vec4(probe.box_min, probe.blend));
        append(high, glm::vec4(probe.box_max, 0));
    }
    values["probeCenter"] = center;
    values["probeBoxMin"] = low;
    values["probeBoxMax"] = high;
    values["probeShare"] = scalar(probes.share);
}

}  // namespace

const Light* cookie_light(std::span<const SeenLight> lights) {
    auto found = std::find_if(lights.begin(), lights.end(), [](const SeenLight& s) { return has_cookie(*s.light); });
    return found == lights.end() ? nullptr : found->light;
}

std::map<std::string, EngineValue> object_values(const glm::mat4& object_to_world) {
    return {{"objectToWorld", matrix(object_to_world)}, {"worldToObject", matrix(glm::inverse(object_to_world))}};
}

std::map<std::string, EngineValue> engine_values(const EngineScene& seen) {
    Values values;
    add_camera(values, seen.view);
    add_frame(values, *seen.scene);
    add_lights(values, seen);
    add_shadow_maps(values, seen.shadow_maps, seen.shadow_atlas_size);
    values.merge(object_values(seen.object_to_world));
    values["lightmapDecode"] = vector(seen.lightmap_decode);

    EngineValue ambient{4, {}};
    for (const glm::vec3& coefficient : seen.ambient.coefficients) append(ambient, glm::vec4(coefficient, 0));
    values["ambientSH"] = ambient;
    add_probes(values, seen.probes);
    return values;
}

std::map<std::string, EngineValue> engine_values(const Scene& scene) {
    EngineScene seen{.scene = &scene,
                     .view = camera_view(scene),
                     .object_to_world = scene.object_to_world,
                     .ambient = scene.ambient};
    // A material graph's own light semantics mean the first light: let that be the sun where there is one.
    for (std::size_t i : light_order(scene.lights)) seen.lights.push_back({.light = &scene.lights[i], .index = i});
    return engine_values(seen);
}

std::vector<std::string> engine_value_names() {
    std::vector<std::string> names;
    for (const auto& [name, value] : engine_values(fullscreen_scene(1, 1))) names.push_back(name);
    return names;
}

}  // namespace patina::runtime
