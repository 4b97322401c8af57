// Models as a whole: the scene, its camera, lights and variants; that every property has a remark; and broken files,
// which are refused at their place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/importers/importer.h"
#include "compiler/json/json.h"
#include "patina/patina.h"
#include "tests/unit/importers/gltf/gltf_writer.h"

namespace patina::importers {
namespace {

Imported import(const std::string& path, const Options& options = {}) {
    const Source source{.path = path, .start = {}};
    return read_verified(*importer_of(source), source, options);
}

// The scene of the file, read as patina reads it.
SceneFile scene_of(const Imported& made, const std::string& name = {}) {
    EXPECT_EQ(made.error, "");
    CompileOptions options;
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        for (const TextFile& file : made.graphs)
            if (file.name == path) return file.text;
        return std::nullopt;
    };
    static const Compiler compiler;
    const SceneResult read = compiler.read_scene(name.empty() ? made.scene : name, options);
    for (const Diagnostic& each : read.diagnostics) ADD_FAILURE() << to_text(each);
    return read.scene;
}

void expect_near(const SceneVector& made, const SceneVector& expected, double tolerance = 1e-5) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(made[i], expected[i], tolerance) << i;
}

TEST(GltfImport, AnObjectIsAPrimitiveOfANode) {
    const Imported made = import(save_gltf({.nodes = R"([{"children":[1,2]},{"name":"left","mesh":0},
                                                         {"name":"left","mesh":0,"translation":[3,0,0]}])"}));
    const SceneFile scene = scene_of(made);
    ASSERT_EQ(scene.objects.size(), 2u);
    // Two nodes have the same name, so their numbers tell them apart.
    EXPECT_EQ(scene.objects[0].mesh, "./square.gltf#node 1/0");
    EXPECT_EQ(scene.objects[1].mesh, "./square.gltf#node 2/0");
    EXPECT_EQ(scene.objects[0].id, "left");
    EXPECT_EQ(scene.objects[1].id, "left_2");
    // No mesh names a material: the specification's default one.
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].graph.path, "default.graph.json");
    // Both squares are in the view: from x = -1 to 4.
    expect_near(scene.camera.target, {1.5, 0, 0}, 1e-2);
}

TEST(GltfImport, AFileOfMaterialsHasNoScene) {
    const Imported made = import(save_gltf({.materials = R"([{"name":"Paint"}])", .nodes = "[{}]"}));
    EXPECT_EQ(made.error, "");
    ASSERT_EQ(made.graphs.size(), 1u);
    EXPECT_EQ(made.graphs[0].name, "Paint.graph.json");
    EXPECT_EQ(made.scene, "");
}

TEST(GltfImport, TheFirstCameraIsTheScenes) {
    const std::string path =
        save_gltf({.nodes = R"([{"mesh":0,"children":[1,2]},{"name":"front","camera":0,"translation":[0,0,5]},
                      {"name":"top","camera":1,"translation":[0,4,0],"rotation":[-0.70710678,0,0,0.70710678]}])",
                   .more = R"("cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.25,"zfar":50}},
                              {"type":"orthographic","name":"map","orthographic":{"xmag":1,"ymag":2,"znear":1,"zfar":9}}])"});
    const SceneCamera front = scene_of(import(path)).camera;
    expect_near(front.position, {0, 0, 5});
    expect_near(front.target, {0, 0, 0});
    EXPECT_NEAR(front.fov, 0.5 * 180 / std::acos(-1.0), 1e-3);
    EXPECT_NEAR(front.near_plane, 0.25, 1e-6);
    EXPECT_NEAR(front.far_plane, 50, 1e-6);
    for (const char* name : {"top", "map"}) {
        const SceneCamera top = scene_of(import(path, {.camera = name})).camera;
        expect_near(top.position, {0, 4, 0});
        EXPECT_NEAR(top.target[0], 0, 1e-5);
        EXPECT_LT(top.target[1], 4);
        EXPECT_NEAR(top.target[2], 0, 1e-5);
        EXPECT_NEAR(top.orthographic.value_or(0), 4, 1e-6);
    }
    EXPECT_NE(import(path, {.camera = "none"}).error.find("has no camera 'none'; these exist: front and top"),
              std::string::npos);
}

