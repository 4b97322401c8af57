// The scene reader: the meaning of each key, its default, and the messages for everything else.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "patina/patina.h"

namespace patina {
namespace {

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

const std::map<std::string, std::string> kFiles = {
    {"dir/rust.graph.json", R"({"patina":1,"workflow":"unlit"})"},
    {"dir/window.png", ""},
    {"art/far.graph.json", ""},
};

SceneResult read(const std::string& text) {
    CompileOptions options;
    options.include_dirs = {"art"};
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        if (path == "dir/t.scene.json") return text;
        const auto found = kFiles.find(path);
        return found == kFiles.end() ? std::nullopt : std::optional(found->second);
    };
    return compiler().read_scene("dir/t.scene.json", options);
}

// A scene with these keys and a camera; a camera among the keys replaces it.
std::string scene_of(const std::string& keys) {
    const std::string camera = keys.find("\"camera\"") == keys.npos ? R"("camera":{"position":[0,1,5]},)" : "";
    const std::string objects = keys.find("\"objects\"") == keys.npos ? R"(,"objects":[])" : "";
    return R"({"patina":1,"kind":"scene",)" + camera + keys + objects + "}";
}

SceneFile good(const std::string& keys) {
    const SceneResult result = read(scene_of(keys));
    EXPECT_TRUE(result.ok && result.diagnostics.empty()) << keys << "\n" << to_text(result.diagnostics.at(0));
    return result.scene;
}

// "message | note"; a '^' in the text is taken out and says where the complaint must be.
std::string complaint(std::string keys) {
    std::string text = scene_of(keys);
    const std::size_t at = text.find('^');
    EXPECT_NE(at, text.npos) << keys;
    text.erase(at, 1);
    const SceneResult result = read(text);
    EXPECT_FALSE(result.ok) << keys;
    if (result.diagnostics.size() != 1) return std::to_string(result.diagnostics.size()) + " complaints";
    const Diagnostic& d = result.diagnostics[0];
    EXPECT_EQ(d.file, "dir/t.scene.json");
    EXPECT_EQ(d.line, 1);
    EXPECT_EQ(d.column, static_cast<int>(at) + 1) << keys;
    std::string said = d.message;
    for (const Diagnostic& note : d.notes) said += " | " + note.message;
    return said;
}

// --- what is read

TEST(ReadScene, SaysWhereItCameFrom) {
    const SceneResult result = read(scene_of(R"("meta":[1],"ui":{},"help":"h","$schema":"s")"));
    EXPECT_TRUE(result.ok);
    EXPECT_EQ(result.scene.path, "dir/t.scene.json");
    EXPECT_EQ(result.scene.name, "t");
    EXPECT_EQ(result.dependencies, std::vector<std::string>{"dir/t.scene.json"});
    EXPECT_EQ(good(R"("name":"Shelf")").name, "Shelf");
}

TEST(ReadScene, Camera) {
    const SceneCamera plain = good(R"("time":0)").camera;
    EXPECT_EQ(plain.position, (SceneVector{0, 1, 5}));
    EXPECT_EQ(plain.target, SceneVector{});
    EXPECT_EQ(plain.fov, 30);
    EXPECT_FALSE(plain.orthographic);
    const SceneCamera own =
        good(R"("camera":{"position":[1,2,3],"target":[0,1,0],"fov":35,"near":0.5,"far":20})").camera;
    EXPECT_EQ(own.target, (SceneVector{0, 1, 0}));
    EXPECT_EQ(own.fov, 35);
    EXPECT_EQ(own.near_plane, 0.5);
    EXPECT_EQ(own.far_plane, 20);
    EXPECT_EQ(plain.up, (SceneVector{0, 1, 0}));
    EXPECT_EQ(good(R"("camera":{"position":[1,2,3],"up":[0,0,-2]})").camera.up, (SceneVector{0, 0, -2}));
    EXPECT_EQ(good(R"("camera":{"position":[1,2,3],"orthographic":2.2})").camera.orthographic, 2.2);
}

TEST(ReadScene, ColoursAreLinear) {
    // IEC 61966-2-1: 128/255 is a linear 0.2158605.
    const SceneFile scene = good(R"("background":"#80ff0080","fog":{"mode":"exp","color":[0.1,0.2,0.3]},"lights":[
        {"type":"point","position":[0,0,0],"color":"#808080"},{"type":"point","position":[0,0,0],"color":0.25}])");
    ASSERT_TRUE(scene.background);
    EXPECT_NEAR((*scene.background)[0], 0.2158605001138993, 1e-12);
    EXPECT_EQ((*scene.background)[1], 1);
    EXPECT_NEAR((*scene.background)[3], 128 / 255.0, 1e-12);
    EXPECT_EQ(scene.fog->color, (SceneVector{0.1, 0.2, 0.3}));
    EXPECT_NEAR(scene.lights[0].color[2], 0.2158605001138993, 1e-12);
    EXPECT_EQ(scene.lights[1].color, (SceneVector{0.25, 0.25, 0.25}));
    EXPECT_FALSE(good(R"("time":0)").background);
}

