// patina bake: the surface of a graph as textures, and as a glTF model that any viewer shows.
#include "runtime/bake/bake.h"

#include <fmt/format.h>

#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/failures/failures.h"
#include "compiler/cli/files.h"
#include "compiler/cli/outputs.h"
#include "compiler/cli/render/picture_options.h"
#include "patina/output_name.h"

namespace patina::cli {
namespace {

// The textures take some 200 bytes for each texel while they are made.
constexpr int kLargest = 4096;
constexpr std::string_view kMetallic = "metallic-roughness", kSpecular = "specular-glossiness";

struct Arguments {
    std::vector<std::string> graphs, set;
    std::string folder, time, format = "png";
    std::string workflow{kMetallic};
    PathOptions path;  // -D alone
    runtime::RenderRequest request;
};

void complete(Arguments& arguments) {
    for (const std::string& graph : arguments.graphs) {
        if (is_scene(graph))
            throw CLI::ValidationError("GRAPHS", "'" + graph + "' is a scene: name the graph of one of its materials");
    }
    refuse_equal_outputs(arguments.graphs, ".glb", "bake");
    take_overrides(arguments.set, arguments.path, arguments.request);
    if (arguments.time.empty()) return;
    double seconds = 0;
    if (!CLI::detail::lexical_cast(arguments.time, seconds))
        throw CLI::ValidationError("--time", "'" + arguments.time + "' is not a number of seconds");
    if (const std::string wrong = is_time_word(arguments.time); !wrong.empty())
        throw CLI::ValidationError("--time", wrong);
    arguments.request.time = seconds;
}

// What a viewer does otherwise than the graph.
void say_lighting(const Console& console, const std::string& graph, const runtime::BakeOutcome& made) {
    if (made.is_unlit || made.lighting == "gltf") return;
    remark(console, fmt::format("{}: viewers light the model by the rules of glTF, not by '{}'", graph,
                                made.lighting.empty() ? "its own lighting" : made.lighting));
}

Exit bake_graph(Outputs& outputs, const Console& console, const Arguments& arguments, const Compiler& compiler,
                const std::string& graph, runtime::RenderMachine& machine) {
    runtime::BakeRequest request{.render = arguments.request,
                                 .is_specular = arguments.workflow == kSpecular,
                                 .is_exr = arguments.format == "exr",
                                 .name = output_name(graph)};
    request.render.graph = graph;
    request.render.options.progress = [&](double share, std::string_view file) {
        show_share(console, share, file.empty() ? graph : fmt::format("prefiltering {}", file));
    };
    runtime::BakeOutcome made = runtime::bake(compiler, request, machine);
    report(console, made.diagnostics);
    if (!made.error.empty()) complain(console, Complaint::CannotRender, {made.error});
    if (made.missing_machine) return Exit::Machine;
    if (!made.ok) return Exit::Wrong;
    OutputFiles files;
    for (runtime::BakedFile& file : made.files)
        files.add(join_path(arguments.folder, file.name), std::move(file.bytes));
    if (!outputs.write(graph, files, made.dependencies)) return Exit::Wrong;
    say_lighting(console, graph, made);
    say(console, files);
    return Exit::Ok;
}

}  // namespace

void add_bake(Program& program) {
    CLI::App& command = add_command(
        program, "bake",
        {"patina bake rust.graph.json -o rust", "patina bake rust.graph.json --mesh chair.glb --size 2048 -o chair",
         "patina bake lava.graph.json --time 0 -o lava",
         "patina bake rust.graph.json --workflow specular-glossiness --format exr -o rust"});
    add_pixels_option(program, command);
    auto arguments = std::make_shared<Arguments>();
    runtime::RenderRequest& request = arguments->request;
    request.size = 1024;
    command.add_option("GRAPHS", arguments->graphs, "Material graphs (JSON)")->required()->type_name(" ");
    command
        .add_option("-o,--output", arguments->folder,
                    "Folder for NAME.glb and its textures, NAME.baseColor.png and so on; default: the current folder")
        ->type_name("DIR")
        ->check(is_folder_name);
    command.add_option("--size", request.size, "Width and height of the textures in texels; default: 1024")
        ->type_name("N")
        ->check(CLI::Range(1, kLargest));
    command
        .add_option("--workflow", arguments->workflow,
                    "The properties of the glTF material. specular-glossiness is KHR_materials_pbrSpecularGlossiness, "
                    "which few viewers know; default: metallic-roughness")
        ->type_name("metallic-roughness|specular-glossiness")
        ->check(one_of("a workflow of glTF", {std::string(kMetallic), std::string(kSpecular)}));
    command
        .add_option("--format", arguments->format,
                    "The files of the textures; those inside of the model are always PNG; default: png")
        ->type_name("png|exr")
        ->check(one_of("a format", {"png", "exr"}));
    add_set_option(command, arguments->set);
    add_mesh_options(command, request);
    command.add_option("--time", arguments->time, "Bake a surface that depends on the time as it is at this second")
        ->type_name("T");
    add_camera_option(command, request);
    add_light_options(command, request);
    add_define_option(command, arguments->path.defines);
    add_include_option(command, request.options.include_dirs);
    add_device_options(command, request);
    set_check(command, [arguments] { complete(*arguments); });

    set_work(program, command, [arguments](const Console& console) {
        const Compiler compiler;
        runtime::RenderMachine machine;
        Outputs outputs(console);
        Exit exit = Exit::Ok;
        const std::size_t count = arguments->graphs.size();
        for (std::size_t i = 0; i < count && exit != Exit::Machine; ++i) {
            show_progress(console, i, count, arguments->graphs[i]);
            const std::string& graph = arguments->graphs[i];
            exit = worse(exit, guarded(console, graph, [&] {
                             return bake_graph(outputs, console, *arguments, compiler, graph, machine);
                         }));
        }
        return exit;
    });
}

}  // namespace patina::cli