// What a scene's keys do not take: numbers are brought within their limits where the picture stays the same, and the
// file is refused where it does not.
TEST(GltfImport, AViewThatNoSceneCanSayIsRefused) {
    const auto with_camera = [](const std::string& place, const std::string& lens) {
        return import(save_gltf(
            {.nodes = R"([{"mesh":0,"children":[1]},{"name":"front","camera":0,"translation":)" + place + "}]",
             .more = R"("cameras":[)" + lens + "]"}));
    };
    const std::string lens = R"({"type":"perspective","perspective":{"yfov":0.5,"znear":1e-20,"zfar":1e20}})";
    const SceneCamera camera = scene_of(with_camera("[0,0,5]", lens)).camera;
    EXPECT_NEAR(camera.near_plane, 1e-4, 1e-6);
    EXPECT_NEAR(camera.far_plane, 1e7, 1);
    const SceneCamera flat = scene_of(with_camera("[0,0,5]", R"({"type":"orthographic","orthographic":{"xmag":1e-20,
        "ymag":1e-20,"znear":0,"zfar":9}})"))
                                 .camera;
    EXPECT_NEAR(flat.orthographic.value_or(0), 1e-3, 1e-6);
    EXPECT_NE(with_camera("[0,0,5e7]", lens).error.find("away from the origin"), std::string::npos);
    EXPECT_NE(with_camera("[0,0,1e38]", lens).error.find("away from the origin"), std::string::npos);
    for (const char* scale : {"1e8", "1e-20"}) {
        const Imported made = import(
            save_gltf({.nodes = std::string(R"([{"mesh":0,"scale":[)") + scale + "," + scale + "," + scale + "]}]"}));
        EXPECT_NE(made.error.find(": scale the model"), std::string::npos) << scale << made.error;
        EXPECT_TRUE(made.graphs.empty());
    }
    const Imported lit =
        import(save_gltf({.nodes = R"([{"mesh":0,"children":[1]},{"name":"lamp","translation":[0,9e9,0],
        "extensions":{"KHR_lights_punctual":{"light":0}}}])",
                          .more = R"("extensions":{"KHR_lights_punctual":{"lights":
        [{"type":"point"}]}})"}));
    EXPECT_NE(lit.error.find("the light at the node 'lamp'"), std::string::npos) << lit.error;
}

// A turn of 30 degrees about the view, which is along -z: what was up is (-sin 30, cos 30, 0).
TEST(GltfImport, ACameraKeepsItsRoll) {
    const std::string path =
        save_gltf({.nodes = R"([{"mesh":0,"children":[1,2,3]},{"name":"rolled","camera":0,"translation":[0,0,5],
                                 "rotation":[0,0,0.25881905,0.96592583]},
                      {"name":"hanging","camera":0,"translation":[0,0,5],"rotation":[0,0,1,0]},
                      {"name":"upright","camera":0,"translation":[0,3,5],"rotation":[-0.25881905,0,0,0.96592583]}])",
                   .more = R"("cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.25,"zfar":50}}])"});
    expect_near(scene_of(import(path, {.camera = "rolled"})).camera.up, {-0.5, 0.8660254037844386, 0});
    expect_near(scene_of(import(path, {.camera = "hanging"})).camera.up, {0, -1, 0});
    EXPECT_EQ(import(path, {.camera = "upright"}).scene.find("\"up\""), std::string::npos);
}

