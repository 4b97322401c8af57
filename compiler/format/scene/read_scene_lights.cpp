#include "compiler/format/scene/read_scene_fields.h"

namespace patina::format {
namespace {

// The keys that only some kinds of light have.
struct OwnedKey {
    std::string_view key;
    bool directional, point, spot;
    bool required = false;  // for the kinds that have it
};
constexpr std::array kOwnedKeys = {
    OwnedKey{"position", false, true, true, true}, OwnedKey{"direction", true, false, true, true},
    OwnedKey{"range", false, true, true},          OwnedKey{"inner", false, false, true},
    OwnedKey{"outer", false, false, true},         OwnedKey{"shadow", true, false, true},
    OwnedKey{"cookie", true, false, true},         OwnedKey{"cookieSize", true, false, false},
};

bool has_key(const OwnedKey& owned, LightKind type) {
    switch (type) {
        case LightKind::Directional: return owned.directional;
        case LightKind::Point: return owned.point;
        case LightKind::Spot: return owned.spot;
    }
    return false;
}

void check_owned_keys(Reading& reading, const json::Json& json, LightKind type) {
    const std::string what = fmt::format("a {} light", to_string(type));
    for (const OwnedKey& owned : kOwnedKeys) {
        if (has_key(owned, type)) {
            if (owned.required && !json.find(owned.key)) {
                reading.diagnostics.report(Code::MissingKey, opening(json), what, owned.key);
            }
            continue;
        }
        std::string owners;
        for (const Word<LightKind>& word : kWords<LightKind>) {
            if (has_key(owned, word.value))
                owners += fmt::format("{}a {} light", owners.empty() ? "" : " and ", word.text);
        }
        refuse_key(reading, json, owned.key, what, owners);
    }
}

std::optional<SceneShadow> read_shadow(Reading& reading, const json::Json& json) {
    SceneShadow shadow;
    if (json.kind == json::Json::Kind::Bool) return json.boolean ? std::optional(shadow) : std::nullopt;
    if (json.kind != json::Json::Kind::Object) {
        report_type(reading, json, "'shadow'", "true, false or an object");
        return std::nullopt;
    }
    check_keys(reading, json, ObjectKind::Shadow);
    read_number(reading, json, ObjectKind::Shadow, "strength", shadow.strength);
    read_number(reading, json, ObjectKind::Shadow, "bias", shadow.bias);
    read_number(reading, json, ObjectKind::Shadow, "normalBias", shadow.normal_bias);
    return shadow;
}

void read_cone(Reading& reading, const json::Json& json, SceneLight& light) {
    double angle = 0;
    if (read_number(reading, json, ObjectKind::Light, "inner", angle)) light.inner = angle;
    if (read_number(reading, json, ObjectKind::Light, "outer", angle)) light.outer = angle;
    if (!light.inner || !light.outer || *light.inner <= *light.outer) return;
    report_impossible(reading, json, "inner", "at most 'outer'");
}

SceneLight read_light(SceneReading& reading, const json::Json& json) {
    SceneLight light{.place = place_of(reading, opening(json))};
    check_keys(reading, json, ObjectKind::Light);
    const json::Json* type = json.find("type");
    if (!type) return light;
    const std::optional<LightKind> known = read_word<LightKind>(reading, *type, "type", "a type of light");
    if (!known) return light;  // the kind decides which other keys there are
    light.type = *known;
    check_owned_keys(reading, json, light.type);

    read_vector(reading, json, ObjectKind::Light, "position", light.position);
    if (read_vector(reading, json, ObjectKind::Light, "direction", light.direction) &&
        light.direction == SceneVector{}) {
        report_impossible(reading, json, "direction", "longer than 0");
    }
    read_color(reading, json, "color", light.color);
    read_number(reading, json, ObjectKind::Light, "intensity", light.intensity);
    read_number(reading, json, ObjectKind::Light, "range", light.range);
    read_cone(reading, json, light);
    read_word(reading, json, "renderMode", "a render mode", light.render_mode);
    if (const json::Json* shadow = json.find("shadow")) light.shadow = read_shadow(reading, *shadow);
    if (const json::Json* cookie = json.find("cookie")) light.cookie = read_file_name(reading, *cookie, "'cookie'");
    read_number(reading, json, ObjectKind::Light, "cookieSize", light.cookie_size);
    return light;
}

}  // namespace

std::vector<SceneLight> read_lights(SceneReading& reading, const json::Json& array) {
    std::vector<SceneLight> lights;
    if (!expect(reading, array, json::Json::Kind::Array, "'lights'")) return lights;
    if (array.elements.size() > kMostSceneLights) {
        reading.diagnostics.report(Code::TooMany, array.elements[kMostSceneLights].span, array.elements.size(),
                                   "lights", kMostSceneLights);
        return lights;
    }
    std::vector<Span> shadows;
    for (const json::Json& element : array.elements) {
        if (!expect(reading, element, json::Json::Kind::Object, "a light")) continue;
        lights.push_back(read_light(reading, element));
        if (lights.back().shadow) shadows.push_back(find_member(element, "shadow")->key_span);
    }
    if (shadows.size() > kMostSceneShadows) {
        reading.diagnostics.report(Code::TooMany, shadows[kMostSceneShadows], shadows.size(), "lights with a shadow",
                                   kMostSceneShadows);
    }
    return lights;
}

}  // namespace patina::format
