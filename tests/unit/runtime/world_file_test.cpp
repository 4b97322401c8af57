// From a scene file to a world: transforms in closed form, lights, surroundings, pictures, and what is said about
// meshes and pictures that are not there.
#include "runtime/scene/world_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "runtime/picture/image.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

class WorldOfFile : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() /
                  (std::string("patina_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        write("plain.graph.json", R"({"patina":1,"workflow":"unlit"})");
    }
    void TearDown() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    // For a scene with these keys, a camera and a material "plain".
    WorldFile read(const std::string& keys) const {
        write("t.scene.json", R"({"patina":1,"kind":"scene","camera":{"position":[0,1,5],"up":[0,1,1]},
"materials":[{"name":"plain","graph":"plain.graph.json","set":{"_A":[1,0.5,0],"_B":"map.png"}}],
)" + keys + (keys.find("\"objects\"") == keys.npos ? R"(,"objects":[]})" : "}"));
        return read_world(compiler(), path("t.scene.json"), {});
    }
    World world(const std::string& keys) const {
        WorldFile file = read(keys);
        for (const Diagnostic& d : file.diagnostics) ADD_FAILURE() << to_text(d);
        EXPECT_TRUE(file.ok);
        return std::move(file.world);
    }

private:
    fs::path folder_;
};

void expect_near(glm::vec3 value, glm::vec3 expected, float tolerance = 1e-6f) {
    for (int c = 0; c < 3; c++) EXPECT_NEAR(value[c], expected[c], tolerance) << "component " << c;
}

std::string object_with(const std::string& keys) {
    return R"("objects":[{"id":"o","mesh":"cube","material":"plain",)" + keys + "}]";
}

TEST_F(WorldOfFile, MovesTurnsAndScales) {
    const auto moved = [&](const std::string& keys, glm::vec3 point) {
        return glm::vec3(world(object_with(keys)).objects.at(0).object_to_world * glm::vec4(point, 1));
    };
    expect_near(moved(R"("position":[1,2,3])", {0, 0, 0}), {1, 2, 3});
    expect_near(moved(R"("scale":2)", {1, -1, 3}), {2, -2, 6});
    expect_near(moved(R"("scale":[1,2,3])", {1, 1, 1}), {1, 2, 3});
    // Counter-clockwise seen from the axis's tip: x to y about z, y to z about x, z to x about y.
    expect_near(moved(R"("rotation":[0,0,90])", {1, 0, 0}), {0, 1, 0});
    expect_near(moved(R"("rotation":[90,0,0])", {0, 1, 0}), {0, 0, 1});
    expect_near(moved(R"("rotation":[0,90,0])", {0, 0, 1}), {1, 0, 0});
    // First about z (x to y), then about x (y to z), then about y (z to x): x comes back to itself.
    expect_near(moved(R"("rotation":[90,90,90])", {1, 0, 0}), {1, 0, 0});
    // y goes to -x about z, stays about x, and becomes z about y.
    expect_near(moved(R"("rotation":[90,90,90])", {0, 1, 0}), {0, 0, 1});
    // Scaled before it is turned, turned before it is moved.
    expect_near(moved(R"("scale":[2,1,1],"rotation":[0,0,90],"position":[5,0,0])", {1, 0, 0}), {5, 2, 0});
    // A plane that lies down faces up.
    const glm::mat4 floor = world(object_with(R"("rotation":[-90,0,0])")).objects.at(0).object_to_world;
    expect_near(glm::vec3(floor * glm::vec4(0, 0, 1, 0)), {0, 1, 0});
}

TEST_F(WorldOfFile, MakesMeshesOncePerKind) {
    const World made = world(R"("objects":[
        {"id":"a","mesh":"sphere","material":"plain"},{"id":"b","mesh":"sphere","material":"plain"},
        {"id":"c","mesh":"sphere","material":"plain","segments":8},{"id":"d","mesh":"cube","material":"plain"}])");
    ASSERT_EQ(made.objects.size(), 4u);
    EXPECT_EQ(made.objects[0].mesh, made.objects[1].mesh);
    EXPECT_NE(made.objects[0].mesh, made.objects[2].mesh);
    EXPECT_EQ(made.objects[2].mesh->vertices.size(), 9u * 5u);  // 8 columns and 4 rows of cells
    EXPECT_EQ(made.objects[3].name, "d");
    EXPECT_NEAR(bounding_radius(*made.objects[3].mesh), 0.75 * std::sqrt(3.0), 1e-6);
}

