#include "compiler/importers/refusals.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>

#include "compiler/importers/terms.h"

namespace patina::importers {
namespace {

// The key of the value that is wrong: "uv" of { "uv": "= a + b" }.
std::string key_at(const Diagnostic& wrong) {
    const std::string_view before =
        std::string_view(wrong.source_line).substr(0, static_cast<std::size_t>(std::max(wrong.column, 0)));
    const std::size_t end = before.rfind("\": ");
    const std::size_t begin = end == before.npos ? end : before.rfind('"', end - 1);
    return begin == before.npos ? std::string() : std::string(before.substr(begin + 1, end - begin - 1));
}

std::vector<Diagnostic> errors_of(const std::string& json, std::span<const TextFile> files) {
    CompileOptions options{.targets = {}};
    options.accept_parts = true;
    options.files.exists = [](const std::string&) { return true; };  // pictures
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        for (const TextFile& each : files)
            if (each.name == path || "./" + each.name == path) return each.text;
        return std::nullopt;
    };
    std::vector<Diagnostic> made = library().compile_text("it.graph.json", json, options).diagnostics;
    std::erase_if(made, [](const Diagnostic& each) { return each.severity != Severity::Error; });
    for (Diagnostic& each : made) {
        // A sub-graph is compiled as the node 'part' of a material.
        if (each.node == "part") each.node = "outputs";
        if (each.node.starts_with("part/")) each.node.erase(0, 5);
        if (each.port.empty()) each.port = key_at(each);
    }
    return made;
}

bool has_constant_at(std::vector<Member>& members, const std::string& key, const Value& constant) {
    const auto found = std::ranges::find(members, key, &Member::key);
    if (found == members.end() || found->value.json == constant.json) return false;
    found->value = constant;
    return true;
}

void add_note(GraphFile& graph, const std::string& id, const std::string& reason) {
    const auto node = std::ranges::find(graph.nodes, id, &GraphNode::id);
    if (node == graph.nodes.end() || std::ranges::find(node->more, "note", &Member::key) != node->more.end()) return;
    node->more.push_back({"note", text("not imported: " + reason)});
}

}  // namespace

const Compiler& library() {
    static const Compiler made;
    return made;
}

bool has_constant(GraphFile& graph, const Diagnostic& wrong, terms::Type type) {
    if (wrong.node == "surface") return has_constant_at(graph.surface, wrong.port, terms::stand_in(type).value());
    const auto found = std::ranges::find(graph.nodes, wrong.node, &GraphNode::id);
    if (found == graph.nodes.end()) return false;
    if (!found->node.empty()) return has_constant_at(found->inputs, wrong.port, number(1.0));
    const std::string constant = terms::stand_in(type).text();
    if (found->expression == constant) return false;
    found->expression = constant;
    return true;
}

std::string refuse_invalid(GraphFile& graph, std::span<const TextFile> files,
                           const std::function<bool(const Diagnostic&)>& put_constant,
                           const std::function<void(const Diagnostic&, const std::string& reason)>& report) {
    constexpr int kMostRounds = 8;
    for (int round = 0;; ++round) {
        const std::string json = write_graph(graph);
        if (json.empty()) return {};  // it is no text: who writes it says so
        const std::vector<Diagnostic> errors = errors_of(json, files);
        if (errors.empty()) return {};
        std::set<std::string> done;
        for (const Diagnostic& each : errors) {
            if (!done.insert(each.node + " " + each.port).second) continue;
            if (round == kMostRounds || !put_constant(each))
                return fmt::format("'{}{}{}' would not be valid: {}", each.node, each.port.empty() ? "" : ".",
                                   each.port, each.message);
            const std::string reason = "the graph would not be valid: " + each.message;
            report(each, reason);
            add_note(graph, each.node, reason);
        }
    }
}

}  // namespace patina::importers
