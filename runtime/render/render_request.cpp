#include "runtime/render/render_request.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "runtime/render/render_world.h"
#include "runtime/scene/scene_text.h"
#include "runtime/scene/world_file.h"

namespace patina::runtime {
namespace {

RenderOutcome failed(RenderOutcome outcome, std::string error) {
    outcome.ok = false;
    outcome.error = std::move(error);
    return outcome;
}

// About the graph as a whole: the reflection knows no lines.
Diagnostic complaint(const RenderRequest& request, Severity severity, std::string code, std::string message) {
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.code = std::move(code);
    diagnostic.message = std::move(message);
    diagnostic.file = request.graph;
    return diagnostic;
}

// The textures that the pass reads and that ask for what the CPU cannot do, in quotes; empty: none.
std::string anisotropic_textures(const Reflection& reflection, const std::string& pass) {
    std::string names;
    for (const Texture& texture : reflection.textures) {
        bool is_read = std::any_of(reflection.passes.begin(), reflection.passes.end(), [&](const Pass& each) {
            return each.name == pass && std::count(each.textures.begin(), each.textures.end(), texture.name);
        });
        if (is_read && texture.sampler.anisotropy > 1) names += (names.empty() ? "'" : ", '") + texture.name + "'";
    }
    return names;
}

// What the request's words say of a scene's lights, surroundings and camera; empty, or what is wrong with them.
std::string take_words(const RenderRequest& request, Scene& scene) {
    if (!request.lights.empty()) scene.lights.clear();
    for (const std::string& text : request.lights) {
        if (text == "none") continue;
        Outcome<Light> light = parse_light(text);
        if (!light) return light.error;
        scene.lights.push_back(light.value);
    }
    if (scene.lights.size() > kMostLights)
        return "there are " + std::to_string(scene.lights.size()) + " lights, more than the limit of " +
               std::to_string(kMostLights);
    if (!request.ambient.empty()) {
        Outcome<SphericalHarmonics> ambient = parse_ambient(request.ambient);
        if (!ambient) return ambient.error;
        scene.ambient = ambient.value;
        scene.environment = nullptr;
    }
    if (!request.camera.empty()) {
        Outcome<Camera> camera = parse_camera(request.camera, scene.camera);
        if (!camera) return camera.error;
        scene.camera = camera.value;
    }
    return "";
}

// The scene that the request's words describe.
Outcome<Scene> read_scene(const RenderRequest& request) {
    std::optional<Mesh> mesh = make_mesh(request.mesh);
    if (!mesh) {
        std::string names;
        for (std::string_view name : mesh_names()) names += (names.empty() ? "" : ", ") + std::string(name);
        return Failure{"there is no mesh '" + request.mesh + "'; there are: " + names};
    }
    if (!is_time(request.time)) return Failure{"the time must be a number of seconds that a float can hold"};
    Scene scene{.mesh = std::move(*mesh),
                .camera = default_camera(request.mesh),
                .lights = default_lights(),
                .ambient = studio_environment()->ambient(),
                .environment = studio_environment(),
                .time = float(request.time),
                .width = request.size,
                .height = request.height ? request.height : request.size,
                .samples = request.samples};
    if (std::string error = take_words(request, scene); !error.empty()) return Failure{error};
    return scene;
}
// The first that draws meshes as the camera sees them.
std::string choose_pass(const Reflection& reflection) {
    for (const Pass& pass : reflection.passes)
        if (pass.draws == PassDraws::Objects && pass.lights != PassLights::Shadowed) return pass.name;
    return "";
}

std::vector<std::pair<std::string, std::string>> switches_of(const RenderRequest& request) {
    std::vector<std::pair<std::string, std::string>> switches;
    for (const std::string& define : request.defines) {
        const std::size_t equals = define.find('=');
        switches.emplace_back(define.substr(0, equals),
                              equals == define.npos ? std::string() : define.substr(equals + 1));
    }
    return switches;
}

// A draw and everything that it points to.
struct Prepared {
    Scene scene;
    Result compiled;
    LoadedTextures loaded;
    std::vector<BlockBytes> blocks;
    Draw draw;
};

// Compiles the graph and resolves what the request says about it. False: `outcome` says why not.
bool prepare(const Compiler& compiler, const RenderRequest& request, Prepared& made, RenderOutcome& outcome) {
    const auto refuse = [&](std::string error) {
        outcome.error = std::move(error);
        return false;
    };
    Outcome<Scene> scene = read_scene(request);
    if (!scene) return refuse(scene.error);
    made.scene = std::move(scene.value);

    CompileOptions options;
    options.targets.clear();
    options.path = request.path;
    options.switches = switches_of(request);
    options.include_dirs = request.include_dirs;
    options.preview = request.preview;
    options.keep_programs = true;
    made.compiled = compiler.compile_file(request.graph, options);
    outcome.diagnostics = made.compiled.diagnostics;
    if (!made.compiled.ok) return false;

    const Reflection& reflection = made.compiled.reflection;
    if (const auto wanted = keywords_of(reflection, request.overrides); !wanted.empty()) {
        options.switches.insert(options.switches.end(), wanted.begin(), wanted.end());
        made.compiled = compiler.compile_file(request.graph, options);
        outcome.diagnostics = made.compiled.diagnostics;
        if (!made.compiled.ok) return false;
    }
    Outcome<MaterialValues> values = material_values(reflection, request.overrides);
    if (!values) return refuse(values.error);
    for (const std::string& warning : values.value.warnings)
        outcome.diagnostics.push_back(complaint(request, Severity::Warning, "soft-range", warning));
    const std::string graph_folder = std::filesystem::path(request.graph).parent_path().string();
    made.loaded = load_textures(reflection, graph_folder, values.value.textures, request.exact_textures);
    for (const std::string& error : made.loaded.errors)
        outcome.diagnostics.push_back(complaint(request, Severity::Error, "bad-texture", error));
    if (!made.loaded.errors.empty()) return false;
    add_engine_textures(made.loaded.textures, reflection, made.scene);
    made.blocks = fill_blocks(reflection, values.value, made.scene);

    made.draw = {.reflection = &reflection,
                 .pass = choose_pass(reflection),
                 .scene = &made.scene,
                 .blocks = made.blocks,
                 .constants = constants_of(reflection, values.value),
                 .textures = made.loaded.textures,
                 .program = made.compiled.program.get(),
                 .progress = request.progress};
    if (std::string names = anisotropic_textures(reflection, made.draw.pass); !names.empty())
        outcome.diagnostics.push_back(complaint(request, Severity::Warning, "no-anisotropy",
                                                "the CPU reference samples without anisotropy: " + names));
    return true;
}

// One object of the material alone in the scene that the request describes.
Outcome<World> world_around(const RenderRequest& request) {
    Outcome<Scene> scene = read_scene(request);
    if (!scene) return Failure{scene.error};
    World world{.view = std::move(scene.value),
                .materials = {{.graph = request.graph, .overrides = request.overrides}}};
    world.objects.push_back({.mesh = std::make_shared<const Mesh>(std::move(world.view.mesh))});
    world.view.mesh = {};
    world.pixel_light_count = int(world.view.lights.size());
    return world;
}

// Every pixel is what it would be without an object.
bool is_empty(const Image& image, const glm::vec4& background) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float without = background[int(i % 4)];
        if (!(std::abs(image.pixels[i] - without) <= 1e-5f)) return false;
    }
    return true;
}

