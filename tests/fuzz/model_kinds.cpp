// Files of other programs: whatever one holds, it is refused at a place, or it becomes graphs that the compiler
// accepts.
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "compiler/importers/importer.h"
#include "runtime/gltf/gltf_file.h"
#include "runtime/gltf/gltf_model.h"
#include "runtime/gltf/gltf_writer.h"
#include "runtime/mesh/mesh.h"
#include "runtime/picture/image.h"
#include "tests/fuzz/fuzz.h"
#include "tests/unit/importers/shadergraph/shadergraph_writer.h"
#include "tests/unit/importers/unitymaterial/unitymaterial_writer.h"

namespace patina::fuzz {
namespace {

namespace fs = std::filesystem;
using importers::Imported;

constexpr std::string_view kWords[] = {"0",  "-1",   "1e30",     "\"\"",       "[]",         "{}",          "null",
                                       "65", "5126", "\"VEC4\"", "4294967295", "\"SCALAR\"", "\"\\u0000\"", "1.5"};

struct Texts {
    std::vector<Seed> seeds;
    TokenChanges tokens;
    explicit Texts(std::vector<Seed> all) : seeds(std::move(all)), tokens(seeds, kWords) {}
    Input make(Random& random) const { return changed_text(seeds, tokens, random); }
};

// --- what an importer makes of it

std::string wrong_with(const Imported& made) {
    for (const importers::Remark& each : made.remarks)
        if (each.text.empty()) return "a remark without a text: " + each.part;
    if (!made.error.empty()) return made.graphs.empty() ? "" : "an error and graphs: " + made.error;
    const bool says_what_is_missing =
        std::any_of(made.remarks.begin(), made.remarks.end(),
                    [](const importers::Remark& each) { return each.kind == importers::Remark::Kind::LeftOut; });
    if (made.graphs.empty() && !says_what_is_missing) return "neither an error nor graphs nor a remark";
    CompileOptions options{.targets = {}};
    options.accept_parts = true;
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        for (const auto& each : made.graphs)
            if (each.name == path || "./" + each.name == path) return each.text;
        return std::nullopt;
    };
    options.files.exists = [](const std::string&) { return true; };  // pictures
    for (const importers::TextFile& each : made.graphs) {
        if (each.name == made.scene) {
            const SceneResult scene = compiler().read_scene(each.name, options);
            if (std::string wrong = fuzz::wrong_with(scene.diagnostics, scene.ok, false); !wrong.empty()) return wrong;
            if (!scene.ok) return to_text(scene.diagnostics[0]);
            continue;
        }
        if (!each.name.ends_with("graph.json")) continue;
        const Result result = compiler().compile_text(each.name, each.text, options);
        if (std::string wrong = fuzz::wrong_with(result.diagnostics, result.ok, false); !wrong.empty()) return wrong;
        if (!result.ok) return to_text(result.diagnostics[0]);
    }
    return {};
}

Verdict run_import(const std::string& path, const std::string& bytes, const importers::Options& options) {
    write_file(path, bytes);
    const importers::Source source{.path = path, .start = bytes.substr(0, importers::kStart)};
    const importers::Importer* importer = importers::importer_of(source);
    if (!importer) return {};
    const Imported made = importers::read_verified(*importer, source, options);
    return {.is_accepted = made.error.empty(), .wrong = wrong_with(made), .said = made.error};
}

Fuzzer imports(const Setup& setup, const std::string& name, std::vector<Seed> written, std::string_view ending) {
    std::vector<Seed> seeds = setup.seeds.empty() ? std::move(written) : seeds_in(setup, {}, ending, 1 << 20);
    auto all = std::make_shared<Texts>(std::move(seeds));
    const std::string path = (setup.scratch / name).string(), folder = setup.seeds.string();
    const auto run = [path, folder](const Input& input, Random& random) {
        importers::Options options;
        if (!folder.empty() && one_in(4, random)) options.include_dirs = {folder};
        return run_import(path, input.bytes, options);
    };
    return {.make = [all](Random& random) { return all->make(random); }, .run = run};
}

std::vector<Seed> project_files(std::string_view ending) {
    constexpr std::string_view kFolders[] = {"tests/fuzz/seeds", "tests/diagnostics"};
    return seeds_in({}, kFolders, ending);
}

Fuzzer mtlx(const Setup& setup) {
    return imports(setup, "fuzz.mtlx", project_files(".mtlx"), ".mtlx");
}

Fuzzer materials(const Setup& setup) {
    using namespace importers;
    MaterialText painted{
        .keywords = {"_NORMALMAP", "_EMISSION"},
        .textures = {{"_MainTex", "0123456789abcdef0123456789abcdef"},
                     {"_BumpMap", "1123456789abcdef0123456789abcdef", "{x: 2, y: 2}"}},
        .numbers = {{"_Glossiness", "0.25"}, {"_Metallic", "0.5"}, {"_Mode", "1"}},
        .colors = {{"_Color", "{r: 1, g: 0.5, b: 0, a: 1}"}, {"_EmissionColor", "{r: 1, g: 2, b: 3, a: 1}"}}};
    std::vector<Seed> seeds;
    for (const char* shader : {kStandard, kStandardSpecular, kLit, kComplexLit, kSimpleLit, kBakedLit, kUnlit}) {
        painted.shader = shader;
        seeds.push_back({.bytes = painted.text()});
        seeds.push_back({.bytes = painted.old_text()});
    }
    return imports(setup, "fuzz.mat", std::move(seeds), ".mat");
}

Fuzzer shader_graphs(const Setup& setup) {
    using namespace importers;
    const auto binary = [](const std::string& kind) {
        return NodeText{.id = kind, .kind = kind, .slots = {{0}, {1}, {.id = 2, .is_input = false}}};
    };
    std::vector<Seed> seeds = project_files(".shadergraph");
    for (const char* kind : {"AddNode", "MultiplyNode", "PowerNode", "DotProductNode", "CrossProductNode"}) {
        const ShaderGraphText text{
            .properties = {{"p", "Color", "Tint", R"({"r":1.0,"g":0.5,"b":0.0,"a":1.0})"},
                           {"q", "Vector1", "Amount", "0.5"}},
            .nodes = {binary(kind),
                      binary("SubtractNode"),
                      {.id = "tint", .kind = "PropertyNode", .slots = {{.id = 0, .is_input = false}}, .property = "p"}},
            .edges = {{"tint", 0, kind, 0}, {kind, 2, "SubtractNode", 0}, {"SubtractNode", 2, "BaseColor"}}};
        seeds.push_back({.bytes = text.new_layout()});
        seeds.push_back({.bytes = text.old_layout()});
    }
    Fuzzer made = imports(setup, "fuzz.shadergraph", std::move(seeds), ".shadergraph");
    return made;
}

// --- glTF

// Two triangles with all that a vertex can have, sparse values, morph targets, joints, a camera, lights and a picture.
// `BUFFER` and `PICTURE` stand for URIs.
constexpr std::string_view kScene = R"json({
"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 3, 4]}],
"extensionsUsed": ["KHR_lights_punctual", "KHR_mesh_quantization", "KHR_texture_transform", "KHR_materials_variants"],
"extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "intensity": 3, "spot": {"outerConeAngle": 0.5}}]},
  "KHR_materials_variants": {"variants": [{"name": "a"}, {"name": "b"}]}},
