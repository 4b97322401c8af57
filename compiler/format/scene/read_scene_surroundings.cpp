// Reads what is around the objects of a scene: ambient light, environment, reflection probes, fog, background.
#include <algorithm>

#include "compiler/format/scene/read_scene_fields.h"

namespace patina::format {
namespace {

// Nothing: the scene has the studio's ambient light.
std::optional<SceneAmbient> read_ambient(Reading& reading, const json::Json& json) {
    if (json.kind == json::Json::Kind::Object) {
        SceneAmbient ambient;
        check_keys(reading, json, ObjectKind::Ambient);
        const auto read = [&](std::string_view key, std::optional<SceneVector>& target) {
            if (json.find(key)) read_color(reading, json, key, target.emplace());
        };
        read("sky", ambient.sky);
        read("horizon", ambient.horizon);
        read("ground", ambient.ground);
        if (!ambient.sky && !ambient.horizon && !ambient.ground) {
            reading.diagnostics.report(Code::MissingKey, opening(json), describe(ObjectKind::Ambient),
                                       "sky', 'horizon' or 'ground");
        }
        return ambient;
    }
    if (json.kind == json::Json::Kind::String && !json.string.starts_with('#')) {
        // The words are those of "environment".
        const auto named = read_word<SceneEnvironment>(reading, json, "ambient", "ambient light");
        if (named == SceneEnvironment::Studio) return std::nullopt;
        return SceneAmbient{.horizon = SceneVector{}};
    }
    const std::optional<std::array<double, 4>> color = read_scene_color(reading, json, "ambient");
    if (!color) return std::nullopt;
    return SceneAmbient{.horizon = SceneVector{(*color)[0], (*color)[1], (*color)[2]}};
}

ScenePicture read_picture(SceneReading& reading, const json::Json& json) {
    ScenePicture picture;
    if (json.kind == json::Json::Kind::String) {
        picture.file = read_file_name(reading, json, "'environment'");
        return picture;
    }
    if (!expect(reading, json, json::Json::Kind::Object, "'environment'")) return picture;
    check_keys(reading, json, ObjectKind::Environment);
    if (const json::Json* file = json.find("file")) picture.file = read_file_name(reading, *file, "'file'");
    read_number(reading, json, ObjectKind::Environment, "rotation", picture.rotation);
    read_number(reading, json, ObjectKind::Environment, "intensity", picture.intensity);
    return picture;
}

// A text with a dot or a slash is a file; another one is a word.
void read_environment(SceneReading& reading, const json::Json& json, SceneFile& scene) {
    const bool is_text = json.kind == json::Json::Kind::String;
    if (is_text && json.string.find_first_of("./\\") == std::string::npos) {
        scene.environment = read_word<SceneEnvironment>(reading, json, "environment", "an environment")
                                .value_or(SceneEnvironment::Studio);
        return;
    }
    scene.picture = read_picture(reading, json);
}

// A colour, or a word.
void read_background(Reading& reading, const json::Json& json, SceneFile& scene) {
    if (json.kind == json::Json::Kind::String && !json.string.starts_with('#')) {
        scene.backdrop =
            read_word<SceneBackdrop>(reading, json, "background", "a background").value_or(SceneBackdrop::Color);
        return;
    }
    scene.background = read_scene_color(reading, json, "background", true);
}

std::optional<SceneFog> read_fog(Reading& reading, const json::Json& json) {
    if (!expect(reading, json, json::Json::Kind::Object, "'fog'")) return std::nullopt;
    SceneFog fog;
    check_keys(reading, json, ObjectKind::Fog);
    const json::Json* mode = json.find("mode");
    const std::optional<FogMode> known = mode ? read_word<FogMode>(reading, *mode, "mode", "a fog mode") : std::nullopt;
    if (!known) return fog;
    fog.mode = *known;
    const std::string what = fmt::format("fog of mode {}", to_string(fog.mode));
    if (fog.mode == FogMode::Linear) {
        refuse_key(reading, json, "density", what, "the modes exp and exp2");
    } else {
        for (const std::string_view key : {"start", "end"}) refuse_key(reading, json, key, what, "the mode linear");
    }
    read_color(reading, json, "color", fog.color);
    read_number(reading, json, ObjectKind::Fog, "density", fog.density);
    read_number(reading, json, ObjectKind::Fog, "start", fog.start);
    read_number(reading, json, ObjectKind::Fog, "end", fog.end);
    if (static_cast<float>(fog.start) >= static_cast<float>(fog.end)) {
        report_impossible(
            reading, json, json.find("end") ? "end" : "start",
            json.find("end") ? "greater than 'start'" : fmt::format("less than 'end', which is {}", fog.end));
    }
    return fog;
}

SceneMixedLighting read_mixed_lighting(Reading& reading, const json::Json& json) {
    SceneMixedLighting mixed;
    if (!expect(reading, json, json::Json::Kind::Object, "'mixedLighting'")) return mixed;
    check_keys(reading, json, ObjectKind::MixedLighting);
    const json::Json* mode = json.find("mode");
    const std::optional<LightMixing> known =
        mode ? read_word<LightMixing>(reading, *mode, "mode", "a mode of mixed lighting") : std::nullopt;
    if (!known) return mixed;
    mixed.mode = *known;
    if (mixed.mode != LightMixing::Subtractive) {
        refuse_key(reading, json, "shadowColor", fmt::format("mixed lighting of mode {}", to_string(mixed.mode)),
                   "the mode subtractive");
    }
    read_color(reading, json, "shadowColor", mixed.shadow_color);
    double distance = 0, fade = 0;
    if (read_number(reading, json, ObjectKind::MixedLighting, "shadowDistance", distance))
        mixed.shadow_distance = distance;
    if (read_number(reading, json, ObjectKind::MixedLighting, "shadowFade", fade)) mixed.shadow_fade = fade;
    if (!mixed.shadow_fade) return mixed;
    if (!json.find("shadowDistance")) {
        report_impossible(reading, json, "shadowFade", "set together with 'shadowDistance'");
    } else if (mixed.shadow_distance && fade > distance) {
        report_impossible(reading, json, "shadowFade", fmt::format("at most 'shadowDistance', which is {}", distance));
    }
    return mixed;
}

// --- reflection probes

void read_box(Reading& reading, const json::Json& json, SceneProbe& probe) {
    if (!expect(reading, json, json::Json::Kind::Object, "'box'")) return;
    check_keys(reading, json, ObjectKind::ProbeBox);
    const bool has_min = read_vector(reading, json, ObjectKind::ProbeBox, "min", probe.box_min);
    const bool has_max = read_vector(reading, json, ObjectKind::ProbeBox, "max", probe.box_max);
    if (!has_min || !has_max) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (static_cast<float>(probe.box_min[axis]) < static_cast<float>(probe.box_max[axis])) continue;
        report_impossible(reading, json, "max", "greater than 'min' in each component");
        return;
    }
}

SceneProbe read_probe(SceneReading& reading, const json::Json& json) {
    SceneProbe probe;
    check_keys(reading, json, ObjectKind::Probe);
    if (const json::Json* environment = json.find("environment")) probe.picture = read_picture(reading, *environment);
    if (const json::Json* box = json.find("box")) read_box(reading, *box, probe);
    for (std::size_t axis = 0; axis < 3; ++axis) probe.position[axis] = (probe.box_min[axis] + probe.box_max[axis]) / 2;
    const bool has_position = read_vector(reading, json, ObjectKind::Probe, "position", probe.position);
    for (std::size_t axis = 0; has_position && axis < 3; ++axis) {
        if (probe.position[axis] >= probe.box_min[axis] && probe.position[axis] <= probe.box_max[axis]) continue;
        report_impossible(reading, json, "position", "inside the box");
        break;
    }
    read_number(reading, json, ObjectKind::Probe, "blend", probe.blend);
    read_bool(reading, json, "boxProjection", probe.box_projection);
    read_int(reading, json, ObjectKind::Probe, "importance", probe.importance);
    return probe;
}

std::vector<SceneProbe> read_probes(SceneReading& reading, const json::Json& array) {
    std::vector<SceneProbe> probes;
    if (!expect(reading, array, json::Json::Kind::Array, "'probes'")) return probes;
    if (array.elements.size() > kMostSceneProbes) {
        reading.diagnostics.report(Code::TooMany, opening(array), array.elements.size(), "probes", kMostSceneProbes);
        return probes;
    }
    for (const json::Json& element : array.elements) {
        if (expect(reading, element, json::Json::Kind::Object, "a probe"))
            probes.push_back(read_probe(reading, element));
    }
    return probes;
}

}  // namespace

void read_surroundings(SceneReading& reading, const json::Json& json, SceneFile& scene) {
    if (const json::Json* ambient = json.find("ambient")) scene.ambient = read_ambient(reading, *ambient);
    if (scene.ambient) scene.environment = SceneEnvironment::None;
    scene.has_studio_ambient = json.find("ambient") && !scene.ambient;
    if (const json::Json* environment = json.find("environment")) read_environment(reading, *environment, scene);
    if (const json::Json* probes = json.find("probes")) scene.probes = read_probes(reading, *probes);
    if (const json::Json* fog = json.find("fog")) scene.fog = read_fog(reading, *fog);
    if (const json::Json* mixed = json.find("mixedLighting"))
        scene.mixed_lighting = read_mixed_lighting(reading, *mixed);
    if (const json::Json* background = json.find("background")) read_background(reading, *background, scene);
}

}  // namespace patina::format