// A scene file's world, seen as the request says.
bool world_of_file(const Compiler& compiler, const RenderRequest& request, World& world, RenderOutcome& outcome) {
    const auto refuse = [&](std::string error) {
        outcome.error = std::move(error);
        return false;
    };
    if (!request.overrides.empty()) return refuse("a scene gives its materials their values itself: under \"set\"");
    if (!request.preview.empty()) return refuse("a scene has no node to look at: its materials have");
    if (request.mesh != RenderRequest{}.mesh) return refuse("a scene has meshes of its own: its objects");
    if (!is_time(request.time)) return refuse("the time must be a number of seconds that a float can hold");
    CompileOptions options;
    options.include_dirs = request.include_dirs;
    WorldFile file = read_world(compiler, request.graph, options);
    outcome.diagnostics = std::move(file.diagnostics);
    if (!file.ok) return false;
    world = std::move(file.world);
    world.view.width = request.size;
    world.view.height = request.height ? request.height : request.size;
    world.view.samples = request.samples;
    if (request.time != 0) world.view.time = float(request.time);
    if (std::string error = take_words(request, world.view); !error.empty()) return refuse(error);
    return true;
}

}  // namespace

std::string open_machine(const std::string& device, bool validation, RenderMachine& machine) {
    DeviceOptions wanted{.validation = validation, .device = device};
    if (machine.renderer && machine.options == wanted) return "";
    machine.renderer.reset();
    Outcome<std::unique_ptr<Renderer>> opened = Renderer::open(wanted);
    if (!opened) return opened.error;
    machine.renderer = std::move(opened.value);
    machine.options = wanted;
    return "";
}

RenderOutcome render(const Compiler& compiler, const RenderRequest& request, RenderMachine& machine) {
    if (request.via != "glsl" && request.via != "hlsl" && request.via != "cpu")
        return failed({}, "there is no way to render via '" + request.via + "'; there are: glsl, hlsl, cpu");
    RenderOutcome outcome;
    World world;
    const bool is_scene = request.graph.ends_with(".scene.json");
    if (is_scene) {
        if (!world_of_file(compiler, request, world, outcome)) return outcome;
    } else {
        Outcome<World> made = world_around(request);
        if (!made) return failed({}, made.error);
        world = std::move(made.value);
    }
    RenderOutcome drawn = draw_world(compiler, world,
                                     {.path = request.path,
                                      .switches = switches_of(request),
                                      .preview = request.preview,
                                      .via = request.via,
                                      .device = request.device,
                                      .validation = request.validation,
                                      .exact_textures = request.exact_textures,
                                      .exact_targets = request.exact_targets,
                                      .include_dirs = request.include_dirs,
                                      .progress = request.progress},
                                     machine);
    drawn.diagnostics.insert(drawn.diagnostics.begin(), outcome.diagnostics.begin(), outcome.diagnostics.end());
    if (!is_scene && drawn.ok && is_empty(drawn.image, world.view.background))
        drawn.diagnostics.push_back(complaint(
            request, Severity::Warning, "nothing-seen",
            "the picture is empty: the object is not where the camera looks, or nothing of it shows before an "
            "even background; a scene gives it a place, and something behind it"));
    return drawn;
}

TraceOutcome trace(const Compiler& compiler, RenderRequest request, int x, int y, Precision precision) {
    request.via = "cpu";
    RenderOutcome drawn;
    Prepared prepared;
    const bool is_prepared = prepare(compiler, request, prepared, drawn);
    TraceOutcome outcome{.diagnostics = std::move(drawn.diagnostics), .error = std::move(drawn.error)};
    if (!is_prepared) return outcome;
    Outcome<PixelTrace> traced = cpu_trace(prepared.draw, x, y, precision);
    outcome.error = traced.error;
    outcome.trace = std::move(traced.value);
    outcome.pass = prepared.draw.pass;
    outcome.ok = outcome.error.empty();
    return outcome;
}

}  // namespace patina::runtime
