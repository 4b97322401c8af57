// The texts that people write, and those that the compiler writes and reads back.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "patina/graph_diff.h"
#include "patina/graph_merge.h"
#include "patina/patina_c.h"
#include "patina/validate.h"
#include "runtime/scene/world_file.h"
#include "runtime/snapshot/snapshot_file.h"
#include "tests/fuzz/fuzz.h"

namespace patina::fuzz {
namespace {

constexpr std::string_view kGraphFolders[] = {"examples", "tests/graphs", "tests/diagnostics/unknown-key",
                                              "nodes/models"};
constexpr std::string_view kSceneFolders[] = {"examples", "tests/snapshots", "tests/examples"};
constexpr std::string_view kNodeFolders[] = {"nodes", "examples", "tests/graphs"};
constexpr std::string_view kHlslFolders[] = {"tests/hlsl"};
constexpr std::string_view kPassFolders[] = {"nodes/passes"};

constexpr std::string_view kWords[] = {"0",
                                       "-1",
                                       "1e39",
                                       "0.5",
                                       "\"= 1\"",
                                       "\"\"",
                                       "[]",
                                       "{}",
                                       "null",
                                       "true",
                                       "\"@uv0\"",
                                       "\"$_Tint\"",
                                       "\"float3\"",
                                       "\"#ff8800\"",
                                       "float",
                                       "float2",
                                       "int",
                                       "bool",
                                       "half",
                                       "float4x4",
                                       "Texture2D",
                                       "TextureCube",
                                       "SamplerState",
                                       "Light",
                                       "LightSum",
                                       "LightingSurface",
                                       "void",
                                       "floatN",
                                       "out",
                                       "const",
                                       "ddx",
                                       "Sample",
                                       "uv0",
                                       "vertexColor",
                                       "frontFacing",
                                       "light",
                                       "time",
                                       "Surface",
                                       "static",
                                       "attribute",
                                       "builtin",
                                       "given",
                                       "node",
                                       "member",
                                       "perObject",
                                       "\"all\"",
                                       "\"Object\"",
                                       "[",
                                       "[ 3 ]",
                                       "positionOS",
                                       "opaqueColor",
                                       "for",
                                       "while",
                                       "return",
                                       "if"};

// Seeds and the ways to change them, for as long as a fuzzer lives.
struct Texts {
    std::vector<Seed> seeds;
    TokenChanges tokens;
    explicit Texts(std::vector<Seed> all) : seeds(std::move(all)), tokens(seeds, kWords) {}
    Input make(Random& random) const { return changed_text(seeds, tokens, random); }
};
std::shared_ptr<const Texts> texts(const Setup& setup, std::span<const std::string_view> folders,
                                   std::string_view ending) {
    return std::make_shared<Texts>(seeds_in(setup, folders, ending));
}

// Files in memory before those of the disk.
FileSystem with_file(const std::string& name, const std::string& text) {
    FileSystem files = disk();
    files.read = [name, text, read = files.read](const std::string& path) -> std::optional<std::string> {
        return path == name ? text : read(path);
    };
    files.exists = [name, exists = files.exists](const std::string& path) { return path == name || exists(path); };
    return files;
}

std::string wrong_with(const Result& result, Random& random) {
    if (std::string wrong = fuzz::wrong_with(result.diagnostics, result.ok); !wrong.empty()) return wrong;
    if (!result.ok && !result.shaders.empty()) return "errors, and shaders";
    if (!result.ok || !one_in(8, random)) return {};
    for (const Shader& shader : result.shaders) {
        if (shader.pass.empty()) continue;  // an engine's own file
        const Validated validated = validate(shader);
        if (!validated.ok) return validated.log + shader.text;
    }
    return {};
}

// --- graphs, scenes, node files, pass files

Verdict run_graph(const Input& input, Random& random) {
    const std::string &path = input.path, &text = input.bytes;
    CompileOptions options;
    if (one_in(4, random)) options.targets = compiler().targets("unity");
    if (one_in(4, random)) options.request = PassesRequest{.path = one_in(2, random) ? "deferred" : "forward-add"};
    options.accept_parts = one_in(2, random);
    const Result result = compiler().compile_text(path, text, options);
    std::string wrong = wrong_with(result, random);
    const Compiler::Formatted formatted = compiler().format(path, text);
    if (wrong.empty()) wrong = fuzz::wrong_with(formatted.diagnostics, formatted.ok);
    if (wrong.empty() && formatted.ok && compiler().format(path, formatted.text).text != formatted.text)
        wrong = "formatted twice, it is another text";
    return {.is_accepted = result.ok, .wrong = std::move(wrong), .said = first_error(result.diagnostics)};
}

Fuzzer graphs(const Setup& setup) {
    auto all = texts(setup, kGraphFolders, ".json");
    return {.make = [all](Random& random) { return all->make(random); }, .run = run_graph};
}

Fuzzer scenes(const Setup& setup) {
    auto all = texts(setup, kSceneFolders, ".scene.json");
    const auto run = [](const Input& input, Random&) -> Verdict {
        const std::string& path = input.path;
        CompileOptions options{.files = with_file(path, input.bytes)};
        const SceneResult scene = compiler().read_scene(path, options);
        if (std::string wrong = fuzz::wrong_with(scene.diagnostics, scene.ok); !wrong.empty())
            return {.wrong = std::move(wrong)};
        if (!scene.ok) return {.said = first_error(scene.diagnostics)};
        const runtime::WorldFile world = runtime::make_world(scene.scene);
        return {.is_accepted = world.ok, .wrong = fuzz::wrong_with(world.diagnostics, world.ok)};
    };
    return {.make = [all](Random& random) { return all->make(random); }, .run = run};
}

// Each node of a file alone, with its comment: a user's file has one node.
std::vector<Seed> single_nodes(std::span<const Seed> files) {
    std::vector<Seed> made;
    for (const Seed& file : files) {
        std::string before;
        for (std::size_t at = 0; at < file.bytes.size();) {
            const std::size_t end = std::min(file.bytes.find("\n}\n", at), file.bytes.size() - 1);
            std::string block = file.bytes.substr(at, end + 3 - at);
            at = end + 3;
            const bool is_node = block.find("\n[node(") != block.npos || block.starts_with("[node(");
            if (!is_node) before += block;
            if (is_node && block.size() + before.size() < 6000)
                made.push_back({.bytes = before + block, .path = file.path});
        }
    }
    return made;
}

Fuzzer node_files_of(std::vector<Seed> seeds, std::string first_line) {
    auto all = std::make_shared<Texts>(single_nodes(seeds));
    const auto run = [](const Input& input, Random& random) -> Verdict {
        CompileOptions options{.files = with_file("fuzz.node.hlsl", input.bytes)};
        const NodeFileResult checked = compiler().check_node_file("fuzz.node.hlsl", options);
        std::string wrong = fuzz::wrong_with(checked.diagnostics, checked.ok);
        const std::string graph =
            R"({ "patina": 1, "workflow": "unlit", "nodes": [{ "id": "n", "node": "./fuzz.node.hlsl" }],)"
            R"( "surface": { "color": "n" } })";
        if (wrong.empty()) wrong = wrong_with(compiler().compile_text("fuzz.graph.json", graph, options), random);
        return {.is_accepted = checked.ok, .wrong = std::move(wrong), .said = first_error(checked.diagnostics)};
    };
    const auto make = [all, first_line](Random& random) {
        Input made = all->make(random);
        made.bytes = first_line + made.bytes;
        return made;
    };
    return {.make = make, .run = run};
}
Fuzzer node_files(const Setup& setup) {
    return node_files_of(seeds_in(setup, kNodeFolders, ".node.hlsl"), "");
}
Fuzzer hlsl_files(const Setup& setup) {
    return node_files_of(seeds_in(setup, kHlslFolders, ".node.hlsl"), "#pragma hlsl\n");
}

constexpr std::string_view kCutout = R"json({
  "patina": 1, "workflow": "metallic-roughness", "lighting": "unity-brdf1", "render": { "surface": "cutout" },
  "properties": [ { "name": "_MainTex", "type": "texture2d", "default": "white" } ],
  "nodes": [ { "id": "albedo", "node": "SampleTexture2D", "in": { "texture": "$_MainTex" } } ],
  "surface": { "baseColor": "albedo.rgb", "alpha": "albedo.a", "emission": "= @vertexColor.rgb" }
})json";
constexpr std::string_view kToon = R"json({
  "patina": 1, "workflow": "metallic-roughness", "lighting": "toon",
  "surface": { "baseColor": "= float3(@uv0, 0)" }
})json";

