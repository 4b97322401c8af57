// What a graph reads of its engine is Unity's in a ShaderLab file, or it is refused where it stands.
#include <filesystem>
#include <fstream>
#include <regex>

#include "unity/compiled.h"

namespace patina::unity {
namespace {

namespace fs = std::filesystem;

// The values that Patina's own engine fills, as the library declares them.
std::vector<std::string> engine_values() {
    static const std::regex kDeclaration(R"(\[extern\("\w+"\)\][^;]*?\b(\w+)(\[\d+\])?;)");
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator("nodes/stage")) {
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);) {
            std::smatch found;
            if (std::regex_search(line, found, kDeclaration)) names.push_back(found[1]);
        }
    }
    return names;
}

const std::vector<std::string>& values() {
    static const std::vector<std::string> kValues = {"@light.direction.x",
                                                     "@light.shadow",
                                                     "AmbientIrradiance(float3(0, 1, 0)).x",
                                                     "EnvironmentRadiance(float3(0, 1, 0), 0.5).x",
                                                     "SplitSumTable(0.5, 0.5).scale",
                                                     "@time",
                                                     "@screenSize.x",
                                                     "@cameraPositionWS.x",
                                                     "@cameraForwardWS.x",
                                                     "@positionVS.z",
                                                     "@normalVS.x",
                                                     "SceneColor(@uv0).x",
                                                     "SceneDepth(@uv0)",
                                                     "@screenUV.x",
                                                     "@objectPositionWS.x",
                                                     "@vertexColor.r",
                                                     "@tangentWS.x",
                                                     "@viewDirWS.x"};
    return kValues;
}

// Graphs that read the value in every place from where a stage is made.
std::vector<std::string> graphs(const std::string& value) {
    const std::string lit = R"({ "patina": 1, "workflow": "metallic-smoothness", )";
    return {lit + R"("vertex": { "positionOS": "= @positionOS * )" + value +
                R"(" }, "surface": { "baseColor": 0.5 }, "render": { "bounds": 1 } })",
            lit + R"("nodes": [ { "id": "pinned", "stage": "vertex", "expr": ")" + value +
                R"(" } ], "surface": { "metallic": "pinned" } })",
            lit + R"("surface": { "baseColor": "= float3(1) * )" + value + R"("
    }
})",
            lit + R"("surface": { "emission": "= float3(1) * )" + value + R"("
}
})",
            lit + R"("surface": { "alpha": "= )" + value + R"(" }, "render": { "surface": "cutout" } })",
            lit + R"("surface": { "alpha": "= )" + value + R"(" }, "render": { "surface": "fade" } })",
            lit + R"("lighting": { "direct": "= @surface.diffuseColor * @light.radiance * )" + value +
                R"(" }, "surface": { "baseColor": 0.5 } })",
            lit + R"("surface": { "baseColor": 0.5 }, "passes": [ { "name": "extra", "workflow": "unlit",
                "surface": { "color": "= float3(1) * )" +
                value + R"("
}
, "render" : {
    "surface" : "additive"
}
} ]
})"};
}

// "float4 lightPosition[16];", "UNITY_DECLARE_TEXCUBE(environmentMap);"
bool declares(const std::string& text, const std::string& name) {
    return has(text, " " + name + ";") || has(text, " " + name + "[") || has(text, "(" + name + ");");
}

TEST(UnitySeam, LeavesNothingThatOnlyPatinasEngineFills) {
    const std::vector<std::string> engine = engine_values();
    EXPECT_GT(engine.size(), 25u);
    int written = 0, refused = 0;
    for (const std::string& value : values()) {
        for (const std::string& graph : graphs(value)) {
            const Result result = of_text(graph);
            for (const Diagnostic& d : result.diagnostics) {
                if (!has(d.message, " stage reads '")) continue;
                EXPECT_TRUE(d.code == "pass-refused" || d.code == "pass-left-out") << to_text(d);
                EXPECT_GT(d.column, 50) << to_text(d) << graph;
            }
            ++(result.ok ? written : refused);
            if (!result.ok) continue;
            const std::string& text = result.shaders.front().text;
            for (const std::string& name : engine) EXPECT_FALSE(declares(text, name)) << name << "\n" << graph;
        }
    }
    EXPECT_GT(written, 90);
    EXPECT_GT(refused, 15);
}

// Lights have no place at the vertices there: each pass has another one, and the shadow caster has none.
TEST(UnitySeam, HasNoLightAtTheVertices) {
    const Result result = of_text(graphs("@light.direction.x").front());
    EXPECT_FALSE(result.ok);
    EXPECT_TRUE(result.shaders.empty());
    EXPECT_EQ(first_error(result).code, "pass-refused");
    EXPECT_EQ(first_error(result).line, 1);
    EXPECT_EQ(first_error(result).column, 77) << to_text(first_error(result));
    EXPECT_TRUE(has(first_error(result).message, "its vertex stage reads '@light'"));
}

// What only the first pass has may be read by what only the first pass shows.
TEST(UnitySeam, LeavesEmissionToTheFirstPass) {
    const std::string text = shader(material(R"("surface": { "emission": "glow" },
      "nodes": [ { "id": "glow", "node": "AmbientIrradiance", "in": { "normal": "@normalWS" } } ])"));
    const std::size_t begin = text.find(R"("LightMode" = "ForwardAdd")"), end = text.find("ENDCG", begin);
    ASSERT_LT(end, text.size()) << text;
    const std::string added = text.substr(begin, end - begin);
    EXPECT_TRUE(has(text, "float3 glow = LinearColor(WhiteLight(")) << text;
    EXPECT_TRUE(has(added, " lightingSurfaceForwardDelta(")) << text;
    EXPECT_FALSE(has(added, "WhiteLight(")) << text;
    EXPECT_FALSE(has(added, "emission")) << text;
}

}  // namespace
}  // namespace patina::unity