TEST_F(WorldOfFile, NamesMaterialsAndTheirFiles) {
    write("map.png", "");
    const World made = world(object_with(R"("lightmap":"map.png","lightmapEncoding":"rgbm","shadowMask":"./map.png")"));
    ASSERT_EQ(made.materials.size(), 1u);
    EXPECT_EQ(made.materials[0].name, "plain");
    EXPECT_EQ(made.materials[0].graph, path("plain.graph.json"));
    const std::map<std::string, std::string> expected = {{"_A", "1,0.5,0"}, {"_B", path("map.png")}};
    EXPECT_EQ(made.materials[0].overrides, expected);
    EXPECT_EQ(made.materials[0].place.line, 2);
    EXPECT_EQ(made.objects[0].material, 0u);
    EXPECT_EQ(made.objects[0].lightmap, path("map.png"));
    EXPECT_EQ(made.objects[0].lightmap_encoding, LightmapEncoding::Rgbm);
    EXPECT_EQ(made.objects[0].shadow_mask, path("map.png"));
}

TEST_F(WorldOfFile, Lights) {
    const World made = world(R"("pixelLightCount":2,"lights":[
        {"type":"directional","direction":[0,0,5],"color":[1,0.5,0],"intensity":2,
         "shadow":{"strength":0.5,"bias":0.1,"normalBias":2}},
        {"type":"point","position":[1,2,3],"range":7,"renderMode":"important"},
        {"type":"spot","position":[0,3,0],"direction":[0,-1e-9,0],"inner":5,"outer":40,"renderMode":"notImportant"},
        {"type":"spot","position":[0,3,0],"direction":[0,-1,0],"outer":15},
        {"type":"spot","position":[0,3,0],"direction":[0,-1,0],"inner":50}])");
    EXPECT_EQ(made.pixel_light_count, 2);
    const std::vector<Light>& lights = made.view.lights;
    ASSERT_EQ(lights.size(), 5u);
    EXPECT_EQ(lights[0].kind, LightKind::Directional);
    expect_near(lights[0].direction, {0, 0, 1});
    expect_near(lights[0].color, {2, 1, 0});
    EXPECT_TRUE(lights[0].shadow.casts);
    EXPECT_EQ(lights[0].shadow.strength, 0.5f);
    EXPECT_EQ(lights[0].shadow.bias, 0.1f);
    EXPECT_EQ(lights[0].shadow.normal_bias, 2);
    EXPECT_EQ(lights[1].kind, LightKind::Point);
    EXPECT_EQ(lights[1].position, glm::vec3(1, 2, 3));
    EXPECT_EQ(lights[1].range, 7);
    EXPECT_EQ(lights[1].importance, LightImportance::Important);
    EXPECT_FALSE(lights[1].shadow.casts);
    EXPECT_EQ(lights[2].kind, LightKind::Spot);
    expect_near(lights[2].direction, {0, -1, 0});
    EXPECT_EQ(lights[2].inner_angle, 5);
    EXPECT_EQ(lights[2].outer_angle, 40);
    EXPECT_EQ(lights[2].importance, LightImportance::NotImportant);
    // One angle moves the other along: two thirds of the outer one, a degree more than the inner one.
    EXPECT_EQ(lights[3].inner_angle, 10);
    EXPECT_EQ(lights[4].outer_angle, 51);
}

