// patina render: graphs and scenes to pictures, by Vulkan or on the CPU.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/eval/sweep.h"
#include "compiler/cli/failures/failures.h"
#include "compiler/cli/files.h"
#include "compiler/cli/outputs.h"
#include "compiler/cli/render/model_file.h"
#include "compiler/cli/render/picture_options.h"
#include "compiler/cli/render/picture_sweep.h"
#include "compiler/importers/source_text.h"
#include "patina/output_name.h"
#include "runtime/picture/tone.h"
#include "runtime/render/render_layers.h"
#include "runtime/scene/scene_text.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::vector<std::string> graphs;
    std::vector<std::string> set;
    std::string output;
    runtime::RenderRequest request;
    std::string range, time, variant;
    std::string tonemap = "none";
    runtime::Tone tone;
    std::vector<std::optional<double>> times = {{}};  // one a picture; nothing: --time is not given
    PathOptions path;
    Sweep sweep;
    std::vector<std::string> aov;
};

// What is drawn for one file of pictures.
struct Drawn {
    runtime::RenderOutcome outcome{};
    std::vector<runtime::Layer> layers{};  // of --aov
    std::vector<std::string> remarks{};    // on the models of --lighting
};

constexpr std::size_t kMostFrames = 10000;
constexpr double kDarkest = -3;  // stops: below, what does not clip becomes black
constexpr double kMostOfIt = 0.5;

bool is_picture(std::string_view path) {
    return path.ends_with(".png") || path.ends_with(".exr");
}

// True if the output is one picture. Standard output, a device and a FIFO get a PNG, unless their name ends otherwise.
bool is_one_picture(const std::string& output) {
    return is_picture(output) || is_standard_output(output) || is_stream(output);
}

// -o names a picture, or a folder for the pictures of all graphs.
std::string output_of(const Arguments& arguments, const std::string& graph, std::size_t frame) {
    const std::string name = is_model(graph) ? std::filesystem::path(graph).stem().string() : output_name(graph);
    std::string path = is_one_picture(arguments.output) ? arguments.output : join_path(arguments.output, name + ".png");
    if (arguments.times.size() > 1) path.insert(path.rfind('.'), fmt::format(".{:04}", frame));
    return path;
}

