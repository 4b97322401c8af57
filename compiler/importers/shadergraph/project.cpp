#include "compiler/importers/shadergraph/project.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/base/text.h"
#include "compiler/importers/shadergraph/graph_maker.h"
#include "compiler/importers/source_text.h"

namespace patina::importers::shadergraph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepest = 32;  // sub-graphs in sub-graphs

// A name of a file on every system.
std::string file_word(std::string_view name) {
    std::string made;
    for (const char c : name)
        made += std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos || static_cast<unsigned char>(c) < 32
                    ? '_'
                    : c;
    return made.empty() || made.starts_with('.') ? "_" + made : made;
}

}  // namespace

const Compiler& library() {
    return importers::library();
}

std::string Project::add_graph(const std::string& path, const std::string& name) {
    const SubgraphPorts made = read_graph(path, name);
    return made.error;
}

SubgraphPorts Project::read_graph(const std::string& path, const std::string& name) {
    std::string why;
    // The first is the one that the user names.
    std::optional<std::string> text = open_.empty() ? read_text(path, why) : read_named_text(path, kGraphs, why);
    if (!text) return {.error = std::move(why)};
    std::size_t bad = 0;
    const bool is_text = is_utf8(*text, bad);
    Documents documents = read_documents(path, std::move(*text));
    const Misreads misreads(documents);
    const ShaderGraph graph = read_shader_graph(documents, misreads);
    if (!graph.error.empty()) return {.error = graph.error};
    const std::string own =
        file_names.unique(file_word(name), "graph") + (graph.is_subgraph ? ".subgraph.json" : ".graph.json");
    open_.push_back(path);
    GraphMaker maker(*this, graph, name);
    std::string error = maker.make();
    open_.pop_back();
    std::string json = maker.file().text();
    if (!error.empty() && (is_text || !json.empty())) return {.error = std::move(error)};
    if (json.empty()) return {.error = fmt::format("{}: a name in it is not UTF-8", path)};
    SubgraphPorts ports = maker.ports();
    files.push_back({.name = own, .text = std::move(json)});
    ports.file = "./" + own;
    return ports;
}

const SubgraphPorts& Project::subgraph(std::string_view guid, std::string_view name) {
    const std::optional<Assets::Found> found = assets.find(guid, name, kGraphs);
    const std::string key = found ? found->path : fmt::format("{} {}", guid, name);
    if (const auto known = subgraphs_.find(key);
        known != subgraphs_.end() && std::ranges::find(open_, key) == open_.end())
        return known->second;
    SubgraphPorts& made = subgraphs_[key];
    if (!found) {
        made.error = fmt::format("no file in {} has the GUID {} of the sub-graph '{}'", assets.folders(),
                                 guid.empty() ? "(none)" : guid, name);
        return made;
    }
    const auto is_same = [&](const std::string& open) {
        std::error_code wrong;
        return fs::equivalent(open, found->path, wrong);
    };
    if (std::ranges::any_of(open_, is_same)) {
        static const SubgraphPorts kCircle{.error = "the sub-graph uses itself"};
        return kCircle;
    }
    if (open_.size() > kDeepest) {
        made.error = fmt::format("more than {} sub-graphs lie in one another", kDeepest);
        return made;
    }
    const std::size_t before = remarks.size();
    SubgraphPorts read = read_graph(found->path, fs::path(found->path).stem().string());
    for (std::size_t i = before; i < remarks.size(); ++i)
        if (remarks[i].file.empty()) remarks[i].file = fs::path(found->path).filename().string();
    if (found->is_by_name) read.remark = fmt::format("no file has its GUID: '{}' has its name", found->path);
    if (!found->other.empty())
        read.remark = fmt::format("'{}' could be meant as well as '{}', which is taken", found->other, found->path);
    subgraphs_[key] = std::move(read);
    return subgraphs_[key];
}

}  // namespace patina::importers::shadergraph