"nodes": [{"mesh": 0, "skin": 0, "children": [1]}, {"name": "root", "translation": [0, 1, 0], "children": [2]},
  {"rotation": [0, 0, 0, 1], "scale": [1, 2, -1]},
  {"camera": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 4, 1]},
  {"extensions": {"KHR_lights_punctual": {"light": 0}}, "mesh": 1}],
"cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
"skins": [{"joints": [1, 2], "inverseBindMatrices": 6}],
"meshes": [{"weights": [0.5], "primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2,
  "JOINTS_0": 3, "WEIGHTS_0": 4}, "indices": 5, "material": 0, "targets": [{"POSITION": 7}],
  "extensions": {"KHR_materials_variants": {"mappings": [{"material": 1, "variants": [1]}]}}}]},
  {"primitives": [{"attributes": {"POSITION": 0}, "mode": 5}]}],
"materials": [{"name": "paint", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0,
  "extensions": {"KHR_texture_transform": {"scale": [2, 2]}}}, "roughnessFactor": 0.4}, "alphaMode": "MASK"},
  {"emissiveFactor": [1, 0, 0], "doubleSided": true}],
"textures": [{"source": 0, "sampler": 0}], "samplers": [{"wrapS": 33071, "magFilter": 9728}],
"images": [{"uri": "PICTURE"}],
"accessors": [
  {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4, "min": [0, 0, 0], "max": [1, 1, 0]},
  {"bufferView": 0, "byteOffset": 48, "componentType": 5126, "type": "VEC3", "count": 4},
  {"bufferView": 1, "componentType": 5123, "normalized": true, "type": "VEC2", "count": 4},
  {"bufferView": 2, "componentType": 5121, "type": "VEC4", "count": 4},
  {"bufferView": 3, "componentType": 5126, "type": "VEC4", "count": 4},
  {"bufferView": 4, "componentType": 5123, "type": "SCALAR", "count": 6},
  {"bufferView": 5, "componentType": 5126, "type": "MAT4", "count": 2},
  {"componentType": 5126, "type": "VEC3", "count": 4, "sparse": {"count": 2,
    "indices": {"bufferView": 6, "componentType": 5121}, "values": {"bufferView": 0, "byteOffset": 12}}}],
"bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 16},
  {"buffer": 0, "byteOffset": 112, "byteLength": 16}, {"buffer": 0, "byteOffset": 128, "byteLength": 64},
  {"buffer": 0, "byteOffset": 192, "byteLength": 12}, {"buffer": 0, "byteOffset": 204, "byteLength": 128},
  {"buffer": 0, "byteOffset": 332, "byteLength": 4}],
"buffers": [{"byteLength": 336, "uri": "BUFFER"}]
})json";

template <class Number>
void add(std::string& bytes, std::initializer_list<Number> numbers) {
    for (const Number each : numbers) bytes.append(reinterpret_cast<const char*>(&each), sizeof each);
}

std::string scene_buffer() {
    std::string bytes;
    add<float>(bytes, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    for (int i = 0; i < 4; ++i) add<float>(bytes, {0, 0, 1});
    add<std::uint16_t>(bytes, {0, 0, 65535, 0, 65535, 65535, 0, 65535});
    for (int i = 0; i < 4; ++i) add<std::uint8_t>(bytes, {0, 1, 0, 0});
    for (int i = 0; i < 4; ++i) add<float>(bytes, {0.5f, 0.5f, 0, 0});
    add<std::uint16_t>(bytes, {0, 1, 2, 0, 2, 3});
    for (int i = 0; i < 2; ++i) add<float>(bytes, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    add<std::uint8_t>(bytes, {1, 2, 0, 0});
    return bytes;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string made;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) made += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63];
    }
    return made;
}

std::string data_uri(std::string_view type, std::string_view bytes) {
    return fmt::format("data:{};base64,{}", type, base64(bytes));
}

std::string draco_bytes() {
    constexpr float kCorners[6][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0.25f}};
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2);
    const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    for (std::uint32_t face = 0; face < 2; face++)
        builder.SetAttributeValuesForFace(position, draco::FaceIndex(face), kCorners[3 * face], kCorners[3 * face + 1],
                                          kCorners[3 * face + 2]);
    draco::Encoder encoder;
    draco::EncoderBuffer buffer;
    encoder.EncodeMeshToBuffer(*builder.Finalize(), &buffer);
    return {buffer.data(), buffer.size()};
}

// The bytes that a mesh compressed by Draco has are changed alone, too: most changes of a text leave them as they are.
std::string draco_model(std::string_view bytes) {
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"extensionsUsed":["KHR_draco_mesh_compression"],"extensionsRequired":["KHR_draco_mesh_compression"],
"buffers":[{{"byteLength":{0},"uri":"{1}"}}],"bufferViews":[{{"buffer":0,"byteLength":{0}}}],
"accessors":[{{"componentType":5126,"type":"VEC3","count":4}},{{"componentType":5125,"type":"SCALAR","count":6}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1,"extensions":{{"KHR_draco_mesh_compression":{{"bufferView":0,"attributes":{{"POSITION":0}}}}}}}}]}}],
"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}],"scene":0}})",
        bytes.size(), data_uri("application/octet-stream", bytes));
}

std::string small_png() {
    return runtime::encode_png(runtime::make_image(4, 4, 0.5f, 0.25f, 1)).value;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    return at == text.npos ? text : text.replace(at, from.size(), to);
}

std::string little_endian(std::size_t number) {
    std::string made;
    for (int i = 0; i < 4; ++i) made += static_cast<char>(number >> (8 * i));
    return made;
}

