#include "compiler/capi/scene_json.h"

#include <optional>

#include "compiler/json/json_writer.h"

namespace patina::capi {
namespace {

void write(JsonWriter& json, const SceneCamera& camera) {
    json.begin("camera", '{');
    json.write("position", camera.position);
    json.write("target", camera.target);
    json.write("up", camera.up);
    if (camera.orthographic)
        json.write("orthographic", *camera.orthographic);
    else
        json.write("fov", camera.fov);
    json.write("near", camera.near_plane);
    json.write("far", camera.far_plane);
    json.end();
}

void write(JsonWriter& json, const SceneLight& light) {
    json.begin('{');
    json.write("type", light.type);
    if (light.type != LightKind::Directional) json.write("position", light.position);
    if (light.type != LightKind::Point) json.write("direction", light.direction);
    json.write("color", light.color);
    json.write("intensity", light.intensity);
    if (light.type != LightKind::Directional) json.write("range", light.range);
    json.if_any("inner", light.inner);
    json.if_any("outer", light.outer);
    json.write("renderMode", light.render_mode);
    if (light.shadow) {
        json.begin("shadow", '{');
        json.write("strength", light.shadow->strength);
        json.write("bias", light.shadow->bias);
        json.write("normalBias", light.shadow->normal_bias);
        json.end();
    }
    json.if_any("cookie", light.cookie.path);
    if (!light.cookie.path.empty()) json.write("cookieSize", light.cookie_size);
    json.end();
}

void write_picture(JsonWriter& json, const ScenePicture& picture) {
    json.begin("environment", '{');
    json.if_any("file", picture.file.path);
    json.write("rotation", picture.rotation);
    json.write("intensity", picture.intensity);
    json.end();
}

void write(JsonWriter& json, const SceneProbe& probe) {
    json.begin('{');
    write_picture(json, probe.picture);
    json.write("position", probe.position);
    json.begin("box", '{');
    json.write("min", probe.box_min);
    json.write("max", probe.box_max);
    json.end();
    json.write("blend", probe.blend);
    json.write("boxProjection", probe.box_projection);
    json.write("importance", probe.importance);
    json.end();
}

void write(JsonWriter& json, const SceneAmbient& ambient) {
    json.begin("ambient", '{');
    if (ambient.sky) json.write("sky", *ambient.sky);
    if (ambient.horizon) json.write("horizon", *ambient.horizon);
    if (ambient.ground) json.write("ground", *ambient.ground);
    json.end();
}

void write(JsonWriter& json, const SceneFog& fog) {
    json.begin("fog", '{');
    json.write("mode", fog.mode);
    json.write("color", fog.color);
    json.write("density", fog.density);
    json.write("start", fog.start);
    json.write("end", fog.end);
    json.end();
}

void write(JsonWriter& json, const SceneMixedLighting& mixed) {
    json.begin("mixedLighting", '{');
    json.write("mode", mixed.mode);
    json.write("shadowColor", mixed.shadow_color);
    json.if_any("shadowDistance", mixed.shadow_distance);
    json.if_any("shadowFade", mixed.shadow_fade);
    json.end();
}

void write_surroundings(JsonWriter& json, const SceneFile& scene) {
    if (scene.ambient)
        write(json, *scene.ambient);
    else if (scene.has_studio_ambient)
        json.if_any("ambient", "studio");
    if (scene.picture)
        write_picture(json, *scene.picture);
    else
        json.write("environment", scene.environment);
    json.begin("probes", '[');
    for (const SceneProbe& probe : scene.probes) write(json, probe);
    json.end();
    if (scene.fog) write(json, *scene.fog);
    write(json, scene.mixed_lighting);
    if (scene.background)
        json.write("background", *scene.background);
    else if (scene.backdrop != SceneBackdrop::Color)
        json.write("background", scene.backdrop);
}

void write_values(JsonWriter& json, const std::vector<SceneValue>& values) {
    json.begin("set", '{');
    for (const SceneValue& value : values) json.if_any(value.property, value.words);
    json.end();
}

template <class Placed>
void write_place(JsonWriter& json, const Placed& placed) {
    json.write("position", placed.position);
    json.write("rotation", placed.rotation);
    json.write("scale", placed.scale);
}

void write(JsonWriter& json, const SceneObject& object, const SceneFile& scene) {
    json.begin('{');
    json.if_any("id", object.id);
    json.if_any("mesh", object.mesh);
    if (object.segments) json.write("segments", *object.segments);
    json.if_any("material", scene.materials[object.material].name);
    write_place(json, object);
    json.if_any("lightmap", object.lightmap.path);
    if (!object.lightmap.path.empty()) json.write("lightmapEncoding", object.lightmap_encoding);
    json.if_any("shadowMask", object.shadow_mask.path);
    json.begin("instances", '[');
    for (const SceneInstance& instance : object.instances) {
        json.begin('{');
        write_place(json, instance);
        write_values(json, instance.set);
        json.end();
    }
    json.end();
    json.end();
}

}  // namespace

std::string json_of(const SceneFile& scene) {
    JsonWriter json;
    json.begin('{');
    json.if_any("name", scene.name);
    write(json, scene.camera);
    json.begin("lights", '[');
    for (const SceneLight& light : scene.lights) write(json, light);
    json.end();
    write_surroundings(json, scene);
    json.write("time", scene.time);
    json.write("pixelLightCount", scene.pixel_light_count);
    json.begin("materials", '[');
    for (const SceneMaterial& material : scene.materials) {
        json.begin('{');
        json.if_any("name", material.name);
        json.if_any("graph", material.graph.path);
        write_values(json, material.set);
        json.end();
    }
    json.end();
    json.begin("objects", '[');
    for (const SceneObject& object : scene.objects) write(json, object, scene);
    json.end();
    json.end();
    return json.take();
}

}  // namespace patina::capi