TEST(ReadScene, Surroundings) {
    const SceneFile plain = good(R"("time":2.5)");
    EXPECT_EQ(plain.time, 2.5);
    EXPECT_EQ(plain.pixel_light_count, 4);
    EXPECT_FALSE(plain.ambient);
    EXPECT_FALSE(plain.fog);
    EXPECT_EQ(plain.environment, SceneEnvironment::Studio);
    EXPECT_FALSE(good(R"("ambient":"studio")").ambient);
    EXPECT_EQ(good(R"("ambient":"none")").ambient->horizon, SceneVector{});
    EXPECT_EQ(good(R"("ambient":0.2)").ambient->horizon, (SceneVector{0.2, 0.2, 0.2}));
    const SceneFile sky = good(R"("ambient":{"sky":[0,0,1],"ground":"#000"},"pixelLightCount":0)");
    EXPECT_EQ(sky.ambient->sky, (SceneVector{0, 0, 1}));
    EXPECT_EQ(sky.ambient->ground, SceneVector{});
    EXPECT_FALSE(sky.ambient->horizon);
    EXPECT_EQ(sky.pixel_light_count, 0);
    // Mirrors show what the ambient light says, unless they are to show the studio.
    EXPECT_EQ(sky.environment, SceneEnvironment::None);
    EXPECT_EQ(good(R"("ambient":0.2,"environment":"studio")").environment, SceneEnvironment::Studio);
    EXPECT_EQ(good(R"("environment":"none")").environment, SceneEnvironment::None);
    EXPECT_FALSE(plain.picture || plain.has_studio_ambient);
}

TEST(ReadScene, Fog) {
    const SceneFog linear = *good(R"("fog":{"mode":"linear","start":1,"end":9})").fog;
    EXPECT_EQ(linear.mode, FogMode::Linear);
    EXPECT_EQ(linear.start, 1);
    EXPECT_EQ(linear.end, 9);
    EXPECT_EQ(good(R"("fog":{"mode":"exp2","density":0.1})").fog->mode, FogMode::ExponentialSquared);
    EXPECT_EQ(good(R"("fog":{"mode":"exp","density":0.1})").fog->density, 0.1);
}

TEST(ReadScene, Lights) {
    const SceneFile scene = good(R"("lights":[
        {"type":"directional","direction":[0,1,0],"shadow":true,"cookie":"./window.png","cookieSize":2},
        {"type":"point","position":[1,2,3],"intensity":4,"range":5,"renderMode":"notImportant"},
        {"type":"spot","position":[0,3,0],"direction":[0,-1,0],"inner":10,"outer":25,"renderMode":"important",
         "shadow":{"strength":0.5,"bias":0.01,"normalBias":1}},
        {"type":"spot","position":[0,3,0],"direction":[0,-1,0],"shadow":false}])");
    ASSERT_EQ(scene.lights.size(), 4u);
    const SceneLight &sun = scene.lights[0], &bulb = scene.lights[1], &spot = scene.lights[2];
    EXPECT_EQ(sun.type, LightKind::Directional);
    EXPECT_EQ(sun.direction, (SceneVector{0, 1, 0}));
    EXPECT_EQ(sun.color, (SceneVector{1, 1, 1}));
    EXPECT_EQ(sun.intensity, 1);
    EXPECT_EQ(sun.render_mode, LightImportance::Auto);
    ASSERT_TRUE(sun.shadow);
    EXPECT_EQ(sun.shadow->strength, 1);
    EXPECT_EQ(sun.cookie.path, "dir/window.png");
    EXPECT_EQ(sun.cookie_size, 2);
    EXPECT_EQ(sun.place.line, 2);
    EXPECT_EQ(bulb.position, (SceneVector{1, 2, 3}));
    EXPECT_EQ(bulb.intensity, 4);
    EXPECT_EQ(bulb.range, 5);
    EXPECT_EQ(bulb.render_mode, LightImportance::NotImportant);
    EXPECT_FALSE(bulb.shadow);
    EXPECT_EQ(spot.inner, 10);
    EXPECT_EQ(spot.outer, 25);
    EXPECT_EQ(spot.shadow->strength, 0.5);
    EXPECT_EQ(spot.shadow->bias, 0.01);
    EXPECT_EQ(spot.shadow->normal_bias, 1);
    EXPECT_EQ(spot.render_mode, LightImportance::Important);
    EXPECT_FALSE(scene.lights[3].shadow);
    EXPECT_FALSE(scene.lights[3].inner || scene.lights[3].outer);
}