// A white diffuse surface sends out E / pi; a candela is a lux at one metre.
TEST(GltfImport, LightsAreInTheUnitsOfScenes) {
    const double pi = std::acos(-1.0);
    const std::string path =
        save_gltf({.nodes = R"([{"mesh":0,"children":[1,2,3]},{"extensions":{"KHR_lights_punctual":{"light":0}}},
                      {"translation":[1,2,3],"extensions":{"KHR_lights_punctual":{"light":1}}},
                      {"rotation":[-0.70710678,0,0,0.70710678],"extensions":{"KHR_lights_punctual":{"light":2}}}])",
                   .more = R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional","intensity":6},
                     {"type":"point","color":[1,0.5,0.25],"intensity":30,"range":7},
                     {"type":"spot","spot":{"innerConeAngle":0.2,"outerConeAngle":0.4}}]}})"});
    const Imported made = import(path);
    const auto text = std::ranges::find(made.graphs, made.scene, &TextFile::name);
    ASSERT_NE(text, made.graphs.end());
    EXPECT_EQ(text->text.find("-0,"), std::string::npos) << text->text;  // a negative zero of the matrices
    const SceneFile scene = scene_of(made);
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(scene.lights[0].type, LightKind::Directional);
    expect_near(scene.lights[0].direction, {0, 0, 1});  // towards the light, which shines along -z
    EXPECT_NEAR(scene.lights[0].intensity, 6 / pi, 1e-5);
    EXPECT_EQ(scene.lights[1].type, LightKind::Point);
    expect_near(scene.lights[1].position, {1, 2, 3});
    expect_near(scene.lights[1].color, {1, 0.5, 0.25});
    EXPECT_NEAR(scene.lights[1].intensity, 30 / pi, 1e-5);
    EXPECT_NEAR(scene.lights[1].range, 7, 1e-6);
    EXPECT_EQ(scene.lights[2].type, LightKind::Spot);
    expect_near(scene.lights[2].direction, {0, -1, 0});
    EXPECT_NEAR(scene.lights[2].inner.value_or(0), 0.2 * 180 / pi, 1e-3);
    EXPECT_NEAR(scene.lights[2].outer.value_or(0), 0.4 * 180 / pi, 1e-3);
}

TEST(GltfImport, EachVariantIsAScene) {
    const std::string path = save_gltf(
        {.materials = R"([{"name":"oak"},{"name":"blue paint"}])",
         .meshes = R"([{"primitives":[{"attributes":{"POSITION":0},"indices":5,"material":0,"extensions":
                       {"KHR_materials_variants":{"mappings":[{"material":1,"variants":[1]}]}}}]}])",
         .more = R"("extensions":{"KHR_materials_variants":{"variants":[{"name":"Oak"},{"name":"Beach"}]}})"});
    const Imported made = import(path);
    EXPECT_EQ(made.scene, "square.scene.json");
    EXPECT_EQ(scene_of(made).materials[0].name, "oak");
    EXPECT_EQ(scene_of(made, "square.Oak.scene.json").materials[0].name, "oak");
    EXPECT_EQ(scene_of(made, "square.Beach.scene.json").materials[0].name, "blue_paint");
    EXPECT_EQ(scene_of(import(path, {.variant = "Beach"})).materials[0].name, "blue_paint");
    EXPECT_NE(import(path, {.variant = "x"}).error.find("has no variant 'x'; these exist: Oak and Beach"),
              std::string::npos);
}

TEST(GltfImport, PicturesAreNamedOrWritten) {
    const std::string png = png_of(1, 1, {255, 0, 0, 255});
    const std::string path =
        save_gltf({.materials = R"([{"name":"a","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}},
                          {"name":"b","pbrMetallicRoughness":{"baseColorTexture":{"index":1}}}])",
                   .textures = R"("textures":[{"source":0},{"source":1}],"images":[{"uri":"wood%20grain.png"},)" +
                               picture_of(png) + "]"});
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::ofstream(folder / "wood grain.png", std::ios::binary) << png;
    const Imported made = import(path, {.folder = (folder / "out").string()});
    ASSERT_EQ(made.error, "");
    EXPECT_NE(made.graphs[0].text.find("\"default\": \"../wood grain.png\""), std::string::npos);
    EXPECT_NE(made.graphs[1].text.find("\"default\": \"./b_baseColor.png\""), std::string::npos);
    ASSERT_EQ(made.copies.size(), 1u);
    EXPECT_EQ(made.copies[0].name, "b_baseColor.png");
    EXPECT_EQ(made.copies[0].bytes, png);
    EXPECT_NE(made.graphs[2].text.find("\"../square.gltf#square/0\""), std::string::npos);
}

