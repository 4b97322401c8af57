// The passes and tags that a material has for Unity, where they depend on its state and on the values that it
// reads.
#include <algorithm>

#include "unity/compiled.h"
#include "unity/shader_lab.h"

namespace patina::unity {
namespace {

constexpr const char* kAlone = "\"DisableBatching\" = \"True\"";

// Objects that are batched are one mesh in world space.
TEST(UnityBatching, IsOffWhereAnObjectKnowsItsSpace) {
    for (const std::string graph : {"graphs/beetle", "graphs/lava", "graphs/turned_wood", "graphs/verdigris",
                                    "graphs/outlined", "surfaces/dimples"})
        EXPECT_TRUE(has(for_unity("examples/" + graph + ".graph.json").shaders.front().text, kAlone)) << graph;
    for (const std::string surface :
         {R"("baseColor": "= @positionOS * @positionOS")", R"("baseColor": "= @normalOS * @normalOS")",
          R"("baseColor": "= @tangentOS.xyz * 0.5")", R"("baseColor": "= @objectPositionWS * 0.5")"})
        EXPECT_TRUE(has(shader(material("\"surface\": { " + surface + " }")), kAlone)) << surface;
    EXPECT_TRUE(has(shader(material(R"("nodes": [ { "id": "height", "expr": "@positionOS.y", "stage": "vertex" } ],
      "surface": { "metallic": "= height * 0.5"
         })")),
                    kAlone));
    EXPECT_TRUE(has(shader(material(R"("vertex": { "positionOS": "= float3(@uv0, 0) * 0.5"
})")),
                    kAlone));
}  // namespace

TEST(UnityBatching, IsLeftToUnityElsewhere) {
    EXPECT_FALSE(has(for_unity("tests/unity/graphs/standard.graph.json").shaders.front().text, "DisableBatching"));
    for (const std::string surface :
         {R"("baseColor": "= @positionWS * 0.5")", R"("baseColor": "= @normalWS * 0.5")",
          R"("normalTS": "= float3(@uv0.x, 0, 1) * 0.5")", R"("baseColor": "= float3(@screenUV, 0) * 0.5")"})
        EXPECT_FALSE(has(shader(material("\"surface\": { " + surface + " }")), "DisableBatching")) << surface;
}

std::vector<std::string> modes(const Result& result) {
    std::vector<std::string> made;
    if (result.shaders.empty()) return made;
    for (const LabPass& pass : taken_apart(result.shaders.front().text).passes) made.push_back(pass.light_mode);
    return made;
}

// The words of the warnings; each is a pass that is left out.
std::vector<std::string> left_out(const Result& result) {
    std::vector<std::string> made;
    for (const Diagnostic& d : result.diagnostics) {
        EXPECT_EQ(d.code, "pass-left-out") << to_text(d);
        EXPECT_GT(d.column, 1) << to_text(d);
        made.push_back(d.message);
    }
    return made;
}

using Words = std::vector<std::string>;

// Unity's deferred path keeps in the stencil which pixels it lights, and sets it whatever a pass says.
TEST(UnityDeferred, HasNoPlaceForAStencil) {
    const Result result = of_text(material(R"("render": { "stencil": { "reference": 1, "pass": "replace" } })"));
    EXPECT_EQ(modes(result), (Words{"ForwardBase", "ForwardAdd", "Meta"}));
    const Words said = left_out(result);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_TRUE(has(said[0], "'Deferred'") && has(said[0], "stencil")) << said[0];
}

// What writes no depth has no place in a G-buffer, and none in the camera's depth texture, which casters fill. A
// fallback would bring a caster.
TEST(UnityDepth, IsThereForPassesThatWriteIt) {
    for (const std::string state :
         {R"("depthWrite": false)", R"("depthTest": "always")", R"("depthTest": "greater")"}) {
        for (const std::string surface : {"opaque", "cutout"}) {
            const Result result = of_text(material(R"("render": { "surface": ")" + surface + "\", " + state + " }"));
            EXPECT_EQ(modes(result), (Words{"ForwardBase", "ForwardAdd", "Meta"})) << state;
            EXPECT_EQ(left_out(result).size(), 2u) << state;
            ASSERT_TRUE(result.ok);
            EXPECT_TRUE(has(result.shaders.front().text, "FallBack Off")) << state;
        }
    }
    for (const std::string test : {"less", "lessEqual", "equal"}) {
        const Result result = of_text(material(R"("render": { "depthTest": ")" + test + "\" }"));
        EXPECT_EQ(modes(result).size(), 4u) << test;
        EXPECT_TRUE(has(result.shaders.front().text, "FallBack \"VertexLit\"")) << test;
        EXPECT_TRUE(result.diagnostics.empty()) << test;
    }
}

// The fallback draws the shadows of surfaces that are as the mesh is, with the same text. All others need their own.
TEST(UnityShadows, AreLeftToTheFallbackWhereItDrawsTheSame) {
    for (const std::string graph : {R"("surface": { "metallic": 0.5 })", R"("render": { "depthTest": "equal" })",
                                    R"("render": { "queue": 2100 })"}) {
        const Result result = of_text(material(graph));
        EXPECT_EQ(modes(result), (Words{"ForwardBase", "ForwardAdd", "Meta", "Deferred"})) << graph;
        EXPECT_TRUE(has(result.shaders.front().text, "FallBack \"VertexLit\"")) << graph;
        for (const Pass& pass : result.reflection.passes) EXPECT_FALSE(pass.targets.empty()) << graph;
    }
    for (const std::string graph :
         {R"("render": { "cull": "off" })", R"("render": { "cull": "front" })", R"("render": { "surface": "cutout" })",
          R"("render": { "depthOffset": [1, 2] })", R"("render": { "depthOffset": [0, 1] })",
          R"("vertex": { "positionOS": "= @positionOS * 2" })"}) {
        const Result result = of_text(material(graph));
        EXPECT_EQ(modes(result), (Words{"ForwardBase", "ForwardAdd", "Meta", "ShadowCaster", "Deferred"})) << graph;
        EXPECT_TRUE(has(result.shaders.front().text, "VertexLit\"")) << graph;
    }
}

// Unity's own Unlit shaders have no light mode, so that objects can be batched, and a lower level of detail.
TEST(UnityModes, UnlitFilesHaveNone) {
    const Result unlit = of_text(R"({ "patina": 1, "workflow": "unlit", "surface": { "color": 0.5 } })");
    EXPECT_EQ(modes(unlit), (Words{""}));
    EXPECT_TRUE(has(unlit.shaders.front().text, "FallBack \"VertexLit\""));
    EXPECT_TRUE(has(unlit.shaders.front().text, "LOD 100"));
    const Result at_vertices =
        of_text(R"({ "patina": 1, "workflow": "unlit", "surface": { "color": 0.5 } })", "vertex");
    EXPECT_EQ(modes(at_vertices), (Words{""}));
    EXPECT_TRUE(has(at_vertices.shaders.front().text, "LOD 100"));
    EXPECT_FALSE(has(at_vertices.shaders.front().text, "WhiteLight"));
    const Result lit = of_text(material(R"("name": "Lit")"));
    EXPECT_EQ(modes(lit).front(), "ForwardBase");
    EXPECT_TRUE(has(lit.shaders.front().text, "LOD 300"));
    // Without a fallback, a low Shader.maximumLOD would leave nothing of the object.
    for (const char* state : {R"("surface": "fade")", R"("surface": "transparent")", R"("surface": "additive")",
                              R"("surface": "multiply")", R"("depthWrite": false)"}) {
        const Result result = of_text(material(std::string(R"("render": { )") + state + " }"));
        EXPECT_EQ(modes(result).front(), "ForwardBase") << state;
        EXPECT_TRUE(has(result.shaders.front().text, "FallBack Off")) << state;
        EXPECT_TRUE(has(result.shaders.front().text, "LOD 100")) << state;
    }
    // Whatever reads a value of lights needs the mode.
    for (const char* value : {"@light.direction", "@light.radiance", "AmbientIrradiance(@geometryNormalWS)"}) {
        const Result reads = of_text(R"j({ "patina": 1, "workflow": "unlit", "surface": { "color": "= abs()j" +
                                     std::string(value) + R"j()" } })j");
        EXPECT_EQ(modes(reads).front(), "ForwardBase") << value;
    }
}

