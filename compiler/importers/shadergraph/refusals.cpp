// The last look at a graph: the compiler reads it, and what it refuses becomes a constant. So a file whose slots are
// not those of its nodes is imported as far as it makes sense.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

// The key of the value that is wrong: "uv" of { "uv": "= a + b" }.
std::string key_at(const Diagnostic& wrong) {
    const std::string_view before =
        std::string_view(wrong.source_line).substr(0, static_cast<std::size_t>(std::max(wrong.column, 0)));
    const std::size_t end = before.rfind("\": ");
    const std::size_t begin = end == before.npos ? end : before.rfind('"', end - 1);
    return begin == before.npos ? std::string() : std::string(before.substr(begin + 1, end - begin - 1));
}

std::vector<Diagnostic> errors_of(const GraphFile& graph, const std::vector<TextFile>& files) {
    CompileOptions options{.targets = {}};
    options.accept_parts = true;
    options.files.exists = [](const std::string&) { return true; };  // pictures
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        for (const TextFile& each : files)
            if (each.name == path || "./" + each.name == path) return each.text;
        return std::nullopt;
    };
    std::vector<Diagnostic> made = library().compile_text("it.graph.json", write_graph(graph), options).diagnostics;
    std::erase_if(made, [](const Diagnostic& each) { return each.severity != Severity::Error; });
    for (Diagnostic& each : made) {
        // A sub-graph is compiled as the node 'part' of a material.
        if (each.node == "part") each.node = "outputs";
        if (each.node.starts_with("part/")) each.node.erase(0, 5);
        if (each.port.empty()) each.port = key_at(each);
    }
    return made;
}

// The same in an object whose text is ready.
bool has_constant(std::string& object, const std::string& key, const Value& constant) {
    const std::string before = text(key).json + ": \"";
    const std::size_t begin = object.find(before);
    const std::size_t end = begin == object.npos ? begin : object.find('"', begin + before.size());
    if (end == object.npos) return false;
    object.replace(begin + before.size() - 1, end + 2 - begin - before.size(), constant.json);
    return true;
}

bool has_constant(std::vector<Member>& members, const std::string& key, const Value& constant) {
    const auto found = std::ranges::find(members, key, &Member::key);
    if (found == members.end() || found->value.json == constant.json) return false;
    found->value = constant;
    return true;
}

}  // namespace

bool GraphMaker::has_constant_for(const Diagnostic& wrong) {
    if (wrong.node == "surface") {
        const bool is_color = wrong.port == "baseColor" || wrong.port == "color";
        return has_constant(file_.surface, wrong.port, stand_in(is_color ? Type::Float3 : Type::Float).value());
    }
    if (const auto part = std::ranges::find(file_.more, wrong.node, &Member::key); part != file_.more.end()) {
        const auto output = std::ranges::find(ports_.outputs, wrong.port, &SubgraphPorts::Output::name);
        const Term constant = stand_in(output == ports_.outputs.end() ? Type::Float3 : output->type);
        return has_constant(part->value.json, wrong.port, text("= " + constant.text()));
    }
    const auto found = std::ranges::find(file_.nodes, wrong.node, &GraphNode::id);
    if (found == file_.nodes.end()) return false;
    if (!found->node.empty()) return has_constant(found->inputs, wrong.port, number(1.0));
    const auto type = types_.find(found->id);
    const std::string constant = stand_in(type == types_.end() ? Type::Float4 : type->second).text();
    if (found->expression == constant) return false;
    found->expression = constant;
    return true;
}

std::string GraphMaker::refuse_invalid() {
    constexpr int kMostRounds = 8;
    for (int round = 0;; ++round) {
        const std::vector<Diagnostic> errors = errors_of(file_, project_.files);
        std::set<std::string> done;
        for (const Diagnostic& each : errors) {
            if (!done.insert(each.node + " " + each.port).second) continue;
            if (round == kMostRounds || !has_constant_for(each))
                return fmt::format("{}: '{}{}{}' would not be valid: {}", graph_.path, each.node,
                                   each.port.empty() ? "" : ".", each.port, each.message);
            const std::string reason = "the graph would not be valid: " + each.message;
            const auto owner = owners_.find(each.node);
            if (owner == owners_.end()) {
                remark(Remark::Kind::LeftOut, fmt::format("'{}.{}'", each.node, each.port), reason, {});
                continue;
            }
            outcomes_[owner->second] = {.kind = Remark::Kind::LeftOut, .text = reason};
            project_.has_refused = true;
            const auto node = std::ranges::find(file_.nodes, each.node, &GraphNode::id);
            if (std::ranges::find(node->more, "note", &Member::key) == node->more.end())
                node->more.push_back({"note", text("not imported: " + reason)});
        }
        if (errors.empty()) return {};
    }
}

}  // namespace patina::importers::shadergraph
