// patina sheet: a folder's graphs on one page.
#include <fmt/format.h>

#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/outputs.h"
#include "compiler/cli/render/picture_options.h"
#include "runtime/sheet/sheet_page.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string folder, output = "index.html";
    PathOptions path;
    bool without_node_pictures = false;
    runtime::SheetOptions options;
};

Exit write_sheet(const Console& console, Arguments& arguments) {
    const Compiler compiler;
    runtime::SheetOptions& options = arguments.options;
    options.node_pictures = !arguments.without_node_pictures;
    options.request.samples = 3;
    options.request.options.path = arguments.path.path;
    options.request.options.switches = arguments.path.switches();
    options.progress = [&](std::size_t index, std::size_t count, const std::string& name) {
        if (index + 1 < count) show_progress(console, index + 1, count, name);
    };
    const runtime::Sheet sheet = runtime::make_sheet(compiler, arguments.folder, options);
    end_progress(console);
    if (!sheet.error.empty()) {
        complain(console, Complaint::CannotRender, {sheet.error});
        return Exit::Wrong;
    }
    Exit exit = Exit::Ok;
    for (const runtime::SheetEntry& entry : sheet.entries) {
        report(console, entry.diagnostics);
        if (!entry.error.empty()) complain(console, Complaint::CannotRender, {entry.file + ": " + entry.error});
        if (!entry.ok) exit = worse(exit, entry.missing_machine ? Exit::Machine : Exit::Wrong);
    }
    OutputFiles files;
    files.add(arguments.output, runtime::sheet_page(sheet, arguments.folder));
    Outputs outputs(console);
    if (!outputs.write(arguments.folder, files)) return worse(exit, Exit::Wrong);
    say(console, files);
    return exit;
}

}  // namespace

void add_sheet(Program& program) {
    CLI::App& command = add_command(program, "sheet",
                                    {"patina sheet art", "patina sheet art -o art.html --env sunset.hdr --size 384",
                                     "patina sheet art --path deferred --no-node-pictures"});
    add_pixels_option(program, command);
    auto arguments = std::make_shared<Arguments>();
    runtime::SheetOptions& options = arguments->options;
    command
        .add_option("DIR", arguments->folder,
                    "Folder with graphs and scenes; its sub-folders are searched, too. A file that is wrong is on the "
                    "page with what is wrong")
        ->required()
        ->type_name(" ");
    command.add_option("-o,--output", arguments->output, "The page: one file that needs no other; default: index.html")
        ->type_name("FILE.html");
    command.add_option("--size", options.size, "Width and height of the pictures, in pixels; default: 256")
        ->type_name("N")
        ->check(CLI::Range(32, 2048));
    command.add_flag("--no-node-pictures", arguments->without_node_pictures,
                     "Draw the nodes without a picture of each, which is faster");
    command.add_option("--jobs", options.jobs, "Work on N graphs at once; default: one for each core, at most 4")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
    add_mesh_options(command, options.request);
    add_light_options(command, options.request);
    add_camera_option(command, options.request);
    add_path_options(command, arguments->path);
    add_device_options(command, options.request);
    add_include_option(command, options.request.options.include_dirs);
    set_check(command, [arguments] {
        const std::string& output = arguments->output;
        if (!is_standard_output(output) && !is_stream(output) && !output.ends_with(".html"))
            throw CLI::ValidationError("--output", "'" + output + "' is not an .html file");
    });
    set_work(program, command, [arguments](const Console& console) {
        if (is_mixed(console, is_standard_output(arguments->output), "-o " + arguments->output)) return Exit::Usage;
        return write_sheet(console, *arguments);
    });
}

}  // namespace patina::cli
