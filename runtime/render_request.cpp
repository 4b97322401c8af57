#include "runtime/render_request.h"

#include <algorithm>
#include <filesystem>

#include "patina/validate.h"
#include "runtime/scene_text.h"

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
                .height = request.size,
                .samples = request.samples};
    if (!request.lights.empty()) scene.lights.clear();
    for (const std::string& text : request.lights) {
        if (text == "none") continue;
        Outcome<Light> light = parse_light(text);
        if (!light) return Failure{light.error};
        scene.lights.push_back(light.value);
    }
    if (scene.lights.size() > kMostLights)
        return Failure{"there are " + std::to_string(scene.lights.size()) + " lights, more than the limit of " +
                       std::to_string(kMostLights)};
    if (!request.ambient.empty()) {
        Outcome<SphericalHarmonics> ambient = parse_ambient(request.ambient);
        if (!ambient) return Failure{ambient.error};
        scene.ambient = ambient.value;
        scene.environment = nullptr;
    }
    if (!request.camera.empty()) {
        Outcome<Camera> camera = parse_camera(request.camera, scene.camera);
        if (!camera) return Failure{camera.error};
        scene.camera = camera.value;
    }
    return scene;
}

// "forward" if there is one, else the first that draws meshes.
std::string choose_pass(const Reflection& reflection, const std::string& wanted) {
    if (!wanted.empty()) return wanted;
    const Pass* first = nullptr;
    for (const Pass& pass : reflection.passes) {
        if (pass.name == "forward") return pass.name;
        if (!first && pass.draws == "objects") first = &pass;
    }
    return first ? first->name : "forward";
}

// SPIR-V of a stage of the pass; what glslang says goes to `diagnostics`. Empty on an error.
std::vector<std::uint32_t> spirv_of(const Result& result, const std::string& pass, Stage stage, Target target,
                                    std::vector<Diagnostic>& diagnostics) {
    for (const Shader& shader : result.shaders) {
        if (shader.pass != pass || shader.stage != stage || shader.target != target) continue;
        Validated validated = validate(shader);
        diagnostics.insert(diagnostics.end(), validated.diagnostics.begin(), validated.diagnostics.end());
        if (validated.ok) return validated.spirv;
    }
    return {};
}

// Opens the device that the request wants, unless it is open already. Empty: done.
std::string open_machine(const RenderRequest& request, RenderMachine& machine) {
    DeviceOptions wanted{.validation = request.validation, .device = request.device};
    if (machine.renderer && machine.options == wanted) return "";
    machine.renderer.reset();
    Outcome<std::unique_ptr<Renderer>> opened = Renderer::open(wanted);
    if (!opened) return opened.error;
    machine.renderer = std::move(opened.value);
    machine.options = wanted;
    return "";
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

    bool on_cpu = request.via == "cpu";
    made.compiled =
        compiler.compile_file(request.graph, {.targets = {request.via == "hlsl" ? Target::Hlsl : Target::Glsl},
                                              .passes = {},
                                              .include_dirs = request.include_dirs,
                                              .loader = {},
                                              .preview = request.preview,
                                              .dump = {},
                                              .keep_programs = on_cpu});
    outcome.diagnostics = made.compiled.diagnostics;
    if (!made.compiled.ok) return false;

    const Reflection& reflection = made.compiled.reflection;
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
                 .pass = choose_pass(reflection, request.pass),
                 .scene = &made.scene,
                 .blocks = made.blocks,
                 .textures = made.loaded.textures,
                 .program = made.compiled.program.get(),
                 .progress = request.progress};
    if (!on_cpu) return true;
    if (std::string names = anisotropic_textures(reflection, made.draw.pass); !names.empty())
        outcome.diagnostics.push_back(complaint(request, Severity::Warning, "no-anisotropy",
                                                "the CPU reference samples without anisotropy: " + names));
    return true;
}

RenderOutcome draw_on_gpu(const RenderRequest& request, const Result& compiled, Draw draw, RenderMachine& machine,
                          RenderOutcome outcome) {
    Target target = request.via == "hlsl" ? Target::Hlsl : Target::Glsl;
    auto vertex = spirv_of(compiled, draw.pass, Stage::Vertex, target, outcome.diagnostics);
    auto fragment = spirv_of(compiled, draw.pass, Stage::Fragment, target, outcome.diagnostics);
    if (vertex.empty() || fragment.empty()) {
        bool explained = std::any_of(outcome.diagnostics.begin(), outcome.diagnostics.end(),
                                     [](const Diagnostic& d) { return d.severity == Severity::Error; });
        return failed(std::move(outcome), explained ? "" : "the pass '" + draw.pass + "' has no shaders to run");
    }
    if (std::string error = open_machine(request, machine); !error.empty()) {
        outcome.missing_machine = true;
        return failed(std::move(outcome), error);
    }
    draw.vertex_spirv = vertex;
    draw.fragment_spirv = fragment;
    if (Outcome<const Pass*> pass = drawable_pass(draw); !pass) return failed(std::move(outcome), pass.error);
    if (std::string error = machine.renderer->beyond_limits(draw); !error.empty()) {
        outcome.missing_machine = true;
        return failed(std::move(outcome), error);
    }
    std::size_t messages_before = machine.renderer->messages().size();
    Outcome<Image> image = machine.renderer->draw(draw);
    if (!image) return failed(std::move(outcome), image.error);
    const std::vector<std::string>& messages = machine.renderer->messages();
    if (messages.size() > messages_before)
        return failed(std::move(outcome), "the Vulkan validation layer says: " + messages[messages_before]);
    outcome.image = std::move(image.value);
    outcome.ok = true;
    return outcome;
}

}  // namespace

RenderOutcome render(const Compiler& compiler, const RenderRequest& request, RenderMachine& machine) {
    RenderOutcome outcome;
    if (request.via != "glsl" && request.via != "hlsl" && request.via != "cpu")
        return failed({}, "there is no way to render via '" + request.via + "'; there are: glsl, hlsl, cpu");
    Prepared prepared;
    if (!prepare(compiler, request, prepared, outcome)) return outcome;
    if (request.via != "cpu") {
        return draw_on_gpu(request, prepared.compiled, prepared.draw, machine, std::move(outcome));
    }
    Outcome<Image> image = cpu_draw(prepared.draw);
    if (!image) return failed(std::move(outcome), image.error);
    outcome.image = std::move(image.value);
    outcome.ok = true;
    return outcome;
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
