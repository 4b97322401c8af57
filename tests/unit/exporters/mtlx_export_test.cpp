// Materials as MaterialX documents: a document that is imported again computes what the graph computes. The CPU
// computes both at some points, with the same textures.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>

#include "compiler/importers/importer.h"
#include "patina/export_mtlx.h"
#include "patina/interpret.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

fs::path folder() {
    const fs::path made = fs::path(testing::TempDir()) / fmt::format("mtlx_export_{}", getpid());
    fs::create_directories(made);
    return made;
}
std::string save(const std::string& name, const std::string& text) {
    std::ofstream(folder() / name, std::ios::binary) << text;
    return (folder() / name).string();
}
std::string errors(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& each : diagnostics)
        if (each.severity == Severity::Error) text += to_text(each) + "\n";
    return text;
}

// Between 0 and 1, by what it is for.
double number(const std::string& word, std::size_t index) {
    const double x =
        std::sin(static_cast<double>(std::hash<std::string>{}(word) % 1000) + 12.9898 * double(index)) * 437.5;
    return x - std::floor(x);
}

std::shared_ptr<const TextureData> texture_of(const std::string& name, const Sampler& sampler) {
    auto made = std::make_shared<TextureData>();
    TextureLevel level{.width = 8, .height = 8, .texels = {}};
    for (std::size_t i = 0; i < 4 * 8 * 8; ++i) level.texels.push_back(static_cast<float>(number(name, i)));
    made->levels.push_back(std::move(level));
    made->sampler = sampler;
    return made;
}

using Values = std::map<std::string, std::vector<double>>;

// What the surface has, by its inputs, at one point.
Values values_of(const Result& result, std::size_t point) {
    Interpreter fragment(*result.program, "forward", Stage::Fragment, Precision::Double);
    for (const Texture& each : result.reflection.textures)
        fragment.set_texture(each.identifier,
                             texture_of(fs::path(each.default_file).filename().string(), each.sampler));
    for (const Texture& each : result.reflection.textures)
        if (!each.tiling.empty()) fragment.set_value(each.tiling, each.tiling_default);
    for (const Property& each : result.reflection.properties) fragment.set_value(each.identifier, each.value);
    // Turned by a right angle, and twice as long.
    fragment.set_value("objectToWorld", std::vector<double>{0, -1, 0, 3, 2, 0, 0, 4, 0, 0, 1, 5, 0, 0, 0, 1});
    fragment.set_value("worldToObject", std::vector<double>{0, 0.5, 0, -2, -1, 0, 0, 3, 0, 0, 1, -5, 0, 0, 0, 1});
    QuadInputs quad;
    for (std::vector<double>& lane : quad.lanes)
        for (const StageValue& each : fragment.inputs())
            for (unsigned i = 0; i < each.components; ++i)
                lane.push_back(each.is_builtin ? 1 : number(each.name, 7 * point + i));
    Values made;
    for (const TracedValue& each : fragment.trace(quad, 0))
        if (each.kind == TracedValue::Kind::Output && each.graph == "material" && each.node == "surface")
            made[each.port] = each.values;
    return made;
}