Exit write(Outputs& outputs, const Console& console, const Arguments& arguments, const std::string& graph,
           std::size_t frame, const Drawn& drawn) {
    const std::string path = output_of(arguments, graph, frame);
    const runtime::RenderOutcome& outcome = drawn.outcome;
    runtime::Outcome<std::string> bytes = !drawn.layers.empty()    ? runtime::encode_layers(outcome.image, drawn.layers)
                                          : path.ends_with(".exr") ? runtime::encode_exr(outcome.image)
                                                                   : runtime::encode_png(outcome.image);
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

// A picture shows values from 0 to 1, so those of a preview may be outside.
void say_range(const Console& console, const Arguments& arguments, const runtime::RenderOutcome& outcome) {
    const runtime::DataSummary& values = outcome.values;
    if (arguments.request.options.preview.empty() || values.is_empty || arguments.request.range) return;
    constexpr double kVisible = 0.5 / 255;
    if (values.low > -kVisible && values.high < 1 + kVisible) return;
    // Rounded outward, to about three digits.
    double low = values.low, high = values.high;
    if (!(low < high)) low -= 1, high += 1;
    const double step = std::pow(10.0, std::floor(std::log10(high - low)) - 2);
    low = std::floor(low / step) * step;
    high = std::ceil(high / step) * step;
    remark(console,
           fmt::format(
               "'{}' goes from {:.4g} to {:.4g}, and the picture shows 0 to 1: --range {:.9g}..{:.9g} shows all of it",
               arguments.request.options.preview, values.low, values.high, low, high));
}

// Light above 1 is lost in a PNG.
void say_clipping(const Console& console, const Arguments& arguments, const std::string& path,
                  const runtime::RenderOutcome& outcome) {
    if (!arguments.request.options.preview.empty() || path.ends_with(".exr")) return;
    const std::optional<runtime::Clipping> clipped = runtime::clipping(outcome.image);
    if (!clipped) return;
    const bool has_curve = arguments.tone.curve != runtime::Tonemap::None;
    const double exposure = arguments.tone.exposure.value_or(outcome.exposure) + clipped->exposure;
    // A dark picture is no answer to highlights.
    const bool is_too_bright =
        clipped->share >= runtime::kHighlights && (clipped->exposure >= kDarkest || clipped->share >= kMostOfIt);
    const bool has_highlights = clipped->left >= runtime::kUnseen;
    std::string advice;
    if (is_too_bright && has_highlights)
        advice = fmt::format("--exposure {:.2f} shows all but highlights, {:.1f} %{}", exposure, 100 * clipped->left,
                             has_curve ? "" : ", and --tonemap khronos-neutral shows these, too");
    else if (is_too_bright)
        advice = fmt::format("--exposure {:.2f} shows all{}", exposure,
                             has_curve ? "" : ", and so does --tonemap khronos-neutral");
    else if (!has_curve)
        advice = "--tonemap khronos-neutral shows such highlights";
    remark(console, fmt::format("{:.1f} % of the pixels are brighter than white and clip{}{}", 100 * clipped->share,
                                advice.empty() ? "" : ": ", advice));
}

// The exposure that was chosen, because the user set none.
void say_exposure(const Console& console, const Arguments& arguments, const runtime::RenderOutcome& outcome) {
    if (arguments.tone.exposure || outcome.exposure == 0) return;
    remark(console, fmt::format("all light comes from a picture, whose exposure is {:.2f}, so that white surfaces stay "
                                "below white: --exposure 0 shows the light unchanged",
                                outcome.exposure));
}

// A picture, a sheet of pictures, or a picture with layers, with its tone.
Drawn draw(const Arguments& arguments, const Compiler& compiler, const runtime::RenderRequest& request,
           runtime::RenderMachine& machine) {
    if (!arguments.sweep.axes.empty()) {
        SheetOutcome sheet = render_sheet(compiler, request, arguments.sweep, arguments.tone, machine);
        return {.outcome = std::move(sheet.drawn), .remarks = lines_of(sheet.left_out, sheet.partial)};
    }
    Drawn made;
    if (arguments.aov.empty()) {
        made.outcome = runtime::render(compiler, request, machine);
    } else {
        runtime::LayersOutcome layers = runtime::render_layers(compiler, request, arguments.aov, machine);
        made = {.outcome = std::move(layers.drawn), .layers = std::move(layers.layers)};
    }
    if (made.outcome.ok)
        made.outcome.image = runtime::toned(
            std::move(made.outcome.image),
            {.exposure = arguments.tone.exposure.value_or(made.outcome.exposure), .curve = arguments.tone.curve});
    return made;
}

// The diagnostics of earlier pictures of a sequence: code, file and text.
using Said = std::set<std::tuple<std::string, std::string, std::string>>;

// What the picture of a graph, a scene or a model is asked for; nothing: the model cannot be imported, and it has
// complained.
std::optional<runtime::RenderRequest> request_for(const Console& console, const Arguments& arguments,
                                                  const std::string& graph) {
    runtime::RenderRequest request = arguments.request;
    request.graph = graph;
    if (!is_model(graph)) return request;
    importers::Options options{.variant = arguments.variant, .is_lit = runtime::is_picture(request.environment)};
    // Of a model, a camera can be named; words that state one have an '='.
    if (request.camera.find('=') == std::string::npos) options.camera = std::exchange(request.camera, {});
    runtime::Outcome<ModelFile> model = import_model(graph, options);
    if (!model) {
        const Diagnostic wrong = importers::cannot_import(graph, model.error);
        report(console, {&wrong, 1});
        return std::nullopt;
    }
    if (model.value.refused > 0) {
        remark(console,
               fmt::format("{} of '{}' {} not in the picture: 'patina import {} -o DIR --report' says what, and "
                           "why",
                           model.value.refused == 1 ? "1 property" : fmt::format("{} properties", model.value.refused),
                           graph, model.value.refused == 1 ? "is" : "are", graph));
    }
    request.graph = model.value.scene;
    request.options.files = model.value.files;
    return request;
}

Exit render_graph(Outputs& outputs, const Console& console, const Arguments& arguments, const Compiler& compiler,
                  const std::string& graph, runtime::RenderRequest request, std::size_t frame, Said& said,
                  runtime::RenderMachine& machine) {
    if (!outputs.is_possible(output_of(arguments, graph, frame))) return Exit::Wrong;
    request.time = arguments.times[frame];
    request.options.progress = [&](double share, std::string_view file) {
        show_share(console, share, file.empty() ? graph : fmt::format("prefiltering {}", file));
    };
    Drawn drawn = draw(arguments, compiler, request, machine);
    runtime::RenderOutcome& outcome = drawn.outcome;
    // A warning that an earlier picture gave is not repeated.
    std::vector<Diagnostic> news;
    for (const Diagnostic& each : outcome.diagnostics) {
        const bool is_counted = each.code == code_of(Complaint::PixelsNotFinite);  // with other numbers each time
        if (!said.insert({each.code, each.file, is_counted ? "" : to_text(each)}).second) continue;
        news.push_back(each);
        if (each.file == "preview") news.back().file = arguments.aov.empty() ? "--node" : "--aov";
    }
    report(console, news);
    if (!outcome.error.empty()) complain(console, Complaint::CannotRender, {outcome.error});
    if (outcome.missing_machine) return Exit::Machine;
    if (outcome.ok && frame == 0)
        for (const std::string& line : drawn.remarks) remark(console, line);
    if (outcome.ok && frame == 0) {
        say_range(console, arguments, outcome);
        say_exposure(console, arguments, outcome);
        say_clipping(console, arguments, output_of(arguments, graph, frame), outcome);
    }
    return outcome.ok ? write(outputs, console, arguments, graph, frame, drawn) : Exit::Wrong;
}

// Empty, or why no picture can have this name.
std::string not_an_output(const std::string& output) {
    std::error_code ignored;  // links that lead nowhere: writing says so
    if (output.empty() || is_one_picture(output) || std::filesystem::is_directory(output, ignored)) return {};
    const bool is_file = std::filesystem::exists(output, ignored) || std::filesystem::path(output).has_extension();
    return is_file ? "'" + output + "' is not a .png file, an .exr file or a folder" : std::string();
}

// One time, or the times of a sequence.
std::vector<std::optional<double>> read_times(const std::string& text) {
    if (text.empty()) return {std::nullopt};
    std::string error;
    if (const auto range = numbers_of_range(text, error, kMostFrames)) return {range->begin(), range->end()};
    double time = 0;
    if (error.empty() && !CLI::detail::lexical_cast(text, time)) error = "'" + text + "' is not a number of seconds";
    if (error.empty()) error = is_time_word(text);
    if (!error.empty()) throw CLI::ValidationError("--time", error);
    return {std::optional(time)};
}

void take_tone(Arguments& arguments) {
    for (const runtime::TonemapWord& each : runtime::kTonemaps)
        if (each.word == arguments.tonemap) arguments.tone.curve = each.curve;
    const bool has_curve = arguments.tone.curve != runtime::Tonemap::None;
    if (has_curve && arguments.output.ends_with(".exr"))
        throw CLI::ValidationError("--tonemap",
                                   "an EXR file holds the light as it is: leave out --tonemap, or write a PNG");
    if (arguments.output.ends_with(".exr") && !arguments.tone.exposure) arguments.tone.exposure = 0;
    arguments.request.exposure = arguments.tone.exposure;
    if ((has_curve || arguments.tone.exposure.value_or(0) != 0) && !arguments.request.options.preview.empty())
        throw CLI::ValidationError(has_curve ? "--tonemap" : "--exposure",
                                   "--node shows values, not light: leave one of them out");
}

void check_layers(const Arguments& arguments) {
    if (arguments.request.light && arguments.request.options.preview.empty() && arguments.aov.empty())
        throw CLI::ValidationError("--of-light", "needs --node: it chooses the light of a value");
    if (arguments.aov.empty()) return;
    if (!arguments.output.ends_with(".exr"))
        throw CLI::ValidationError("--aov", "only an EXR file has layers: name one with -o NAME.exr");
    if (!arguments.request.options.preview.empty())
        throw CLI::ValidationError("--aov", "draws the material and values of its nodes: leave out --node");
    if (!arguments.sweep.axes.empty())
        throw CLI::ValidationError("--aov", "a sheet has no layers: leave out --sweep, and name one lighting model");
    for (const std::string& name : arguments.aov) {
        if (std::ranges::count(arguments.aov, name) > 1)
            throw CLI::ValidationError("--aov", "'" + name + "' is given twice: leave one out");
    }
}

// Checks what can be wrong before the first graph is read.
void complete(Arguments& arguments, bool has_mesh) {
    if (arguments.path.path == "all")
        throw CLI::ValidationError("--path",
                                   "a picture is drawn along one path: name one; 'patina compile' accepts 'all'");
    refuse_mesh(arguments.graphs, has_mesh);
    const runtime::RenderRequest& request = arguments.request;
    for (const auto& [option, value] : {std::pair("--object", request.object), {"--material", request.material}}) {
        for (const std::string& graph : arguments.graphs) refuse_object(graph, option, value);
        if (!value.empty() && request.options.preview.empty() && arguments.aov.empty())
            throw CLI::ValidationError(option, "needs --node: it chooses what shows the values of a port");
    }
    for (const std::string& graph : arguments.graphs) {
        if (!arguments.variant.empty() && !is_model(graph))
            throw CLI::ValidationError("--variant", "'" + graph + "' is no model: only .glb and .gltf files have them");
    }
    take_overrides(arguments.set, arguments.path, arguments.request);
    read_sweep(arguments.sweep, arguments.request);
    if (const std::string wrong = not_an_output(arguments.output); !wrong.empty())
        throw CLI::ValidationError("--output", wrong);
    arguments.times = read_times(arguments.time);
    for (const std::optional<double> time : arguments.times) {
        if (!runtime::is_time(time.value_or(0)))
            throw CLI::ValidationError("--time",
                                       fmt::format("{} is not a number of seconds that a shader can hold", *time));
    }
    if (arguments.times.size() > 1 && is_one_picture(arguments.output) && !is_picture(arguments.output))
        throw CLI::ValidationError("--output", "a sequence cannot go through '" + arguments.output +
                                                   "': name a .png file, an .exr file or a folder");
    if (arguments.graphs.size() > 1 && is_one_picture(arguments.output)) {
        throw CLI::ValidationError("--output", "several graphs cannot share one picture: name a folder");
    }
    if (!arguments.range.empty()) {
        if (arguments.request.options.preview.empty())
            throw CLI::ValidationError("--range", "needs --node: it shows the values of one port");
        if (arguments.output.ends_with(".exr"))
            throw CLI::ValidationError("--range",
                                       "an EXR file holds the values as they are: leave out --range, or write a PNG");
        const runtime::Outcome<runtime::DataRange> range = runtime::parse_data_range(arguments.range);
        if (!range) throw CLI::ValidationError("--range", range.error);
        arguments.request.range = range.value;
    }
    check_layers(arguments);
    take_tone(arguments);
    arguments.request.keeps_values = arguments.output.ends_with(".exr");
    refuse_equal_outputs(arguments.graphs, ".png", "render");
}

}  // namespace