std::string container(std::string text, std::string binary) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    return "glTF" + little_endian(2) + little_endian(28 + text.size() + binary.size()) + little_endian(text.size()) +
           "JSON" + text + little_endian(binary.size()) + std::string("BIN\0", 4) + binary;
}

Verdict run_model(const std::string& path, const std::string& bytes) {
    Verdict verdict = run_import(path, bytes, {});
    const auto file = runtime::open_gltf(path);
    if (!file) {
        if (file.error.find(path) == std::string::npos) verdict.wrong = "no file in: " + file.error;
        return verdict;
    }
    for (std::size_t i = 0; i < file.value.images.size(); ++i) runtime::picture_bytes(file.value, i);
    const auto model = runtime::model_of(file.value);
    if (model) runtime::mesh_of(model.value, path, "root");
    return verdict;
}

Fuzzer gltf(const Setup& setup) {
    std::vector<Seed> seeds = project_files(".gltf");
    const std::string text =
        replaced(replaced(std::string(kScene), "BUFFER", data_uri("application/octet-stream", scene_buffer())),
                 "PICTURE", data_uri("image/png", small_png()));
    seeds.push_back({.bytes = text});
    const std::string draco = draco_bytes();
    seeds.push_back({.bytes = draco_model(draco)});
    if (!setup.seeds.empty()) seeds = seeds_in(setup, {}, ".gltf", 1 << 20);
    auto all = std::make_shared<Texts>(std::move(seeds));
    const std::string path = (setup.scratch / "fuzz.gltf").string();
    const auto make = [all, draco, text](Random& random) {
        if (one_in(8, random)) return Input{.bytes = draco_model(changed_bytes(draco, draco, random))};
        if (one_in(8, random))
            return Input{
                .bytes = replaced(std::string(kScene), "BUFFER",
                                  data_uri("application/octet-stream", changed_bytes(scene_buffer(), draco, random)))};
        return all->make(random);
    };
    return {.make = make, .run = [path](const Input& input, Random&) { return run_model(path, input.bytes); }};
}

// The text with its buffer and its picture, which lie in the second chunk.
Fuzzer glb(const Setup& setup) {
    const std::string picture = small_png(), buffer = scene_buffer();
    std::string text =
        replaced(std::string(kScene), R"("uri": "PICTURE")", R"("bufferView": 7, "mimeType": "image/png")");
    text = replaced(text, R"(, "uri": "BUFFER")", "");
    text = replaced(text, R"("byteLength": 336)", fmt::format(R"("byteLength": {})", 336 + picture.size()));
    text = replaced(text, R"("byteOffset": 332, "byteLength": 4})",
                    fmt::format(R"("byteOffset": 332, "byteLength": 4}},
  {{"buffer": 0, "byteOffset": 336, "byteLength": {}}})",
                                picture.size()));
    auto all = std::make_shared<Texts>(std::vector<Seed>{{.bytes = text}});
    std::vector<Seed> files = {{.bytes = container(text, buffer + picture)}};
    if (const auto baked = runtime::write_glb("plane", runtime::make_plane(1, 2), {}, {}))
        files.push_back({.bytes = baked.value});
    if (!setup.seeds.empty()) files = seeds_in(setup, {}, ".glb", 1 << 20);
    const std::string path = (setup.scratch / "fuzz.glb").string();
    const auto make = [all, files, picture, buffer](Random& random) {
        switch (below(random, 4)) {
            case 0: return Input{.bytes = container(all->make(random).bytes, buffer + picture)};
            case 1:
                return Input{.bytes = container(all->seeds[0].bytes, buffer + changed_bytes(picture, buffer, random))};
            case 2:
                return Input{.bytes = container(all->seeds[0].bytes, changed_bytes(buffer, picture, random) + picture)};
            default: return Input{.bytes = changed_bytes(files[below(random, files.size())].bytes, buffer, random)};
        }
    };
    return {.make = make, .run = [path](const Input& input, Random&) { return run_model(path, input.bytes); }};
}

}  // namespace

std::vector<InputKind> model_kinds() {
    return {{"gltf", "glTF as text, with Draco", 100, gltf},
            {"glb", "glTF as one file, with its picture", 100, glb},
            {"mtlx", "documents of MaterialX", 100, mtlx},
            {"mat", "materials of Unity", 100, materials},
            {"shadergraph", "shader graphs of Unity", 100, shader_graphs}};
}

}  // namespace patina::fuzz
