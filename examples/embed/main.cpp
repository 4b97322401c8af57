// What an engine does with the compiler: files of its own, nodes of its own, many threads, bindings from the
// reflection, and materials that are compiled again when one of their files changes. It needs only the compiler
// library.
#include <patina/patina.h>

#include <cstdio>
#include <map>
#include <mutex>
#include <thread>

namespace {

// The engine's files: here, texts in memory under URIs.
class Pack {
public:
    void set(const std::string& path, std::string text) {
        const std::lock_guard lock(mutex_);
        texts_[path] = std::move(text);
    }
    // Called from every thread that compiles. Textures are only asked for existence: their bytes are the engine's
    // matter.
    patina::FileSystem files() const {
        patina::FileSystem files;
        files.exists = [this](const std::string& path) { return path.ends_with(".png") || find(path); };
        files.read = [this](const std::string& path) { return find(path); };
        return files;
    }

private:
    std::optional<std::string> find(const std::string& path) const {
        const std::lock_guard lock(mutex_);
        const auto found = texts_.find(path);
        return found == texts_.end() ? std::nullopt : std::optional(found->second);
    }
    mutable std::mutex mutex_;
    std::map<std::string, std::string> texts_;
};

// A node that every graph of the engine can use by its name.
const patina::LibraryOverlay kNodes{.files = {{"engine/dots.node.hlsl", R"hlsl(
/// Round dots, a grid of them.
[node("Procedural/Dots")]
float Dots(float2 uv = uv0, float scale = 4) {
    float2 cell = frac(uv * scale) - 0.5;
    return smoothstep(0.35, 0.3, length(cell));
}
)hlsl"}}};

constexpr const char* kMask = R"json({ "patina": 1, "kind": "subgraph",
  "nodes": [{ "id": "dots", "node": "Dots", "in": { "scale": 8 } }], "outputs": { "mask": "dots" } })json";
constexpr const char* kDotted = R"json({
  "patina": 1,
  "workflow": "metallic-roughness",
  "lighting": "unity-brdf1",
  "properties": [
    { "name": "_Tint", "type": "color", "default": "#c9a27e" },
    { "name": "_Grain", "type": "texture2d", "default": "../textures/grain.png" }
  ],
  "nodes": [
    { "id": "mask", "node": "./mask.subgraph.json" },
    { "id": "grain", "node": "SampleTexture2D", "in": { "texture": "$_Grain" } }
  ],
  "surface": { "baseColor": "= $_Tint.rgb * grain.rgb * (0.5 + 0.5 * mask)", "roughness": 0.4 }
})json";
constexpr const char* kPlain = R"json({ "patina": 1, "workflow": "unlit", "surface": { "color": [1, 0, 0] } })json";

struct Material {
    std::string key;  // of all that the result depends on
    patina::Result result;
};

// Compiles the material if anything that it depends on has changed. Keeps the old one if the new one has errors.
bool update(const patina::Compiler& compiler, const std::string& path, const patina::CompileOptions& options,
            Material& material) {
    const std::string key = compiler.cache_key(path, options);
    if (key == material.key) return false;
    patina::Result result = compiler.compile_file(path, options);
    for (const patina::Diagnostic& d : result.diagnostics) std::fprintf(stderr, "%s\n", patina::to_text(d).c_str());
    material.key = key;
    if (result.ok) material.result = std::move(result);
    return result.ok || !material.result.shaders.empty();
}

// What is bound when the material is drawn. A tool has written the text; the engine needs no compiler for this.
void print_bindings(const std::string& text) {
    const patina::ReadReflection read = patina::Reflection::from_json(text);
    for (const patina::Diagnostic& d : read.diagnostics) std::fprintf(stderr, "%s\n", patina::to_text(d).c_str());
    for (const patina::Block& block : read.reflection.blocks)
        std::printf("set %u, binding %u: block %s, %u bytes\n", block.set, block.binding, block.name.c_str(),
                    block.size);
    for (const patina::Texture& texture : read.reflection.textures)
        if (texture.default_texture == patina::TextureDefault::File)
            std::printf("set %u, binding %u: %s\n", texture.set, texture.binding, texture.default_file.c_str());
}

}  // namespace

int main() {
    const patina::Compiler compiler(kNodes);  // loads the node library; keep it
    for (const patina::Diagnostic& d : compiler.library_diagnostics()) std::puts(patina::to_text(d).c_str());

    Pack pack;
    pack.set("pack://stone/dotted.graph.json", kDotted);
    pack.set("pack://stone/mask.subgraph.json", kMask);
    pack.set("pack://stone/plain.graph.json", kPlain);
    patina::CompileOptions options;
    options.targets = {patina::Target::Glsl};
    options.files = pack.files();
    options.limits.nodes = 10000;  // a graph that some user made is not to stop the engine

    std::map<std::string, Material> materials{{"pack://stone/dotted.graph.json", {}},
                                              {"pack://stone/plain.graph.json", {}}};
    const auto update_all = [&] {
        std::vector<std::thread> threads;
        for (auto& [path, material] : materials)
            threads.emplace_back([&, path = path, material = &material] {
                if (update(compiler, path, options, *material)) std::printf("compiled %s\n", path.c_str());
            });
        for (std::thread& thread : threads) thread.join();
    };
    update_all();
    const patina::Result& dotted = materials["pack://stone/dotted.graph.json"].result;
    if (!dotted.ok) return 1;
    for (const patina::Shader& shader : dotted.shaders)
        std::printf("// ---- %s\n%s\n", shader.file_name.c_str(), shader.text.c_str());
    print_bindings(dotted.reflection.to_json());

    std::puts("mask.subgraph.json changes");
    std::string finer = kMask;
    finer.replace(finer.find("8"), 1, "16");
    pack.set("pack://stone/mask.subgraph.json", finer);
    update_all();
    return 0;
}