void expect_same(const std::string& graph) {
    const Compiler compiler;
    const MtlxExport made = export_mtlx(compiler, graph, {.folder = folder().string()});
    ASSERT_TRUE(made.ok) << graph << "\n" << errors(made.diagnostics);
    const std::string document = save("x.mtlx", made.text);
    const importers::Source source{.path = document, .start = made.text.substr(0, importers::kStart)};
    const importers::Importer* const importer = importers::importer_of(source);
    ASSERT_TRUE(importer) << made.text;
    const importers::Imported imported = importers::read_verified(*importer, source, {.folder = folder().string()});
    ASSERT_EQ(imported.error, "") << made.text;
    ASSERT_GE(imported.graphs.size(), 1u);
    for (const importers::TextFile& each : imported.graphs) save(each.name, each.text);
    EXPECT_FALSE(imported.has_refused) << made.text;
    for (const importers::Remark& each : imported.remarks)
        EXPECT_NE(each.kind, importers::Remark::Kind::LeftOut) << each.part << ": " << each.text;
    const std::string again = save("again.graph.json", imported.graphs[0].text);

    CompileOptions options;
    options.targets.clear();
    options.keep_programs = true;
    // A document has no vertex stage.
    std::ifstream file(graph, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    const std::string unpinned = std::regex_replace(text, std::regex(R"x(,\s*"stage": "vertex")x"), "");
    const Result before = compiler.compile_text(graph, unpinned, options),
                 after = compiler.compile_file(again, options);
    ASSERT_TRUE(before.ok) << graph << "\n" << errors(before.diagnostics);
    ASSERT_TRUE(after.ok) << imported.graphs[0].text << "\n" << errors(after.diagnostics);
    std::size_t compared = 0;
    for (std::size_t point = 0; point < 5; ++point) {
        const Values old_values = values_of(before, point), new_values = values_of(after, point);
        for (const auto& [input, expected] : old_values) {
            const auto found = new_values.find(input);
            if (found == new_values.end()) continue;
            // What the graph does not set is the lighting model's, which may be another one. Opaque surfaces ignore
            // alpha.
            const bool is_opaque = input == "alpha" && made.text.find("alpha_mode") == std::string::npos &&
                                   made.text.find("\"opacity\"") == std::string::npos;
            const bool is_set = text.find("\"" + input + "\": ") != std::string::npos || input == "normalWS";
            if (!is_set || is_opaque) continue;
            ASSERT_EQ(found->second.size(), expected.size()) << input;
            for (std::size_t i = 0; i < expected.size(); ++i, ++compared)
                EXPECT_NEAR(found->second[i], expected[i], 2e-5 * std::max(1.0, std::abs(expected[i])))
                    << fs::path(graph).filename() << " " << input << "[" << i << "] at point " << point << "\n"
                    << made.text << "\n"
                    << imported.graphs[0].text;
            if (testing::Test::HasFailure()) return;
        }
    }
    EXPECT_GE(compared, 5u);
}

// A material with these nodes and this surface.
std::string material(const std::string& surface, const std::string& nodes = {}) {
    for (const char* picture : {"paint.png", "data.png", "bumps.png"}) save(picture, "no picture");
    return fmt::format(R"json({{
  "patina": 1, "kind": "material", "name": "tested", "workflow": "metallic-roughness", "lighting": "gltf",
  "properties": [
    {{ "name": "_Paint", "type": "texture2d", "usage": "color", "default": "./paint.png" }},
    {{ "name": "_Data", "type": "texture2d", "usage": "data", "default": "./data.png", "sampler": {{ "wrap": "clamp", "filter": "nearest" }} }},
    {{ "name": "_Bumps", "type": "texture2d", "usage": "normal", "default": "./bumps.png" }},
    {{ "name": "_Tint", "type": "color", "default": "#c0a080", "label": "Tint", "group": "Paint" }},
    {{ "name": "_Amount", "type": "float", "default": 0.375, "range": [0, 1], "help": "how much" }}
  ],
  "nodes": [ {} ],
  "surface": {{ {} }}
}})json",
                       nodes, surface);
}