TEST(ReadScene, BakedLight) {
    EXPECT_FALSE(good(R"("time":0)").mixed_lighting.shadow_distance);
    const SceneFile scene = good(R"("mixedLighting":{"mode":"subtractive","shadowColor":[0.1,0.2,0.3],
        "shadowDistance":40,"shadowFade":8},"materials":[{"name":"rust","graph":"rust.graph.json"}],"objects":[
        {"id":"a","mesh":"plane","material":"rust","lightmap":"window.png","lightmapEncoding":"rgbm"},
        {"id":"b","mesh":"plane","material":"rust","lightmap":"window.png","lightmapEncoding":"dldr"},
        {"id":"c","mesh":"plane","material":"rust","lightmap":"window.png"}])");
    EXPECT_EQ(scene.mixed_lighting.mode, LightMixing::Subtractive);
    EXPECT_EQ(scene.mixed_lighting.shadow_color, (SceneVector{0.1, 0.2, 0.3}));
    EXPECT_EQ(scene.mixed_lighting.shadow_distance, 40);
    EXPECT_EQ(scene.mixed_lighting.shadow_fade, 8);
    EXPECT_EQ(scene.objects[0].lightmap_encoding, LightmapEncoding::Rgbm);
    EXPECT_EQ(scene.objects[1].lightmap_encoding, LightmapEncoding::DoubleLdr);
    EXPECT_EQ(scene.objects[2].lightmap_encoding, LightmapEncoding::Hdr);
}

TEST(ReadScene, ValuesOfPropertiesBecomeWords) {
    const SceneFile scene = good(R"("materials":[
        {"name":"far","graph":"far.graph.json"},
        {"name":"rust","graph":"./rust.graph.json","set":
         {"_A":0.50,"_B":[1, 0.5,0],"_C":"#ff8800","_D":true,"_E":"Wet","_F":"window.png","_G":"white"}}])");
    EXPECT_EQ(scene.materials[0].graph.path, "art/far.graph.json");  // along the include folders
    const SceneMaterial& rust = scene.materials[1];
    EXPECT_EQ(rust.name, "rust");
    EXPECT_EQ(rust.graph.path, "dir/rust.graph.json");
    const std::vector<std::pair<std::string, std::string>> expected = {
        {"_A", "0.50"}, {"_B", "1,0.5,0"},        {"_C", "#ff8800"}, {"_D", "true"},
        {"_E", "Wet"},  {"_F", "dir/window.png"}, {"_G", "white"}};
    ASSERT_EQ(rust.set.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(rust.set[i].property, expected[i].first);
        EXPECT_EQ(rust.set[i].words, expected[i].second);
    }
    EXPECT_EQ(rust.set[0].property_location.line, 4);
    EXPECT_EQ(rust.set[0].property_location.column, 12);
}