// All shaders that other compilers take, too.
Verdict run_pass_file(const Input& input, Random& random) {
    CompileOptions options{.files = with_file("mine.pass.hlsl", input.bytes)};
    options.request = PassesRequest{.path = "mine.pass.hlsl"};
    options.keep_programs = true;
    const Result result =
        compiler().compile_text("fuzz.graph.json", std::string(one_in(4, random) ? kToon : kCutout), options);
    std::string wrong = wrong_with(result, random);
    for (const Shader& shader : result.shaders) {
        const Validated validated = validate(shader);
        if (wrong.empty() && !validated.ok) wrong = validated.log + shader.text;
    }
    return {.is_accepted = result.ok, .wrong = std::move(wrong), .said = first_error(result.diagnostics)};
}

Fuzzer pass_files(const Setup& setup) {
    auto all = texts(setup, kPassFolders, ".pass.hlsl");
    return {.make = [all](Random& random) { return all->make(random); }, .run = run_pass_file};
}

// --- options of the C API

constexpr std::string_view kOptions[] = {
    R"({ "targets": ["glsl", "hlsl"], "path": "deferred", "passes": ["gbuffer"], "hashes": true })",
    R"({ "targets": ["unity"], "switches": { "shadows": "true", "_Mode": "Wet" }, "keepVariants": true })",
    R"({ "targets": [], "acceptParts": true, "includeDirs": ["nodes", "../shared"], "lighting": "toon" })",
    R"({ "preview": "surface.baseColor", "limits": { "nodes": 10, "sourceBytes": 100000, "shaderBytes": 1000000 } })",
    R"({ "functions": "Rust_" })",
};

