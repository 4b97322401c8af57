// patina nodes: the nodes of the library, as a table by category.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/pages/library_json.h"
#include "compiler/cli/pages/page.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::string category, search;
    bool json = false;
};

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return result;
}

// "lighting" also holds "Lighting/Distribution".
bool is_within(std::string_view category, std::string_view wanted) {
    const std::string whole = lower(category) + '/', part = lower(wanted) + (wanted.ends_with('/') ? "" : "/");
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

// --- by words

// The words of a text, small and without a plural's s. A capital after a small letter begins a word: RoundedRectangle
// is two.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    bool in_word = false, was_small = false;
    for (const char c : text) {
        const bool is_capital = c >= 'A' && c <= 'Z', is_small = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (is_capital || is_small) {
            if (!in_word || (is_capital && was_small)) words.emplace_back();
            words.back() += is_capital ? static_cast<char>(c - 'A' + 'a') : c;
        }
        in_word = is_capital || is_small;
        was_small = is_small;
    }
    for (std::string& word : words) {
        if (word.size() > 3 && word.ends_with('s')) word.pop_back();
    }
    return words;
}

bool has_word(std::string_view text, const std::string& wanted) {
    const std::vector<std::string> words = words_of(text);
    return std::ranges::any_of(words, [&](const std::string& word) { return word.starts_with(wanted); });
}

// How prominent a word is in what is said of a node: in its name, its names elsewhere, its summary, or the rest; 0:
// nowhere.
int prominence(const NodeInfo& node, const std::string& word) {
    const auto has = [&](std::string_view text) { return has_word(text, word); };
    if (has(node.name)) return 8;
    if (std::ranges::any_of(node.also, has)) return 6;
    if (has(first_sentence(node.doc))) return 4;
    if (has(node.category) || has(node.doc)) return 2;
    const auto in_port = [&](const PortInfo& port) {
        return has(port.name) || has(port.doc) || std::ranges::any_of(port.enumerators, [&](const auto& choice) {
                   return has(choice.name) || has(choice.doc);
               });
    };
    return std::ranges::any_of(node.ports, in_port) ? 1 : 0;
}

// The nodes that have all of the words, the most prominent first.
std::vector<const NodeInfo*> found(std::vector<const NodeInfo*> nodes, const std::string& search) {
    std::vector<std::pair<int, const NodeInfo*>> ranked;
    for (const NodeInfo* node : nodes) {
        int sum = 0;
        bool has_all = true;
        for (const std::string& word : words_of(search)) {
            const int one = prominence(*node, word);
            has_all = has_all && one > 0;
            sum += one;
        }
        if (has_all) ranked.emplace_back(-sum, node);
    }
    std::ranges::stable_sort(ranked, {}, &std::pair<int, const NodeInfo*>::first);
    nodes.clear();
    for (const auto& [rank, node] : ranked) nodes.push_back(node);
    return nodes;
}

void print_found(std::span<const NodeInfo* const> nodes) {
    std::size_t width = 0;
    for (const NodeInfo* node : nodes) width = std::max(width, node->name.size());
    for (const NodeInfo* node : nodes) print(fmt::format("{:<{}}  {}\n", node->name, width, first_sentence(node->doc)));
}

Exit list_nodes(const Console& console, const Arguments& arguments) {
    const Compiler compiler;
    std::vector<const NodeInfo*> nodes;
    for (const NodeInfo& node : compiler.nodes()) {
        if (is_within(node.category, arguments.category)) nodes.push_back(&node);
    }
    if (nodes.empty()) return unknown_category(console, compiler, arguments.category);
    const bool is_search = !arguments.search.empty();
    if (is_search) nodes = found(std::move(nodes), arguments.search);
    if (nodes.empty()) {
        complain(console, Complaint::UnknownNode, {arguments.search, "; none has all of these words: try fewer"});
        return Exit::Wrong;
    }
    if (arguments.json) {
        print(to_json(nodes));
    } else if (is_search) {
        print_found(nodes);
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
        .add_option("-s,--search", arguments->search,
                    "List only nodes whose name, description or ports have all of these words, the best first")
        ->type_name("WORDS");
    command.add_flag("--json", arguments->json, "Print everything about each node as JSON");
    set_work(program, command, [arguments](const Console& console) { return list_nodes(console, *arguments); });
}

}  // namespace patina::cli
