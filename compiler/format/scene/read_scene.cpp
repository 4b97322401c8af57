#include "compiler/format/scene/read_scene.h"

#include <algorithm>
#include <cfloat>
#include <unordered_map>

#include "compiler/base/file_names.h"
#include "compiler/format/scene/read_scene_fields.h"

namespace patina::format {
namespace {

// --- the camera

bool is_same_point(const SceneVector& a, const SceneVector& b) {
    return std::equal(a.begin(), a.end(), b.begin(),
                      [](double x, double y) { return static_cast<float>(x) == static_cast<float>(y); });
}

// In floats, as the renderer takes them.
bool is_along(const SceneVector& a, const SceneVector& b) {
    const auto product = [](double x, double y) { return static_cast<float>(x) * static_cast<float>(y); };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (product(a[i], b[j]) != product(a[j], b[i])) return false;
    }
    return true;
}

SceneCamera read_camera(Reading& reading, const json::Json& json) {
    SceneCamera camera;
    if (!expect(reading, json, json::Json::Kind::Object, "'camera'")) return camera;
    check_keys(reading, json, ObjectKind::Camera);
    const std::size_t errors_before = reading.diagnostics.error_count();
    read_vector(reading, json, ObjectKind::Camera, "position", camera.position);
    read_vector(reading, json, ObjectKind::Camera, "target", camera.target);
    read_vector(reading, json, ObjectKind::Camera, "up", camera.up);
    read_number(reading, json, ObjectKind::Camera, "fov", camera.fov);
    double height = 0;
    if (read_number(reading, json, ObjectKind::Camera, "orthographic", height)) camera.orthographic = height;
    if (const json::JsonMember* fov = find_member(json, "fov"); fov && json.find("orthographic")) {
        reading.diagnostics.report(Code::ConflictingInputs, fov->key_span, "fov", "orthographic")
            .note(find_member(json, "orthographic")->key_span, "the other one is here");
    }
    read_number(reading, json, ObjectKind::Camera, "near", camera.near_plane);
    read_number(reading, json, ObjectKind::Camera, "far", camera.far_plane);
    if (reading.diagnostics.error_count() > errors_before) return camera;
    if (is_same_point(camera.position, camera.target)) {
        report_impossible(reading, json, json.find("target") ? "target" : "position",
                          json.find("target") ? "another point than 'position'" : "another point than 'target'");
    } else if (json.find("up")) {
        SceneVector forward{};
        for (std::size_t i = 0; i < 3; ++i) forward[i] = camera.target[i] - camera.position[i];
        if (is_along(forward, camera.up)) report_impossible(reading, json, "up", "a direction across the view");
    }
    if (static_cast<float>(camera.near_plane) >= static_cast<float>(camera.far_plane)) {
        if (json.find("far")) {
            report_impossible(reading, json, "far", "greater than 'near'");
        } else {
            report_impossible(reading, json, "near", fmt::format("less than 'far', which is {}", camera.far_plane));
        }
    }
    return camera;
}

// --- materials

// A matrix, a gradient or a curve, as the file writes it. Its type is checked when the property is known.
std::optional<std::string> read_array_text(SceneReading& reading, const json::Json& json) {
    const std::optional<PropertyType> type = array_type(json);
    if (!type) {
        report_type(reading, json, "the value of a property", "a matrix of 2 to 4 rows, a gradient or a curve");
        return std::nullopt;
    }
    if (!read_array_value(reading, json, *type)) return std::nullopt;
    return std::string(reading.sources.text(json.span));
}

// Reads a value in words; nothing after an error.
std::optional<std::string> read_set_value(SceneReading& reading, const json::Json& json, std::string_view what) {
    switch (json.kind) {
        case json::Json::Kind::Bool: return json.boolean ? "true" : "false";
        case json::Json::Kind::Number:
            if (!read_float(reading, json, what)) return std::nullopt;
            return std::string(reading.sources.text(json.span));
        case json::Json::Kind::Array: {
            if (has_rows(json)) return read_array_text(reading, json);
            if (json.elements.size() < 2 || json.elements.size() > 4) break;
            std::string words;
            for (const json::Json& element : json.elements) {
                if (!read_float(reading, element, fmt::format("a component of {}", what))) return std::nullopt;
                words += (words.empty() ? "" : ",") + std::string(reading.sources.text(element.span));
            }
            return words;
        }
        case json::Json::Kind::String: {
            const std::string& text = json.string;
            if (text.starts_with('#')) {
                if (parse_color(text)) return text;
                reading.diagnostics.report(Code::BadColor, inside(json.span), json::shown(text));
                return std::nullopt;
            }
            if (is_file_name(text)) {
                return read_file_name(reading, json, what).path;
            }
            std::string file = reading.files.find(text, inside(json.span));
            return file.empty() ? text : file;
        }
        case json::Json::Kind::Object: return read_array_text(reading, json);
        case json::Json::Kind::Null: break;
    }
    report_type(reading, json, what, "a number, true or false, an array of 2 to 4 numbers or a string");
    return std::nullopt;
}

std::vector<SceneValue> read_set(SceneReading& reading, const json::Json& json) {
    std::vector<SceneValue> values;
    const json::Json* set = json.find("set");
    if (!set || !expect(reading, *set, json::Json::Kind::Object, "'set'")) return values;
    for (const json::JsonMember& member : set->members) {
        std::optional<std::string> words =
            read_set_value(reading, member.value, fmt::format("'{}'", json::shown(member.key)));
        if (!words) continue;
        values.push_back({.property = member.key,
                          .words = std::move(*words),
                          .property_location = place_of(reading, member.key_span),
                          .value_location = place_of(reading, member.value.span)});
    }
    return values;
}

SceneMaterial read_material(SceneReading& reading, const json::Json& json, UniqueNames& names) {
    SceneMaterial material;
    check_keys(reading, json, ObjectKind::SceneMaterial);
    Span name{};
    read_name(reading, json, "material", material.name, name, names);
    material.place = place_of(reading, name ? name : opening(json));
    if (const json::Json* graph = json.find("graph")) material.graph = read_graph_name(reading, *graph, "'graph'");
    material.set = read_set(reading, json);
    return material;
}

std::vector<SceneMaterial> read_materials(SceneReading& reading, const json::Json& array) {
    std::vector<SceneMaterial> materials;
    if (!expect(reading, array, json::Json::Kind::Array, "'materials'")) return materials;
    UniqueNames names;
    for (const json::Json& element : array.elements) {
        if (!expect(reading, element, json::Json::Kind::Object, "a material")) continue;
        materials.push_back(read_material(reading, element, names));
    }
    return materials;
}

// --- objects

void read_scale(Reading& reading, const json::Json& json, ObjectKind kind, SceneVector& scale) {
    double uniform = 1;
    if (const json::Json* value = json.find("scale"); value && value->kind != json::Json::Kind::Number) {
        if (value->kind == json::Json::Kind::Array) {
            read_vector(reading, json, kind, "scale", scale);
        } else {
            report_type(reading, *value, "'scale'", "a number or an array of 3 numbers");
        }
    } else if (read_number(reading, json, kind, "scale", uniform)) {
        scale = {uniform, uniform, uniform};
    }
}

// The scene's materials by name.
struct Materials {
    std::unordered_map<std::string_view, std::size_t> indices;
    std::vector<std::string_view> names;
};

std::size_t find_material(Reading& reading, const json::Json& json, const Materials& materials) {
    const std::string* name = read_string(reading, json, "'material'");
    if (!name) return 0;
    if (const auto found = materials.indices.find(*name); found != materials.indices.end()) return found->second;
    suggest(reading, reading.diagnostics.report(Code::UnknownName, inside(json.span), "material", json::shown(*name)),
            *name, materials.names);
    return 0;
}

std::vector<SceneInstance> read_instances(SceneReading& reading, const json::Json& array) {
    std::vector<SceneInstance> instances;
    if (!expect(reading, array, json::Json::Kind::Array, "'instances'")) return instances;
    if (array.elements.empty()) {
        reading.diagnostics.report(Code::EmptyList, array.span, "instances")
            .note("leave 'instances' out to draw the object once");
    }
    if (array.elements.size() > kMostSceneInstances) {
        reading.diagnostics.report(Code::TooMany, opening(array), array.elements.size(), "instances",
                                   kMostSceneInstances);
        return instances;
    }
    for (const json::Json& element : array.elements) {
        if (!expect(reading, element, json::Json::Kind::Object, "an instance")) continue;
        check_keys(reading, element, ObjectKind::SceneInstance);
        SceneInstance& instance = instances.emplace_back();
        read_vector(reading, element, ObjectKind::SceneInstance, "position", instance.position);
        read_vector(reading, element, ObjectKind::SceneInstance, "rotation", instance.rotation);
        read_scale(reading, element, ObjectKind::SceneInstance, instance.scale);
        instance.set = read_set(reading, element);
    }
    return instances;
}

SceneObject read_object(SceneReading& reading, const json::Json& json, const Materials& materials, UniqueNames& names) {
    SceneObject object;
    check_keys(reading, json, ObjectKind::SceneObject);
    if (const json::Json* id = json.find("id")) {
        object.id = read_identifier(reading, *id, "'id'");
        if (id->kind == json::Json::Kind::String) names.add(reading, *id, "object");
    }
    if (const json::Json* mesh = json.find("mesh")) {
        object.mesh = read_text(reading, json, "mesh");
        object.mesh_location = place_of(reading, inside(mesh->span));
    }
    if (const json::Json* segments = json.find("segments")) {
        const Form& form = form_of(ObjectKind::SceneObject, "segments", Form::Of::Integer);
        object.segments = read_int(reading, *segments, "'segments'", form);
    }
    if (const json::Json* material = json.find("material"))
        object.material = find_material(reading, *material, materials);
    read_vector(reading, json, ObjectKind::SceneObject, "position", object.position);
    read_vector(reading, json, ObjectKind::SceneObject, "rotation", object.rotation);
    read_scale(reading, json, ObjectKind::SceneObject, object.scale);
    if (const json::Json* map = json.find("lightmap")) object.lightmap = read_file_name(reading, *map, "'lightmap'");
    if (const json::Json* encoding = json.find("lightmapEncoding")) {
        if (json.find("lightmap")) {
            object.lightmap_encoding =
                read_word<LightmapEncoding>(reading, *encoding, "lightmapEncoding", "an encoding of lightmaps")
                    .value_or(LightmapEncoding::Hdr);
        } else {
            refuse_key(reading, json, "lightmapEncoding", "an object without a lightmap", "one with 'lightmap'");
        }
    }
    if (const json::Json* mask = json.find("shadowMask"))
        object.shadow_mask = read_file_name(reading, *mask, "'shadowMask'");
    if (const json::Json* instances = json.find("instances")) object.instances = read_instances(reading, *instances);
    return object;
}

void read_objects(SceneReading& reading, const json::Json& array, SceneFile& scene) {
    if (!expect(reading, array, json::Json::Kind::Array, "'objects'")) return;
    Materials materials;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (materials.indices.emplace(scene.materials[i].name, i).second)
            materials.names.push_back(scene.materials[i].name);
    }
    UniqueNames names;
    for (const json::Json& element : array.elements) {
        if (!expect(reading, element, json::Json::Kind::Object, "an object of a scene")) continue;
        scene.objects.push_back(read_object(reading, element, materials, names));
    }
}

}  // namespace

SceneFile read_scene(const Reading& given, const json::Json& json, const std::string& path, std::string name,
                     const SceneFiles& files) {
    SceneReading reading{given, files};
    SceneFile scene{.path = path, .name = std::move(name)};
    constexpr ObjectKind kAllowed[] = {ObjectKind::Scene};
    if (!read_header(reading, json, kAllowed)) return scene;
    check_keys(reading, json, ObjectKind::Scene);
    for (const std::string_view key : {"$schema", "help"}) (void)read_text(reading, json, key);
    if (std::string said = read_text(reading, json, "name"); !said.empty()) scene.name = std::move(said);
    if (const json::Json* camera = json.find("camera")) scene.camera = read_camera(reading, *camera);
    read_surroundings(reading, json, scene);
    read_number(reading, json, ObjectKind::Scene, "time", scene.time);
    read_int(reading, json, ObjectKind::Scene, "pixelLightCount", scene.pixel_light_count);
    if (const json::Json* lights = json.find("lights")) scene.lights = read_lights(reading, *lights);
    if (const json::Json* materials = json.find("materials")) scene.materials = read_materials(reading, *materials);
    if (const json::Json* objects = json.find("objects")) read_objects(reading, *objects, scene);
    return scene;
}

}  // namespace patina::format
