#include "compiler/format/schema/schema_parts.h"
#include "patina/segments.h"

namespace patina::graph {
namespace {

constexpr std::string_view kText = R"({"type":"string"})";
constexpr std::string_view kIdentifier = R"({"$ref":"#/$defs/identifier"})";
constexpr std::string_view kNumber = R"({"type":"number"})";
constexpr std::string_view kPositive = R"({"type":"number","minimum":0})";
constexpr std::string_view kVector = R"({"type":"array","items":{"type":"number"},"minItems":3,"maxItems":3})";
constexpr std::string_view kColor =
    R"({"anyOf":[{"type":"string","pattern":"^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"},{"type":"number","minimum":0},)"
    R"({"type":"array","items":{"type":"number","minimum":0},"minItems":3,"maxItems":3}]})";
constexpr std::string_view kColorWithAlpha =
    R"({"anyOf":[{"type":"string","pattern":"^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})$"},)"
    R"({"type":"number","minimum":0},)"
    R"({"type":"array","items":{"type":"number","minimum":0},"minItems":3,"maxItems":4}]})";
constexpr std::string_view kSet =
    R"({"type":"object","additionalProperties":{"anyOf":[{"type":"number"},{"type":"boolean"},{"type":"string"},)"
    R"({"type":"array","items":{"type":"number"},"minItems":2,"maxItems":4}]}})";

std::string between(std::string_view type, double low, double high) {
    return fmt::format(R"({{"type":"{}","minimum":{},"maximum":{}}})", type, low, high);
}

}  // namespace

std::vector<SchemaRow> scene_rows() {
    using enum ObjectKind;
    const auto text = [](std::string_view schema) { return std::string(schema); };
    return {
        {Scene, "kind", R"({"const":"scene"})"},
        {Free, "camera", reference("camera")},
        {Free, "ambient", any_of({R"({"enum":["studio","none"]})", text(kColor), reference("ambient")})},
        {Free, "environment", any_of({text(kText), reference("environment")})},
        {Environment, "file", text(kText)},
        {Environment, "rotation", text(kNumber)},
        {Free, "probes", R"({"type":"array","maxItems":32,"items":{"$ref":"#/$defs/probe"}})"},
        {Free, "box", reference("probeBox")},
        {ProbeBox, "min", text(kVector)},
        {ProbeBox, "max", text(kVector)},
        {Free, "blend", text(kPositive)},
        {Free, "boxProjection", R"({"type":"boolean"})"},
        {Free, "importance", between("integer", 0, 1000)},
        {Free, "fog", reference("fog")},
        {Free, "mixedLighting", reference("mixedLighting")},
        {Free, "background", any_of({words_schema<SceneBackdrop>(), text(kColorWithAlpha)})},
        {Free, "time", text(kNumber)},
        {Free, "pixelLightCount", between("integer", 0, kMostSceneLights)},
        {Free, "lights", R"({"type":"array","maxItems":16,"items":{"$ref":"#/$defs/light"}})"},
        {Free, "materials", list_of("sceneMaterial")},
        {Free, "objects", list_of("sceneObject")},
        {Free, "position", text(kVector)},
        {Free, "target", text(kVector)},
        {Free, "up", text(kVector)},
        {Free, "fov", between("number", 1, 170)},
        {Free, "orthographic", text(kPositive)},
        {Free, "near", text(kPositive)},
        {Free, "far", text(kPositive)},
        {Free, "sky", text(kColor)},
        {Free, "horizon", text(kColor)},
        {Free, "ground", text(kColor)},
        {Free, "mode", words_schema<FogMode>()},
        {MixedLighting, "mode", words_schema<LightMixing>()},
        {Free, "shadowColor", text(kColor)},
        {Free, "shadowDistance", text(kPositive)},
        {Free, "shadowFade", text(kPositive)},
        {Free, "color", text(kColor)},
        {Free, "density", text(kPositive)},
        {Free, "start", text(kNumber)},
        {Free, "end", text(kNumber)},
        {Light, "type", words_schema<LightKind>()},
        {Free, "direction", text(kVector)},
        {Free, "intensity", text(kPositive)},
        {Light, "range", text(kPositive)},
        {Free, "inner", between("number", 0, 89)},
        {Free, "outer", between("number", 0.1, 90)},
        {Free, "renderMode", words_schema<LightImportance>()},
        {Free, "shadow", any_of({R"({"type":"boolean"})", reference("shadow")})},
        {Free, "cookie", text(kText)},
        {Free, "cookieSize", text(kPositive)},
        {Free, "strength", between("number", 0, 1)},
        {Free, "bias", text(kPositive)},
        {Free, "normalBias", text(kPositive)},
        {SceneMaterial, "name", text(kIdentifier)},
        {Free, "graph", text(kText)},
        {Free, "set", text(kSet)},
        {Free, "mesh", text(kText)},
        {Free, "segments", between("integer", kLeastSegments, kMostSegments)},
        {Free, "material", text(kIdentifier)},
        {Free, "rotation", text(kVector)},
        {Free, "scale", any_of({text(kPositive), text(kVector)})},
        {Free, "lightmap", text(kText)},
        {Free, "lightmapEncoding", words_schema<LightmapEncoding>()},
        {Free, "shadowMask", text(kText)},
        {Free, "instances", list_of("sceneInstance")},
    };
}

}  // namespace patina::graph
