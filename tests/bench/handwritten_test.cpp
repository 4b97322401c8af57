// An expert's shaders and the compiler's for the same materials: both draw the same picture, the compiler's runs at
// most as many instructions, and its text is at most half as long again. Prints the table of docs/cost.md.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "paths/drawing.h"
#include "patina/cost.h"
#include "patina/validate.h"
#include "runtime/gpu/renderer.h"
#include "runtime/values/engine_values.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "tests/bench/handwritten";
constexpr double kMostText = 1.5;
constexpr const char* kPicture = "examples/graphs/textures/steel_orm.png";
constexpr const char* kNormalMap = "examples/graphs/textures/tiles_normal.png";

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// Without comments, indentation and empty lines.
std::size_t length_of(const std::string& text) {
    std::size_t length = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line(text.data() + begin, end - begin);
        line = line.substr(0, line.find("//"));
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        line = line.substr(0, line.find_last_not_of(' ') + 1);
        if (!line.empty()) length += line.size() + 1;
        begin = end + 1;
    }
    return length;
}

// A material's own stages, and the fragment stage that was written by hand.
struct Twins {
    std::string name;
    Result compiled;
    Shader vertex, fragment, by_hand;
};

Twins twins_of(const fs::path& text) {
    Twins twins;
    twins.name = text.filename().string();
    twins.name.resize(twins.name.find('.'));
    const std::string graph = twins.name + ".graph.json";
    const fs::path own = fs::path(kFolder) / graph, source = fs::path("examples/sources") / graph;
    CompileOptions options;
    options.targets = {Target::Glsl};
    twins.compiled = paths::compiler().compile_file((fs::exists(own) ? own : source).string(), options);
    EXPECT_TRUE(twins.compiled.ok) << twins.name;
    for (const Shader& shader : twins.compiled.shaders)
        (shader.stage == Stage::Vertex ? twins.vertex : twins.fragment) = shader;
    twins.by_hand.stage = Stage::Fragment;
    twins.by_hand.text = read(text);
    return twins;
}

std::vector<Twins> all_twins() {
    std::vector<fs::path> texts;
    for (const fs::directory_entry& entry : fs::directory_iterator(kFolder))
        if (entry.path().extension() == ".glsl") texts.push_back(entry.path());
    std::sort(texts.begin(), texts.end());
    std::vector<Twins> twins;
    for (const fs::path& text : texts) twins.push_back(twins_of(text));
    return twins;
}

StageCost cost_of(const Shader& shader) {
    std::vector<Diagnostic> diagnostics;
    std::optional<StageCost> cost = measure_cost(shader, diagnostics);
    EXPECT_TRUE(cost) << (diagnostics.empty() ? "" : diagnostics.front().message);
    return cost.value_or(StageCost{});
}

TEST(Handwritten, EachSourceHasATwin) {
    for (const fs::directory_entry& entry : fs::directory_iterator("examples/sources")) {
        std::string name = entry.path().filename().string();
        if (!name.ends_with(".graph.json")) continue;
        name.resize(name.find('.'));
        EXPECT_TRUE(fs::exists(fs::path(kFolder) / (name + ".frag.glsl"))) << name;
    }
}

TEST(Handwritten, CostNoLess) {
    fmt::print("| material | instructions | by hand | | text | by hand | |\n|---|---|---|---|---|---|---|\n");
    for (const Twins& twins : all_twins()) {
        const std::uint32_t own = cost_of(twins.fragment).total(), by_hand = cost_of(twins.by_hand).total();
        const std::size_t text = length_of(twins.fragment.text), shortest = length_of(twins.by_hand.text);
        fmt::print("| {} | {} | {} | {:.2f} | {} | {} | {:.2f} |\n", twins.name, own, by_hand, double(own) / by_hand,
                   text, shortest, double(text) / double(shortest));
        EXPECT_LE(own, by_hand) << twins.name;
        EXPECT_LE(double(text), kMostText * double(shortest)) << twins.name;
    }
}

// --- the same picture

