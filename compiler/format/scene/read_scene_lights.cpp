#include "compiler/format/scene/read_scene_fields.h"

namespace patina::graph {
namespace {

constexpr double kBrightest = 1e6;
constexpr double kLargestBias = 100;

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

void check_owned_keys(Reading& reading, const Json& json, LightKind type) {
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

std::optional<SceneShadow> read_shadow(Reading& reading, const Json& json) {
    SceneShadow shadow;
    if (json.kind == Json::Kind::Bool) return json.boolean ? std::optional(shadow) : std::nullopt;
    if (json.kind != Json::Kind::Object) {
        report_type(reading, json, "'shadow'", "true, false or an object");
        return std::nullopt;
    }
    check_keys(reading, json, ObjectKind::Shadow);
    read_number(reading, json, "strength", 0, 1, shadow.strength);
    read_number(reading, json, "bias", 0, kLargestBias, shadow.bias);
    read_number(reading, json, "normalBias", 0, kLargestBias, shadow.normal_bias);
    return shadow;
}

void read_cone(Reading& reading, const Json& json, SceneLight& light) {
    double angle = 0;
    if (read_number(reading, json, "inner", 0, 89, angle)) light.inner = angle;
    if (read_number(reading, json, "outer", 0.1, 90, angle)) light.outer = angle;
    if (!light.inner || !light.outer || *light.inner <= *light.outer) return;
    report_impossible(reading, json, "inner", "at most 'outer'");
}

SceneLight read_light(SceneReading& reading, const Json& json) {
    SceneLight light{.place = place_of(reading, opening(json))};
    check_keys(reading, json, ObjectKind::Light);
    const Json* type = json.find("type");
    if (!type) return light;
    const std::optional<LightKind> known = read_word<LightKind>(reading, *type, "type", "a type of light");
    if (!known) return light;  // the kind decides which other keys there are
    light.type = *known;
    check_owned_keys(reading, json, light.type);

    read_vector(reading, json, "position", -kFarthest, kFarthest, light.position);
    if (read_vector(reading, json, "direction", -kFarthest, kFarthest, light.direction) &&
        light.direction == SceneVector{}) {
        report_impossible(reading, json, "direction", "longer than 0");
    }
    read_color(reading, json, "color", light.color);
    read_number(reading, json, "intensity", 0, kBrightest, light.intensity);
    read_number(reading, json, "range", 1e-3, kFarthest, light.range);
    read_cone(reading, json, light);
    if (const Json* mode = json.find("renderMode")) {
        light.render_mode =
            read_word<LightImportance>(reading, *mode, "renderMode", "a render mode").value_or(LightImportance::Auto);
    }
    if (const Json* shadow = json.find("shadow")) light.shadow = read_shadow(reading, *shadow);
    if (const Json* cookie = json.find("cookie")) light.cookie = read_file_name(reading, *cookie, "'cookie'");
    read_number(reading, json, "cookieSize", 1e-3, kFarthest, light.cookie_size);
    return light;
}

}  // namespace

std::vector<SceneLight> read_lights(SceneReading& reading, const Json& array) {
    std::vector<SceneLight> lights;
    if (!expect(reading, array, Json::Kind::Array, "'lights'")) return lights;
    if (array.elements.size() > kMostSceneLights) {
        reading.diagnostics.report(Code::TooMany, array.elements[kMostSceneLights].span, array.elements.size(),
                                   "lights", kMostSceneLights);
        return lights;
    }
    std::vector<Span> shadows;
    for (const Json& element : array.elements) {
        if (!expect(reading, element, Json::Kind::Object, "a light")) continue;
        lights.push_back(read_light(reading, element));
        if (lights.back().shadow) shadows.push_back(find_member(element, "shadow")->key_span);
    }
    if (shadows.size() > kMostSceneShadows) {
        reading.diagnostics.report(Code::TooMany, shadows[kMostSceneShadows], shadows.size(), "lights with a shadow",
                                   kMostSceneShadows);
    }
    return lights;
}

}  // namespace patina::graph