Fuzzer options(const Setup&) {
    std::vector<Seed> seeds;
    for (const std::string_view each : kOptions) seeds.push_back({.bytes = std::string(each)});
    auto all = std::make_shared<Texts>(std::move(seeds));
    patina_compiler* made = nullptr;
    patina_compiler_create(PATINA_C_ABI, nullptr, 0, &made);
    const std::shared_ptr<patina_compiler> library(made, patina_compiler_free);
    const auto run = [library](const Input& input, Random&) -> Verdict {
        patina_result* result = nullptr;
        const patina_status status = patina_compile(library.get(), "a.graph.json", kToon.data(), kToon.size(),
                                                    input.bytes.c_str(), nullptr, &result);
        const std::shared_ptr<patina_result> owner(result, patina_result_free);
        if (status != PATINA_OK && status != PATINA_HAS_ERRORS) return {.wrong = patina_status_text(status)};
        const std::string_view messages = patina_result_messages(result), json = patina_result_diagnostics(result);
        if (json.find("\"internal\"") != json.npos) return {.wrong = std::string(messages)};
        if (status == PATINA_HAS_ERRORS && messages.empty()) return {.wrong = "errors without a message"};
        char key[PATINA_KEY_SIZE];
        const patina_status keyed = patina_cache_key(library.get(), "a.graph.json", kToon.data(), kToon.size(),
                                                     input.bytes.c_str(), nullptr, key);
        if (keyed != PATINA_OK && keyed != PATINA_HAS_ERRORS) return {.wrong = patina_status_text(keyed)};
        return {.is_accepted = status == PATINA_OK};
    };
    return {.make = [all](Random& random) { return all->make(random); }, .run = run};
}

// --- reflection

Fuzzer reflections(const Setup& setup) {
    std::vector<Seed> seeds;
    constexpr std::string_view kFolders[] = {"examples/graphs", "examples/surfaces"};
    for (const Seed& graph : seeds_in(setup, kFolders, ".graph.json")) {
        const Result result = compiler().compile_text(graph.path, graph.bytes, {.targets = {Target::Glsl}});
        if (result.ok) seeds.push_back({.bytes = result.reflection.to_json()});
        if (seeds.size() == 12) break;
    }
    auto all = std::make_shared<Texts>(std::move(seeds));
    const auto run = [](const Input& input, Random&) -> Verdict {
        const ReadReflection read = Reflection::from_json(input.bytes, "fuzz.reflect.json");
        std::string wrong = fuzz::wrong_with(read.diagnostics, read.ok);
        if (wrong.empty() && read.ok) {
            const std::string written = read.reflection.to_json();
            const ReadReflection again = Reflection::from_json(written);
            if (!again.ok || again.reflection.to_json() != written) wrong = "written and read again, it is another one";
        }
        return {.is_accepted = read.ok, .wrong = std::move(wrong)};
    };
    return {.make = [all](Random& random) { return all->make(random); }, .run = run};
}

