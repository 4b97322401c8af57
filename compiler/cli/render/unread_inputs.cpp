#include "compiler/cli/render/unread_inputs.h"

#include <algorithm>
#include <set>
#include <span>
#include <string_view>

#include "compiler/base/letters.h"
#include "patina/graph_view.h"

namespace patina::cli {
namespace {

using Names = std::set<std::string, std::less<>>;

// The words of an expression that come after this sign: of "= $a * @surface.f0", "f0" after "@surface.".
Names words_after(std::string_view text, std::string_view sign) {
    Names words;
    for (std::size_t at = text.find(sign); at != text.npos; at = text.find(sign, at + 1)) {
        const std::size_t begin = at + sign.size();
        if (sign.empty() && ((begin > 0 && (is_word_letter(text[begin - 1]) || text[begin - 1] == '$')))) continue;
        std::size_t end = begin;
        while (end < text.size() && is_word_letter(text[end])) ++end;
        if (end > begin) words.emplace(text.substr(begin, end - begin));
    }
    return words;
}

std::vector<std::string_view> texts_of(const ModelNodeInfo& node) {
    std::vector<std::string_view> texts = {node.expr};
    for (const auto& [port, value] : node.inputs) texts.push_back(value);
    return texts;
}

// The inputs that a text of a workflow depends on, through its nodes. Nodes come before the nodes that read them.
Names inputs_behind(const ModelInfo& workflow, std::string_view text) {
    Names inputs = words_after(text, "$"), words = words_after(text, "");
    for (auto node = workflow.nodes.rbegin(); node != workflow.nodes.rend(); ++node) {
        if (!words.contains(node->id)) continue;
        for (const std::string_view each : texts_of(*node)) {
            inputs.merge(words_after(each, "$"));
            words.merge(words_after(each, ""));
        }
    }
    return inputs;
}

// What the lighting graph reads of the surface. A roughness has three names.
Names read_by(const ModelInfo& model) {
    Names read;
    for (const ModelNodeInfo& node : model.nodes)
        for (const std::string_view each : texts_of(node)) read.merge(words_after(each, "@surface."));
    for (const auto& [name, value] : model.outputs) read.merge(words_after(value, "@surface."));
    if (read.contains("alphaRoughness") || read.contains("smoothness")) read.insert("roughness");
    return read;
}

const ModelInfo* find(std::span<const ModelInfo> models, const std::string& name) {
    const auto found = std::ranges::find(models, name, &ModelInfo::name);
    return found == models.end() ? nullptr : &*found;
}

std::vector<std::string> inputs_set(const Compiler& compiler, const std::string& graph, const CompileOptions& options) {
    const GraphView view = view_graph(compiler, graph, options);
    std::vector<std::string> set;
    for (const GraphBox& box : view.boxes) {
        if (box.is_node || box.id != "surface") continue;
        for (const GraphPort& port : box.inputs) set.push_back(port.name);
    }
    return set;
}

}  // namespace

std::vector<std::string> unread_inputs(const Compiler& compiler, const std::string& graph,
                                       const CompileOptions& options, const std::string& workflow,
                                       const std::string& lighting) {
    const ModelInfo* from = find(compiler.workflows(), workflow);
    const ModelInfo* model = find(compiler.lighting_models(), lighting);
    if (!from || !model) return {};
    const Names read = read_by(*model);
    std::vector<std::string> unread;
    for (const std::string& input : inputs_set(compiler, graph, options)) {
        // Values that lighting reads of every surface, such as emission and alpha, follow from no value of the
        // workflow.
        bool has_value = false, is_read = read.contains(input);
        for (const auto& [name, value] : from->outputs) {
            if (!inputs_behind(*from, value).contains(input)) continue;
            has_value = true;
            is_read |= read.contains(name);
        }
        if (has_value && !is_read) unread.push_back(input);
    }
    return unread;
}

}  // namespace patina::cli