TEST(GltfImport, AWrongMimeTypeIsReported) {
    const std::string picture = picture_of(png_of(1, 1, {255, 0, 0, 255}), R"(,"mimeType":"image/webp")");
    const Imported made =
        import(save_gltf({.materials = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])",
                          .textures = R"("textures":[{"source":0}],"images":[)" + picture + "]"}));
    EXPECT_EQ(made.error, "");
    const auto is_it = [](const Remark& remark) {
        return remark.part == "images[0].mimeType" && remark.kind == Remark::Kind::Changed &&
               remark.text == "'image/webp' is wrong: the bytes are a PNG file, 'image/png'";
    };
    EXPECT_EQ(std::count_if(made.remarks.begin(), made.remarks.end(), is_it), 1);
}

// --- nothing is dropped silently

// Every key of the JSON has a remark: of itself, of something inside, or of what it lies in.
void expect_remarks(const json::Json& json, const std::string& path, const Imported& made) {
    const auto lies_in = [](const std::string& part, const std::string& whole) {
        return part == whole || part.starts_with(whole + ".") || part.starts_with(whole + "[");
    };
    for (const json::JsonMember& member : json.members) {
        const std::string part = path.empty() ? member.key : path + "." + member.key;
        const bool has_own = std::any_of(made.remarks.begin(), made.remarks.end(),
                                         [&](const Remark& remark) { return lies_in(part, remark.part); });
        if (has_own) continue;
        EXPECT_TRUE(member.value.kind == json::Json::Kind::Object || member.value.kind == json::Json::Kind::Array)
            << part << " has no remark";
        expect_remarks(member.value, part, made);
    }
    for (std::size_t i = 0; i < json.elements.size(); ++i) {
        const std::string part = path + "[" + std::to_string(i) + "]";
        if (json.elements[i].kind == json::Json::Kind::Object) expect_remarks(json.elements[i], part, made);
    }
}

