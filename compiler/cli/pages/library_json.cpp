#include "compiler/cli/pages/library_json.h"

#include "compiler/cli/pages/model_cost.h"
#include "compiler/cli/pages/pages.h"
#include "compiler/json/memory/json_memory.h"

namespace patina::cli {
namespace {

void write_text(JsonPages& writer, const char* key, const std::string& text) {
    if (text.empty()) return;
    writer.Key(key);
    writer.String(text.c_str());
}

void write_word(JsonPages& writer, const char* key, HasWords auto value) {
    write_text(writer, key, std::string(to_string(value)));
}

void write_range(JsonPages& writer, const std::optional<std::array<double, 2>>& range) {
    if (!range) return;
    writer.Key("range");
    writer.StartArray();
    for (double limit : *range) writer.Double(limit);
    writer.EndArray();
}

void write_texts(JsonPages& writer, const char* key, std::span<const std::string> texts) {
    if (texts.empty()) return;
    writer.Key(key);
    writer.StartArray();
    for (const std::string& text : texts) writer.String(text.c_str());
    writer.EndArray();
}

void write_pairs(JsonPages& writer, const char* key, std::span<const std::pair<std::string, std::string>> pairs) {
    if (pairs.empty()) return;
    writer.Key(key);
    writer.StartObject();
    for (const auto& [name, value] : pairs) {
        writer.Key(name.c_str());
        writer.String(value.c_str());
    }
    writer.EndObject();
}

void write_port(JsonPages& writer, const PortInfo& port) {
    writer.StartObject();
    write_text(writer, "name", port.name);
    write_text(writer, "type", port.type);
    write_text(writer, "default", port.default_value);
    write_range(writer, port.range);
    write_text(writer, "unit", port.unit);
    write_text(writer, "doc", port.doc);
    std::vector<std::string> names, docs;
    for (const EnumeratorInfo& enumerator : port.enumerators) {
        names.push_back(enumerator.name);
        docs.push_back(enumerator.doc);
    }
    write_texts(writer, "values", names);
    write_texts(writer, "valueDocs", docs);
    writer.EndObject();
}

void write_ports(JsonPages& writer, const char* key, const NodeInfo& node, bool outputs) {
    writer.Key(key);
    writer.StartArray();
    for (const PortInfo& port : node.ports) {
        if (port.is_output == outputs) write_port(writer, port);
    }
    writer.EndArray();
}

void write_node(JsonPages& writer, const NodeInfo& node) {
    writer.StartObject();
    write_text(writer, "name", node.name);
    write_text(writer, "category", node.category);
    writer.Key("also");
    writer.StartArray();
    for (const std::string& name : node.also) writer.String(name.c_str());
    writer.EndArray();
    write_text(writer, "doc", node.doc);
    write_text(writer, "formula", node.formula);
    write_text(writer, "source", node.source);
    write_text(writer, "file", node.file);
    write_ports(writer, "inputs", node, false);
    write_ports(writer, "outputs", node, true);
    write_text(writer, "example", example_of(node, node.name));
    write_texts(writer, "tests", node.tests);
    writer.EndObject();
}

void write_inputs(JsonPages& writer, const char* key, std::span<const ModelInputInfo> inputs) {
    if (inputs.empty()) return;
    writer.Key(key);
    writer.StartArray();
    for (const ModelInputInfo& input : inputs) {
        writer.StartObject();
        write_text(writer, "name", input.name);
        write_text(writer, "type", input.type);
        write_text(writer, "default", input.default_value);
        write_range(writer, input.range);
        write_texts(writer, "values", input.values);
        if (input.is_variant) {
            writer.Key("variant");
            writer.Bool(true);
        }
        write_text(writer, "doc", input.doc);
        writer.EndObject();
    }
    writer.EndArray();
}

void write_counts(JsonPages& writer, const char* key, const CostCounts& counts) {
    writer.Key(key);
    writer.StartObject();
    for (const CostFigure& figure : kCostFigures) {
        writer.Key(std::string(figure.name).c_str());
        writer.Uint(counts.*figure.count);
    }
    writer.EndObject();
}

void write_cost(JsonPages& writer, const ModelCost& cost) {
    writer.Key("cost");
    writer.StartObject();
    write_text(writer, "workflow", cost.workflow);
    write_text(writer, "pass", cost.pass);
    write_counts(writer, "once", cost.fragment.once);
    write_counts(writer, "perLight", cost.fragment.per_light);
    writer.Key("registers");
    writer.Uint(cost.fragment.registers);
    writer.EndObject();
}

// `cost`: null if it is not measured.
void write_model(JsonPages& writer, const Compiler& compiler, const ModelInfo& model, const ModelCost* cost) {
    writer.StartObject();
    write_text(writer, "name", model.name);
    write_text(writer, "title", model.title);
    write_text(writer, "doc", model.doc);
    write_text(writer, "use", model.use);
    write_text(writer, "formula", model.formula);
    write_text(writer, "source", model.source);
    write_text(writer, "file", model.file);
    write_inputs(writer, "inputs", model.inputs);
    write_inputs(writer, "properties", model.properties);
    write_texts(writer, "reads", semantics_read(compiler, model));
    writer.Key("nodes");
    writer.StartArray();
    for (const ModelNodeInfo& node : model.nodes) {
        writer.StartObject();
        write_text(writer, "id", node.id);
        write_text(writer, "node", node.node);
        write_text(writer, "expr", node.expr);
        write_pairs(writer, "in", node.inputs);
        write_text(writer, "doc", node.doc);
        writer.EndObject();
    }
    writer.EndArray();
    write_pairs(writer, "outputs", model.outputs);
    if (cost) write_cost(writer, *cost);
    writer.EndObject();
}

void write_flag(JsonPages& writer, const char* key, bool value) {
    writer.Key(key);
    writer.Bool(value);
}

void write_targets(JsonPages& writer, const std::vector<RenderTarget>& targets) {
    writer.Key("targets");
    writer.StartArray();
    for (const RenderTarget& target : targets) {
        writer.StartObject();
        write_text(writer, "name", target.name);
        write_word(writer, "format", target.format);
        writer.EndObject();
    }
    writer.EndArray();
}

void write_blends(JsonPages& writer, const std::vector<PassInfo::SurfaceBlend>& blends) {
    writer.Key("blends");
    writer.StartArray();
    for (const auto& [surface, blend] : blends) {
        writer.StartObject();
        if (surface) write_word(writer, "surface", *surface);
        write_word(writer, "source", blend.source);
        write_word(writer, "destination", blend.destination);
        write_word(writer, "sourceAlpha", blend.source_alpha);
        write_word(writer, "destinationAlpha", blend.destination_alpha);
        writer.EndObject();
    }
    writer.EndArray();
}

void write_pass(JsonPages& writer, const PassInfo& pass) {
    const Pass& state = pass.state;
    writer.StartObject();
    write_text(writer, "name", state.name);
    write_word(writer, "draws", state.draws);
    write_word(writer, "each", state.each);
    write_word(writer, "lights", state.lights);
    write_word(writer, "camera", state.camera);
    write_text(writer, "fallback", state.fallback);
    write_flag(writer, "optional", pass.is_optional);
    write_text(writer, "depthTarget", state.depth_target);
    write_targets(writer, state.targets);
    write_blends(writer, pass.blends);
    writer.EndObject();
}

void write_path(JsonPages& writer, const PathInfo& path) {
    writer.StartObject();
    write_text(writer, "name", path.name);
    write_text(writer, "doc", path.doc);
    write_text(writer, "source", path.source);
    write_text(writer, "file", path.file);
    writer.Key("passes");
    writer.StartArray();
    for (const PassInfo& pass : path.passes) write_pass(writer, pass);
    writer.EndArray();
    writer.EndObject();
}

void write_engine(JsonPages& writer, const EngineInfo& engine) {
    writer.StartObject();
    write_text(writer, "name", engine.name);
    write_text(writer, "title", engine.title);
    write_text(writer, "doc", engine.doc);
    write_text(writer, "file", engine.file);
    write_texts(writer, "languages", engine.languages);
    write_flag(writer, "default", engine.is_default);
    write_flag(writer, "ownPasses", engine.has_own_passes);
    write_texts(writer, "paths", engine.paths);
    write_flag(writer, "oneFile", engine.is_one_file);
    write_text(writer, "folder", engine.folder);
    writer.EndObject();
}

void write_semantic(JsonPages& writer, const SemanticInfo& semantic) {
    writer.StartObject();
    write_text(writer, "name", semantic.name);
    write_text(writer, "type", semantic.type);
    write_text(writer, "rate", semantic.rate);
    write_text(writer, "doc", semantic.doc);
    writer.EndObject();
}

void write_engine_value(JsonPages& writer, const EngineValueInfo& value) {
    writer.StartObject();
    write_text(writer, "name", value.name);
    write_text(writer, "type", value.type);
    write_text(writer, "doc", value.doc);
    write_text(writer, "unit", value.unit);
    write_text(writer, "space", value.space);
    write_texts(writer, "with", value.with);
    write_flag(writer, "ofObject", value.is_of_object);
    writer.EndObject();
}

void write_block(JsonPages& writer, const EngineBlockInfo& block) {
    writer.StartObject();
    write_text(writer, "name", block.name);
    write_text(writer, "doc", block.doc);
    writer.Key("values");
    writer.StartArray();
    for (const EngineValueInfo& value : block.values) write_engine_value(writer, value);
    writer.EndArray();
    writer.EndObject();
}

template <class Write>
std::string as_text(Write write) {
    JsonBuffer buffer;
    JsonPages writer(buffer);
    writer.SetIndent(' ', 2);
    write(writer);
    return std::string(buffer.GetString()) + "\n";
}

}  // namespace

std::string to_json(const NodeInfo& node) {
    return as_text([&](JsonPages& writer) { write_node(writer, node); });
}

std::string to_json(std::span<const NodeInfo* const> nodes) {
    return as_text([&](JsonPages& writer) {
        writer.StartArray();
        for (const NodeInfo* node : nodes) write_node(writer, *node);
        writer.EndArray();
    });
}

std::string to_json(const Compiler& compiler, const ModelInfo& model) {
    const ModelCost cost = cost_of(compiler, model);
    return as_text([&](JsonPages& writer) { write_model(writer, compiler, model, &cost); });
}

std::string to_json(const Compiler& compiler, std::span<const ModelInfo> models) {
    return as_text([&](JsonPages& writer) {
        writer.StartArray();
        for (const ModelInfo& model : models) write_model(writer, compiler, model, nullptr);
        writer.EndArray();
    });
}

std::string to_json(std::span<const EngineInfo> engines) {
    return as_text([&](JsonPages& writer) {
        writer.StartArray();
        for (const EngineInfo& engine : engines) write_engine(writer, engine);
        writer.EndArray();
    });
}

std::string to_json(std::span<const SemanticInfo> semantics, std::span<const EngineBlockInfo> blocks) {
    return as_text([&](JsonPages& writer) {
        writer.StartObject();
        writer.Key("semantics");
        writer.StartArray();
        for (const SemanticInfo& semantic : semantics) write_semantic(writer, semantic);
        writer.EndArray();
        writer.Key("blocks");
        writer.StartArray();
        for (const EngineBlockInfo& block : blocks) write_block(writer, block);
        writer.EndArray();
        writer.EndObject();
    });
}

std::string to_json(std::span<const PathInfo> paths) {
    return as_text([&](JsonPages& writer) {
        writer.StartArray();
        for (const PathInfo& path : paths) write_path(writer, path);
        writer.EndArray();
    });
}

}  // namespace patina::cli
