// The last look at an imported graph: the compiler reads it, and what it refuses becomes a constant.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/importers/imported_graph.h"

namespace patina::importers {
namespace {

std::vector<Diagnostic> errors_of(const GraphBuilder& graph, std::span<const TextFile> files) {
    CompileOptions options{.targets = {}};
    options.accept_parts = true;
    options.files.exists = [](const std::string&) { return true; };  // pictures
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        for (const TextFile& each : files)
            if (each.name == path || "./" + each.name == path) return each.text;
        return std::nullopt;
    };
    std::vector<Diagnostic> made = library().compile(graph, options).diagnostics;
    std::erase_if(made, [](const Diagnostic& each) { return each.severity != Severity::Error; });
    return made;
}

bool puts_constant_at(GraphMembers& members, const std::string& key, const GraphValue& constant) {
    const auto found = std::ranges::find(members, key, &GraphMember::key);
    if (found == members.end() || found->value == constant) return false;
    found->value = constant;
    return true;
}

// Of an input of a surface whose type was not noted.
terms::Type usual_type(std::string_view input) {
    static constexpr std::string_view kVectors[] = {"baseColor", "color",         "emission",
                                                    "specular",  "specularColor", "normalTS"};
    return std::ranges::find(kVectors, input) == std::end(kVectors) ? terms::Type::Float : terms::Type::Float3;
}

void add_note(ImportedNode& node, const std::string& reason) {
    if (std::ranges::find(node.more, "note", &GraphMember::key) != node.more.end()) return;
    node.more.push_back({"note", "not imported: " + reason});
}

}  // namespace

// In the place of the value that is wrong. False: there is no such place, or the constant is there already.
bool ImportedGraph::puts_constant(const Diagnostic& wrong) {
    const auto type_of = [&](const std::string& what, terms::Type otherwise) {
        const auto found = types.find(what);
        return found == types.end() ? otherwise : found->second;
    };
    const std::string input = wrong.node + "." + wrong.port;
    if (wrong.node == "surface")
        return puts_constant_at(surface, wrong.port, terms::stand_in(type_of(input, usual_type(wrong.port))).value());
    if (wrong.node == "vertex" || wrong.node == "outputs")
        return puts_constant_at(wrong.node == "vertex" ? vertex : outputs, wrong.port,
                                "= " + terms::stand_in(type_of(input, terms::Type::Float3)).text());
    const auto found = std::ranges::find(nodes, wrong.node, &ImportedNode::id);
    if (found == nodes.end()) return false;
    if (!found->node.empty()) return puts_constant_at(found->inputs, wrong.port, 1);
    const std::string constant = terms::stand_in(type_of(wrong.node, terms::Type::Float4)).text();
    if (found->expression == constant) return false;
    found->expression = constant;
    return true;
}

std::string ImportedGraph::refuse_invalid(
    std::span<const TextFile> files,
    const std::function<void(const Diagnostic&, const std::string& reason)>& otherwise) {
    constexpr int kMostRounds = 8;
    for (int round = 0;; ++round) {
        if (text().empty()) return {};  // it is no text: who writes it says so
        const std::vector<Diagnostic> errors = errors_of(builder("it.graph.json"), files);
        if (errors.empty()) return {};
        std::set<std::string> done;
        for (const Diagnostic& each : errors) {
            if (!done.insert(each.node + " " + each.port).second) continue;
            if (round == kMostRounds || !puts_constant(each))
                return fmt::format("'{}{}{}' would not be valid: {}", each.node, each.port.empty() ? "" : ".",
                                   each.port, each.message);
            const std::string reason = "the graph would not be valid: " + each.message;
            const auto parts = owners.find(each.node);
            if (parts == owners.end() || parts->second.empty())
                otherwise(each, reason);
            else
                for (const std::size_t part : parts->second) {
                    outcomes[part].kind = Remark::Kind::LeftOut;
                    outcomes[part].text = reason;
                }
            const auto node = std::ranges::find(nodes, each.node, &ImportedNode::id);
            if (node != nodes.end()) add_note(*node, reason);
        }
    }
}

}  // namespace patina::importers