// Further passes of a material are Unity's own along every path: along `tiers`, too, which has none for other lighting.
TEST(UnityPasses, OfAMaterialAreThereAlongEachPath) {
    const std::string graph = material(R"json("passes": [
        { "name": "outline", "workflow": "unlit", "surface": { "color": 0.1 },
          "render": { "cull": "front", "queue": 1990 } },
        { "name": "clear", "lighting": "lambert", "surface": { "alpha": 0.3 },
          "render": { "surface": "transparent" } } ])json");
    for (const char* path : {"forward", "vertex", "tiers"}) {
        const Result result = of_text(graph, path);
        ASSERT_TRUE(result.ok) << path;
        EXPECT_EQ(modes(result), (Words{"ForwardBase", "ForwardBase", "ForwardAdd", "Meta", "ForwardBase"})) << path;
        EXPECT_EQ(has(result.shaders.front().text, "UNITY_BRDF_PBS"), std::string(path) == "tiers");
    }
}

// A lightmap has no camera and no side, and a surface without specular light has nothing of it.
TEST(UnityMeta, ReadsNoCamera) {
    const auto meta = [](const std::string& graph) {
        const Result result = of_text(graph);
        EXPECT_TRUE(result.ok);
        const ShaderLab file = taken_apart(result.shaders.front().text);
        const LabPass* pass = file.pass("Meta");
        return pass ? pass->program : std::string();
    };
    const std::string seen = meta(material(R"json("render": { "cull": "off", "depthOffset": [1, 1] },
        "surface": { "baseColor": "= saturate(@viewDirWS * @normalWS)" })json"));
    EXPECT_TRUE(has(seen, "meta.Albedo"));
    EXPECT_FALSE(has(seen, "SV_IsFrontFace"));
    EXPECT_FALSE(has(seen, "UnityWorldSpaceViewDir") || has(seen, "_WorldSpaceCameraPos"));
    // 0.96 of the base colour is diffuse.
    const std::string lambert = meta(R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": "lambert",
        "surface": { "baseColor": 0.5 } })");
    EXPECT_TRUE(has(lambert, "meta.Albedo = ProjectColor(float3(0.48, 0.48, 0.48))")) << lambert;
}

