// Makes the public description of a workflow or lighting graph. The comments above the graph and above its nodes are
// its documentation.
#include <algorithm>

#include "compiler/api/describe/describe.h"

namespace patina {
namespace {

// The comment lines that end directly before the offset, without the text in front of their slashes.
std::string_view comment_before(const SourceMap& sources, std::uint32_t offset) {
    const std::string_view text = sources.text_before(offset);
    const auto line_start = [&](std::size_t end) { return text.substr(0, end).rfind('\n') + 1; };
    std::size_t begin = line_start(text.size());
    const std::size_t end = begin;
    while (begin > 0) {
        const std::size_t above = line_start(begin - 1);
        const std::string_view line = text.substr(above, begin - above);
        const std::size_t first = line.find_first_not_of(" \t");
        if (first == line.npos || !line.substr(first).starts_with("//")) break;
        begin = above;
    }
    return text.substr(begin, end - begin);
}

// The text as written, without the quotes of a JSON string.
std::string value_text(const SourceMap& sources, Span span) {
    std::string_view text = sources.text(span);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return std::string(text);
}

ModelInputInfo describe_input(const format::Input& input, const SourceMap& sources) {
    return {.name = input.name,
            .type = input.type,
            .default_value = std::string(sources.text(input.default_span)),
            .doc = input.help,
            .range = input.range,
            .gives = input.gives};
}

ModelInputInfo describe_property(const format::Property& property, const SourceMap& sources) {
    return {.name = property.name,
            .type = std::string(to_string(property.type)),
            .default_value = std::string(sources.text(property.default_span)),
            .doc = property.help,
            .range = property.range,
            .values = property.values,
            .is_variant = property.binding == Binding::Variant};
}

ModelNodeInfo describe_node(const format::Node& node, const SourceMap& sources) {
    ModelNodeInfo info{.id = node.id,
                       .node = node.is_expression ? std::string() : node.type,
                       .expr = node.is_expression ? value_text(sources, node.expr_span) : std::string(),
                       .inputs = {},
                       .doc = read_doc(comment_before(sources, node.span.begin)).text};
    for (const format::PortValue& port : node.inputs) {
        info.inputs.emplace_back(port.name, value_text(sources, port.value_span));
    }
    return info;
}

}  // namespace

ModelInfo describe_model(const format::Graph& graph, const std::string& name, const SourceMap& sources) {
    Doc doc = read_doc(comment_before(sources, graph.span.begin));
    ModelInfo model{.name = name,
                    .title = graph.name,
                    .doc = doc.text.empty() ? graph.name : std::move(doc.text),
                    .formula = std::move(doc.formula),
                    .source = std::move(doc.source),
                    .use = doc.use.empty() ? graph.help : std::move(doc.use),
                    .file = graph.path,
                    .inputs = {},
                    .properties = {},
                    .nodes = {},
                    .outputs = {}};
    for (const format::Input& input : graph.inputs) model.inputs.push_back(describe_input(input, sources));
    for (const format::Property& property : graph.properties) {
        model.properties.push_back(describe_property(property, sources));
    }
    for (const format::Node& node : graph.nodes) model.nodes.push_back(describe_node(node, sources));
    const bool is_workflow = graph.kind == format::GraphKind::Workflow;
    for (const format::PortValue& output : is_workflow ? graph.surface : graph.outputs) {
        model.outputs.emplace_back(output.name, value_text(sources, output.value_span));
    }
    return model;
}

}  // namespace patina