const std::string kTwoMaterials =
    R"("materials":[{"name":"rust","graph":"rust.graph.json"},{"name":"far","graph":"far.graph.json"}],)";

TEST(ReadScene, Objects) {
    const SceneFile scene = good(kTwoMaterials + R"("objects":[
        {"id":"ball","mesh":"sphere","material":"far","segments":64,"position":[1,2,3],"rotation":[0,90,0],"scale":2},
        {"id":"floor","mesh":"teapot","material":"rust","scale":[1,2,3],"lightmap":"window.png",
         "shadowMask":"./window.png"}])");
    ASSERT_EQ(scene.objects.size(), 2u);
    const SceneObject &ball = scene.objects[0], &floor = scene.objects[1];
    EXPECT_EQ(ball.id, "ball");
    EXPECT_EQ(ball.mesh, "sphere");
    EXPECT_EQ(ball.segments, 64);
    EXPECT_EQ(ball.material, 1u);
    EXPECT_EQ(ball.position, (SceneVector{1, 2, 3}));
    EXPECT_EQ(ball.rotation, (SceneVector{0, 90, 0}));
    EXPECT_EQ(ball.scale, (SceneVector{2, 2, 2}));
    EXPECT_EQ(floor.material, 0u);
    EXPECT_EQ(floor.scale, (SceneVector{1, 2, 3}));
    EXPECT_EQ(floor.lightmap.path, "dir/window.png");
    EXPECT_EQ(floor.shadow_mask.path, "dir/window.png");
    // The runtime checks meshes; it gets the place of the name.
    EXPECT_EQ(floor.mesh, "teapot");
    EXPECT_EQ(floor.mesh_location.line, 3);
    EXPECT_EQ(floor.mesh_location.column, 31);
    EXPECT_EQ(floor.mesh_location.end_column, 37);
}

// --- what is wrong

struct Wrong {
    const char* keys;
    const char* said;
};

class WrongScene : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongScene, IsSaidAtItsPlace) {
    EXPECT_EQ(complaint(GetParam().keys), GetParam().said) << GetParam().keys;
}

INSTANTIATE_TEST_SUITE_P(
    Cameras, WrongScene,
    ::testing::Values(
        Wrong{R"("camera":^{})", "a camera needs the key 'position'"},
        Wrong{R"("camera":{"position":[0,0,1],"^lens":[0,1,0]})",
              "unknown key 'lens' in a camera | these exist: position, target, up, fov, orthographic, near and far"},
        Wrong{R"("camera":{"position":^[0,1]})", "'position' must be an array of 3 numbers, not an array of 2"},
        Wrong{R"("camera":{"position":[0,^"1",2]})", "a component of 'position' must be a number, not a string"},
        Wrong{R"("camera":{"position":[0,^1e7,2]})", "1e7 is outside the range -1e+06 to 1e+06 of 'position'"},
        Wrong{R"("camera":{"position":[0,1,2],"target":^[0,1,2]})", "'target' must be another point than 'position'"},
        Wrong{R"("camera":{"position":^[0,0,0]})", "'position' must be another point than 'target'"},
        Wrong{R"("camera":{"position":[0,1,2],"fov":^171})", "171 is outside the range 1 to 170 of 'fov'"},
        Wrong{R"("camera":{"position":[0,1,2],"^fov":30,"orthographic":2})",
              "'fov' and 'orthographic' exclude each other: remove one | the other one is here"},
        Wrong{R"("camera":{"position":[0,1,2],"near":1,"far":^1})", "'far' must be greater than 'near'"},
        Wrong{R"("camera":{"position":[0,1,2],"near":^200})", "'near' must be less than 'far', which is 100"}));

