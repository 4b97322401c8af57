// patina node NAME: the manual page of one node.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "compiler/base/text.h"
#include "compiler/cli/commands.h"
#include "compiler/cli/node_json.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string name;
    bool json = false;
};

// "0 to 1, metres; default 0.5. Roughness squared"
std::string describe(const PortInfo& port) {
    std::vector<std::string> facts;
    if (port.range) facts.push_back(shortest((*port.range)[0]) + " to " + shortest((*port.range)[1]));
    if (!port.unit.empty()) facts.push_back("in " + port.unit);
    if (!port.enumerators.empty()) {
        const std::vector<std::string_view> words(port.enumerators.begin(), port.enumerators.end());
        facts.push_back(enumerate(words));
    }
    if (!port.is_output)
        facts.push_back(port.default_value.empty() ? "needs a value" : "default " + port.default_value);
    return fmt::format("{}", fmt::join(facts, "; "));
}

void print_ports(const Console& console, const NodeInfo& node, bool outputs) {
    bool any = false;
    for (const PortInfo& port : node.ports) {
        if (port.is_output != outputs) continue;
        if (!any) print("\n" + heading(console, outputs ? "OUTPUTS" : "INPUTS") + "\n");
        any = true;
        const std::string facts = describe(port);
        print("  " + heading(console, port.name) + "  " + port.type + (facts.empty() ? "" : "  (" + facts + ")") +
              "\n");
        if (!port.doc.empty()) print("      " + port.doc + "\n");
    }
}

void print_section(const Console& console, std::string_view title, std::string_view text) {
    if (text.empty()) return;
    print("\n" + heading(console, title) + "\n");
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        print(line.empty() ? std::string("\n") : "  " + std::string(line) + "\n");
        text = end == text.npos ? std::string_view() : text.substr(end + 1);
    }
}

// A default as a graph writes it: float3(0, 0, 1) is [0, 0, 1], and a word stands in quotes.
std::string as_json(const std::string& value) {
    constexpr std::string_view kNumber = "0123456789.-+e";
    if (value.empty()) return "\"...\"";
    if (value == "true" || value == "false" || value.find_first_not_of(kNumber) == value.npos) return value;
    const std::size_t open = value.find('(');
    const std::string list = open == value.npos ? "" : value.substr(open + 1, value.size() - open - 2);
    const bool is_vector = value.starts_with("float") && value.ends_with(')') &&
                           list.find_first_not_of(std::string(kNumber) + ", ") == list.npos;
    return is_vector ? "[" + list + "]" : '"' + value + '"';
}

// The node with every input at its default, ready to paste into "nodes".
std::string example(const NodeInfo& node, const std::string& name) {
    std::string inputs;
    for (const PortInfo& port : node.ports) {
        if (port.is_output) continue;
        inputs += fmt::format("{}\"{}\": {}", inputs.empty() ? "" : ", ", port.name, as_json(port.default_value));
    }
    // A file is named from the graph's own folder.
    const std::string file = "./" + std::filesystem::path(name).filename().generic_string();
    const std::string id =
        fmt::format("{{ \"id\": \"my_node\", \"node\": \"{}\"", name.ends_with(".hlsl") ? file : name);
    return inputs.empty() ? id + " }" : id + ", \"in\": { " + inputs + " } }";
}

// The node of the library, or that of a user's file; none after a message.
std::optional<NodeInfo> find_node(const Console& console, const Compiler& compiler, const std::string& name) {
    if (name.ends_with(".hlsl")) {
        NodeFileResult file = compiler.check_node_file(name);
        report(console, file.diagnostics);
        return file.ok ? std::optional(std::move(file.node)) : std::nullopt;
    }
    if (const NodeInfo* node = compiler.node(name)) return *node;
    std::vector<std::string_view> names;
    for (const NodeInfo& known : compiler.nodes()) names.push_back(known.name);
    const std::string_view near = nearest(name, names);
    complain(console, "unknown-node",
             "there is no node '" + name + "'" +
                 (near.empty() ? "; 'patina nodes' lists them" : "; did you mean '" + std::string(near) + "'?"));
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
    print(heading(console, node->name) + "  " + node->category + "\n");
    print_section(console, "DESCRIPTION", node->doc);
    print_section(console, "FORMULA", node->formula);
    print_section(console, "SOURCE", node->source);
    print_ports(console, *node, false);
    print_ports(console, *node, true);
    print_section(console, "IN A GRAPH", example(*node, arguments.name));
    print_section(console, "FILE", node->file);
    return Exit::Ok;
}

}  // namespace

void add_node(Program& program) {
    CLI::App& command =
        add_command(program, "node", "Show the manual page of a node",
                    {"patina node Lerp", "patina node DistributionGGX --json", "patina node wave.node.hlsl"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("NAME", arguments->name, "A node of the library, or the file of one (.node.hlsl)")
        ->required()
        ->type_name(" ");
    command.add_flag("--json", arguments->json, "Print it as JSON");
    set_work(program, command, [arguments](const Console& console) { return show_node(console, *arguments); });
}

}  // namespace patina::cli