// What a file leaves out is what the runtime's own light, camera and view have.
TEST_F(WorldOfFile, DefaultsAreTheRuntimes) {
    const World made = world(R"("lights":[{"type":"spot","position":[0,0,0],"direction":[0,1,0],"shadow":true}],
        "fog":{"mode":"exp"},"mixedLighting":{"mode":"distanceShadowMask","shadowDistance":30})");
    const Light& light = made.view.lights.at(0);
    const Light usual;
    EXPECT_EQ(light.color, usual.color);
    EXPECT_EQ(light.range, usual.range);
    EXPECT_EQ(light.inner_angle, usual.inner_angle);
    EXPECT_EQ(light.outer_angle, usual.outer_angle);
    EXPECT_EQ(light.importance, usual.importance);
    EXPECT_EQ(light.shadow.strength, usual.shadow.strength);
    EXPECT_EQ(light.shadow.bias, usual.shadow.bias);
    EXPECT_EQ(light.shadow.normal_bias, usual.shadow.normal_bias);
    EXPECT_EQ(light.cookie_size, usual.cookie_size);
    EXPECT_EQ(light.cookie, nullptr);
    const Camera camera;
    EXPECT_EQ(made.view.camera.target, camera.target);
    EXPECT_EQ(made.view.camera.up, glm::vec3(0, 1, 1));
    EXPECT_EQ(made.view.camera.fov, camera.fov);
    EXPECT_EQ(made.view.camera.near_plane, camera.near_plane);
    EXPECT_EQ(made.view.camera.far_plane, camera.far_plane);
    EXPECT_FALSE(made.view.camera.orthographic_height);
    const Fog fog;
    EXPECT_EQ(made.view.mixed_lighting.mode, LightMixing::DistanceShadowMask);
    EXPECT_EQ(made.view.mixed_lighting.shadow_distance, 30.0f);
    EXPECT_FALSE(made.view.mixed_lighting.shadow_fade);
    EXPECT_EQ(made.view.fog.mode, FogMode::Exponential);
    EXPECT_EQ(made.view.fog.color, fog.color);
    EXPECT_EQ(made.view.fog.density, fog.density);
    EXPECT_EQ(made.view.fog.start, fog.start);
    EXPECT_EQ(made.view.fog.end, fog.end);
    EXPECT_EQ(made.view.background, Scene{}.background);
    EXPECT_EQ(made.view.environment, studio_environment());
    EXPECT_EQ(made.view.ambient.coefficients, studio_environment()->ambient().coefficients);
    EXPECT_EQ(world(R"("time":3)").view.fog.mode, FogMode::None);
    EXPECT_EQ(world(R"("time":3)").view.time, 3);
    EXPECT_EQ(World{}.pixel_light_count, made.pixel_light_count);
}

TEST_F(WorldOfFile, AmbientLight) {
    const auto radiance = [&](const std::string& keys, glm::vec3 direction) {
        const World made = world(keys);
        EXPECT_EQ(made.view.environment, nullptr);
        glm::vec3 sum(0);
        const std::array<float, 9> basis = spherical_harmonics_basis(direction);
        for (std::size_t i = 0; i < 9; i++) sum += made.view.ambient.coefficients[i] * basis[i];
        return sum;
    };
    const float s = std::sqrt(0.5f);
    expect_near(radiance(R"("ambient":[0.1,0.2,0.3])", {s, 0.5f, 0.5f}), {0.1f, 0.2f, 0.3f});
    expect_near(radiance(R"("ambient":"none")", {0, 1, 0}), glm::vec3(0));
    const char* sky = R"("ambient":{"sky":1,"ground":0})";  // the horizon is their mean
    expect_near(radiance(sky, {0, 1, 0}), glm::vec3(1));
    expect_near(radiance(sky, {s, 0, s}), glm::vec3(0.5f));
    expect_near(radiance(sky, {0, -1, 0}), glm::vec3(0));
    EXPECT_EQ(world(R"("ambient":0.2,"environment":"studio")").view.environment, studio_environment());
}