// --- merges and differences

constexpr char kBetween = '\0';

Fuzzer merges(const Setup& setup) {
    constexpr std::string_view kFolders[] = {"examples", "tests/graphs"};
    auto all = std::make_shared<Texts>(seeds_in(setup, kFolders, ".json", 6000));
    // Two sides of one text; sometimes the base is none of them.
    const auto make = [all](Random& random) {
        const std::size_t seed = below(random, all->seeds.size());
        const auto side = [&] {
            const std::string& text = all->seeds[seed].bytes;
            return one_in(3, random) ? text
                   : one_in(2, random)
                       ? all->tokens.make(seed, random)
                       : changed_lines(text, all->seeds[below(random, all->seeds.size())].bytes, random);
        };
        std::string made = one_in(8, random) ? std::string() : side();
        for (int i = 0; i < 2; ++i) (made += kBetween) += side();
        return Input{.bytes = std::move(made), .path = all->seeds[seed].path};
    };
    const auto run = [](const Input& input, Random& random) -> Verdict {
        std::vector<std::string> sides;
        for (std::size_t at = 0; at <= input.bytes.size();) {
            const std::size_t end = std::min(input.bytes.find(kBetween, at), input.bytes.size());
            sides.push_back(input.bytes.substr(at, end - at));
            at = end + 1;
        }
        sides.resize(3);
        const MergeOptions options{.path = input.path};
        const MergeResult merged = merge_graphs(compiler(), {"base.json", sides[0]}, {"ours.json", sides[1]},
                                                {"theirs.json", sides[2]}, options);
        const bool is_clean = merged.state == MergeState::Clean;
        std::string wrong = fuzz::wrong_with(merged.diagnostics, is_clean);
        const GraphDiff diff = diff_graphs({"ours.json", sides[1]}, {"theirs.json", sides[2]});
        if (wrong.empty()) wrong = fuzz::wrong_with(diff.diagnostics, diff.ok);
        if (wrong.empty() && is_clean) {
            const Result compiled =
                compiler().compile_text(options.path, merged.text, {.targets = {}, .accept_parts = true});
            wrong = wrong_with(compiled, random);
        }
        return {.is_accepted = is_clean, .wrong = std::move(wrong)};
    };
    return {.make = make, .run = run};
}

// --- snapshots

Fuzzer snapshots(const Setup& setup) {
    constexpr std::string_view kFolders[] = {"tests", "examples"};
    auto all = texts(setup, kFolders, ".snapshot.json");
    const std::string path = (setup.scratch / "fuzz.snapshot.json").string();
    const auto run = [path](const Input& input, Random&) -> Verdict {
        write_file(path, input.bytes);
        const runtime::ReadSnapshot read = runtime::read_snapshot(path);
        if (!read.file) return {.wrong = fuzz::wrong_with({&read.error, 1}, false)};
        if (runtime::variations(*read.file).size() > runtime::kMostVariations) return {.wrong = "too many variations"};
        return {.is_accepted = true};
    };
    return {.make = [all](Random& random) { return all->make(random); }, .run = run};
}

}  // namespace

std::vector<InputKind> text_kinds() {
    return {{"graph", "graphs, sub-graphs, lighting models and workflows", 60, graphs},
            {"scene", "scene files, up to their meshes and lights", 200, scenes},
            {"node", "node files, checked and used by a graph", 60, node_files},
            {"hlsl", "the same of files that are read by HLSL's rules", 60, hlsl_files},
            {"pass", "rendering paths; all shaders are validated", 60, pass_files},
            {"options", "options of the C API", 200, options},
            {"reflection", "reflections, read and written again", 200, reflections},
            {"merge", "three versions of a graph, merged and compared", 60, merges},
            {"snapshot", "snapshot files", 300, snapshots}};
}

}  // namespace patina::fuzz
