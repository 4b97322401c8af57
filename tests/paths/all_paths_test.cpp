// `--path all` compiles every pass that can draw a material, each as its own path would have it: the functions of its
// shaders are the same, and only the interface, which all passes share, is larger.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "paths/drawing/drawing.h"

namespace patina::paths {
namespace {

// The text without what it declares of blocks and bindings.
std::string functions_of(const Shader& shader) {
    std::istringstream lines(shader.text);
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        const auto says = [&](const char* word) { return line.find(word) != line.npos; };
        const bool is_member = line.starts_with("    ") && line.find('=') == line.npos && line.find('(') == line.npos;
        if (!is_member && !says("binding") && !says("register")) kept += line + "\n";
    }
    return kept;
}

void expect_same_shaders(const std::string& graph) {
    const Result all = compiled(graph, "all");
    int compared = 0;
    for (const PathInfo& path : compiler().paths()) {
        const Result alone = compiled(graph, path.name);
        if (alone.reflection.path != path.name) continue;  // it cannot draw the material
        for (const Shader& shader : alone.shaders) {
            const auto twin = std::find_if(all.shaders.begin(), all.shaders.end(), [&](const Shader& other) {
                return other.pass == shader.pass && other.stage == shader.stage && other.target == shader.target;
            });
            ASSERT_NE(twin, all.shaders.end()) << shader.pass;
            EXPECT_EQ(functions_of(*twin), functions_of(shader)) << shader.pass;
            ++compared;
        }
    }
    EXPECT_GT(compared, 20);
}

TEST(AllPaths, HaveTheShadersOfEach) {
    for (const ModelInfo& model : compiler().lighting_models()) {
        SCOPED_TRACE(model.name);
        expect_same_shaders(written(model.name + ".all.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness",
  "lighting": ")" + model.name + R"(", "surface": { "baseColor": [0.8, 0.6, 0.4], "metallic": 0.7 } })"));
    }
}

TEST(AllPaths, HaveThemWithBakedLightToo) {
    const std::string graph =
        written("baked.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": "cook-torrance",
  "surface": { "baseColor": 0.5 } })");
    const Result all = compiled(graph, "all", {{"lightmap", "true"}, {"shadows", "true"}});
    for (const char* name : {"forward", "forward-base", "gbuffer", "gbuffer-ldr", "vertex"})
        EXPECT_TRUE(find_pass(all, name)) << name;
}

// The lines of a vertex shader that read the matrices of the object and the camera.
std::string transforms(const Shader& shader) {
    std::istringstream lines(shader.text);
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        const bool computes = line.find('=') != line.npos;
        if (computes && (line.find("objectToWorld") != line.npos || line.find("worldToClip") != line.npos))
            kept += line + "\n";
    }
    return kept;
}

// A pass may test for the depth that another one has written, so all compute it alike, whatever else they need of the
// vertex.
TEST(AllPaths, ComputeThePlaceOnTheScreenAlike) {
    const Result all = compiled(written("screen.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness",
  "surface": { "baseColor": "= @positionWS" }, "vertex": { "positionOS": "= @positionOS * 1.1" } })"),
                                "all");
    std::map<Target, std::string> expected;
    std::set<std::string> passes;
    for (const Shader& shader : all.shaders) {
        const bool draws_objects = find_pass(all, shader.pass)->draws == PassDraws::Objects;
        if (shader.stage != Stage::Vertex || !draws_objects || shader.pass == "shadow-caster") continue;
        const std::string found = transforms(shader);
        if (found.find("worldToClip") == found.npos) continue;  // it draws into a texture
        expected.try_emplace(shader.target, found);
        EXPECT_EQ(found, expected[shader.target]) << shader.pass;
        passes.insert(shader.pass);
    }
    for (const char* name : {"forward", "forward-add", "directional-base", "vertex", "depth-only", "depth-normals",
                             "gbuffer", "gbuffer-ldr"})
        EXPECT_TRUE(passes.contains(name)) << name;
}

// The first of the two is a pass of another path.
TEST(Statics, AreTrueWhereAnyOfTheirPassesIsThere) {
    const std::string graph = written("white.graph.json", R"({ "patina": 1, "workflow": "metallic-roughness",
  "lighting": "lambert", "surface": { "baseColor": 1 } })");
    const std::string file = written("said.pass.hlsl", R"(
[static("pass", "depth-only", "said-extra")] bool hasExtra;
float said() {
    float sum = 0;
    for (int i = 0; i < 3; i++) { sum += hasExtra ? cameraPositionWS.x : 2.0 * cameraPositionWS.y; }
    return sum;
}
[pass("said")] [pass("said-extra")] [vertex]
float4 saidVertex(float3 position = positionWS) { return mul(worldToClip, float4(position, 1)); }
[pass("said")] [fragment] [blend("one", "zero")] float4 saidFragment() { return float4(said()); }
[pass("said-extra")] [fragment] [optional] [blend("one", "one")] float4 saidExtra() { return float4(said()); }
)");
    const Result made = compiled(graph, file);
    ASSERT_TRUE(find_pass(made, "said-extra"));
    for (const Shader& shader : made.shaders) {
        if (shader.pass != "said" || shader.stage != Stage::Fragment) continue;
        EXPECT_NE(shader.text.find("cameraPositionWS.x"), shader.text.npos) << shader.text;
        EXPECT_EQ(shader.text.find("cameraPositionWS.y"), shader.text.npos) << shader.text;
    }
}

}  // namespace
}  // namespace patina::paths