INSTANTIATE_TEST_SUITE_P(
    SurroundingsOf, WrongScene,
    ::testing::Values(
        Wrong{R"("ambient":"^studi")", "'studi' is not ambient light | did you mean 'studio'?"},
        Wrong{R"("ambient":^{})", "ambient light needs the key 'sky', 'horizon' or 'ground'"},
        Wrong{R"("ambient":{"sky":"^#12345"})", "'#12345' is not a colour: write #rgb, #rrggbb or #rrggbbaa"},
        Wrong{R"("ambient":^[1,2])", "'ambient' must be \"#rrggbb\", a number or an array of 3, not an array of 2"},
        Wrong{R"("ambient":{"sky":"^#11223344"})", "'sky' must be a colour without alpha, not #11223344"},
        Wrong{R"("ambient":^-1)", "-1 is outside the range 0 to 1e+06 of 'ambient'"},
        Wrong{R"("environment":"^office")", "'office' is not an environment | these exist: studio and none"},
        Wrong{R"("fog":^{})", "fog needs the key 'mode'"},
        Wrong{R"("fog":{"mode":"^linaer"})", "'linaer' is not a fog mode | did you mean 'linear'?"},
        Wrong{R"("fog":{"mode":"exp","^start":1})",
              "unknown key 'start' in fog of mode exp | 'start' belongs to the mode linear"},
        Wrong{R"("fog":{"mode":"linear","^density":1})",
              "unknown key 'density' in fog of mode linear | 'density' belongs to the modes exp and exp2"},
        Wrong{R"("fog":{"mode":"linear","start":9,"end":^9})", "'end' must be greater than 'start'"},
        Wrong{R"("fog":{"mode":"exp","density":^-1})", "-1 is outside the range 0 to 1e+06 of 'density'"},
        Wrong{R"("mixedLighting":^{})", "mixed lighting needs the key 'mode'"},
        Wrong{R"("mixedLighting":{"mode":"^shadowmask"})",
              "'shadowmask' is not a mode of mixed lighting | did you mean 'shadowMask'?"},
        Wrong{R"("mixedLighting":{"mode":"shadowMask","^shadowColor":1})",
              "unknown key 'shadowColor' in mixed lighting of mode shadowMask | 'shadowColor' belongs to the mode "
              "subtractive"},
        Wrong{R"("mixedLighting":{"mode":"shadowMask","shadowDistance":^0})",
              "0 is outside the range 0.001 to 1e+06 of 'shadowDistance'"},
        Wrong{R"("mixedLighting":{"mode":"shadowMask","shadowFade":^3})",
              "'shadowFade' must be set together with 'shadowDistance'"},
        Wrong{R"("mixedLighting":{"mode":"shadowMask","shadowDistance":2,"shadowFade":^3})",
              "'shadowFade' must be at most 'shadowDistance', which is 2"},
        Wrong{R"("background":^null)", "'background' must be \"#rrggbb\", a number or an array of 3 or 4, not null"},
        Wrong{R"("time":^1e39)", "the number 1e39 does not fit in a 32-bit float"},
        Wrong{R"("pixelLightCount":^17)", "17 is outside the range 0 to 16 of 'pixelLightCount'"},
        Wrong{R"("^lihgts":[])", "unknown key 'lihgts' in a scene | did you mean 'lights'?"},
        Wrong{R"("^workflow":"unlit")", "unknown key 'workflow' in a scene | 'workflow' belongs to a material"}));

INSTANTIATE_TEST_SUITE_P(
    Lights, WrongScene,
    ::testing::Values(
        Wrong{R"("lights":[^{}])", "a light needs the key 'type'"},
        Wrong{R"("lights":[{"type":"^sopt"}])", "'sopt' is not a type of light | did you mean 'spot'?"},
        Wrong{R"("lights":[^{"type":"point"}])", "a point light needs the key 'position'"},
        Wrong{R"("lights":[^{"type":"directional"}])", "a directional light needs the key 'direction'"},
        Wrong{R"("lights":[{"type":"directional","direction":^[0,0,0]}])", "'direction' must be longer than 0"},
        Wrong{R"("lights":[{"type":"directional","direction":[0,1,0],"^range":3}])",
              "unknown key 'range' in a directional light | 'range' belongs to a point light and a spot light"},
        Wrong{R"("lights":[{"type":"point","position":[0,0,0],"^inner":3}])",
              "unknown key 'inner' in a point light | 'inner' belongs to a spot light"},
        Wrong{R"("lights":[{"type":"point","position":[0,0,0],"^shadow":true}])",
              "unknown key 'shadow' in a point light | 'shadow' belongs to a directional light and a spot light"},
        Wrong{R"("lights":[{"type":"point","position":[0,0,0],"range":^0}])",
              "0 is outside the range 0.001 to 1e+06 of 'range'"},
        Wrong{R"("lights":[{"type":"point","position":[0,0,0],"intensity":^-1}])",
              "-1 is outside the range 0 to 1e+06 of 'intensity'"},
        Wrong{R"("lights":[{"type":"point","position":[0,0,0],"renderMode":"^pixel"}])",
              "'pixel' is not a render mode | these exist: auto, important and notImportant"},
        Wrong{R"("lights":[{"type":"spot","position":[0,0,0],"direction":[0,1,0],"inner":^31,"outer":30}])",
              "'inner' must be at most 'outer'"},
        Wrong{R"("lights":[{"type":"directional","direction":[0,1,0],"shadow":^1}])",
              "'shadow' must be true, false or an object, not 1"},
        Wrong{R"("lights":[{"type":"directional","direction":[0,1,0],"shadow":{"strength":^2}}])",
              "2 is outside the range 0 to 1 of 'strength'"},
        Wrong{R"("lights":[{"type":"directional","direction":[0,1,0],"cookie":"^door.png"}])",
              "there is no file 'door.png'"},
        Wrong{R"("lights":[^7])", "a light must be an object, not 7"}));

INSTANTIATE_TEST_SUITE_P(
    Materials, WrongScene,
    ::testing::Values(
        Wrong{R"("materials":[^{"graph":"rust.graph.json"}])", "a material of a scene needs the key 'name'"},
        Wrong{R"("materials":[{"name":"^a b","graph":"rust.graph.json"}])",
              "'a b' is not an identifier: use letters, digits and _, and no digit first"},
        Wrong{R"("materials":[{"name":"a","graph":"rust.graph.json"},{"name":"^a","graph":"rust.graph.json"}])",
              "a second material is called 'a' | the first one is here"},
        Wrong{R"("materials":[{"name":"a","graph":"^rost.graph.json"}])", "there is no file 'rost.graph.json'"},
        Wrong{R"("materials":[{"name":"a","graph":"rust.graph.json","set":{"_A":^null}}])",
              "'_A' must be a number, true or false, an array of 2 to 4 numbers or a string, not null"},
        Wrong{R"("materials":[{"name":"a","graph":"rust.graph.json","set":{"_A":^[1]}}])",
              "'_A' must be a number, true or false, an array of 2 to 4 numbers or a string, not an array of 1"},
        Wrong{R"("materials":[{"name":"a","graph":"rust.graph.json","set":{"_A":"^#1"}}])",
              "'#1' is not a colour: write #rgb, #rrggbb or #rrggbbaa"},
        Wrong{R"("materials":[{"name":"a","graph":"rust.graph.json","set":{"_A":"^./no.png"}}])",
              "there is no file './no.png'"}));

INSTANTIATE_TEST_SUITE_P(
    Objects, WrongScene,
    ::testing::Values(
        Wrong{R"("objects":^{})", "'objects' must be an array, not an object"},
        Wrong{R"("objects":[{"id":"a","mesh":"sphere","material":"^rust"}])", "there is no material 'rust'"},
        Wrong{
            R"("materials":[{"name":"m","graph":"rust.graph.json"}],"objects":[{"id":"a","mesh":"cube","material":"m","^lightmapEncoding":"hdr"}])",
            "unknown key 'lightmapEncoding' in an object without a lightmap | 'lightmapEncoding' belongs to one with "
            "'lightmap'"},
        Wrong{
            R"("materials":[{"name":"rust","graph":"rust.graph.json"}],"objects":[{"id":"a","mesh":"cube","material":"^rsut"}])",
            "there is no material 'rsut' | did you mean 'rust'?"},
        Wrong{
            R"("materials":[{"name":"m","graph":"rust.graph.json"}],"objects":[{"id":"a","mesh":"cube","material":"m","scale":^0}])",
            "0 is outside the range 0.001 to 1000 of 'scale'"},
        Wrong{
            R"("materials":[{"name":"m","graph":"rust.graph.json"}],"objects":[{"id":"a","mesh":"cube","material":"m","scale":[1,^-1,1]}])",
            "-1 is outside the range 0.001 to 1000 of 'scale'"},
        Wrong{
            R"("materials":[{"name":"m","graph":"rust.graph.json"}],"objects":[{"id":"a","mesh":"cube","material":"m","scale":^"1"}])",
            "'scale' must be a number or an array of 3 numbers, not a string"},
        Wrong{
            R"("materials":[{"name":"m","graph":"rust.graph.json"}],"objects":[{"id":"a","mesh":"cube","material":"m","segments":^2}])",
            "2 is outside the range 3 to 512 of 'segments'"},
        Wrong{
            R"("materials":[{"name":"m","graph":"rust.graph.json"}],"objects":[{"id":"a","mesh":"cube","material":"m"},{"id":"^a","mesh":"cube","material":"m"}])",
            "a second object is called 'a' | the first one is here"},
        Wrong{R"("materials":[{"name":"m","graph":"rust.graph.json"}],"objects":[^{"id":"a","material":"m"}])",
              "an object of a scene needs the key 'mesh'"}));

std::string many_lights(int count, const std::string& shadow) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text +=
            (text.empty() ? "" : ",\n") + std::string(R"({"type":"directional","direction":[0,1,0])") + shadow + "}";
    }
    return "\"lights\":[" + text + "]";
}

