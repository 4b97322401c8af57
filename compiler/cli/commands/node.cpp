// patina node NAME: the manual page of one node.
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/pages/library_json.h"
#include "compiler/cli/pages/node_search.h"
#include "compiler/cli/pages/pages.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string name;
    bool json = false;
};

bool is_model(const Compiler& compiler, const std::string& name) {
    for (const ModelInfo& model : compiler.lighting_models()) {
        if (model.name == name) return true;
    }
    return false;
}

// A node of the library or of a user's file; nothing after a message.
std::optional<NodeInfo> find_node(const Console& console, const Compiler& compiler, const std::string& name) {
    if (name.ends_with(".hlsl")) {
        NodeFileResult file = compiler.check_node_file(name);
        report(console, file.diagnostics);
        return file.ok ? std::optional(std::move(file.node)) : std::nullopt;
    }
    if (const NodeInfo* node = compiler.node(name)) return *node;
    if (const NodeInfo* node = find_named(compiler.nodes(), name)) return *node;
    std::string advice = compiler.node_advice(name);
    advice = "; " + (advice.empty() ? "'patina nodes' lists them" : advice);
    if (is_model(compiler, name)) advice = ", but a lighting model: 'patina model " + name + "' shows it";
    complain(console, Complaint::UnknownNode, {name, advice});
    return {};
}

Exit show_node(const Console& console, const Arguments& arguments) {
    const Compiler compiler;
    const std::optional<NodeInfo> node = find_node(console, compiler, arguments.name);
    if (!node) return Exit::Wrong;
    if (arguments.json) {
        print(to_json(*node));
        return Exit::Ok;
    }
    const bool is_file = arguments.name.ends_with(".hlsl");
    print(to_terminal(console, is_file ? node_page(*node, arguments.name) : node_page(*node, compiler)));
    return Exit::Ok;
}

}  // namespace

void add_node(Program& program) {
    CLI::App& command = add_command(program, "node",
                                    {"patina node Lerp", "patina node \"Sample Texture 2D\"",
                                     "patina node DistributionGGX --json", "patina node wave.node.hlsl"});
    auto arguments = std::make_shared<Arguments>();
    command
        .add_option("NAME", arguments->name,
                    "A node of the library, also by its name in another program, or the file of one (.node.hlsl)")
        ->required()
        ->type_name(" ");
    command.add_flag("--json", arguments->json, "Print it as JSON");
    set_work(program, command, [arguments](const Console& console) { return show_node(console, *arguments); });
}

}  // namespace patina::cli
