// Records how an engine stores the values of properties: the type, the decoder, and the values that it fills for each
// texture. Adds the lines of the engine's file for each stage that calls one of its functions.
#include <algorithm>

#include "compiler/lower/lowering.h"

namespace patina::lower {
namespace {

using nodelang::Expr;

bool reads(const Expr& expr, std::string_view property) {
    if (expr.kind == Expr::Kind::Property && expr.text == property) return true;
    return std::any_of(expr.args.begin(), expr.args.end(), [&](const Expr* arg) { return reads(*arg, property); });
}

bool reads(std::span<const format::PortValue> ports, std::string_view property) {
    return std::any_of(ports.begin(), ports.end(),
                       [&](const format::PortValue& port) { return port.value && reads(*port.value, property); });
}

bool node_reads(const format::Node& node, std::string_view property) {
    return (node.expr && reads(*node.expr, property)) || reads(node.inputs, property);
}

// Marks the outputs of a node that the expression reads. The node's name alone may mean any of them.
void mark_outputs(const Expr& expr, const format::Node& node, std::span<const format::PortValue> outputs,
                  std::vector<bool>& read) {
    const bool is_member = expr.kind == Expr::Kind::Member && expr.args[0]->text == node.id;
    const bool is_node = expr.kind == Expr::Kind::Name && expr.text == node.id;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (is_node || (is_member && outputs[i].name == expr.text)) read[i] = true;
    }
    if (is_member) return;
    for (const Expr* arg : expr.args) mark_outputs(*arg, node, outputs, read);
}

// The outputs of a sub-graph's node that the ports read, and the other nodes that the ports read.
std::vector<format::PortValue> outputs_read(const resolve::CheckedGraph& graph,
                                            std::span<const format::PortValue> ports, const std::vector<bool>& nodes,
                                            std::uint32_t at) {
    const std::vector<format::PortValue>& outputs = graph.nodes[at].subgraph->graph->outputs;
    const format::Node& node = graph.graph->nodes[at];
    std::vector<bool> read(outputs.size(), false);
    const auto mark = [&](std::span<const format::PortValue> values) {
        for (const format::PortValue& port : values) {
            if (port.value) mark_outputs(*port.value, node, outputs, read);
        }
    };
    mark(ports);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i]) continue;
        const format::Node& other = graph.graph->nodes[i];
        if (other.expr) mark_outputs(*other.expr, node, outputs, read);
        mark(other.inputs);
    }
    std::vector<format::PortValue> made;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (read[i]) made.push_back(outputs[i]);
    }
    return made;
}

// True if the ports read the property, directly or through nodes.
bool reaches(const resolve::CheckedGraph& graph, std::span<const format::PortValue> ports, std::string_view property) {
    if (reads(ports, property)) return true;
    const std::vector<bool> nodes = graph.reachable(ports);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i]) continue;
        if (node_reads(graph.graph->nodes[i], property)) return true;
        const resolve::CheckedGraph* inner = graph.nodes[i].subgraph;
        if (inner && reaches(*inner, outputs_read(graph, ports, nodes, i), property)) return true;
    }
    return false;
}

// True for a colour that may be brighter than white: its range or its default exceeds 1, or only emitted light reads it
// ([hdr] members of the lighting surface).
bool is_hdr(const paths::PathDeclarations& paths, const resolve::CheckedGraph& graph,
            const format::Property& property) {
    if (property.range && (*property.range)[1] > 1) return true;
    if (std::any_of(property.value.begin(), property.value.begin() + 3, [](double v) { return v > 1; })) return true;
    std::vector<format::PortValue> light, others = graph.graph->vertex;
    for (const format::PortValue& port : graph.graph->surface)
        (paths.is_hdr(port.name) ? light : others).push_back(port);
    return reaches(graph, light, property.name) && !reaches(graph, others, property.name);
}