runtime::Renderer& renderer() {
    static const auto kOpened = runtime::Renderer::open({.validation = true});
    EXPECT_TRUE(kOpened) << kOpened.error;
    return *kOpened.value;
}

// A sphere below a sun, a lamp and a spot.
runtime::Scene scene() {
    runtime::Scene scene = runtime::default_scene("sphere");
    scene.width = scene.height = 96;
    scene.background = glm::vec4(0);
    scene.lights = {
        {.direction = {-0.6f, 0.8f, 0.8f}, .color = glm::vec3(0.95f, 0.92f, 0.88f)},
        {.kind = LightKind::Point, .position = {1.2f, 0.4f, 1.6f}, .color = glm::vec3(0.5f, 0.8f, 1.1f), .range = 6},
        {.kind = LightKind::Spot,
         .position = {-1.2f, 0.2f, 2.0f},
         .direction = {0.5f, -0.05f, -0.8f},
         .color = glm::vec3(1.2f, 0.4f, 0.2f),
         .range = 8,
         .inner_angle = 12,
         .outer_angle = 24}};
    return scene;
}

// Every texture and number shows something, so that a twin that does not read it draws another picture.
std::map<std::string, std::string> pictures(const Reflection& reflection) {
    std::map<std::string, std::string> files;
    for (const Texture& texture : reflection.textures)
        if (texture.is_material)
            files[texture.name] = fs::absolute(texture.usage == TextureUsage::Normal ? kNormalMap : kPicture).string();
    return files;
}

std::map<std::string, std::string> numbers(const Reflection& reflection) {
    std::map<std::string, std::string> words;
    for (const Property& property : reflection.properties) {
        if (property.binding != Binding::Uniform) continue;
        if (property.type == PropertyType::Color) words[property.name] = "#c08040";
        const bool is_share = property.range && (*property.range)[0] == 0 && (*property.range)[1] >= 1;
        if (property.type == PropertyType::Float && is_share) words[property.name] = "0.37";
    }
    return words;
}

std::vector<std::uint32_t> spirv(const Shader& shader) {
    const Validated validated = validate(shader);
    EXPECT_TRUE(validated.ok) << validated.log << shader.text;
    return validated.spirv;
}

runtime::Image draw(const Twins& twins, const Shader& fragment, const runtime::Scene& scene) {
    const Reflection& reflection = twins.compiled.reflection;
    auto loaded = runtime::load_textures(reflection, ".", pictures(reflection), true);
    EXPECT_TRUE(loaded.errors.empty()) << twins.name;
    runtime::add_engine_textures(loaded.textures, reflection, scene);
    const auto values = runtime::material_values(reflection, numbers(reflection));
    EXPECT_TRUE(values) << values.error;
    const std::vector<std::uint32_t> vertex_spirv = spirv(twins.vertex), fragment_spirv = spirv(fragment);
    const std::vector<runtime::BlockBytes> blocks = runtime::fill_blocks(reflection, values.value, scene);
    const auto image = renderer().draw({.reflection = &reflection,
                                        .scene = &scene,
                                        .blocks = blocks,
                                        .textures = loaded.textures,
                                        .vertex_spirv = vertex_spirv,
                                        .fragment_spirv = fragment_spirv});
    EXPECT_TRUE(image) << image.error;
    EXPECT_EQ(renderer().messages(), std::vector<std::string>{}) << twins.name;
    return image ? image.value : runtime::make_image(scene.width, scene.height);
}

TEST(Handwritten, DrawTheSamePicture) {
    const runtime::Scene shown = scene();
    for (const Twins& twins : all_twins()) {
        const runtime::Image own = draw(twins, twins.fragment, shown), by_hand = draw(twins, twins.by_hand, shown);
        EXPECT_GT(paths::lit_pixels(own), 1000) << twins.name;
        const paths::Difference apart = paths::difference(own, by_hand);
        EXPECT_LE(apart.largest, 2.0 / 255) << twins.name << ": " << paths::to_text(apart);
    }
}

}  // namespace
}  // namespace patina