TEST(MtlxExport, ConstantsAndProperties) {
    expect_same(
        save("c.graph.json", material(R"x("baseColor": "= $_Tint.rgb * 0.5", "roughness": "$_Amount", "metallic": 0.25,
                                 "emission": [0.1, 0.2, 3], "clearcoat": 0.5, "occlusion": "= 1 - $_Amount")x")));
}

TEST(MtlxExport, PicturesAreTurned) {
    for (const std::string uv : {"@uv0", "= @uv0 * 3", "= @uv0 * float2(2, 3.5) + float2(0.25, 0.125)", "@uv1",
                                 "= @uv0.yx * $_Amount", "= frac(@uv0 * 4)"}) {
        for (const std::string texture : {"$_Paint", "$_Data"})
            expect_same(save(
                "p.graph.json",
                material(
                    R"x("baseColor": "= paint.rgb", "roughness": "= paint.a", "metallic": "= paint.g")x",
                    fmt::format(
                        R"x({{ "id": "paint", "node": "SampleTexture2D", "in": {{ "texture": "{}", "uv": "{}" }} }})x",
                        texture, uv))));
    }
}

// A texture slot that has no picture yet.
TEST(MtlxExport, TexturesWithoutAPictureStayProperties) {
    const Compiler compiler;
    for (const std::string usage : {"color", "data"}) {
        for (const std::string shown : {"white", "black", "gray", "bump"}) {
            if (usage == "color" && shown == "bump") continue;
            const std::string property = fmt::format(R"({{ "name": "_Slot", "type": "texture2d", {}"default": "{}" }})",
                                                     usage == "color" ? "" : R"("usage": "data", )", shown);
            const std::string graph = save(
                "slots.graph.json",
                fmt::format(
                    R"({{"patina": 1, "kind": "material", "name": "slots", "workflow": "metallic-roughness", "properties": [{}],
"nodes": [{{ "id": "slot", "node": "SampleTexture2D", "in": {{ "texture": "$_Slot" }} }}], "surface": {{ "baseColor": "slot.rgb" }}}})",
                    property));
            const MtlxExport made = export_mtlx(compiler, graph, {.folder = folder().string()});
            ASSERT_TRUE(made.ok) << errors(made.diagnostics);
            const importers::Source source{.path = save("x.mtlx", made.text), .start = {}};
            const importers::Imported imported = importers::read_verified(*importers::importer_of(source), source, {});
            ASSERT_GE(imported.graphs.size(), 1u) << imported.error;
            EXPECT_NE(imported.graphs[0].text.find(property), std::string::npos)
                << property << made.text << imported.graphs[0].text;
        }
    }
}

TEST(MtlxExport, NormalMaps) {
    const std::string nodes =
        R"x({ "id": "bumps", "node": "SampleNormalMap", "in": { "texture": "$_Bumps", "uv": "= @uv0 * 2", "scale": "$_Amount" } })x";
    for (const std::string normal :
         {"bumps", "= normalize(bumps + float3(0.25, 0, 1))", "= NormalBlend(bumps, float3(0, 0.6, 0.8))"})
        expect_same(save("n.graph.json", material(fmt::format(R"x("normalTS": "{}")x", normal), nodes)));
}

