#include "compiler/cli/render/picture_options.h"

#include "patina/name_value.h"
#include "patina/scene.h"
#include "runtime/gltf/gltf_model.h"
#include "runtime/mesh/mesh.h"

namespace patina::cli {
namespace {

void add_size_options(CLI::App& command, runtime::RenderRequest& request) {
    CLI::Option* size = command
                            .add_option("--size", request.size,
                                        "Width and height in pixels; default: 512. A large picture is drawn in tiles")
                            ->type_name("N")
                            ->check(CLI::Range(1, 8192));
    command.add_option("--width", request.size, "Width in pixels; default: 512")
        ->type_name("N")
        ->check(CLI::Range(1, 8192))
        ->excludes(size);
    command.add_option("--height", request.height, "Height in pixels; default: as the width")
        ->type_name("N")
        ->check(CLI::Range(1, 8192))
        ->excludes(size);
    command
        .add_option("--samples", request.samples, "Samples along each axis of a pixel; default: 4, which is 16 a pixel")
        ->type_name("N")
        ->check(CLI::Range(1, 16));
}

void add_background_option(CLI::App& command, runtime::RenderRequest& request) {
    command
        .add_option("--background", request.background,
                    "The background: the surroundings, the same out of focus, a colour, or none, which is transparent. "
                    "Default: dark grey; env if --env is a picture and a material reads its background, as glass does")
        ->type_name("env|blur|COLOR|none");
}

}  // namespace

void add_mesh_options(CLI::App& command, runtime::RenderRequest& request) {
    std::vector<std::string> meshes;
    for (std::string_view name : runtime::mesh_names()) meshes.emplace_back(name);
    std::string list;
    for (const std::string& mesh : meshes) list += (list.empty() ? "" : "|") + mesh;
    const std::function<std::string(std::string)> is_built_in = one_of("a mesh", std::move(meshes));
    command
        .add_option("--mesh", request.mesh,
                    "The mesh to draw: a built-in one, or a glTF file, or one of its nodes with all nodes below it; "
                    "default: sphere")
        ->type_name(list + "|FILE.glb[#NODE]")
        ->check([is_built_in](const std::string& word) {
            return runtime::is_model_name(word) ? std::string() : is_built_in(word);
        });
    command
        .add_option("--segments", request.segments,
                    "How finely the mesh is divided: the number of quads around a round mesh, or along each side of a "
                    "flat one. A coarse mesh shows which values are computed at vertices")
        ->type_name("N")
        ->check(CLI::Range(kLeastSegments, kMostSegments));
}

void add_light_options(CLI::App& command, runtime::RenderRequest& request) {
    command
        .add_option(
            "--light", request.lights,
            "Light it with this instead of the default lights: 'point position=1,2,0 color=#f80', or none; repeatable. "
            "A picture as --env leaves out the default lights by itself")
        ->type_name("LIGHT")
        ->allow_extra_args(false);
    CLI::Option* environment =
        command
            .add_option("--env", request.environment,
                        "The surroundings: a picture of them (equirectangular, or the faces of a cube), 'sunset.hdr "
                        "rotation=90 intensity=2', studio or none; default: studio")
            ->type_name("FILE")
            ->check(is_not_empty);
    command.add_option("--ambient", request.ambient, "Ambient light: a colour, or 'sky=#9ab horizon=0.2 ground=0.05'")
        ->type_name("LIGHT")
        ->excludes(environment);
}

void add_camera_option(CLI::App& command, runtime::RenderRequest& request) {
    command
        .add_option("--camera", request.camera,
                    "The camera: 'position=2,1,3 target=0,0,0 fov=35'; of a model also the name of one of its cameras")
        ->type_name("CAMERA");
}

// The GPU, or the CPU reference.
void add_device_options(CLI::App& command, runtime::RenderRequest& request) {
    command
        .add_option("--via", request.options.via,
                    "Render with the GLSL or the HLSL on the GPU, or with the CPU reference; default: glsl")
        ->type_name("glsl|hlsl|cpu")
        ->check(one_of("a way to render", {"glsl", "hlsl", "cpu"}));
    command
        .add_option("--device", request.options.device,
                    "Use the GPU whose name contains NAME; default: the software renderer")
        ->type_name("NAME");
}

void add_set_option(CLI::App& command, std::vector<std::string>& set) {
    command.add_option("--set", set, "Set a property: _Roughness=0.2, _MainTex=rust.png; repeatable")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

bool is_scene(const std::string& graph) {
    return graph.ends_with(".scene.json");
}

bool is_model(const std::string& graph) {
    return runtime::is_model_name(graph);
}

void refuse_mesh(const std::vector<std::string>& graphs, bool has_mesh) {
    for (const std::string& graph : graphs) {
        if (has_mesh && (is_scene(graph) || is_model(graph)))
            throw CLI::ValidationError("--mesh", "'" + graph + "' is a " + (is_scene(graph) ? "scene" : "model") +
                                                     ", which has meshes of its own");
    }
}

void refuse_object(const std::string& graph, const std::string& option, const std::string& value) {
    if (!value.empty() && !is_scene(graph) && !is_model(graph))
        throw CLI::ValidationError(option, "'" + graph + "' is a graph: only a scene (NAME.scene.json) has objects");
}

std::string is_not_empty(const std::string& word) {
    return word.empty() ? "it is empty" : "";
}

std::string is_time_word(const std::string& word) {
    double seconds = 0;
    if (!CLI::detail::lexical_cast(word, seconds)) return {};  // CLI11 reports that it is not a number
    return runtime::is_time(seconds) ? "" : "'" + word + "' is not a number of seconds that a shader can hold";
}

void add_picture_options(CLI::App& command, std::vector<std::string>& set, runtime::RenderRequest& request) {
    add_set_option(command, set);
    add_mesh_options(command, request);
    add_size_options(command, request);
    add_light_options(command, request);
    add_background_option(command, request);
    add_camera_option(command, request);
    add_include_option(command, request.options.include_dirs);
}

void take_overrides(const std::vector<std::string>& set, const PathOptions& path, runtime::RenderRequest& request) {
    request.options.path = path.path;
    request.options.switches = path.switches();
    std::map<std::string, std::string> values;
    for (const auto& [name, value] : request.options.switches) set_once(values, name, value);
    for (const std::string& text : set) {
        const auto [given, value] = split_name_value(text);
        if (given.empty() || !value) {
            throw CLI::ValidationError("--set", "'" + text + "' is not of the form NAME=VALUE");
        }
        const std::string name(given);
        if (const std::string why = set_once(values, name, std::string(*value)); !why.empty())
            throw CLI::ValidationError("--set", why);
        request.overrides[name] = *value;
    }
}

}  // namespace patina::cli
