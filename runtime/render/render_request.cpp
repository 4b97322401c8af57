#include "runtime/render/render_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/render/complaints.h"
#include "runtime/render/not_finite.h"
#include "runtime/render/prepare_material.h"
#include "runtime/render/preview_world.h"
#include "runtime/render/render_world.h"
#include "runtime/scene/named_mesh.h"
#include "runtime/scene/scene_text.h"
#include "runtime/scene/world_file.h"

namespace patina::runtime {
namespace {

// The target of the passes that draw the picture itself.
constexpr std::string_view kPictureTarget = "color";

bool is_scene(const RenderRequest& request) {
    return request.graph.ends_with(".scene.json");
}

RenderOutcome failed(RenderOutcome outcome, std::string error) {
    outcome.ok = false;
    outcome.error = std::move(error);
    return outcome;
}

// Applies the request's words about a scene's lights, surroundings, background and camera; returns what is wrong with
// them, or nothing.
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
    if (!request.environment.empty()) {
        const Outcome<EnvironmentChoice> around = parse_environment(request.environment);
        if (!around) return around.error;
        std::string error = set_environment(scene, around.value, request.options.progress);
        if (!error.empty()) return error;
    }
    if (!request.ambient.empty()) {
        Outcome<SphericalHarmonics> ambient = parse_ambient(request.ambient);
        if (!ambient) return ambient.error;
        scene.ambient = ambient.value;
        scene.environment = nullptr;
        scene.picture_intensity.reset();
    }
    if (!request.background.empty()) {
        const Outcome<Background> background = parse_background(request.background);
        if (!background) return background.error;
        scene.background = background.value.color;
        scene.backdrop = background.value.backdrop;
        scene.is_default_background = false;
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
    Outcome<Mesh> mesh = mesh_named(request.mesh, request.segments);
    if (!mesh) return Failure{mesh.error};
    if (!is_time(request.time.value_or(0)))
        return Failure{"the time must be a number of seconds that a float can hold"};
    const Camera camera = camera_for(request.mesh, mesh.value);
    Scene scene{.mesh = std::move(mesh.value),
                .camera = camera,
                .lights = is_picture(request.environment) ? std::vector<Light>() : default_lights(),
                .ambient = studio_environment()->ambient(),
                .environment = studio_environment(),
                .time = float(request.time.value_or(0)),
                .width = request.size,
                .height = request.height ? request.height : request.size,
                .samples = request.samples,
                .is_default_background = true};
    if (std::string error = take_words(request, scene); !error.empty()) return Failure{error};
    return scene;
}

// Every pixel is what it would be without an object. Not known of a picture before its surroundings.
bool is_empty(const Image& image, const Scene& view) {
    const glm::vec4& background = view.background;
    if (view.backdrop != SceneBackdrop::Color) return false;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float without = background[int(i % 4)];
        if (!(std::abs(image.pixels[i] - without) <= 1e-5f * std::max(1.0f, without))) return false;
    }
    return true;
}

// Forward has all values of a material in one pass.
std::optional<Cause> find_cause(const Compiler& compiler, const World& world, const RenderOptions& options,
                                const DataSummary& values) {
    const TraceWish wish{.x = values.first_x, .y = values.first_y};
    std::optional<Cause> cause = cause_at(compiler, world, options, wish);
    RenderOptions forward = options;
    forward.path = RenderOptions{}.path;
    return cause || options.path == forward.path ? cause : cause_at(compiler, world, forward, wish);
}

// A message about pixels that are NaN or infinite, at the node that computes them.
Diagnostic not_finite(const Compiler& compiler, const RenderRequest& request, const World& world,
                      const RenderOptions& options, const RenderOutcome& drawn) {
    const DataSummary& values = drawn.values;
    const std::optional<Cause> cause = find_cause(compiler, world, options, values);
    Diagnostic warning =
        complaint(request.graph, Severity::Warning, Complaint::PixelsNotFinite,
                  {std::to_string(values.not_finite),
                   std::to_string(std::size_t(drawn.image.width) * std::size_t(drawn.image.height)),
                   std::to_string(values.first_x), std::to_string(values.first_y), cause ? words_of(*cause) : ""});
    if (!cause) return warning;
    blame(warning, *cause);
    // A preview leaves out what is before its object.
    const bool is_found = cause->is_front && (cause->object.empty() || request.options.preview.empty());
    warning.notes.push_back(
        note(fmt::format("'patina trace {} --pixel {},{}{}', with the same options, shows all values of the pixel",
                         request.graph, values.first_x, values.first_y, is_found ? "" : " --object " + cause->object)));
    return warning;
}

// Replaces the numbers of a preview by what shows them.
void show_values(const RenderRequest& request, Image& image) {
    if (request.range) image = in_range(image, *request.range);
    if (!request.keeps_values) mark_not_finite(image);
}

// A scene file's world, seen as the request says.
bool world_of_file(const Compiler& compiler, const RenderRequest& request, World& world, RenderOutcome& outcome) {
    const auto refuse = [&](std::string error) {
        outcome.error = std::move(error);
        return false;
    };
    if (!request.overrides.empty())
        return refuse(request.options.files
                          ? "a model has values of its own: 'patina import' makes graphs of it, and --set is for these"
                          : "a scene sets the values of its materials itself, under \"set\"");
    if (request.mesh != RenderRequest{}.mesh || request.segments != 0)
        return refuse("a scene has its own meshes, in its objects");
    if (!is_time(request.time.value_or(0))) return refuse("the time must be a number of seconds that a float can hold");
    WorldFile file = read_world(compiler, request.graph, compile_options(request.options), request.options.progress);
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

// The world that the request is about. False if there is none, with the reason in `outcome`.
bool world_of(const Compiler& compiler, const RenderRequest& request, World& world, RenderOutcome& outcome) {
    if (is_scene(request)) return world_of_file(compiler, request, world, outcome);
    if (!request.object.empty() || !request.material.empty()) {
        outcome.error = fmt::format("'{}' is a graph, which has no objects: only a scene has", request.graph);
        return false;
    }
    Outcome<World> made = world_of_graph(request);
    outcome.error = std::move(made.error);
    world = std::move(made.value);
    return outcome.error.empty();
}

// Messages from before the drawing come first, and are not reported again.
void put_first(const std::vector<Diagnostic>& earlier, RenderOutcome& drawn) {
    const auto is_known = [&](const Diagnostic& each) {
        return std::ranges::any_of(earlier, [&](const Diagnostic& e) { return to_text(e) == to_text(each); });
    };
    std::erase_if(drawn.diagnostics, is_known);
    drawn.diagnostics.insert(drawn.diagnostics.begin(), earlier.begin(), earlier.end());
}

// Leaves one of the lights; empty, or why it cannot.
std::string keep_light(const RenderRequest& request, World& world) {
    std::vector<Light>& lights = world.view.lights;
    if (!request.light) return {};
    if (*request.light < 0 || std::size_t(*request.light) >= lights.size())
        return lights.empty()
                   ? "there are no lights to choose from"
                   : fmt::format("there is no light {}: the lights are 0 to {}", *request.light, lights.size() - 1);
    lights = {lights[std::size_t(*request.light)]};
    return {};
}

RenderOutcome draw(const Compiler& compiler, const RenderRequest& request, const World& world,
                   const RenderOptions& options, RenderMachine& machine) {
    RenderOutcome drawn = draw_world(compiler, world, options, machine);
    if (drawn.ok) drawn.values = summarise(drawn.image);
    if (drawn.values.not_finite > 0) drawn.diagnostics.push_back(not_finite(compiler, request, world, options, drawn));
    return drawn;
}

// The pass of the rendering path that a preview names: "gbuffer/gbufferNormal". Null if it names none.
const PassInfo* shown_pass(const Compiler& compiler, const RenderOptions& options) {
    const std::size_t slash = options.preview.find('/');
    if (slash == std::string::npos) return nullptr;
    for (const PathInfo& path : compiler.paths()) {
        if (path.name != options.path) continue;
        for (const PassInfo& each : path.passes)
            if (each.state.name == options.preview.substr(0, slash)) return &each;
    }
    return nullptr;
}

// Null if the pass has no such target.
const RenderTarget* shown_target(const PassInfo& pass, const RenderOptions& options) {
    const std::string name = options.preview.substr(options.preview.find('/') + 1);
    for (const RenderTarget& target : pass.state.targets)
        if (target.name == name) return &target;
    return nullptr;
}

// A user who misspells a target gets the message that there is no such node: this adds the targets that exist.
void name_targets(const PassInfo& pass, std::vector<Diagnostic>& diagnostics) {
    const auto error = std::find_if(diagnostics.begin(), diagnostics.end(),
                                    [](const Diagnostic& each) { return each.severity == Severity::Error; });
    std::string names;
    for (const RenderTarget& target : pass.state.targets)
        if (target.name != kPictureTarget) names += (names.empty() ? "'" : ", '") + target.name + "'";
    if (error != diagnostics.end() && !names.empty())
        error->notes.push_back(note(fmt::format("the targets of the pass '{}' are {}", pass.state.name, names)));
}

// What is in the target when the picture is done.
RenderOutcome render_target(const Compiler& compiler, RenderRequest request, const World& world,
                            const std::string& target, RenderMachine& machine) {
    if (target == kPictureTarget)
        return failed({}, "the target 'color' of '" + request.options.preview + "' is the picture: leave out --node");
    request.options.preview.clear();
    request.options.also_shown = {target};
    RenderOutcome drawn = draw_world(compiler, world, request.options, machine);
    if (!drawn.ok) return drawn;
    drawn.image = std::move(drawn.also_shown[0]);
    drawn.also_shown.clear();
    for (std::size_t i = 3; i < drawn.image.pixels.size(); i += 4) drawn.image.pixels[i] = 1;  // it may hold any data
    drawn.values = summarise(drawn.image);
    show_values(request, drawn.image);
    return drawn;
}

RenderOutcome render_preview(const Compiler& compiler, const RenderRequest& request, World world,
                             RenderMachine& machine) {
    // Only what the object covers is data.
    const SceneBackdrop backdrop = std::exchange(world.view.backdrop, SceneBackdrop::Color);
    const glm::vec4 background = world.view.background;
    world.view.background.a = 0;
    world.view.is_default_background = false;
    RenderOutcome drawn = draw(compiler, request, world, request.options, machine);
    if (!drawn.ok) return drawn;
    show_values(request, drawn.image);
    if (backdrop == SceneBackdrop::Color) {
        if (background.a > 0) put_before(drawn.image, background.r, background.g, background.b);
        return drawn;
    }
    world.view.backdrop = backdrop;
    world.materials.clear();
    world.objects.clear();
    const RenderOutcome around = draw_world(compiler, world, request.options, machine);
    if (!around.ok) return around;
    put_before(drawn.image, around.image);
    return drawn;
}

// --- a preview in a scene

// Every sample a pixel of its own, so that it is either of the object or not.
World by_samples(World world) {
    world.view.width *= world.view.samples;
    world.view.height *= world.view.samples;
    world.view.samples = 1;
    return world;
}

// The values of a node that reads the picture behind its object: from a picture with all objects, where the object is
// seen.
RenderOutcome draw_with_picture(const Compiler& compiler, const ScenePreview& preview, const RenderOptions& options,
                                RenderMachine& machine) {
    RenderOutcome seen = draw_world(compiler, by_samples(preview.world), preview.options, machine);
    if (!seen.ok) return seen;
    RenderOutcome drawn = draw_world(compiler, by_samples(preview.with_picture), options, machine);
    if (!drawn.ok) return drawn;
    for (std::size_t i = 0; i < drawn.image.pixels.size(); i += 4) {
        float* pixel = drawn.image.pixels.data() + i;
        if (!(seen.image.pixels[i + 3] > 0)) std::fill(pixel, pixel + 4, 0.0f);
    }
    drawn.image = box_filtered(drawn.image, preview.world.view.samples);
    put_first(seen.diagnostics, drawn);
    return drawn;
}

RenderOutcome draw_values(const Compiler& compiler, const RenderRequest& request, const ScenePreview& preview,
                          const RenderOptions& options, RenderMachine& machine) {
    if (!preview.reads_picture) return draw(compiler, request, preview.world, preview.options, machine);
    RenderOutcome drawn = draw_with_picture(compiler, preview, options, machine);
    if (drawn.ok) drawn.values = summarise(drawn.image);
    if (drawn.values.not_finite > 0)
        drawn.diagnostics.push_back(not_finite(compiler, request, preview.with_picture, options, drawn));
    return drawn;
}

// The values where the objects are seen, before the scene as it looks without them, faded.
RenderOutcome render_scene_preview(const Compiler& compiler, const RenderRequest& request, const World& world,
                                   RenderMachine& machine) {
    RenderOptions options = request.options;
    options.preview.clear();
    ScenePreview preview = preview_world(compiler, world,
                                         {.port = request.options.preview,
                                          .object = request.object,
                                          .material = request.material,
                                          .scene = request.graph},
                                         options);
    RenderOutcome drawn;
    if (preview.ok) drawn = draw_values(compiler, request, preview, options, machine);
    put_first(preview.diagnostics, drawn);
    if (!drawn.ok) return drawn;
    if (drawn.values.is_empty && drawn.values.not_finite == 0)
        drawn.diagnostics.push_back(complaint(
            request.graph, Severity::Warning, Complaint::NoPreviewSeen,
            {request.object.empty() ? fmt::format("all objects of '{}' are", fmt::join(preview.materials, "' and '"))
                                    : fmt::format("the object '{}' is", request.object)}));
    show_values(request, drawn.image);
    if (request.background == "none") return drawn;
    RenderOutcome around = draw_world(compiler, world, options, machine);
    put_first(around.diagnostics, drawn);
    if (!around.ok) {
        around.diagnostics = std::move(drawn.diagnostics);
        return around;
    }
    fade(around.image);
    put_before(drawn.image, around.image);
    drawn.dependencies = std::move(around.dependencies);
    return drawn;
}

}  // namespace

Outcome<World> world_of_graph(const RenderRequest& request) {
    Outcome<Scene> scene = read_scene(request);
    if (!scene) return Failure{scene.error};
    World world{.view = std::move(scene.value),
                .materials = {{.graph = request.graph, .overrides = request.overrides}}};
    world.objects.push_back({.mesh = std::make_shared<const Mesh>(std::move(world.view.mesh))});
    world.view.mesh = {};
    world.pixel_light_count = int(world.view.lights.size());
    return world;
}

RenderOutcome render(const Compiler& compiler, const RenderRequest& request, RenderMachine& machine) {
    if (request.options.via != "glsl" && request.options.via != "hlsl" && request.options.via != "cpu")
        return failed({}, "there is no way to render via '" + request.options.via + "'; there are: glsl, hlsl, cpu");
    RenderOutcome outcome;
    World world;
    if (!world_of(compiler, request, world, outcome)) return outcome;
    const bool is_preview = !request.options.preview.empty();
    if (!is_preview && !(request.object + request.material).empty())
        return failed({}, "an object or a material is chosen for a preview: name a node, too");
    if (std::string error = keep_light(request, world); !error.empty())
        return failed(std::move(outcome), std::move(error));
    const double exposure = is_preview ? 0 : request.exposure.value_or(exposure_for(world.view));
    for (int c = 0; c < 3; ++c) world.view.background[c] *= float(std::exp2(-exposure));
    const PassInfo* const pass = shown_pass(compiler, request.options);
    const RenderTarget* const target = pass ? shown_target(*pass, request.options) : nullptr;
    RenderOutcome drawn = target              ? render_target(compiler, request, world, target->name, machine)
                          : !is_preview       ? draw(compiler, request, world, request.options, machine)
                          : is_scene(request) ? render_scene_preview(compiler, request, world, machine)
                                              : render_preview(compiler, request, world, machine);
    if (pass && !target && !drawn.ok) name_targets(*pass, drawn.diagnostics);
    drawn.exposure = exposure;
    put_first(outcome.diagnostics, drawn);
    drawn.dependencies.insert(drawn.dependencies.end(), outcome.dependencies.begin(), outcome.dependencies.end());
    if (!is_scene(request) && drawn.ok && is_empty(drawn.image, world.view))
        drawn.diagnostics.push_back(complaint(request.graph, Severity::Warning, Complaint::NothingSeen, {}));
    return drawn;
}

TraceOutcome trace(const Compiler& compiler, const RenderRequest& request, int x, int y, Precision precision) {
    RenderOutcome read;
    World world;
    const bool has_world = world_of(compiler, request, world, read);
    TraceOutcome refused{.diagnostics = std::move(read.diagnostics), .error = std::move(read.error)};
    if (!has_world) return refused;
    TraceWish wish{.x = x, .y = y, .precision = precision};
    if (!request.object.empty()) {
        const Outcome<std::size_t> object = find_object(world, request.object);
        if (!object) {
            refused.diagnostics.push_back(unknown_object(world, request.object, request.graph));
            return refused;
        }
        wish.object = object.value;
    }
    TraceOutcome traced = trace_world(compiler, world, request.options, wish);
    traced.diagnostics.insert(traced.diagnostics.begin(), refused.diagnostics.begin(), refused.diagnostics.end());
    return traced;
}

}  // namespace patina::runtime