TEST(GltfImport, EveryPropertyHasARemark) {
    std::string layers;
    for (const char* layer :
         {"clearcoat\":{\"clearcoatFactor\":1,\"clearcoatNew\":1}",
          "sheen\":{\"sheenColorFactor\":[1,1,1],\"sheenNew\":1}", "specular\":{\"specularFactor\":0.5,\"new\":1}",
          "ior\":{\"ior\":1.2,\"new\":1}",
          "anisotropy\":{\"anisotropyStrength\":1,\"anisotropyTexture\":{\"index\":0,\"new\":1}}",
          "iridescence\":{\"iridescenceFactor\":0,\"iridescenceIor\":1.2}", "transmission\":{\"transmissionFactor\":1}",
          "volume\":{\"thicknessFactor\":1,\"attenuationDistance\":2,\"new\":1}", "dispersion\":{\"dispersion\":0.1}",
          "emissive_strength\":{\"emissiveStrength\":2}", "diffuse_transmission\":{\"diffuseTransmissionFactor\":1}"})
        layers += (layers.empty() ? "" : ",") + std::string("\"KHR_materials_") + layer;
    const std::string path = save_gltf(
        {.materials = R"([{"name":"all","new":1,"alphaMode":"MASK","alphaCutoff":0.2,"doubleSided":true,
              "pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.5],"metallicFactor":0,"new":1,"baseColorTexture":{"index":0,
              "texCoord":0,"extensions":{"KHR_texture_transform":{"scale":[2,2],"new":1},"EXT_new":{}}}},
              "normalTexture":{"index":0,"scale":0.5},"occlusionTexture":{"index":0,"strength":0.5},
              "emissiveFactor":[1,1,1],"emissiveTexture":{"index":0},"extras":{"a":1},"extensions":{"EXT_new":{"b":1},)" +
                      layers + R"(}},{"extensions":{"KHR_materials_unlit":{}},"normalTexture":{"index":0}},
              {"extensions":{"KHR_materials_pbrSpecularGlossiness":{"specularGlossinessTexture":{"index":0},"new":1}}}])",
         .nodes = R"([{"name":"square","mesh":0,"scale":[2,2,2],"extensions":{"EXT_new":{}}},{"mesh":0,"camera":0}])",
         .textures =
             R"("samplers":[{"wrapS":33071,"new":1},{}],"textures":[{"source":0,"sampler":0,"new":1},{"source":1}],
                        "images":[)" +
             picture_of(png_of(1, 1, {9, 9, 9, 255}), R"(,"new":1)") + "," + picture_of(png_of(1, 1, {9, 9, 9, 255})) +
             "]",
         .more = R"("cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":1}}],"new":1,
                    "animations":[{"channels":[],"samplers":[]}],"extensions":{"EXT_new":{}},"extensionsUsed":["EXT_new"])"});
    const Imported made = import(path);
    ASSERT_EQ(made.error, "");
    std::ifstream file(path);
    SourceMap sources;
    Diagnostics diagnostics;
    const std::uint32_t begin = sources.add(path, std::string(std::istreambuf_iterator<char>(file), {}));
    const auto root = json::parse_json(sources, begin, diagnostics, json::JsonOf::OtherProgram);
    expect_remarks(*root, "", made);
    // What nobody reads is refused, at its line.
    const auto refused = [&](const std::string& part) {
        return std::any_of(made.remarks.begin(), made.remarks.end(), [&](const Remark& remark) {
            return remark.part == part && remark.kind == Remark::Kind::LeftOut && remark.line > 0;
        });
    };
    for (const char* part : {"materials[0].new",
                             "materials[0].pbrMetallicRoughness.new",
                             "materials[0].extras",
                             "materials[0].extensions.EXT_new",
                             "materials[0].extensions.KHR_materials_clearcoat.clearcoatNew",
                             "materials[0].extensions.KHR_materials_sheen.sheenNew",
                             "materials[0].extensions.KHR_materials_specular.new",
                             "materials[0].extensions.KHR_materials_ior.new",
                             "materials[0].extensions.KHR_materials_anisotropy.anisotropyTexture.new",
                             "materials[0].extensions.KHR_materials_volume.new",
                             "materials[0].pbrMetallicRoughness.baseColorTexture.extensions.EXT_new",
                             "materials[0].pbrMetallicRoughness.baseColorTexture.extensions.KHR_texture_transform.new",
                             "materials[2].extensions.KHR_materials_pbrSpecularGlossiness.new",
                             "nodes[0].extensions.EXT_new",
                             "nodes[1].mesh",
                             "samplers[0].new",
                             "samplers[1]",
                             "textures[0].new",
                             "textures[1]",
                             "images[0].new",
                             "images[1]",
                             "cameras[0]",
                             "animations[0]",
                             "new",
                             "extensions.EXT_new"})
        EXPECT_TRUE(refused(part)) << part;
}

// --- broken files