// An even picture of 0.5: the first coefficient is 0.5 times 2 sqrt(pi).
TEST_F(WorldOfFile, AnEnvironmentFromAPicture) {
    setenv("XDG_CACHE_HOME", path("cache").c_str(), 1);
    ASSERT_EQ(save_exr(path("sky.exr"), make_image(8, 4, 0.5f, 0.5f, 0.5f)), "");
    const float half = std::sqrt(std::acos(-1.0f));
    const auto first = [](const World& made) { return made.view.ambient.coefficients[0].g; };
    World made = world(R"("environment":"sky.exr")");
    ASSERT_TRUE(made.view.environment);
    EXPECT_NEAR(first(made), half, 1e-3f);
    EXPECT_NEAR(made.view.environment->ambient().coefficients[0].g, half, 1e-3f);
    EXPECT_NEAR(first(world(R"("environment":{"file":"sky.exr","rotation":90,"intensity":2})")), 2 * half, 2e-3f);
    // Other ambient light replaces the picture's diffuse light alone.
    made = world(R"("environment":"sky.exr","ambient":0.25)");
    EXPECT_NEAR(first(made), half / 2, 1e-3f);
    EXPECT_NEAR(made.view.environment->ambient().coefficients[0].g, half, 1e-3f);
    made = world(R"("environment":"sky.exr","ambient":"studio")");
    EXPECT_EQ(made.view.ambient.coefficients, studio_environment()->ambient().coefficients);

    std::ofstream(path("broken.exr")) << "no picture";
    const WorldFile broken = read(R"("environment":{"file":"broken.exr"})");
    EXPECT_FALSE(broken.ok);
    ASSERT_EQ(broken.diagnostics.size(), 1u);
    EXPECT_EQ(broken.diagnostics[0].code, "bad-environment");
    EXPECT_EQ(broken.diagnostics[0].line, 3);
    const WorldFile missing = read(R"("environment":"none.exr")");
    EXPECT_FALSE(missing.ok);
    ASSERT_EQ(missing.diagnostics.size(), 1u);
    EXPECT_EQ(missing.diagnostics[0].line, 3);
}

TEST_F(WorldOfFile, LoadsCookies) {
    Image image = make_image(2, 1, 0.25f, 0, 0);
    image.at(1, 0)[0] = 0.75f;
    ASSERT_EQ(save_exr(path("cookie.exr"), image), "");
    const WorldFile file = read(R"("lights":[
        {"type":"directional","direction":[0,1,0],"cookie":"./cookie.exr","cookieSize":3},
        {"type":"spot","position":[0,1,0],"direction":[0,-1,0],"cookie":"cookie.exr"}])");
    ASSERT_TRUE(file.ok);
    const std::vector<Light>& lights = file.world.view.lights;
    ASSERT_TRUE(lights[0].cookie && lights[1].cookie);
    EXPECT_EQ(lights[0].cookie_size, 3);
    EXPECT_EQ(lights[0].cookie->sampler.wrap, Wrap::Repeat);
    EXPECT_EQ(lights[1].cookie->sampler.wrap, Wrap::Clamp);
    ASSERT_EQ(lights[0].cookie->levels.size(), 2u);
    EXPECT_EQ(lights[0].cookie->levels[0].texels[0], 0.25f);
    EXPECT_EQ(lights[0].cookie->levels[0].texels[4], 0.75f);
    EXPECT_EQ(lights[0].cookie->levels[1].texels[0], 0.5f);
    EXPECT_EQ(file.dependencies.front(), path("t.scene.json"));
    EXPECT_EQ(file.dependencies.back(), path("cookie.exr"));
}

// Who watches a scene draws it again when a file appears that it looked for.
TEST_F(WorldOfFile, DependsOnWhatItLookedForInVain) {
    const WorldFile file = read(R"("time":1)");
    EXPECT_TRUE(file.ok);
    EXPECT_EQ(std::set(file.dependencies.begin(), file.dependencies.end()),
              (std::set<std::string>{path("t.scene.json"), path("map.png")}));
}

TEST_F(WorldOfFile, SaysWhereAMeshIsUnknown) {
    const WorldFile file = read(
        "\"objects\":[\n"
        R"({"id":"o","mesh":"shpere","material":"plain"}])");
    EXPECT_FALSE(file.ok);
    ASSERT_EQ(file.diagnostics.size(), 1u);
    EXPECT_EQ(to_text(file.diagnostics[0]),
              path("t.scene.json") + R"(:4:19: error: there is no mesh 'shpere' [unknown-name]
    4 | {"id":"o","mesh":"shpere","material":"plain"}]}
      |                   ^~~~~~
