// patina nodes: the nodes of the library, as a table by category.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "compiler/base/letters.h"
#include "compiler/cli/commands/commands.h"
#include "compiler/cli/pages/library_json.h"
#include "compiler/cli/pages/node_search.h"
#include "compiler/cli/pages/page.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string category, words;
    bool json = false;
};

// "lighting" also holds "Lighting/Distribution".
bool is_within(std::string_view category, std::string_view wanted) {
    const std::string whole = small_letters(category) + '/',
                      part = small_letters(wanted) + (wanted.ends_with('/') ? "" : "/");
    return wanted.empty() || whole.starts_with(part);
}

Exit unknown_category(const Console& console, const Compiler& compiler, const std::string& wanted) {
    std::vector<std::string> categories;
    for (const NodeInfo& node : compiler.nodes()) {
        const std::string& whole = node.category;
        for (const std::string& name : {whole, whole.substr(0, whole.find('/'))}) {
            if (std::ranges::find(categories, name) == categories.end()) categories.push_back(name);
        }
    }
    const std::string advice = suggestion(wanted, categories);
    complain(console, Complaint::UnknownCategory,
             {wanted, advice.empty() ? "'patina nodes' shows all of them" : advice});
    return Exit::Wrong;
}

void print_table(const Console& console, std::span<const NodeInfo* const> nodes) {
    std::size_t width = 0;
    for (const NodeInfo* node : nodes) width = std::max(width, node->name.size());
    const std::string* category = nullptr;
    for (const NodeInfo* node : nodes) {
        if (!category || *category != node->category) {
            print((category ? "\n" : "") + heading(console, node->category) + "\n");
            category = &node->category;
        }
        print(fmt::format("  {:<{}}  {}\n", node->name, width, first_sentence(node->doc)));
    }
}

Exit print_found(const Console& console, const Compiler& compiler, const Arguments& arguments) {
    std::vector<const NodeInfo*> found = search_nodes(compiler.nodes(), arguments.words);
    std::erase_if(found, [&](const NodeInfo* node) { return !is_within(node->category, arguments.category); });
    std::vector<Hint> hints;
    if (!arguments.json) hints = search_hints(arguments.words, found.empty());
    if (found.empty() && hints.empty()) {
        const std::string advice = compiler.node_advice(arguments.words);
        complain(console, Complaint::UnknownNode,
                 {arguments.words, "; " + (advice.empty() ? "none has these words: try others" : advice)});
        return Exit::Wrong;
    }
    if (arguments.json) {
        print(to_json(found));
        return Exit::Ok;
    }
    std::size_t width = 0;
    for (const NodeInfo* node : found) width = std::max(width, node->name.size());
    for (const Hint& hint : hints) print(fmt::format("{:<{}}  no node: {}\n", hint.name, width, hint.text));
    for (const NodeInfo* node : found) print(fmt::format("{:<{}}  {}\n", node->name, width, first_sentence(node->doc)));
    return Exit::Ok;
}

Exit list_nodes(const Console& console, const Arguments& arguments) {
    const Compiler compiler;
    if (!arguments.words.empty()) return print_found(console, compiler, arguments);
    std::vector<const NodeInfo*> nodes;
    for (const NodeInfo& node : compiler.nodes()) {
        if (is_within(node.category, arguments.category)) nodes.push_back(&node);
    }
    if (nodes.empty()) return unknown_category(console, compiler, arguments.category);
    if (arguments.json) {
        print(to_json(nodes));
    } else {
        print_table(console, nodes);
    }
    return Exit::Ok;
}

}  // namespace

void add_nodes(Program& program) {
    CLI::App& command = add_command(program, "nodes",
                                    {"patina nodes", "patina nodes --search \"round corners\"",
                                     "patina nodes --category lighting", "patina nodes --json"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("-c,--category", arguments->category, "List only this category and those inside it")
        ->type_name("CATEGORY");
    command
        .add_option(
            "-s,--search", arguments->words,
            "List the nodes whose names and texts have these words, the best first; a node need not have all words")
        ->type_name("WORDS");
    command.add_flag("--json", arguments->json, "Print everything about each node as JSON");
    set_work(program, command, [arguments](const Console& console) { return list_nodes(console, *arguments); });
}

}  // namespace patina::cli