TEST(GltfImport, BrokenFilesAreRefusedAtTheirPlace) {
    const std::string png = png_of(4, 4, std::vector<int>(64, 7));
    std::string scratched = png;  // in the middle of its pixels
    scratched[scratched.find("IDAT") + 8] ^= 0x55;
    const std::string material = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])";
    const auto with_picture = [&](const std::string& images, const std::string& textures = R"([{"source":0}])") {
        return Square{.materials = material, .textures = "\"textures\":" + textures + ",\"images\":" + images};
    };
    struct Broken {
        Square square;
        std::string error;
    };
    const std::vector<Broken> cases = {
        {with_picture(R"([{"uri":"nowhere.png"}])"), "images[0].uri: the file 'nowhere.png' cannot be read"},
        {with_picture("[" + picture_of(png.substr(0, png.size() - 20)) + "]"),
         "images[0]: is a PNG file without its end"},
        {with_picture("[" + picture_of("\xff\xd8\xff\xe0") + "]"), "images[0]: is a JPEG file without its end"},
        {with_picture("[" + picture_of(scratched) + "]"), "images[0]: is a PNG file whose bytes are damaged"},
        {{.meshes = R"([{"primitives":[{"attributes":{"POSITION":6}}]}])", .has_bytes = true},
         "meshes[0].primitives[0].attributes.POSITION: has whole numbers, which only the extension "
         "KHR_mesh_quantization allows"},
        {with_picture("[" + picture_of("no picture") + "]"), "images[0]: is neither a PNG nor a JPEG file"},
        {with_picture(R"([{"bufferView":0,"mimeType":"image/png"}])"), "images[0]: is neither a PNG nor a JPEG file"},
        {with_picture(R"([{"bufferView":99,"mimeType":"image/png"}])"), "bufferView \"99\" not found"},
        {with_picture("[" + picture_of(png) + "]", R"([{"source":3}])"), "textures[0].source: names images[3]"},
        {with_picture("[" + picture_of(png) + "]", "[]"),
         "materials[0].pbrMetallicRoughness.baseColorTexture.index: names textures[0], and the file has 0"},
        {{.materials = R"([{"alphaMode":7}])"}, "materials[0].alphaMode: is a number, not a string"},
        {{.materials = R"([{"extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":"all"}}}])"},
         "materials[0].extensions.KHR_materials_clearcoat.clearcoatFactor: is a string, not a number"},
        {{.materials = R"([{"extensions":{"KHR_materials_sheen":{"sheenColorFactor":[1,1]}}}])"},
         "materials[0].extensions.KHR_materials_sheen.sheenColorFactor: is not an array of 3 numbers"},
        {{.materials = R"([{"extensions":{"KHR_materials_ior":[]}}])"},
         "materials[0].extensions.KHR_materials_ior: is an array, not an object"},
        {{.meshes = R"([{"primitives":[{"attributes":{"POSITION":0},"indices":5,"material":4}]}])"},
         "meshes[0].primitives[0].material: names materials[4], and the file has 0"},
        {{.meshes = R"([{"primitives":[{"attributes":{"POSITION":9}}]}])"},
         "meshes[0].primitives[0].attributes.POSITION: names accessors[9]"},
        {{.nodes = R"([{"children":[1]},{"children":[0]}])"}, "is its own ancestor"},
        {{.more = R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","intensity":-1}]}})"},
         "extensions.KHR_lights_punctual.lights[0].intensity: is less than 0"},
        {{.more = R"("extensionsRequired":["KHR_texture_basisu"])"},
         "extensionsRequired: 'KHR_texture_basisu' is not supported"},
        {{.more = R"("a":1,"a":2)"}, "'a'"},
    };
    for (const Broken& each : cases) {
        const std::string path = save_gltf(each.square);
        const Imported made = import(path);
        EXPECT_NE(made.error.find(each.error), std::string::npos) << each.error << "\n" << made.error;
        EXPECT_EQ(made.error.rfind(path, 0), 0u) << made.error;
        EXPECT_TRUE(made.graphs.empty() && made.copies.empty());
    }
}

