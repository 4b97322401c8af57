// The options of `patina watch`, and its loop.
#include <csignal>
#include <memory>
#include <thread>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/files.h"
#include "compiler/cli/render/picture_options.h"
#include "compiler/cli/watch/watch.h"

namespace patina::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto kPause = 150ms;  // between two looks

volatile std::sig_atomic_t stopped = 0;

// The work at hand is finished, so that no file is half-written. A second signal ends the program at once.
void stop_at_signals() {
    struct sigaction action {};
    action.sa_handler = [](int) { stopped = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

void complete(WatchArguments& arguments) {
    require_inputs(arguments.compile.inputs);
    const std::vector<std::string>& words = arguments.compile.inputs.words;
    const auto scenes = std::ranges::count_if(words, [](const std::string& word) { return is_scene(word); });
    if (scenes > 0 && arguments.picture.empty())
        throw CLI::ValidationError("--render", "a scene has no shaders of its own: name the picture to draw");
    if (scenes > 1) throw CLI::ValidationError("GRAPH", "one picture cannot show several scenes: name one of them");
    if (!arguments.picture.empty() && !arguments.picture.ends_with(".png"))
        throw CLI::ValidationError("--render", "'" + arguments.picture + "' is not a .png file");
    take_overrides(arguments.set, arguments.compile.path, arguments.request);
    arguments.compile.include_dirs = arguments.request.options.include_dirs;
}

Exit run_watch(const Console& console, WatchArguments& arguments) {
    const Inputs inputs = find_inputs(console, arguments.compile.inputs, {".graph.json"});
    if (inputs.files.empty()) return inputs.exit;
    const Compiler compiler;
    if (const std::string why = settle(arguments.compile, compiler); !why.empty()) {
        complain(console, Complaint::Usage, {why});
        return Exit::Usage;
    }
    if (!arguments.picture.empty() && !Outputs(console).is_possible(arguments.picture)) return Exit::Wrong;
    stop_at_signals();
    Watch watch(console, compiler, arguments, inputs);
    Exit exit = Exit::Ok;
    while (!stopped && exit == Exit::Ok && !output_failed()) {
        exit = watch.look();
        if (!stopped) std::this_thread::sleep_for(kPause);
    }
    return exit;
}

}  // namespace

void add_watch(Program& program) {
    CLI::App& command = add_command(
        program, "watch",
        {"patina watch art -o out", "patina watch rust.graph.json -t glsl -o out --render rust.png   # open rust.html",
         "patina watch room.scene.json art -o out --render room.png --size 256"});
    add_pixels_option(program, command);
    auto arguments = std::make_shared<WatchArguments>();
    add_input_options(command, arguments->compile.inputs, "Material graphs (JSON), a scene to draw");
    add_target_options(command, arguments->compile);
    add_path_options(command, arguments->compile.path);
    command
        .add_option("--render", arguments->picture,
                    "Also draw the graph that changed last, or the scene. NAME.html next to it is a page that shows "
                    "the picture and all errors, and is updated at each change")
        ->type_name("NAME.png");
    add_picture_options(command, arguments->set, arguments->request);
    add_device_options(command, arguments->request);
    set_check(command, [arguments] { complete(*arguments); });
    set_work(program, command, [arguments](const Console& console) { return run_watch(console, *arguments); });
}

}  // namespace patina::cli
