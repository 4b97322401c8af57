// "materialOverride": what a material can change in Unity, and what it looks like then.
#include <algorithm>

#include "unity/pictures.h"

namespace patina::unity {
namespace {

// The material has all passes, and its state begins as the graph's.
TEST(UnityState, IsTheMaterialsToChange) {
    struct Begin {
        std::string render, clip, surface, blend, factors, depth, faces, queue;
    };
    const Begin begins[] = {
        {R"("materialOverride": true)", "0", "0", "0", "1, 0, 1, 0", "1, 4", "2", "Geometry"},
        {R"("materialOverride": true, "surface": "cutout", "cull": "off")", "1", "0", "0", "1, 0, 1, 0", "1, 4", "0",
         "AlphaTest"},
        {R"("materialOverride": true, "surface": "fade", "cull": "front")", "0", "1", "0", "5, 10, 1, 10", "0, 4", "1",
         "Transparent"},
        {R"("materialOverride": true, "surface": "transparent", "depthWrite": true)", "0", "1", "1", "1, 10, 1, 10",
         "1, 4", "2", "Transparent"},
        {R"("materialOverride": true, "surface": "additive", "depthTest": "always")", "0", "1", "2", "1, 1, 0, 1",
         "0, 8", "2", "Transparent"},
        {R"("materialOverride": true, "surface": "multiply", "queue": 3010)", "0", "1", "3", "2, 0, 0, 1", "0, 4", "2",
         "Transparent+10"},
    };
    for (const Begin& begin : begins) {
        SCOPED_TRACE(begin.render);
        const std::string text =
            shader(material(R"("surface": { "alpha": "= @uv0.x" }, "render": { )" + begin.render + " }"));
        const auto value_of = [&](const std::string& name) {
            const std::size_t line = text.find(" " + name + " (\"");
            if (line == text.npos) return std::string("none");
            const std::size_t equals = text.find(" = ", line);
            return text.substr(equals + 3, text.find('\n', equals) - equals - 3);
        };
        EXPECT_EQ(value_of("_AlphaClip"), begin.clip);
        EXPECT_EQ(value_of("_Surface"), begin.surface);
        EXPECT_EQ(value_of("_Blend"), begin.blend);
        EXPECT_EQ(value_of("_SrcBlend") + ", " + value_of("_DstBlend") + ", " + value_of("_SrcBlendAlpha") + ", " +
                      value_of("_DstBlendAlpha"),
                  begin.factors);
        EXPECT_EQ(value_of("_ZWrite") + ", " + value_of("_ZTest"), begin.depth);
        EXPECT_EQ(value_of("_Cull"), begin.faces);
        EXPECT_TRUE(has(text, "\"Queue\" = \"" + begin.queue + "\"")) << text;
        const ShaderLab file = taken_apart(text);
        for (const char* mode : {"ForwardBase", "ForwardAdd", "Meta", "ShadowCaster", "Deferred"})
            EXPECT_TRUE(file.pass(mode)) << mode;
        ASSERT_TRUE(file.forward() && file.pass("ForwardAdd") && file.pass("ShadowCaster"));
        EXPECT_TRUE(has(file.forward()->state, "Blend [_SrcBlend] [_DstBlend], [_SrcBlendAlpha] [_DstBlendAlpha]"));
        EXPECT_TRUE(has(file.forward()->state, "ZWrite [_ZWrite]") && has(file.forward()->state, "ZTest [_ZTest]"));
        EXPECT_TRUE(has(file.pass("ForwardAdd")->state, "Blend [_SrcBlend] One, Zero One"));
        EXPECT_TRUE(has(file.pass("ForwardAdd")->state, "ZWrite Off"));
        EXPECT_FALSE(has(file.pass("Deferred")->state, "Blend"));
        for (const LabPass& pass : file.passes) {
            EXPECT_EQ(has(pass.state, "Cull [_Cull]"), pass.light_mode != "Meta") << pass.light_mode;
            const auto& pragmas = pass.pragmas;
            EXPECT_EQ(std::count(pragmas.begin(), pragmas.end(), "shader_feature_local _ALPHATEST_ON"),
                      pass.light_mode == "Meta" ? 0 : 1)
                << pass.light_mode;
        }
    }
    EXPECT_FALSE(has(shader(material(R"("render": { "materialOverride": false })")), "_SrcBlend"));
}

// Other engines and the passes of a material's own have the state of the graph.
TEST(UnityState, IsTheMaterialsOnlyOfTheMainSurfaceInUnity) {
    const std::string pass = R"("passes": [ { "name": "outline", "workflow": "unlit", "surface": { "color": 0 },
      "render": { "cull": "front", "materialOverride": true } } ])";
    Result result = of_text(material(R"("render": { "materialOverride": true }, )" + pass));
    ASSERT_TRUE(result.ok);
    EXPECT_TRUE(std::any_of(result.diagnostics.begin(), result.diagnostics.end(), [](const Diagnostic& each) {
        return each.code == "no-effect" && has(each.message, "'materialOverride' has no effect");
    }));
    EXPECT_TRUE(has(result.shaders.front().text, "Cull Front"));
    const std::string faded = R"("surface": { "alpha": 0.5 }, "render": { "surface": "fade")";
    const Result plain = compiler().compile_text("t.graph.json", material(faded + " }"), {}),
                 chosen =
                     compiler().compile_text("t.graph.json", material(faded + R"(, "materialOverride": true })"), {});
    ASSERT_EQ(plain.shaders.size(), chosen.shaders.size());
    for (std::size_t i = 0; i < plain.shaders.size(); ++i) EXPECT_EQ(plain.shaders[i].text, chosen.shaders[i].text);
    EXPECT_TRUE(chosen.diagnostics.empty());
}