// The bytes of the container are those of glTF 2.0, section 4.4: magic, version, length; then length, kind and data of
// each chunk.
TEST(GltfImport, BrokenContainersAreRefusedAtTheirPlace) {
    const auto number = [](unsigned value) {
        std::string bytes;
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i));
        return bytes;
    };
    struct Broken {
        std::string name, bytes, error;
    };
    const std::string json = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":1000000000}]})";
    const std::string text = json + std::string((4 - json.size() % 4) % 4, ' ');
    const auto size = static_cast<unsigned>(text.size());
    const std::string claim = "glTF" + number(2) + number(32 + size) + number(size) + "JSON" + text + number(4) +
                              std::string("BIN\0", 4) + "abcd";
    const std::vector<Broken> cases = {
        {"cut.glb", "glTF" + number(2) + number(100) + number(80) + "JSON{}",
         "byte 8: the file shall have 100 bytes, and has 22: it is cut off"},
        {"old.glb", "glTF" + number(1) + number(12), "byte 4: version 1 of the container is not read, only 2"},
        {"short.glb", "glTF" + number(2) + number(12), "byte 8: 12 bytes hold no chunk"},
        {"kind.glb", "glTF" + number(2) + number(22) + number(2) + "BIN " + "{}",
         "byte 16: the first chunk is not JSON"},
        {"chunk.glb", "glTF" + number(2) + number(22) + number(90) + "JSON{}",
         "byte 12: the first chunk shall have 90 bytes, and 2 are left"},
        // tinygltf compares with the length of the file without the header of the second chunk.
        {"second.glb",
         "glTF" + number(2) + number(32 + size) + number(size) + "JSON" + text + number(8) + std::string("BIN\0", 4) +
             "abcd",
         "byte " + std::to_string(20 + size) + ": the next chunk shall have 8 bytes, and 4 are left"},
        {"text.gltf", "{ \"asset\": { \"version\": \"2.0\" },\n  \"nodes\": [ { ] ] }", "text.gltf:2:16: broken JSON"},
        {"claim.glb", claim, "buffers[0].byteLength: the buffer shall have 1000000000 bytes, and the chunk BIN has 4"},
        {"empty.gltf", "", "the file is empty"},
        {"tiny.glb", "glTF", "the file has 4 bytes, less than the header of a .glb"},
        {"magic.glb", "XXXX" + number(2) + number(12), "byte 0: it begins neither with 'glTF'"},
    };
    for (const Broken& each : cases) {
        const std::string path = testing::TempDir() + each.name;
        std::ofstream(path, std::ios::binary) << each.bytes;
        const Imported made = import(path);
        EXPECT_NE(made.error.find(each.error), std::string::npos) << each.error << "\n" << made.error;
        EXPECT_EQ(made.error.rfind(path + ":", 0), 0u) << made.error;
        EXPECT_EQ(made.error.find("json.exception"), std::string::npos) << made.error;
        EXPECT_TRUE(made.graphs.empty() && made.copies.empty());
    }
}

// A .gltf is text: whatever is wrong in it is told at its line, also what only the reader of the meshes sees.
TEST(GltfImport, MistakesOfTextFilesHaveALine) {
    const std::string head = "{ \"asset\": { \"version\": \"2.0\" },\n  ";
    const std::string scene = "\"scenes\": [{ \"nodes\": [0] }], \"nodes\": [{ \"mesh\": 0 }],\n  ";
    const std::string meshes = "\"meshes\": [{ \"primitives\": [{ \"attributes\": { \"POSITION\": 0 } }] }],\n  ";
    const std::string views = "\"bufferViews\": [{ \"buffer\": 0, \"byteLength\": 36 }],\n  ";
    const std::string bytes = "\"buffers\": [{ \"byteLength\": 36, \"uri\": \"data:application/octet-stream;base64,";
    const std::string accessor = "\"accessors\": [{ \"bufferView\": 0, \"componentType\": 5126, \"count\": 3,\n  ";
    struct Broken {
        std::string text, error;
    };
    const std::vector<Broken> cases = {
        {"[1, 2]", "1:1: a glTF file is an object, not an array"},
        {"{ \"nodes\": [] }", "1:1: asset: a glTF file states its version"},
        {"{ \"asset\":\n { \"version\": \"1.0\" } }", "2:15: asset.version: version '1.0' is not read, only 2.0"},
        {"{ \"asset\":\n { \"version\": \"2.1\", \"minVersion\": \"2.1\" } }", "asset.minVersion: version '2.1'"},
        {head + "\"nodes\": \"x\" }", "2:12: nodes: is a string, not a list"},
        {head + "\"nodes\": [{ \"children\": [1] },\n { \"children\": [0] }] }", "2:13: nodes[0]: is its own ancestor"},
        {head + "\"nodes\": [{},\n { \"mesh\": 9 }] }", "3:12: nodes[1].mesh: names meshes[9], and the file has 0"},
        {head + accessor + "\"type\": \"VEC9\" }] }", "3:11: accessors[0].type: there is no such type"},
        {head + "\"buffers\": [{ \"byteLength\": 4,\n \"uri\": \"nothere.bin\" }] }",
         "3:9: buffers[0].uri: the file 'nothere.bin' cannot be read"},
        {head + "\"buffers\": [{ \"byteLength\": 4,\n \"uri\": \"mistake.gltf\" }] }",
         "3:9: buffers[0].uri: the file 'mistake.gltf' does not have as many bytes as 'byteLength' says"},
        {head + "\"buffers\": [{ \"byteLength\": 4000,\n \"uri\": \"mistake.gltf\" }] }",
         "2:31: buffers[0].byteLength: the buffer shall have 4000 bytes, and the file 'mistake.gltf' has fewer"},
        {head + "\"buffers\": [{ \"byteLength\": 4,\n \"uri\": \"not%20here.bin\" }] }",
         "3:9: buffers[0].uri: the file 'not here.bin' cannot be read"},
        {head + "\"buffers\": [{ \"byteLength\": 4 }] }", "2:15: buffers[0]: names no file of its bytes"},
        {head + bytes + "AAAA\" }] }",
         "2:31: buffers[0].byteLength: the buffer shall have 36 bytes, and its data URI holds 3"},
        {head + scene + meshes + accessor + "\"type\": \"VEC3\" }],\n  " + views + bytes +
             base64(bytes_of({NAN, 0, 0, 1, 0, 0, 0, 1, 0})) + "\" }] }",
         "3:61: meshes[0].primitives[0].attributes.POSITION: a number is not finite"},
    };
    const std::string path = testing::TempDir() + "mistake.gltf";
    for (const Broken& each : cases) {
        std::ofstream(path, std::ios::binary) << each.text;
        const Imported made = import(path);
        EXPECT_EQ(made.error.rfind(path + ":", 0), 0u) << made.error;
        EXPECT_NE(made.error.find(each.error), std::string::npos) << each.error << "\n" << made.error;
        EXPECT_EQ(made.error.find("base64"), std::string::npos) << made.error;
        EXPECT_TRUE(made.graphs.empty() && made.copies.empty());
    }
}

