// patina new: writes a file to start from.
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

Exit write_template(const Console& console, const Arguments& arguments) {
    std::string_view text;
    for (const Template& each : templates()) {
        if (each.kind == arguments.kind) text = each.text;
    }
    if (arguments.output.empty()) {
        print(text);
        return Exit::Ok;
    }
    if (!is_standard_output(arguments.output) && is_taken(arguments.output)) {
        complain(console, Complaint::FileExists, {arguments.output});
        return Exit::Wrong;
    }
    OutputFiles files;
    files.add(arguments.output, std::string(text));
    if (!Outputs(console).write(arguments.kind, files)) return Exit::Wrong;
    say(console, files);
    return Exit::Ok;
}

}  // namespace

void add_new(Program& program) {
    CLI::App& command = add_command(program, "new",
                                    {"patina new metal -o pipe.graph.json", "patina new toon -o hero.graph.json",
                                     "patina new scene -o room.scene.json", "patina new node -o rings.node.hlsl",
                                     "patina new unlit    # prints it"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("KIND", arguments->kind, kind_help())
        ->required()
        ->type_name(" ")
        ->check(one_of("a kind of file", kinds()));
    command
        .add_option("-o,--output", arguments->output,
                    "File to write, which must not exist yet; default, and -: print it")
        ->type_name("FILE");
    set_work(program, command, [arguments](const Console& console) { return write_template(console, *arguments); });
}

}  // namespace patina::cli