// Each expression, as a base colour.
TEST(MtlxExport, Expressions) {
    for (const std::string color : {"p.rgb + 0.5",
                                    "p.rgb - q.rgb * 2",
                                    "p.rgb / (q.rgb + 1)",
                                    "-p.bgr",
                                    "float3(p.rg, 1)",
                                    "p.rrr",
                                    "fmod(p.rgb * 5, 0.7)",
                                    "frac(p.rgb * 7)",
                                    "lerp(p.rgb, q.rgb, p.a)",
                                    "lerp(p.rgb, q.rgb, q.bgr)",
                                    "lerp(p.rgb, 1, 0.25)",
                                    "clamp(p.rgb, 0.2, 0.7)",
                                    "saturate(p.rgb * 3 - 1)",
                                    "min(p.rgb, q.rgb)",
                                    "max(p.rgb, 0.5)",
                                    "pow(p.rgb, 2.2)",
                                    "sqrt(p.rgb)",
                                    "rsqrt(p.rgb + 1)",
                                    "exp(p.rgb)",
                                    "exp2(q.rgb)",
                                    "log(p.rgb + 1)",
                                    "log2(p.rgb + 1)",
                                    "sin(p.rgb * 9)",
                                    "cos(p.rgb)",
                                    "tan(p.rgb)",
                                    "asin(p.rgb)",
                                    "acos(p.rgb)",
                                    "float3(atan(p.r), atan2(p.g - 0.5, p.b - 0.5), tanh(q.r))",
                                    "abs(p.rgb - 0.5)",
                                    "sign(p.rgb - 0.5)",
                                    "floor(p.rgb * 4)",
                                    "ceil(p.rgb * 4)",
                                    "round(p.rgb * 4)",
                                    "trunc(p.rgb * 4 - 2)",
                                    "smoothstep(0.2, 0.8, p.rgb)",
                                    "step(0.5, p.rgb)",
                                    "normalize(p.rgb)",
                                    "cross(p.rgb, q.rgb)",
                                    "reflect(p.rgb, normalize(q.rgb))",
                                    "float3(dot(p.rgb, q.rgb), length(p.rg), distance(p.rgb, q.rgb))",
                                    "dot(p, q).xxx",
                                    "p.r > 0.5 ? p.rgb : q.rgb",
                                    "p.r <= q.r && p.g > 0.3 ? p.rgb : 0.25",
                                    "!(p.r < q.r) || p.b == 0.5 ? p.rgb : q.rgb",
                                    "radians(p.rgb * 90)",
                                    "degrees(p.rgb)",
                                    "float3(@uv0, @uv1.x)",
                                    "@positionWS + @normalOS",
                                    "@normalWS * 0.5 + 0.5",
                                    "@viewDirWS * p.r",
                                    "@vertexColor.rgb * p.a",
                                    "sin(@time) * p.rgb",
                                    "RgbToHsv(p.rgb)",
                                    "HsvToRgb(p.rgb)",
                                    "Remap(p.rgb, 0.2, 0.7, 0, 2)",
                                    "Rotate(@uv0, 0.5).xyx",
                                    "BlendColors(p.rgb, q.rgb, 0.75, Overlay)"}) {
        SCOPED_TRACE(color);
        expect_same(
            save("e.graph.json", material(fmt::format(R"x("baseColor": "= {}")x", color),
                                          R"x({ "id": "p", "node": "SampleTexture2D", "in": { "texture": "$_Paint" } },
                                     { "id": "q", "node": "SampleTexture2D", "in": { "texture": "$_Data", "uv": "@uv1" } })x")));
    }
}

TEST(MtlxExport, OtherModels) {
    const std::string nodes = R"x("nodes": [ { "id": "g", "expr": "frac(@uv0.x * 3)" } ])x";
    const auto graph = [&](const std::string& head, const std::string& surface) {
        return fmt::format(R"x({{ "patina": 1, "kind": "material", "name": "m", {}, {}, "surface": {{ {} }} }})x", head,
                           nodes, surface);
    };
    expect_same(save(
        "o.graph.json",
        graph(R"x("workflow": "metallic-roughness", "lighting": "openpbr")x",
              R"x("baseColor": "= g.xxx", "emission": "= float3(g, 0, 2)", "coatWeight": "g", "fuzzWeight": 0.5)x")));
    expect_same(save("u.graph.json", graph(R"x("workflow": "unlit", "render": { "surface": "fade" })x",
                                           R"x("color": "= float3(g, 1, 0)", "alpha": "g")x")));
    expect_same(
        save("s.graph.json",
             graph(R"x("workflow": "specular-glossiness", "lighting": "gltf")x",
                   R"x("baseColor": [0.1, 0.2, 0.3], "specular": "= g * float3(0.5, 1, 1)", "glossiness": "g")x")));
    expect_same(
        save("a.graph.json",
             graph(R"x("workflow": "metallic-roughness", "lighting": "gltf", "render": { "surface": "cutout" })x",
                   R"x("alpha": "g", "alphaClip": 0.25)x")));
}

TEST(MtlxExport, WholeNumbersSwitchesAndChoices) {
    expect_same(save("f.graph.json", R"json({
  "patina": 1, "kind": "material", "name": "f", "workflow": "metallic-roughness", "lighting": "gltf",
  "properties": [
    { "name": "_Wet", "type": "bool", "default": true },
    { "name": "_Count", "type": "int", "default": 3, "range": [1, 8] },
    { "name": "_Mode", "type": "enum", "values": ["Dry", "Damp", "Soaked"], "default": "Damp" },
    { "name": "_Depth", "type": "float", "default": 0.25, "as": "instance" },
    { "name": "_Far", "type": "bool", "default": false, "as": "variant" }
  ],
  "nodes": [ { "id": "squares", "node": "Checkerboard", "in": { "scale": "= float($_Count)" } },
             { "id": "corner", "expr": "@uv0.x * $_Depth", "stage": "vertex" } ],
  "surface": {
    "baseColor": "= $_Mode == Damp ? float3(1, squares, 0) : float3(0, corner, 1)",
    "roughness": "= $_Wet && squares > 0.5 ? $_Depth : 0.5",
    "metallic": "= $_Far ? 1 : float($_Count & 3) * 0.25",
    "emission": "= corner.xxx"
  }
})json"));
}

TEST(MtlxExport, NoiseBecomesNoiseAgain) {
    std::string nodes, inputs;
    const std::pair<std::string, std::string> noises[] = {{"noise2d", "roughness"},
                                                          {"noise3d", "metallic"},
                                                          {"fractal2d", "clearcoat"},
                                                          {"fractal3d", "base_color"},
                                                          {"cellnoise2d", "specular"},
                                                          {"cellnoise3d", "occlusion"},
                                                          {"worleynoise2d", "clearcoat_roughness"},
                                                          {"worleynoise3d", "transmission"}};
    for (const auto& [noise, input] : noises) {
        const std::string type = input == "base_color" ? "color3" : "float";
        const std::string more =
            noise == "fractal3d" ? R"(<input name="octaves" type="integer" interfacename="layers"/>)" : "";
        nodes += fmt::format(R"(<{0} name="a_{0}" type="{1}">{2}</{0}>)", noise, type, more);
        nodes += fmt::format(R"(<output name="o_{0}" type="{1}" nodename="a_{0}"/>)", noise, type);
        inputs += fmt::format(R"(<input name="{}" type="{}" nodegraph="g" output="o_{}"/>)", input, type, noise);
    }
    const std::string document = save(
        "noise.mtlx",
        fmt::format(
            R"(<materialx version="1.39"><nodegraph name="g"><input name="layers" type="integer" value="2"/>{}</nodegraph><gltf_pbr name="s" type="surfaceshader">{}</gltf_pbr>
<surfacematerial name="noisy" type="material"><input name="surfaceshader" type="surfaceshader" nodename="s"/></surfacematerial></materialx>)",
            nodes, inputs));
    const importers::Source source{.path = document, .start = "<materialx"};
    const importers::Imported made =
        importers::read_verified(*importers::importer_of(source), source, {.folder = folder().string()});
    for (const importers::TextFile& each : made.graphs) save(each.name, each.text);
    const std::string graph = (folder() / "noisy.graph.json").string();
    const MtlxExport again = export_mtlx(Compiler(), graph);
    for (const auto& [noise, input] : noises)
        EXPECT_NE(again.text.find("<" + noise + " "), std::string::npos) << noise << errors(again.diagnostics);
    expect_same(graph);
}

// A function of the library that MaterialX has, too, is that node, and functions that are made of it contain it.
TEST(MtlxExport, NodesThatMaterialXHasStayOneNode) {
    const std::pair<std::string, std::string> nodes[] = {
        {"= float3(PerlinNoise2D(@uv0 * 3))", "noise2d"},
        {"= PerlinNoise3DVector(@positionOS)", "noise3d"},
        {"= float3(GradientNoise3D(@positionOS, 5))", "noise3d"},
        {"= float3(PerlinFractal2D(@uv0 * 5, 3, 2.5))", "fractal2d"},
        {"= float3(CellNoise2D(@uv0 * 8))", "cellnoise2d"},
        {"= float3(FractalNoise3D(@positionOS, 5, 3, 2, 0.5, Ridged))", "noise3d"},
        {"= float3(ValueNoise3D(@positionOS, 5))", "cellnoise3d"},
        {"= float3(ValueNoise3DTiled(@positionOS, 5))", "cellnoise3d"},
        {"= WorleyNoise2D(@uv0 * 4, 0.5)", "worleynoise2d"},
        {"= WorleyNoise3D(@positionOS, 1, Cell)", "worleynoise3d"},
        {"= WorleyNoise3D(@positionOS, 0.75, CellVector)", "worleynoise3d"},
        {"= float3(Checkerboard(@uv0, float2(3, 5)))", "checkerboard"},
        {"= RgbToHsv($_Tint.rgb * @uv0.x)", "rgbtohsv"},
        {"= HsvToRgb(float3(@uv0, 0.5))", "hsvtorgb"},
        {"= HsvAdjust($_Tint.rgb, @uv0.x, $_Amount, 0.5)", "hsvadjust"},
        {"= float3(Luminance($_Tint.rgb * @uv0.x))", "luminance"},
        {"= Saturation($_Tint.rgb, @uv0.x)", "saturate"},
        {"= Contrast($_Tint.rgb, @uv0.x, 0.25)", "contrast"},
        {"= float3(Remap(@uv0.x, 0.25, 0.75, 1, $_Amount))", "remap"},
        {"= Remap($_Tint.rgb, float3(0.25), float3(0.75), float3(1), float3(@uv0, 0))", "remap"},
    };
    for (const auto& [expression, category] : nodes) {
        SCOPED_TRACE(expression);
        const std::string graph = save("n.graph.json", material("\"baseColor\": \"" + expression + "\""));
        const MtlxExport made = export_mtlx(Compiler(), graph, {.folder = folder().string()});
        EXPECT_TRUE(made.ok) << errors(made.diagnostics);
        EXPECT_NE(made.text.find("<" + category + " "), std::string::npos) << made.text;
        expect_same(graph);
    }
}

// Programs read the colour space of a picture at the node that reads it, and not at the input of the node graph.
TEST(MtlxExport, ColourSpacesStandWherePicturesAreRead) {
    const Compiler compiler;
    const MtlxExport made = export_mtlx(
        compiler,
        save("s.graph.json", material(R"x("baseColor": "= paint.rgb", "roughness": "= data.r")x",
                                      R"x({ "id": "paint", "node": "SampleTexture2D", "in": { "texture": "$_Paint" } },
                          { "id": "data", "node": "SampleTexture2D", "in": { "texture": "$_Data" } })x")),
        {.folder = folder().string()});
    const auto has = [&](const std::string& text) { return made.text.find(text) != made.text.npos; };
    EXPECT_TRUE(has(R"x(<input name="file" type="filename" colorspace="srgb_texture" interfacename="_Paint" />)x"))
        << made.text;
    EXPECT_TRUE(has(R"x(<input name="file" type="filename" interfacename="_Data" />)x")) << made.text;
    EXPECT_TRUE(has(R"x(<input name="_Paint" type="filename" value="paint.png" colorspace="srgb_texture" />)x"))
        << made.text;
}

// Each example is a document that computes the same, or is refused where its reason is.
TEST(MtlxExport, Examples) {
    const Compiler compiler;
    std::size_t exported = 0, refused = 0;
    std::vector<std::string> paths;
    for (const std::string_view each : {"graphs", "surfaces", "sources"})
        for (const fs::directory_entry& entry : fs::directory_iterator(fs::path("examples") / each))
            if (entry.path().string().ends_with(".graph.json")) paths.push_back(entry.path().string());
    for (const std::string& path : paths) {
        SCOPED_TRACE(path);
        const MtlxExport made = export_mtlx(compiler, path, {.folder = folder().string()});
        if (made.ok) {
            expect_same(path);
            ++exported;
            continue;
        }
        ++refused;
        EXPECT_EQ(made.text, "");
        for (const Diagnostic& diagnostic : made.diagnostics) {
            EXPECT_GT(diagnostic.line, 1) << to_text(diagnostic);
            if (diagnostic.severity == Severity::Error) {
                EXPECT_EQ(diagnostic.code, "no-counterpart");
            }
        }
    }
    EXPECT_GE(5 * exported, 4 * (exported + refused)) << refused << " are refused";
    EXPECT_GE(refused, 5u);
}

// MaterialX has no derivatives: the edge is where it was, and sharp.
TEST(MtlxExport, EdgesThatAreOnePixelWideAreSharp) {
    const Compiler compiler;
    for (
        const std::string& node :
        {std::string(R"x({ "id": "mask", "node": "SdfMask", "in": { "value": "= length(@uv0 - 0.5) - 0.25" } })x"),
         std::string(R"x({ "id": "mask", "node": "Rectangle" })x"),
         std::string(R"x({ "id": "mask", "node": "CheckerboardUnity", "in": { "scale": 4 } })x"),
         std::string(R"x({ "id": "mask", "expr": "smoothstep(0.5 - 2 * fwidth(@uv0.x), 0.5, @uv0.x)" })x"),
         std::string(
             R"x({ "id": "mask", "expr": "smoothstep(0.5 - 0.7 * length(float2(ddx(@uv0.x), ddy(@uv0.x))), 0.5 + 0.7 * length(float2(ddx(@uv0.x), ddy(@uv0.x))), @uv0.x)" })x")}) {
        SCOPED_TRACE(node);
        const std::string read = node.find("Checkerboard") == node.npos ? "mask" : "mask.r";
        const std::string graph = save("w.graph.json", material("\"roughness\": \"" + read + "\"", node));
        const MtlxExport made = export_mtlx(compiler, graph, {.folder = folder().string()});
        EXPECT_TRUE(made.ok) << errors(made.diagnostics);
        ASSERT_GE(made.diagnostics.size(), 1u);
        EXPECT_EQ(made.diagnostics[0].code, "export-differs");
        EXPECT_EQ(made.diagnostics[0].line, 10);
        EXPECT_NE(made.diagnostics[0].message.find("an edge is not smoothed over a pixel"), std::string::npos)
            << made.diagnostics[0].message;
        expect_same(graph);
    }
    // A width that is not that of an edge has no counterpart.
    for (const std::string expression : {"max(fwidth(@uv0.x), fwidth(@uv0.y))", "max(fwidth(@uv0.x) * @uv0.y, 0.1)",
                                         "smoothstep(0, fwidth(@uv0.x), @uv0.x)"}) {
        const std::string node = R"x({ "id": "mask", "expr": ")x" + expression + "\" }";
        EXPECT_FALSE(export_mtlx(compiler, save("w.graph.json", material(R"x("roughness": "mask")x", node)),
                                 {.folder = folder().string()})
                         .ok)
            << expression;
    }
}

TEST(MtlxExport, WhatHasNoCounterpartIsReportedWhereItIs) {
    const Compiler compiler;
    const MtlxExport made = export_mtlx(
        compiler,
        save("w.graph.json", material(R"x("roughness": "slope")x", R"x({ "id": "slope", "expr": "ddx(@uv0.x)" })x")));
    EXPECT_FALSE(made.ok);
    EXPECT_EQ(made.text, "");
    ASSERT_EQ(made.diagnostics.size(), 1u) << errors(made.diagnostics);
    EXPECT_EQ(made.diagnostics[0].code, "no-counterpart");
    EXPECT_EQ(made.diagnostics[0].line, 10);
}

}  // namespace
}  // namespace patina