std::string_view stored_as(const engines::Engine& engine, const format::Property& property) {
    const bool is_within_one = property.type == PropertyType::Float && property.range && (*property.range)[0] >= -1 &&
                               (*property.range)[1] <= 1;
    return engine.stored_as(is_within_one ? "floatWithinOne" : to_string(property.type));
}

std::string_view usage_of(const paths::PathDeclarations& paths, const resolve::CheckedGraph& graph,
                          const format::Property& property) {
    if (property.type == PropertyType::Color) return is_hdr(paths, graph, property) ? "" : "color";
    if (!is_texture(property.type)) return {};
    // An engine's own normal maps have only the channels that a decoder reads. If other channels are read, the map is a
    // plain texture.
    if (property.usage == TextureUsage::Normal) return property.swizzle.empty() ? "normal" : "";
    return property.usage == TextureUsage::Color ? "color" : "";
}

// The included file that declares a value of materials with this name and type; empty if there is none.
std::string declared_in(const Lowering& lowering, const format::Property& property) {
    const auto& foreign = lowering.session.paths->foreign;
    const auto found = std::find_if(foreign.begin(), foreign.end(), [&](const paths::ForeignDecl& each) {
        return each.variable->name == property.name && !each.include.empty();
    });
    if (found == foreign.end() || property.type != PropertyType::Color || property.binding == Binding::Instance)
        return {};
    return found->include;
}

// [decodes("normal", "f", "g")]: if f is called with the result, g replaces both.
void decode_by(const paths::DecoderDecl& decoder, ir::Global& global) {
    global.decoder = decoder.function->name;
    if (decoder.at_once.empty()) return;
    global.follower = decoder.follower;
    global.at_once = decoder.at_once;
}

// (1/width, 1/height, width, height).
ir::GlobalId add_texture_size(ir::Module& module, const ir::Global& texture, const std::string& ending) {
    module.globals.push_back(
        {.name = texture.name + ending, .type = ir::kFloat4, .group = texture.group, .span = texture.span});
    return {static_cast<std::uint32_t>(module.globals.size() - 1)};
}

}  // namespace

void keep_values(Lowering& lowering) {
    Lowered& out = lowering.out;
    const engines::Engine& engine = lowering.session.engine;
    const auto& decoders = lowering.session.paths->decoders;
    for (std::size_t i = 0; i < lowering.material.properties.size(); ++i) {
        const format::Property& property = *lowering.material.properties[i].property;
        PropertyGlobals& globals = out.property_globals[i];
        if (!globals.texture && !globals.value) continue;  // it is a keyword
        if (globals.texture && !engine.texture_sizes.empty())
            globals.texel_size = add_texture_size(out.module, ir::Global(out.module.globals[globals.texture.index]),
                                                  engine.texture_sizes);
        ir::Global& global = out.module.globals[(globals.texture ? globals.texture : globals.value).index];
        const auto decoder = decoders.find(usage_of(*lowering.session.paths, *lowering.material.graph, property));
        if (decoder != decoders.end()) decode_by(decoder->second, global);
        if (!global.in_block()) continue;
        ir::BlockMember& member = out.module.blocks[global.block].members[global.member];
        member.stored_as = stored_as(engine, property);
        member.is_of_instance = engine.instances == engines::Instances::Engine && property.binding == Binding::Instance;
        member.declared_in = declared_in(lowering, property);
    }
}

void give_texts(Lowering& lowering) {
    for (const paths::ForeignFunctionDecl& foreign : lowering.session.paths->foreign_functions) {
        for (const emit::InstanceInfo& instance : lowering.emitter.instances.of(*foreign.function))
            lowering.out.module[instance.id].texts = foreign.texts;
    }
    // The lines of a decoder are added where its follower is called.
    for (const auto& [usage, decoder] : lowering.session.paths->decoders) {
        for (ir::Function& function : lowering.out.module.functions) {
            if (!decoder.follower.empty() && function.name == decoder.follower) function.texts = decoder.texts;
        }
    }
}

}  // namespace patina::lower
