#include "runtime/render/render_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/render/complaints.h"
#include "runtime/render/prepare_material.h"
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

// What the request's words say of a scene's lights, surroundings, background and camera; empty, or what is wrong with
// them.
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
    if (!request.background.empty()) {
        Outcome<glm::vec4> background = parse_background(request.background);
        if (!background) return background.error;
        scene.background = background.value;
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
    std::optional<Mesh> mesh = make_mesh(request.mesh, request.segments);
    if (!mesh) {
        std::string names;
        for (std::string_view name : mesh_names()) names += (names.empty() ? "" : ", ") + std::string(name);
        return Failure{"there is no mesh '" + request.mesh + "'; there are: " + names};
    }
    if (!is_time(request.time.value_or(0)))
        return Failure{"the time must be a number of seconds that a float can hold"};
    Scene scene{.mesh = std::move(*mesh),
                .camera = default_camera(request.mesh),
                .lights = default_lights(),
                .ambient = studio_environment()->ambient(),
                .environment = studio_environment(),
                .time = float(request.time.value_or(0)),
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

// The first value behind the pixel that is not finite: what comes after it is not finite because of it. Nothing if the
// CPU finds none there.
std::optional<TracedValue> first_not_finite(const Compiler& compiler, const RenderRequest& request, int x, int y) {
    TraceOutcome outcome = trace(compiler, request, x, y, Precision::Float);
    if (!outcome.ok) return std::nullopt;
    const auto search = [](const std::vector<TracedValue>& values) -> std::optional<TracedValue> {
        for (const TracedValue& value : values) {
            if (!std::ranges::all_of(value.values, [](double number) { return std::isfinite(number); })) return value;
        }
        return std::nullopt;
    };
    for (const std::vector<TracedValue>& corner : outcome.trace.corners) {
        if (auto found = search(corner)) return found;
    }
    return search(outcome.trace.values);
}

// What is wrong with pixels that are NaN or infinite, at the node that they come from.
Diagnostic not_finite(const Compiler& compiler, const RenderRequest& request, const RenderOutcome& drawn,
                      bool is_scene) {
    const DataSummary& values = drawn.values;
    const std::optional<TracedValue> cause =
        is_scene ? std::nullopt : first_not_finite(compiler, request, values.first_x, values.first_y);
    std::string node;
    if (cause) {
        const std::vector<double>& numbers = cause->values;
        node = fmt::format(": '{}.{}' is {:.6g} there", cause->node, cause->port, fmt::join(numbers, ", "));
    }
    Diagnostic warning = complaint(request.graph, Severity::Warning, Complaint::PixelsNotFinite,
                                   {std::to_string(values.not_finite),
                                    std::to_string(std::size_t(drawn.image.width) * std::size_t(drawn.image.height)),
                                    std::to_string(values.first_x), std::to_string(values.first_y), node});
    if (is_scene) warning.notes.push_back(note("render one of its materials alone to find the node"));
    if (!cause) return warning;
    warning.node = cause->node;
    warning.port = cause->port;
    if (!cause->file.empty()) {
        warning.file = cause->file;
        warning.line = cause->line;
        warning.column = cause->column;
    }
    warning.notes.push_back(
        note(fmt::format("'patina trace {} --pixel {},{}', with the same options, shows all values of the pixel",
                         request.graph, values.first_x, values.first_y)));
    return warning;
}

// Replaces the numbers of a preview by what shows them, before the background.
void show_values(const RenderRequest& request, const glm::vec4& background, Image& image) {
    if (request.range) image = in_range(image, *request.range);
    if (!request.keeps_values) mark_not_finite(image);
    if (background.a > 0) put_before(image, background.r, background.g, background.b);
}

// A scene file's world, seen as the request says.
bool world_of_file(const Compiler& compiler, const RenderRequest& request, World& world, RenderOutcome& outcome) {
    const auto refuse = [&](std::string error) {
        outcome.error = std::move(error);
        return false;
    };
    if (!request.overrides.empty()) return refuse("a scene sets the values of its materials itself, under \"set\"");
    if (!request.options.preview.empty())
        return refuse("a scene has no nodes to preview: preview a node of one of its materials");
    if (request.mesh != RenderRequest{}.mesh || request.segments != 0)
        return refuse("a scene has its own meshes, in its objects");
    if (!is_time(request.time.value_or(0))) return refuse("the time must be a number of seconds that a float can hold");
    WorldFile file = read_world(compiler, request.graph, compile_options(request.options));
    outcome.diagnostics = std::move(file.diagnostics);
    outcome.dependencies = std::move(file.dependencies);
    if (!file.ok) return false;
    world = std::move(file.world);
    world.view.width = request.size;
    world.view.height = request.height ? request.height : request.size;
    world.view.samples = request.samples;
    if (request.time) world.view.time = float(*request.time);
    if (std::string error = take_words(request, world.view); !error.empty()) return refuse(error);
    return true;
}

}  // namespace

RenderOutcome render(const Compiler& compiler, const RenderRequest& request, RenderMachine& machine) {
    if (request.options.via != "glsl" && request.options.via != "hlsl" && request.options.via != "cpu")
        return failed({}, "there is no way to render via '" + request.options.via + "'; there are: glsl, hlsl, cpu");
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
    // Of a preview, only what the object covers is data.
    const glm::vec4 background = world.view.background;
    const bool is_preview = !request.options.preview.empty();
    if (is_preview) world.view.background.a = 0;
    RenderOutcome drawn = draw_world(compiler, world, request.options, machine);
    drawn.diagnostics.insert(drawn.diagnostics.begin(), outcome.diagnostics.begin(), outcome.diagnostics.end());
    drawn.dependencies.insert(drawn.dependencies.end(), outcome.dependencies.begin(), outcome.dependencies.end());
    if (drawn.ok) drawn.values = summarise(drawn.image);
    if (drawn.values.not_finite > 0) drawn.diagnostics.push_back(not_finite(compiler, request, drawn, is_scene));
    if (drawn.ok && is_preview) show_values(request, background, drawn.image);
    if (!is_scene && drawn.ok && is_empty(drawn.image, background))
        drawn.diagnostics.push_back(complaint(request.graph, Severity::Warning, Complaint::NothingSeen, {}));
    return drawn;
}

TraceOutcome trace(const Compiler& compiler, const RenderRequest& request, int x, int y, Precision precision) {
    TraceOutcome outcome;
    Outcome<Scene> scene = read_scene(request);
    if (!scene) {
        outcome.error = scene.error;
        return outcome;
    }
    CompileOptions options = compile_options(request.options);
    options.targets.clear();  // what is run is the program, not a text
    options.keep_programs = true;
    const WorldMaterial material{.graph = request.graph, .overrides = request.overrides};
    PreparedMaterial made =
        prepare_material(material, compile_material(compiler, material, options), request.options.exact_textures);
    outcome.error = std::move(made.error);
    outcome.diagnostics = made.compiled.diagnostics;
    outcome.diagnostics.insert(outcome.diagnostics.end(), made.diagnostics.begin(), made.diagnostics.end());
    if (!made.ok) return outcome;

    const Reflection& reflection = made.compiled.reflection;
    outcome.pass = choose_pass(reflection);
    if (auto warning = anisotropy_warning(request.graph, reflection, outcome.pass))
        outcome.diagnostics.push_back(*std::move(warning));
    add_engine_textures(made.loaded.textures, reflection, scene.value);
    const std::vector<BlockBytes> blocks = fill_blocks(reflection, made.values, scene.value);
    Outcome<PixelTrace> traced = cpu_trace({.reflection = &reflection,
                                            .pass = outcome.pass,
                                            .scene = &scene.value,
                                            .blocks = blocks,
                                            .constants = constants_of(reflection, made.values),
                                            .textures = made.loaded.textures,
                                            .program = made.compiled.program.get(),
                                            .progress = request.options.progress},
                                           x, y, precision);
    outcome.error = traced.error;
    outcome.trace = std::move(traced.value);
    outcome.ok = outcome.error.empty();
    return outcome;
}

}  // namespace patina::runtime