note: did you mean 'sphere'?)");
}

TEST_F(WorldOfFile, SaysWhichPictureCannotBeRead) {
    write("cookie.png", "no picture");
    const WorldFile file = read(R"("lights":[{"type":"directional","direction":[0,1,0],"cookie":"cookie.png"}])");
    EXPECT_FALSE(file.ok);
    ASSERT_EQ(file.diagnostics.size(), 1u);
    EXPECT_EQ(file.diagnostics[0].code, "bad-texture");
    EXPECT_EQ(file.diagnostics[0].line, 3);
    EXPECT_NE(file.diagnostics[0].message.find("cookie.png"), std::string::npos);
}

// A shadow map is flat: it cannot hold a half-space.
TEST_F(WorldOfFile, WarnsOfShadowsThatEndWithinTheirCone) {
    const auto spot = [&](const std::string& rest) {
        return read(
            "\"lights\":[\n"
            R"({"type":"spot","position":[0,3,0],"direction":[0,-1,0],)" +
            rest + "}]");
    };
    const WorldFile file = spot(R"("outer":90,"shadow":true)");
    EXPECT_TRUE(file.ok);
    ASSERT_EQ(file.diagnostics.size(), 1u);
    EXPECT_EQ(file.diagnostics[0].code, "cut-shadow");
    EXPECT_EQ(file.diagnostics[0].severity, Severity::Warning);
    EXPECT_EQ(file.diagnostics[0].line, 4);
    EXPECT_NE(file.diagnostics[0].message.find("85 degrees"), std::string::npos);
    EXPECT_TRUE(spot(R"("outer":85,"shadow":true)").diagnostics.empty());
    EXPECT_TRUE(spot(R"("outer":90)").diagnostics.empty());
}

TEST_F(WorldOfFile, PassesOnWhatTheReaderSays) {
    const WorldFile file = read(R"("lights":[{"type":"sun"}])");
    EXPECT_FALSE(file.ok);
    ASSERT_EQ(file.diagnostics.size(), 1u);
    EXPECT_EQ(file.diagnostics[0].code, "unknown-word");
    EXPECT_FALSE(read_world(compiler(), path("none.scene.json"), {}).ok);
}

// examples/scenes: what five-lights promises, and that all of it is in the picture.
TEST(FiveLights, IsWhatItSays) {
    const WorldFile file = read_world(compiler(), "examples/scenes/five-lights.scene.json", {});
    for (const Diagnostic& d : file.diagnostics) ADD_FAILURE() << to_text(d);
    ASSERT_TRUE(file.ok) << "run this in the project's root";
    const World& world = file.world;
    std::map<LightKind, int> kinds;
    int shadows = 0;
    for (const Light& light : world.view.lights) {
        kinds[light.kind]++;
        shadows += light.shadow.casts;
    }
    EXPECT_EQ(world.view.lights.size(), 5u);
    EXPECT_EQ(kinds.size(), 3u);
    EXPECT_EQ(shadows, 1);

    const glm::mat4 to_clip = view_to_clip(world.view.camera, 1) * world_to_view(world.view.camera);
    std::set<std::string> graphs;
    std::set<std::size_t> materials;
    for (const WorldObject& object : world.objects) {
        if (object.name == "floor") continue;
        materials.insert(object.material);
        graphs.insert(world.materials[object.material].graph);
        for (const Vertex& vertex : object.mesh->vertices) {
            const glm::vec4 p = to_clip * object.object_to_world * glm::vec4(vertex.position, 1);
            ASSERT_LT(std::max(std::abs(p.x), std::abs(p.y)), 0.98f * p.w) << object.name << " is cut off";
            ASSERT_GT((object.object_to_world * glm::vec4(vertex.position, 1)).y, -1e-5f) << "below the floor";
        }
    }
    EXPECT_EQ(world.objects.size(), 9u);
    EXPECT_EQ(materials.size(), 8u);
    EXPECT_EQ(graphs.size(), 8u);
}

}  // namespace
}  // namespace patina::runtime
