#include "paths/drawing/drawing.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "runtime/scene/world_file.h"

namespace patina::paths {

namespace fs = std::filesystem;

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

World proof_world(int width, int height) {
    const runtime::WorldFile file = runtime::read_world(compiler(), "examples/scenes/five-lights.scene.json", {});
    EXPECT_TRUE(file.ok);
    World world = file.world;
    world.view.width = width;
    world.view.height = height;
    world.view.samples = 1;
    return world;
}

void add_object(World& world, const std::string& graph, const std::string& mesh, int segments,
                const glm::mat4& object_to_world, std::map<std::string, std::string> overrides) {
    world.objects.push_back({.name = fmt::format("{} {}", mesh, world.objects.size()),
                             .mesh = std::make_shared<const runtime::Mesh>(*runtime::make_mesh(mesh, segments)),
                             .object_to_world = object_to_world,
                             .material = world.materials.size()});
    world.materials.push_back(
        {.name = fmt::format("{}", world.materials.size()), .graph = graph, .overrides = std::move(overrides)});
}

World proof_scene_and_metals(int width, int height) {
    World world = proof_world(width, height);
    world.pixel_light_count = static_cast<int>(runtime::kMostLights);
    float x = -1.6f;
    for (const char* model : {"cook-torrance", "blinn-phong", "cl-pbr-specular", "gltf", "energy-conserving"}) {
        const std::string graph =
            written(std::string(model) + ".graph.json",
                    fmt::format(R"({{ "patina": 1, "workflow": "metallic-roughness", "lighting": "{}", "surface":
 {{ "baseColor": [0.8, 0.6, 0.4], "metallic": 0.7, "roughness": 0.35, "occlusion": 0.7 }} }})",
                                model));
        add_object(world, graph, "sphere", 48,
                   glm::scale(glm::translate(glm::mat4(1), {x, 0.3f, 2.4f}), glm::vec3(0.3f)));
        x += 0.8f;
    }
    return world;
}

std::string written(const std::string& name, const std::string& text) {
    const fs::path folder = fs::path(testing::TempDir()) / fmt::format("patina_paths_{}", ::getpid());
    fs::create_directories(folder);
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
}

std::string written_texture(const std::string& name, int width, int height,
                            const std::function<glm::dvec4(int x, int y)>& texel) {
    Image image = runtime::make_image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 4; ++c) image.at(x, y)[std::size_t(c)] = float(texel(x, y)[c]);
    std::string path = written(name, "");
    EXPECT_EQ(runtime::save_exr(path, image), "");
    return path;
}

Result compiled(const std::string& graph, const std::string& path,
                std::vector<std::pair<std::string, std::string>> switches) {
    CompileOptions options;
    options.request = CompileOptions::Passes{.path = path};
    options.switches = std::move(switches);
    Result result = compiler().compile_file(graph, options);
    EXPECT_TRUE(result.ok) << graph << " along " << path;
    return result;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

const Pass* find_pass(const Result& result, const std::string& name) {
    for (const Pass& pass : result.reflection.passes)
        if (pass.name == name) return &pass;
    return nullptr;
}

std::vector<std::string> Drawn::codes() const {
    std::vector<std::string> codes;
    for (const Diagnostic& diagnostic : diagnostics)
        if (std::find(codes.begin(), codes.end(), diagnostic.code) == codes.end()) codes.push_back(diagnostic.code);
    return codes;
}

Drawn drawn(const World& world, const RenderOptions& options) {
    static runtime::RenderMachine machine;
    RenderOptions with_validation = options;
    with_validation.validation = true;
    runtime::RenderOutcome outcome = runtime::draw_world(compiler(), world, with_validation, machine);
    if (!outcome.ok) {
        ADD_FAILURE() << options.path << ": " << outcome.error;
        for (const Diagnostic& diagnostic : outcome.diagnostics) ADD_FAILURE() << patina::to_text(diagnostic);
        outcome.image = runtime::make_image(world.view.width, world.view.height);
    }
    return {.image = std::move(outcome.image), .diagnostics = std::move(outcome.diagnostics)};
}

Image draw(const World& world, const RenderOptions& options) {
    return drawn(world, options).image;
}

double apart(double a, double b) {
    if (!std::isfinite(a) || !std::isfinite(b)) return std::numeric_limits<double>::infinity();
    return std::abs(a - b) / std::max({1.0, std::abs(a), std::abs(b)});
}

double apart(const Image& a, const Image& b, int x, int y) {
    const auto p = a.at(x, y), q = b.at(x, y);
    return std::max(
        {apart(double(p[0]), double(q[0])), apart(double(p[1]), double(q[1])), apart(double(p[2]), double(q[2]))});
}

Difference difference(const Image& a, const Image& b, const std::function<bool(int, int)>& counts) {
    Difference found;
    if (a.width != b.width || a.height != b.height) {
        found.largest = std::numeric_limits<double>::infinity();
        return found;
    }
    int channels = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            if (counts && !counts(x, y)) continue;
            for (std::size_t c = 0; c < 4; ++c, ++channels) {
                const double here = apart(double(a.at(x, y)[c]), double(b.at(x, y)[c]));
                found.mean += here;
                if (here <= found.largest) continue;
                found.largest = here;
                found.x = x;
                found.y = y;
            }
        }
    }
    if (channels > 0) found.mean /= channels;
    const auto p = a.at(found.x, found.y), q = b.at(found.x, found.y);
    found.shown = fmt::format("({}, {}, {}) and ({}, {}, {})", p[0], p[1], p[2], q[0], q[1], q[2]);
    return found;
}

std::string to_text(const Difference& difference) {
    return fmt::format("apart by up to {:.3g} / 255, in the mean by {:.3g} / 255; at ({}, {}) they are {}",
                       255 * difference.largest, 255 * difference.mean, difference.x, difference.y, difference.shown);
}

int lit_pixels(const Image& image, float darkest) {
    int count = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto pixel = image.at(x, y);
            count += std::max({pixel[0], pixel[1], pixel[2]}) > darkest;
        }
    return count;
}

}  // namespace patina::paths
