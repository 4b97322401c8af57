// patina new: writes a file to start from.
#include <algorithm>
#include <filesystem>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/outputs.h"
#include "compiler/cli/templates.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string kind;
    std::string output;
};

std::vector<std::string> kinds() {
    std::vector<std::string> names;
    for (const Template& each : templates()) names.emplace_back(each.kind);
    return names;
}

std::string kind_help() {
    std::string help = "The kind of file:";
    for (const Template& each : templates()) {
        help += "\n  " + std::string(each.kind) + ": " + std::string(each.summary);
    }
    return help;
}

// "pipe" is pipe.graph.json; a name that has an ending keeps it, and so does a device or a FIFO.
std::string file_name(const std::string& output, std::string_view ending) {
    const bool keeps_name =
        is_standard_output(output) || is_stream(output) || std::filesystem::path(output).has_extension();
    return keeps_name ? output : output + std::string(ending);
}

Exit write_template(const Console& console, const Arguments& arguments) {
    const auto chosen = std::ranges::find(templates(), arguments.kind, &Template::kind);
    if (arguments.output.empty()) {
        print(chosen->text);
        return Exit::Ok;
    }
    const std::string path = file_name(arguments.output, chosen->ending);
    if (!is_standard_output(path) && is_taken(path)) {
        complain(console, Complaint::FileExists, {path});
        return Exit::Wrong;
    }
    OutputFiles files;
    files.add(path, std::string(chosen->text));
    if (!Outputs(console).write(arguments.kind, files)) return Exit::Wrong;
    say(console, files);
    return Exit::Ok;
}

}  // namespace

void add_new(Program& program) {
    CLI::App& command = add_command(
        program, "new",
        {"patina new metal -o pipe.graph.json", "patina new toon -o hero.graph.json", "patina new scene -o room",
         "patina new node -o rings.node.hlsl", "patina new unlit    # prints it"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("KIND", arguments->kind, kind_help())
        ->required()
        ->type_name(" ")
        ->check(one_of("a kind of file", kinds()));
    command
        .add_option("-o,--output", arguments->output,
                    "File to write, which must not exist yet; a name without an ending gets the kind's; default, and "
                    "-: print it")
        ->type_name("FILE");
    set_work(program, command, [arguments](const Console& console) { return write_template(console, *arguments); });
}

}  // namespace patina::cli