// A texture on a mesh without coordinates shows one texel: the report says so.
TEST(GltfImport, TexturesWithoutCoordinatesAreReported) {
    const std::string path = save_gltf(
        {.materials = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":1}}}])",
         .meshes =
             R"([{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"indices":5,"material":0}]}])",
         .textures = R"("textures":[{"source":0}],"images":[)" + picture_of(png_of(1, 1, {1, 2, 3, 255})) + "]"});
    const Imported made = import(path);
    ASSERT_TRUE(made.error.empty()) << made.error;
    const auto says = [](const Remark& remark) { return remark.text.find("has no TEXCOORD_1") != std::string::npos; };
    ASSERT_EQ(std::ranges::count_if(made.remarks, says), 1);
    const Remark& remark = *std::ranges::find_if(made.remarks, says);
    EXPECT_EQ(remark.part, "materials[0].pbrMetallicRoughness.baseColorTexture");
    EXPECT_EQ(remark.kind, Remark::Kind::Changed);
}

// Cut anywhere, or with any byte changed, a file is read or refused.
TEST(GltfImport, DamagedFilesAreReadOrRefused) {
    const std::string path = save_gltf(
        {.materials = R"([{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"normalTexture":{"index":0}}])",
         .textures = R"("textures":[{"source":0}],"images":[)" + picture_of(png_of(1, 1, {1, 2, 3, 255})) + "]"});
    std::ifstream in(path, std::ios::binary);
    const std::string whole(std::istreambuf_iterator<char>(in), {});
    const auto try_text = [&](const std::string& text) {
        std::ofstream(path, std::ios::binary) << text;
        const Imported made = import(path);
        EXPECT_TRUE(made.error.empty() || made.graphs.empty());
    };
    for (std::size_t i = 0; i < whole.size(); i += 23) try_text(whole.substr(0, i));
    for (std::size_t i = 0; i < whole.size(); i += 13) {
        for (const char byte : {'"', '9', '-', '\xff'}) {
            std::string text = whole;
            text[i] = byte;
            try_text(text);
        }
    }
}

}  // namespace
}  // namespace patina::importers