void add_render(Program& program) {
    CLI::App& command = add_command(
        program, "render",
        {"patina render rust.graph.json -o rust.png --mesh torus --size 256",
         "patina render rust.graph.json --set _Roughness=0.2 --set _MainTex=other.png",
         "patina render rust.graph.json --node mask --range -1..1 -o mask.png",
         "patina render *.graph.json -o pictures", "patina render flag.graph.json --time 0..2:48 -o frames",
         "patina render room.scene.json --path deferred -o room.png",
         "patina render room.scene.json --node albedo --object wall -o albedo.png",
         "patina render rust.graph.json --light 'directional direction=1,1,1 intensity=2' --ambient 0.1 --via cpu",
         "patina render upload/rust.graph.json --root upload --max-pixels 4194304 -o rust.png",
         "patina render chair.glb -o chair.png", "patina render chair.glb --camera Front --variant Oak -o front.png",
         "patina render rust.graph.json --exposure -1 --tonemap khronos-neutral -o rust.png",
         "patina render rust.graph.json --env 'sunset.hdr rotation=90' -o rust.png",
         "patina render rust.graph.json --sweep _Roughness=0..1:5 --sweep _Wear=0..1:3 --size 160 -o sweep.png",
         "patina render rust.graph.json --node lighting/fresnel --of-light 0 -o fresnel.png",
         "patina render rust.graph.json --aov baseColor,normalWS,mask -o rust.exr",
         "patina render rust.graph.json --lighting all --size 160 -o models.png"});
    add_pixels_option(program, command);
    auto arguments = std::make_shared<Arguments>();
    runtime::RenderRequest& request = arguments->request;
    command
        .add_option("GRAPH", arguments->graphs,
                    "Material graphs and scenes (JSON), and models (.glb, .gltf). A scene and a model have meshes and "
                    "values of their own: --mesh and --set are for graphs")
        ->required()
        ->type_name(" ");
    command
        .add_option(
            "-o,--output", arguments->output,
            "A .png or .exr file, a folder (NAME.png), or - for a PNG on standard output; default: the current folder")
        ->type_name("OUT");
    command
        .add_option("--node", request.options.preview,
                    "Show this value, unlit: mask, rust.amount, layers/mask inside a sub-graph, roughness or f0 of the "
                    "surface, lighting/fresnel of the lighting graph, or outline/color of an extra pass")
        ->type_name("PORT")
        ->check(is_not_empty);
    CLI::Option* object =
        command
            .add_option(
                "--object", request.object,
                "Of a scene: show --node in the object with this id. Default: all objects whose material has the node")
            ->type_name("ID")
            ->check(is_not_empty);
    command
        .add_option("--material", request.material,
                    "Of a scene: show --node in all objects that have the material of this name")
        ->type_name("NAME")
        ->check(is_not_empty)
        ->excludes(object);
    command
        .add_option("--of-light", request.light,
                    "Show --node of this light alone, by its number from 0; default: the sum over all lights, if the "
                    "value depends on the light")
        ->type_name("N")
        ->check(CLI::Range(0, std::numeric_limits<int>::max()));
    add_words_option(command, "--aov", arguments->aov,
                     "Also write these values, as --node shows them, into the EXR file: layers with the channels "
                     "normalWS.R and so on",
                     is_not_empty)
        ->type_name("PORT[,PORT]");
    command
        .add_option("--range", arguments->range,
                    "Show the values of --node between LOW and HIGH: one number in false colour, a vector as red, "
                    "green and blue. "
                    "Pixels that are not finite are squares of magenta and black")
        ->type_name("LOW..HIGH");
    add_picture_options(command, arguments->set, request);
    command
        .add_option("--variant", arguments->variant,
                    "Of a model: show this one of its material variants; default: the materials that its meshes name")
        ->type_name("NAME")
        ->check(is_not_empty);
    command
        .add_option("--exposure", arguments->tone.exposure,
                    "Make the picture brighter by so many stops: 1 doubles its light. Default: 0; if all light comes "
                    "from a picture, the stops that keep a white surface below white")
        ->type_name("EV")
        ->check(within(-64, 64));
    std::vector<std::string> curves;
    for (const runtime::TonemapWord& each : runtime::kTonemaps) curves.emplace_back(each.word);
    command
        .add_option("--tonemap", arguments->tonemap,
                    "Bring bright light below white by a curve; default: none, so that it clips")
        ->type_name("none|khronos-neutral|agx|aces")
        ->check(one_of("a tone curve", std::move(curves)));
    command
        .add_option("--time", arguments->time,
                    "The time in seconds, or a sequence FROM..TO:COUNT of pictures NAME.0000.png; default: 0")
        ->type_name("T");
    add_sweep_options(command, arguments->sweep);
    add_path_options(command, arguments->path);
    add_device_options(command, request);
    command.add_flag("--vulkan-validation", request.options.validation, "Turn on the Khronos validation layer");
    set_check(command, [arguments, mesh = command.get_option("--mesh")] { complete(*arguments, mesh->count() > 0); });

    set_work(program, command, [arguments](const Console& console) {
        if (is_mixed(console, is_standard_output(arguments->output), "-o " + arguments->output)) return Exit::Usage;
        const Compiler compiler;
        runtime::RenderMachine machine;
        Outputs outputs(console);
        Exit exit = Exit::Ok;
        Said said;
        std::optional<runtime::RenderRequest> request;
        const std::size_t frames = arguments->times.size(), count = arguments->graphs.size() * frames;
        for (std::size_t i = 0; i < count && exit != Exit::Machine; ++i) {
            const std::string& graph = arguments->graphs[i / frames];
            show_progress(console, i, count, graph);
            const Exit done = guarded(console, graph, [&] {
                if (i % frames == 0) {
                    said.clear();
                    request = request_for(console, *arguments, graph);
                }
                if (!request) return Exit::Wrong;
                return render_graph(outputs, console, *arguments, compiler, graph, *request, i % frames, said, machine);
            });
            exit = worse(exit, done);
            if (done != Exit::Ok) i += frames - 1 - i % frames;  // the rest of a sequence would fail the same way
        }
        return exit;
    });
}

}  // namespace patina::cli
