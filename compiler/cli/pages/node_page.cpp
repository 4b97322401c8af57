// The page of one node.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/cli/pages/pages.h"

namespace patina::cli {
namespace {

// "0 to 1; in m; default 0.5"
std::string facts_of(const PortInfo& port) {
    std::vector<std::string> facts;
    if (port.range) facts.push_back(fmt::format("{} to {}", (*port.range)[0], (*port.range)[1]));
    if (!port.unit.empty()) facts.push_back("in " + port.unit);
    if (!port.is_output)
        facts.push_back(port.default_value.empty() ? "needs a value" : "default " + port.default_value);
    return fmt::format("{}", fmt::join(facts, "; "));
}

Section ports(const NodeInfo& node, bool outputs) {
    Section section{.title = outputs ? "Outputs" : "Inputs"};
    for (const PortInfo& port : node.ports) {
        if (port.is_output != outputs) continue;
        Entry& entry = section.entries.emplace_back(
            Entry{.name = port.name, .type = port.type, .facts = facts_of(port), .doc = port.doc});
        for (const EnumeratorInfo& choice : port.enumerators) entry.choices.emplace_back(choice.name, choice.doc);
    }
    return section;
}

// A default as a graph writes it: float3(0, 0, 1) is [0, 0, 1], and a word is in quotes.
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

}  // namespace

std::string example_of(const NodeInfo& node, const std::string& name) {
    std::string inputs;
    for (const PortInfo& port : node.ports) {
        // A sampler's default is that of a texture, for which a graph has no word.
        const bool is_left_open = port.type == "SamplerState" && !port.default_value.empty();
        if (port.is_output || is_left_open) continue;
        inputs += fmt::format("{}\"{}\": {}", inputs.empty() ? "" : ", ", port.name, as_json(port.default_value));
    }
    // A graph names a file relative to its own folder.
    const std::string file = "./" + std::filesystem::path(name).filename().generic_string();
    const std::string id =
        fmt::format("{{ \"id\": \"myNode\", \"node\": \"{}\"", name.ends_with(".hlsl") ? file : name);
    return inputs.empty() ? id + " }" : id + ", \"in\": { " + inputs + " } }";
}

Page node_page(const NodeInfo& node, const std::string& name) {
    Page page{.title = node.name, .place = node.category, .sections = {}};
    page.sections = {
        {.title = {}, .text = node.doc},
        {.title = "Also known as", .text = fmt::format("{}", fmt::join(node.also, ", "))},
        {.title = "Formula", .code = node.formula},
        {.title = "Source", .text = node.source},
        ports(node, false),
        ports(node, true),
        {.title = "In a graph", .code = example_of(node, name)},
        {.title = "Examples", .code = fmt::format("{}", fmt::join(node.tests, "\n"))},
        {.title = "File", .text = node.file},
    };
    return page;
}

Page node_page(const NodeInfo& node, const Compiler& compiler) {
    Page page = node_page(node, node.name);
    std::vector<std::string> names = node.also;
    names.push_back(node.name);
    for (const EngineInfo& engine : compiler.engines()) {
        const auto found = std::ranges::find_if(compiler.nodes(), [&](const NodeInfo& other) {
            return std::ranges::any_of(names,
                                       [&](const std::string& each) { return other.name == each + engine.title; });
        });
        if (found == compiler.nodes().end()) continue;
        const auto before = std::ranges::find(page.sections, "Inputs", &Section::title);
        page.sections.insert(before, {.title = engine.title + "'s formula", .text = found->name});
    }
    return page;
}

}  // namespace patina::cli