TEST(ReadScene, LimitsLightsAndShadows) {
    EXPECT_EQ(good(many_lights(16, "")).lights.size(), 16u);
    const SceneResult lights = read(scene_of(many_lights(17, "")));
    ASSERT_EQ(lights.diagnostics.size(), 1u);
    EXPECT_EQ(lights.diagnostics[0].message, "17 lights are too many: the limit is 16");
    EXPECT_EQ(lights.diagnostics[0].line, 17);
    EXPECT_EQ(good(many_lights(4, ",\"shadow\":true")).lights.size(), 4u);
    const SceneResult shadows = read(scene_of(many_lights(6, ",\"shadow\":true")));
    ASSERT_EQ(shadows.diagnostics.size(), 1u);
    EXPECT_EQ(shadows.diagnostics[0].message, "6 lights with a shadow are too many: the limit is 4");
    EXPECT_EQ(shadows.diagnostics[0].line, 5);
}

TEST(ReadScene, FindsIndependentMistakesInOneRun) {
    const SceneResult result = read(scene_of(
        R"("fog":{"mode":"x"},"lights":[{"type":"y"}],"objects":[{"id":"a","mesh":"b","material":"c"}],"z":0)"));
    EXPECT_EQ(result.diagnostics.size(), 4u);
    EXPECT_FALSE(result.ok);
}

