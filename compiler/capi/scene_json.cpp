#include "compiler/capi/scene_json.h"

#include <optional>

#include "compiler/capi/json_writer.h"

namespace patina::capi {
namespace {

void number_if(JsonWriter& json, std::string_view key, const std::optional<double>& value) {
    if (value) json.number(key, *value);
}

void write(JsonWriter& json, const SceneCamera& camera) {
    json.begin("camera", '{');
    json.numbers("position", camera.position);
    json.numbers("target", camera.target);
    json.numbers("up", camera.up);
    if (camera.orthographic)
        json.number("orthographic", *camera.orthographic);
    else
        json.number("fov", camera.fov);
    json.number("near", camera.near_plane);
    json.number("far", camera.far_plane);
    json.end('}');
}

void write(JsonWriter& json, const SceneLight& light) {
    json.begin('{');
    json.word("type", light.type);
    if (light.type != LightKind::Directional) json.numbers("position", light.position);
    if (light.type != LightKind::Point) json.numbers("direction", light.direction);
    json.numbers("color", light.color);
    json.number("intensity", light.intensity);
    if (light.type != LightKind::Directional) json.number("range", light.range);
    number_if(json, "inner", light.inner);
    number_if(json, "outer", light.outer);
    json.word("renderMode", light.render_mode);
    if (light.shadow) {
        json.begin("shadow", '{');
        json.number("strength", light.shadow->strength);
        json.number("bias", light.shadow->bias);
        json.number("normalBias", light.shadow->normal_bias);
        json.end('}');
    }
    json.text("cookie", light.cookie.path);
    if (!light.cookie.path.empty()) json.number("cookieSize", light.cookie_size);
    json.end('}');
}

void write_picture(JsonWriter& json, const ScenePicture& picture) {
    json.begin("environment", '{');
    json.text("file", picture.file.path);
    json.number("rotation", picture.rotation);
    json.number("intensity", picture.intensity);
    json.end('}');
}

void write(JsonWriter& json, const SceneProbe& probe) {
    json.begin('{');
    write_picture(json, probe.picture);
    json.numbers("position", probe.position);
    json.begin("box", '{');
    json.numbers("min", probe.box_min);
    json.numbers("max", probe.box_max);
    json.end('}');
    json.number("blend", probe.blend);
    json.flag("boxProjection", probe.box_projection);
    json.number("importance", probe.importance);
    json.end('}');
}

void write(JsonWriter& json, const SceneAmbient& ambient) {
    json.begin("ambient", '{');
    if (ambient.sky) json.numbers("sky", *ambient.sky);
    if (ambient.horizon) json.numbers("horizon", *ambient.horizon);
    if (ambient.ground) json.numbers("ground", *ambient.ground);
    json.end('}');
}

void write(JsonWriter& json, const SceneFog& fog) {
    json.begin("fog", '{');
    json.word("mode", fog.mode);
    json.numbers("color", fog.color);
    json.number("density", fog.density);
    json.number("start", fog.start);
    json.number("end", fog.end);
    json.end('}');
}

void write(JsonWriter& json, const SceneMixedLighting& mixed) {
    json.begin("mixedLighting", '{');
    json.word("mode", mixed.mode);
    json.numbers("shadowColor", mixed.shadow_color);
    number_if(json, "shadowDistance", mixed.shadow_distance);
    number_if(json, "shadowFade", mixed.shadow_fade);
    json.end('}');
}

void write_surroundings(JsonWriter& json, const SceneFile& scene) {
    if (scene.ambient)
        write(json, *scene.ambient);
    else if (scene.has_studio_ambient)
        json.text("ambient", "studio");
    if (scene.picture)
        write_picture(json, *scene.picture);
    else
        json.word("environment", scene.environment);
    json.begin("probes", '[');
    for (const SceneProbe& probe : scene.probes) write(json, probe);
    json.end(']');
    if (scene.fog) write(json, *scene.fog);
    write(json, scene.mixed_lighting);
    if (scene.background)
        json.numbers("background", *scene.background);
    else if (scene.backdrop != SceneBackdrop::Color)
        json.word("background", scene.backdrop);
}

void write_values(JsonWriter& json, const std::vector<SceneValue>& values) {
    json.begin("set", '{');
    for (const SceneValue& value : values) json.text(value.property, value.words);
    json.end('}');
}

template <class Placed>
void write_place(JsonWriter& json, const Placed& placed) {
    json.numbers("position", placed.position);
    json.numbers("rotation", placed.rotation);
    json.numbers("scale", placed.scale);
}

void write(JsonWriter& json, const SceneObject& object, const SceneFile& scene) {
    json.begin('{');
    json.text("id", object.id);
    json.text("mesh", object.mesh);
    if (object.segments) json.number("segments", *object.segments);
    json.text("material", scene.materials[object.material].name);
    write_place(json, object);
    json.text("lightmap", object.lightmap.path);
    if (!object.lightmap.path.empty()) json.word("lightmapEncoding", object.lightmap_encoding);
    json.text("shadowMask", object.shadow_mask.path);
    json.begin("instances", '[');
    for (const SceneInstance& instance : object.instances) {
        json.begin('{');
        write_place(json, instance);
        write_values(json, instance.set);
        json.end('}');
    }
    json.end(']');
    json.end('}');
}

}  // namespace

std::string json_of(const SceneFile& scene) {
    JsonWriter json;
    json.begin('{');
    json.text("name", scene.name);
    write(json, scene.camera);
    json.begin("lights", '[');
    for (const SceneLight& light : scene.lights) write(json, light);
    json.end(']');
    write_surroundings(json, scene);
    json.number("time", scene.time);
    json.number("pixelLightCount", scene.pixel_light_count);
    json.begin("materials", '[');
    for (const SceneMaterial& material : scene.materials) {
        json.begin('{');
        json.text("name", material.name);
        json.text("graph", material.graph.path);
        write_values(json, material.set);
        json.end('}');
    }
    json.end(']');
    json.begin("objects", '[');
    for (const SceneObject& object : scene.objects) write(json, object, scene);
    json.end(']');
    json.end('}');
    return json.take();
}

}  // namespace patina::capi