// A stencil that changes the value that it tests requires a single draw: unlit materials, and extra passes.
TEST(UnityStencil, MayChangeWhatItTestsWhereAnObjectIsDrawnOnce) {
    const std::string stencil = R"("stencil": { "reference": 1, "test": "notEqual", "pass": "replace" })";
    for (const std::string kind : {"fade", "opaque"}) {
        const Result unlit = of_text(R"({ "patina": 1, "workflow": "unlit", "surface": { "color": 1 },
            "render": { "surface": ")" +
                                     kind + "\", " + stencil + " } }");
        ASSERT_TRUE(unlit.ok) << to_text(first_error(unlit));
        EXPECT_EQ(modes(unlit).front(), "");
        EXPECT_TRUE(has(unlit.shaders.front().text, "Stencil { Ref 1 Comp NotEqual Pass Replace }"));
    }
    for (const std::string workflow : {"\"unlit\", \"surface\": { \"color\": 0 }", "\"metallic-roughness\""}) {
        const Result added = of_text(material(R"("passes": [ { "name": "veil", "workflow": )" + workflow +
                                              R"(, "render": { )" + stencil + " } } ]"));
        ASSERT_TRUE(added.ok) << to_text(first_error(added));
        EXPECT_TRUE(has(added.shaders.front().text, "Name \"veil\""));
    }
    const Result lit = of_text(material(R"("render": { )" + stencil + " }"));
    EXPECT_FALSE(lit.ok);
    EXPECT_EQ(std::count_if(lit.diagnostics.begin(), lit.diagnostics.end(),
                            [](const Diagnostic& d) { return d.severity == Severity::Error; }),
              1);
    EXPECT_EQ(first_error(lit).code, "pass-refused");
    EXPECT_GT(first_error(lit).column, 80);
    ASSERT_FALSE(first_error(lit).notes.empty());
    EXPECT_TRUE(has(to_text(first_error(lit)), "\"test\"")) << to_text(first_error(lit));
}

std::vector<std::string> pass_names(const std::string& text) {
    const std::string before = "            Name \"";
    std::vector<std::string> made;
    for (std::size_t at = text.find(before); at != text.npos; at = text.find(before, at + 1)) {
        const std::size_t begin = at + before.size();
        made.push_back(text.substr(begin, text.find('"', begin) - begin));
    }
    return made;
}

std::string added(const std::string& name, const std::string& render) {
    return R"({ "name": ")" + name + R"(", "workflow": "unlit", "surface": { "color": 1 }, "render": { )" + render +
           " } }";
}

// Unity draws the passes of a file in their order, and the file at one queue.
TEST(UnityQueue, OrdersThePassesOfAMaterial) {
    const std::string text =
        shader(R"({ "patina": 1, "workflow": "unlit", "surface": { "color": 1 },
        "render": { "queue": 2100 }, "passes": [ )" +
               added("late", R"("queue": 2300)") + ", " + added("same", R"("queue": 2100)") + ", " +
               added("before", R"("queue": 2050)") + ", " + added("first", R"("queue": 1900)") + " ] }");
    EXPECT_EQ(pass_names(text), (Words{"first", "before", "FORWARD", "same", "late"}));
    EXPECT_TRUE(has(text, "\"Queue\" = \"Geometry+100\"")) << text;
}

struct Added {
    std::string name, material, pass, words;  // no words: nothing is said
};
class UnityQueueOf : public ::testing::TestWithParam<Added> {};

// Of solid passes depth says what is seen, whenever they are drawn; a pass on the very surface of its material is seen
// where that has left its depth.
TEST_P(UnityQueueOf, APassIsToldWhereItMayBeSeen) {
    const Added& each = GetParam();
    const Result result = of_text(R"({ "patina": 1, "workflow": "unlit", "surface": { "color": 1 },
        "render": { )" + each.material +
                                  R"( }, "nodes": [ { "id": "shell", "expr": "@positionOS * 1.1", "stage": "vertex" } ],
        "passes": [ { "name": "other", "vertex": { "positionOS": "shell" } }, )" +
                                  added("shown", each.pass) + " ] }");
    ASSERT_TRUE(result.ok) << to_text(first_error(result));
    std::string said;
    for (const Diagnostic& d : result.diagnostics) {
        if (d.code != "queue-limit") continue;
        EXPECT_TRUE(has(d.message, "the pass 'shown' is drawn at the material's queue")) << d.message;
        EXPECT_EQ(d.source_line.substr(std::size_t(d.column) - 1, 5), "shown");
        said += d.message;
    }
    EXPECT_EQ(said.empty(), each.words.empty()) << said;
    EXPECT_TRUE(has(said, each.words)) << said;
}

INSTANTIATE_TEST_SUITE_P(
    All, UnityQueueOf,
    ::testing::Values(
        Added{"solid", R"("queue": 2000)", R"("queue": 2400, "cull": "front")", ""},
        Added{"on_it", R"("queue": 2000)", R"("surface": "additive")", ""},
        Added{"of_the_other_side", R"("queue": 2000)", R"("surface": "additive", "cull": "front")", "the sky"},
        Added{"through_walls", R"("queue": 2000)", R"("surface": "fade", "depthTest": "always")", "the sky"},
        Added{"on_what_writes_no_depth", R"("depthWrite": false)", R"("surface": "additive")", "the sky"},
        Added{"on_holes", R"("surface": "cutout")", R"("surface": "additive")", "the sky"},
        Added{"hidden", R"("queue": 2000)", R"("queue": 2100, "depthTest": "greater")",
              "2100: objects with a queue in between are drawn after it"},
        Added{"before_blended", R"("surface": "fade")", R"("queue": 2000)",
              "opaque objects and the sky are drawn before it"},
        Added{"among_blended", R"("surface": "fade")", R"("surface": "fade", "queue": 2900)",
              "objects with a queue in between are drawn before it"},
        Added{"after_opaque", R"("surface": "fade", "queue": 2500)", R"("surface": "fade", "queue": 2500)", ""}),
    [](const auto& info) { return info.param.name; });

// The range of a colour says that it may be brighter than white.
TEST(UnityColors, WithARangeAboveOneAreHdr) {
    const std::string text = shader(R"({ "patina": 1, "workflow": "unlit", "properties": [
        { "name": "_Glow", "type": "color", "default": [1, 1, 1], "range": [0, 16] },
        { "name": "_Paint", "type": "color", "default": [1, 1, 1], "range": [0, 1] } ],
        "surface": { "color": "= $_Glow.rgb * $_Paint.rgb" } })");
    EXPECT_TRUE(has(text, "[HDR] _Glow (\"Glow\", Color) = (1, 1, 1, 1)"));
    EXPECT_TRUE(has(text, "\n        _Paint (\"Paint\", Color) = (1, 1, 1, 1)"));
}

}  // namespace
}  // namespace patina::unity