TEST(ReadScene, IsForScenes) {
    const auto message = [](const std::string& text) {
        const SceneResult result = read(text);
        EXPECT_FALSE(result.ok);
        return result.diagnostics.empty() ? "" : result.diagnostics[0].message;
    };
    EXPECT_EQ(message(R"({"patina":1,"workflow":"unlit"})"), "this file must be a scene, not a material");
    EXPECT_EQ(message(R"({"kind":"scene","camera":{"position":[0,0,1]},"objects":[]})"),
              "a scene needs the key 'patina'");
    EXPECT_EQ(message("[]"), "a scene must be an object, not an empty array");
    EXPECT_EQ(message(""), "the file is empty");
    const SceneResult missing = compiler().read_scene("no/such.scene.json");
    ASSERT_EQ(missing.diagnostics.size(), 1u);
    EXPECT_EQ(missing.diagnostics[0].code, "missing-file");
}

TEST(ReadScene, AScenesFileIsNoMaterial) {
    for (const bool any_part : {false, true}) {
        CompileOptions options;
        options.accept_parts = any_part;
        const Result result = compiler().compile_text("t.scene.json", scene_of("\"time\":0"), options);
        ASSERT_EQ(result.diagnostics.size(), 1u);
        EXPECT_EQ(result.diagnostics[0].message,
                  any_part ? "this file must be a graph, not a scene" : "this file must be a material, not a scene");
        EXPECT_NE(result.diagnostics[0].notes.at(0).message.find("patina render"), std::string::npos);
    }
}

}  // namespace
}  // namespace patina
