// patina render: graphs and scenes to pictures, by Vulkan or on the CPU.
#include <filesystem>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/files.h"
#include "compiler/cli/outputs.h"
#include "compiler/cli/picture_options.h"
#include "patina/output_name.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::vector<std::string> graphs;
    std::vector<std::string> set;
    std::string output;
    runtime::RenderRequest request;
    PathOptions path;
};

bool is_picture(std::string_view path) {
    return path.ends_with(".png") || path.ends_with(".exr");
}

// A picture, also one that goes through standard output, a device or a FIFO, which holds a PNG if its name does not say
// otherwise.
bool is_one_picture(const std::string& output) {
    return is_picture(output) || is_standard_output(output) || is_stream(output);
}

// -o names a picture, or a folder for the pictures of all graphs.
std::string output_of(const Arguments& arguments, const std::string& graph) {
    if (is_one_picture(arguments.output)) return arguments.output;
    return join_path(arguments.output, output_name(graph) + ".png");
}

Exit write(Outputs& outputs, const Console& console, const Arguments& arguments, const std::string& graph,
           const runtime::RenderOutcome& outcome) {
    const std::string path = output_of(arguments, graph);
    runtime::Outcome<std::string> bytes =
        path.ends_with(".exr") ? runtime::encode_exr(outcome.image) : runtime::encode_png(outcome.image);
    if (!bytes) {
        complain(console, Complaint::CannotWrite, {"cannot write '" + path + "': " + bytes.error});
        return Exit::Wrong;
    }
    OutputFiles files;
    files.add(path, std::move(bytes.value));
    if (!outputs.write(graph, files, outcome.dependencies)) return Exit::Wrong;
    say(console, files);
    return Exit::Ok;
}

Exit render_graph(Outputs& outputs, const Console& console, const Arguments& arguments, const Compiler& compiler,
                  const std::string& graph, runtime::RenderMachine& machine) {
    runtime::RenderRequest request = arguments.request;
    request.graph = graph;
    request.options.progress = [&](double share) { show_share(console, share, graph); };
    const runtime::RenderOutcome outcome = runtime::render(compiler, request, machine);
    report(console, outcome.diagnostics);
    if (!outcome.error.empty()) complain(console, Complaint::CannotRender, {outcome.error});
    if (outcome.missing_machine) return Exit::Machine;
    return outcome.ok ? write(outputs, console, arguments, graph, outcome) : Exit::Wrong;
}

// Empty, or why no picture can have this name.
std::string not_an_output(const std::string& output) {
    std::error_code ignored;  // links that lead nowhere: writing says so
    if (output.empty() || is_one_picture(output) || std::filesystem::is_directory(output, ignored)) return {};
    const bool is_file = std::filesystem::exists(output, ignored) || std::filesystem::path(output).has_extension();
    return is_file ? "'" + output + "' is not a .png file, an .exr file or a folder" : std::string();
}

// Checks what can be wrong before the first graph is read.
void complete(Arguments& arguments, bool has_mesh) {
    if (arguments.path.path == "all")
        throw CLI::ValidationError("--path",
                                   "a picture is drawn along one path: name one; 'patina compile' takes 'all'");
    for (const std::string& graph : arguments.graphs) {
        if (has_mesh && graph.ends_with(".scene.json"))
            throw CLI::ValidationError("--mesh", "'" + graph + "' is a scene, which has meshes of its own");
    }
    take_overrides(arguments.set, arguments.path, arguments.request);
    if (const std::string wrong = not_an_output(arguments.output); !wrong.empty())
        throw CLI::ValidationError("--output", wrong);
    if (arguments.graphs.size() > 1 && is_one_picture(arguments.output)) {
        throw CLI::ValidationError("--output", "several graphs cannot share one picture: name a folder");
    }
    refuse_equal_outputs(arguments.graphs, ".png", "render");
}

}  // namespace

void add_render(Program& program) {
    CLI::App& command = add_command(
        program, "render",
        {"patina render rust.graph.json -o rust.png --mesh torus --size 256",
         "patina render rust.graph.json --set _Roughness=0.2 --set _MainTex=other.png",
         "patina render rust.graph.json --node mask -o mask.png", "patina render *.graph.json -o pictures",
         "patina render room.scene.json --path deferred -o room.png",
         "patina render rust.graph.json --light 'directional direction=1,1,1 intensity=2' --ambient 0.1 --via cpu"});
    auto arguments = std::make_shared<Arguments>();
    runtime::RenderRequest& request = arguments->request;
    command
        .add_option("GRAPH", arguments->graphs,
                    "Material graphs and scenes (JSON). A scene has meshes and values of its own: --mesh, --set and "
                    "--node are for graphs")
        ->required()
        ->type_name(" ");
    command
        .add_option(
            "-o,--output", arguments->output,
            "A .png or .exr file, a folder (NAME.png), or - for a PNG on standard output; default: the current folder")
        ->type_name("OUT");
    command
        .add_option("--node", request.options.preview,
                    "Show this port, unlit: mask, rust.amount, or layers/mask inside a sub-graph")
        ->type_name("PORT")
        ->check([](const std::string& port) { return port.empty() ? std::string("it is empty") : std::string(); });
    add_picture_options(command, arguments->set, request);
    add_path_options(command, arguments->path);
    command
        .add_option("--via", request.options.via,
                    "Render with the GLSL or the HLSL on the GPU, or with the CPU reference; default: glsl")
        ->type_name("glsl|hlsl|cpu")
        ->check(one_of("a way to render", {"glsl", "hlsl", "cpu"}));
    command
        .add_option("--device", request.options.device,
                    "Use the GPU whose name contains NAME; default: the software renderer")
        ->type_name("NAME");
    command.add_flag("--vulkan-validation", request.options.validation, "Turn on the Khronos validation layer");
    command.parse_complete_callback(
        [arguments, mesh = command.get_option("--mesh")] { complete(*arguments, mesh->count() > 0); });

    set_work(program, command, [arguments](const Console& console) {
        if (console.json && is_standard_output(arguments->output)) {
            complain(console, Complaint::MixedOutput, {"-o " + arguments->output});
            return Exit::Usage;
        }
        const Compiler compiler;
        runtime::RenderMachine machine;
        Outputs outputs(console);
        Exit exit = Exit::Ok;
        for (std::size_t i = 0; i < arguments->graphs.size() && exit != Exit::Machine; ++i) {
            show_progress(console, i, arguments->graphs.size(), arguments->graphs[i]);
            exit = worse(exit, render_graph(outputs, console, *arguments, compiler, arguments->graphs[i], machine));
        }
        return exit;
    });
}

}  // namespace patina::cli
