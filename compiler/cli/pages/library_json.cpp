#include "compiler/cli/pages/library_json.h"

#include "compiler/api/describe/list_json.h"
#include "compiler/cli/pages/model_cost.h"
#include "compiler/cli/pages/pages.h"

namespace patina::cli {
namespace {

void write_pairs(JsonWriter& json, std::string_view key, std::span<const std::pair<std::string, std::string>> pairs) {
    if (pairs.empty()) return;
    json.begin(key, '{');
    for (const auto& [name, value] : pairs) json.write(name, value);
    json.end();
}

void write_inputs(JsonWriter& json, std::string_view key, std::span<const ModelInputInfo> inputs) {
    if (inputs.empty()) return;
    json.begin(key, '[');
    for (const ModelInputInfo& input : inputs) {
        json.begin('{');
        json.if_any("name", input.name);
        json.if_any("type", input.type);
        json.if_any("default", input.default_value);
        json.if_any("range", input.range);
        json.if_any("values", input.values);
        if (input.is_variant) json.write("variant", true);
        json.if_any("doc", input.doc);
        json.end();
    }
    json.end();
}

void write_counts(JsonWriter& json, std::string_view key, const CostCounts& counts) {
    json.begin(key, '{');
    for (const CostFigure& figure : kCostFigures) json.write(figure.name, counts.*figure.count);
    json.end();
}

void write_cost(JsonWriter& json, const ModelCost& cost) {
    json.begin("cost", '{');
    json.if_any("workflow", cost.workflow);
    json.if_any("pass", cost.pass);
    write_counts(json, "once", cost.fragment.once);
    write_counts(json, "perLight", cost.fragment.per_light);
    json.write("registers", cost.fragment.registers);
    json.end();
}

// `cost`: null if it is not measured.
void write_model(JsonWriter& json, const Compiler& compiler, const ModelInfo& model, const ModelCost* cost) {
    json.begin('{');
    json.if_any("name", model.name);
    json.if_any("title", model.title);
    json.if_any("doc", model.doc);
    json.if_any("use", model.use);
    json.if_any("formula", model.formula);
    json.if_any("source", model.source);
    json.if_any("file", model.file);
    write_inputs(json, "inputs", model.inputs);
    write_inputs(json, "properties", model.properties);
    json.if_any("reads", semantics_read(compiler, model));
    json.begin("nodes", '[');
    for (const ModelNodeInfo& node : model.nodes) {
        json.begin('{');
        json.if_any("id", node.id);
        json.if_any("node", node.node);
        json.if_any("expr", node.expr);
        write_pairs(json, "in", node.inputs);
        json.if_any("doc", node.doc);
        json.end();
    }
    json.end();
    write_pairs(json, "outputs", model.outputs);
    if (cost) write_cost(json, *cost);
    json.end();
}

void write(JsonWriter& json, const SemanticInfo& semantic) {
    json.begin('{');
    json.if_any("name", semantic.name);
    json.if_any("type", semantic.type);
    json.if_any("rate", semantic.rate);
    json.if_any("doc", semantic.doc);
    json.end();
}

void write(JsonWriter& json, const EngineValueInfo& value) {
    json.begin('{');
    json.if_any("name", value.name);
    json.if_any("type", value.type);
    json.if_any("doc", value.doc);
    json.if_any("unit", value.unit);
    json.if_any("space", value.space);
    json.if_any("with", value.with);
    json.write("ofObject", value.is_of_object);
    json.end();
}

void write(JsonWriter& json, const EngineBlockInfo& block) {
    json.begin('{');
    json.if_any("name", block.name);
    json.if_any("doc", block.doc);
    json.begin("values", '[');
    for (const EngineValueInfo& value : block.values) write(json, value);
    json.end();
    json.end();
}

// A page that `write` fills.
template <class Write>
std::string page_of(const Write& write) {
    JsonWriter json(JsonWriter::Layout::Pages);
    write(json);
    return json.take() + "\n";
}

template <class All, class Write>
std::string list_of(const All& all, const Write& write) {
    return page_of([&](JsonWriter& json) {
        json.begin('[');
        for (const auto& each : all) write(json, each);
        json.end();
    });
}

void write_node(JsonWriter& json, const NodeInfo& node) {
    write_json(json, node, example_of(node, node.name));
}

}  // namespace

std::string to_json(const NodeInfo& node) {
    return page_of([&](JsonWriter& json) { write_node(json, node); });
}

std::string to_json(std::span<const NodeInfo* const> nodes) {
    return list_of(nodes, [](JsonWriter& json, const NodeInfo* node) { write_node(json, *node); });
}

std::string to_json(const Compiler& compiler, const ModelInfo& model) {
    const ModelCost cost = cost_of(compiler, model);
    return page_of([&](JsonWriter& json) { write_model(json, compiler, model, &cost); });
}

std::string to_json(const Compiler& compiler, std::span<const ModelInfo> models) {
    return list_of(models,
                   [&](JsonWriter& json, const ModelInfo& each) { write_model(json, compiler, each, nullptr); });
}

std::string to_json(std::span<const EngineInfo> engines) {
    return list_of(engines, [](JsonWriter& json, const EngineInfo& each) { write_json(json, each); });
}

std::string to_json(std::span<const SemanticInfo> semantics, std::span<const EngineBlockInfo> blocks) {
    return page_of([&](JsonWriter& json) {
        json.begin('{');
        json.begin("semantics", '[');
        for (const SemanticInfo& semantic : semantics) write(json, semantic);
        json.end();
        json.begin("blocks", '[');
        for (const EngineBlockInfo& block : blocks) write(json, block);
        json.end();
        json.end();
    });
}

std::string to_json(std::span<const PathInfo> paths) {
    return list_of(paths, [](JsonWriter& json, const PathInfo& each) { write_json(json, each); });
}

}  // namespace patina::cli