TEST(UnityState, NeedsItsNames) {
    for (const std::string name :
         {"_Surface", "_Blend", "_AlphaClip", "_SrcBlend", "_DstBlendAlpha", "_ZWrite", "_ZTest", "_Cull"}) {
        const auto result = [&](const std::string& chosen) {
            return of_text(material(R"("properties": [ { "name": ")" + name + R"(", "type": "float" } ],
              "surface": { "metallic": "$)" +
                                    name + R"(" }, "render": { "materialOverride": )" + chosen + " }"));
        };
        const Diagnostic error = first_error(result("true"));
        EXPECT_TRUE(has(to_text(error), "materialOverride") || error.notes.size() == 1) << to_text(error);
        EXPECT_EQ(error.line, 1) << name;
        EXPECT_TRUE(result("false").ok) << name;
    }
}

// A material that chooses its kind looks like a graph of that kind, also if it blends and is clipped. Where the surface
// adds or multiplies, further lights change nothing.
TEST(UnityPictures, OfAChosenSurfaceAreThoseOfForward) {
    struct Choice {
        std::string kind;
        Keywords keywords;
    };
    const Choice choices[] = {{"opaque", {}},
                              {"cutout", {"_ALPHATEST_ON"}},
                              {"fade", {"_SURFACE_TYPE_TRANSPARENT", "_BLEND_ALPHA"}},
                              {"transparent", {"_SURFACE_TYPE_TRANSPARENT", "_BLEND_PREMULTIPLY"}},
                              {"additive", {"_SURFACE_TYPE_TRANSPARENT", "_BLEND_ADDITIVE"}},
                              {"multiply", {"_SURFACE_TYPE_TRANSPARENT", "_BLEND_MULTIPLY"}},
                              {"fade", {"_SURFACE_TYPE_TRANSPARENT", "_BLEND_ALPHA", "_ALPHATEST_ON"}},
                              {"transparent", {"_SURFACE_TYPE_TRANSPARENT", "_BLEND_PREMULTIPLY", "_ALPHATEST_ON"}}};
    const std::string chosen = "tests/unity/graphs/override.graph.json", words = R"("fade", "materialOverride": true)",
                      clip = R"("alphaClip": 0.5,)";
    std::ifstream file(chosen);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    ASSERT_TRUE(has(text, words) && has(text, clip));
    runtime::Scene scene = scene_of("sphere", {kSun, kLamp});
    scene.background = glm::vec4(0.4f, 0.5f, 0.2f, 1);
    std::vector<Image> seen;
    for (const Choice& choice : choices) {
        SCOPED_TRACE(choice.kind);
        std::string own = text;
        own.replace(own.find(words), words.size(), '"' + choice.kind + '"');
        const bool is_clipped = std::count(choice.keywords.begin(), choice.keywords.end(), "_ALPHATEST_ON") > 0;
        if (!is_clipped) own.erase(own.find(clip), clip.size());
        const std::string path =
            testing::TempDir() + "patina_" + choice.kind + (is_clipped ? "_clipped" : "") + ".graph.json";
        std::ofstream(path) << own;
        const bool is_lit_once = choice.kind == "additive" || choice.kind == "multiply";
        runtime::Scene lit = scene;
        if (is_lit_once) lit.lights.resize(1);
        const auto material = [&](std::vector<std::pair<std::string, std::string>> switches) {
            Material made(path, lit, {}, switches);
            made.file = taken_apart(Material(chosen, lit, {}, {}).result.shaders.back().text);
            return made;
        };
        const Image expected = forward(material({}), lit);
        expect_same(expected, in_unity(material({}), lit, choice.keywords), "linear");
        if (is_lit_once) expect_same(expected, in_unity(material({}), scene, choice.keywords), "two lights");
        for (const Image& other : seen) EXPECT_GT(paths::difference(expected, other).largest, kMost);
        seen.push_back(expected);
        lit.fog = kFog;
        Keywords in_fog = choice.keywords;
        in_fog.insert(in_fog.end(), {"FOG_LINEAR", "STAND_IN_FOG"});
        const Material foggy = material({{"fog", "true"}});
        expect_same(forward(foggy, lit), in_unity(foggy, lit, in_fog), "fog");
    }
}

}  // namespace
}  // namespace patina::unity
