// What a target whose files are another tool's wants to know beside the passes: how the tool keeps the values of
// properties, what decodes them, what it fills beside textures, and the lines that a stage needs which calls a foreign
// function.
#include <algorithm>

#include "compiler/lower/lowering.h"

namespace patina::graph {
namespace {

using nodelang::Expr;

bool reads(const Expr& expr, std::string_view property) {
    if (expr.kind == Expr::Kind::Property && expr.text == property) return true;
    return std::any_of(expr.args.begin(), expr.args.end(), [&](const Expr* arg) { return reads(*arg, property); });
}

bool reads(std::span<const PortValue> ports, std::string_view property) {
    return std::any_of(ports.begin(), ports.end(),
                       [&](const PortValue& port) { return port.value && reads(*port.value, property); });
}

bool node_reads(const Node& node, std::string_view property) {
    return (node.expr && reads(*node.expr, property)) || reads(node.inputs, property);
}

// Marks the outputs of a node that the expression reads; the node by its name alone may be any of them.
void mark_outputs(const Expr& expr, const Node& node, std::span<const PortValue> outputs, std::vector<bool>& read) {
    const bool is_member = expr.kind == Expr::Kind::Member && expr.args[0]->text == node.id;
    const bool is_node = expr.kind == Expr::Kind::Name && expr.text == node.id;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (is_node || (is_member && outputs[i].name == expr.text)) read[i] = true;
    }
    if (is_member) return;
    for (const Expr* arg : expr.args) mark_outputs(*arg, node, outputs, read);
}

// The outputs of a sub-graph's node that the ports read, and the other nodes.
std::vector<PortValue> outputs_read(const CheckedGraph& graph, std::span<const PortValue> ports,
                                    const std::vector<bool>& nodes, std::uint32_t at) {
    const std::vector<PortValue>& outputs = graph.nodes[at].subgraph->graph->outputs;
    const Node& node = graph.graph->nodes[at];
    std::vector<bool> read(outputs.size(), false);
    const auto mark = [&](std::span<const PortValue> values) {
        for (const PortValue& port : values) {
            if (port.value) mark_outputs(*port.value, node, outputs, read);
        }
    };
    mark(ports);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i]) continue;
        const Node& other = graph.graph->nodes[i];
        if (other.expr) mark_outputs(*other.expr, node, outputs, read);
        mark(other.inputs);
    }
    std::vector<PortValue> made;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (read[i]) made.push_back(outputs[i]);
    }
    return made;
}

// Whether these ports come to read the property, themselves or through nodes.
bool reaches(const CheckedGraph& graph, std::span<const PortValue> ports, std::string_view property) {
    if (reads(ports, property)) return true;
    const std::vector<bool> nodes = graph.reachable(ports);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i]) continue;
        if (node_reads(graph.graph->nodes[i], property)) return true;
        const CheckedGraph* inner = graph.nodes[i].subgraph;
        if (inner && reaches(*inner, outputs_read(graph, ports, nodes, i), property)) return true;
    }
    return false;
}

constexpr std::string_view kEmission = "emission";

// A colour that may be brighter than white: one whose range ends above, or that is so by default, or that nothing but
// the emission reads.
bool is_hdr(const CheckedGraph& graph, const Property& property) {
    if (property.range && (*property.range)[1] > 1) return true;
    if (std::any_of(property.value.begin(), property.value.begin() + 3, [](double v) { return v > 1; })) return true;
    std::vector<PortValue> emission, others = graph.graph->vertex;
    for (const PortValue& port : graph.graph->surface) (port.name == kEmission ? emission : others).push_back(port);
    return reaches(graph, emission, property.name) && !reaches(graph, others, property.name);
}

// The word for its type; half where that is precise enough for what artists set.
std::string stored_as(const Property& property) {
    switch (property.type) {
        case PropertyType::Color: return "half4";
        case PropertyType::Int:
        case PropertyType::Bool:
        case PropertyType::Enum: return "float";
        case PropertyType::Float:
            return property.range && (*property.range)[0] >= -1 && (*property.range)[1] <= 1 ? "half" : "float";
        case PropertyType::Float2:
        case PropertyType::Float3:
        case PropertyType::Float4: return "float4";
        case PropertyType::Texture2D: return {};
    }
    return {};
}

std::string_view usage_of(const CheckedGraph& graph, const Property& property) {
    if (property.type == PropertyType::Color) return is_hdr(graph, property) ? "" : "color";
    if (property.type != PropertyType::Texture2D) return {};
    return property.usage == TextureUsage::Normal ? "normal" : property.usage == TextureUsage::Color ? "color" : "";
}

// The tool's file that declares a value of materials under this name and with this type; empty: none does.
std::string declared_in(const Lowering& lowering, const Property& property) {
    const auto& foreign = lowering.session.stages->foreign;
    const auto found = std::find_if(foreign.begin(), foreign.end(), [&](const nodelang::VariableDecl* each) {
        return each->name == property.name && each->attribute("text");
    });
    if (found == foreign.end() || property.type != PropertyType::Color || property.binding == Binding::Instance)
        return {};
    Diagnostics said;  // when the file was read
    return texts_of((*found)->attributes, said).front().line;
}

// [decodes("normal", "f", "g")]: where f follows, g does both.
void decode_by(const nodelang::FunctionDecl& decoder, ir::Global& global) {
    global.decoder = decoder.name;
    const std::vector<std::string_view> pair = attribute_words(*decoder.attribute("decodes"), 1);
    if (pair.size() < 2) return;
    global.follower = pair[0];
    global.at_once = pair[1];
}

// Beside each texture the tool fills (1/width, 1/height, width, height).
ir::GlobalId add_texel_size(ir::Module& module, const ir::Global& texture) {
    module.globals.push_back(
        {.name = texture.name + "_TexelSize", .type = ir::kFloat4, .set = texture.set, .span = texture.span});
    return {static_cast<std::uint32_t>(module.globals.size() - 1)};
}

}  // namespace

void mark_for_tool(Lowering& lowering) {
    Lowered& out = lowering.out;
    const auto& decoders = lowering.session.stages->decoders;
    for (std::size_t i = 0; i < lowering.material.properties.size(); ++i) {
        const Property& property = *lowering.material.properties[i].property;
        PropertyGlobals& globals = out.property_globals[i];
        if (!globals.texture && !globals.value) continue;  // it has a keyword
        if (globals.texture)
            globals.texel_size = add_texel_size(out.module, ir::Global(out.module.globals[globals.texture.index]));
        ir::Global& global = out.module.globals[(globals.texture ? globals.texture : globals.value).index];
        const auto decoder = decoders.find(usage_of(*lowering.material.graph, property));
        if (decoder != decoders.end()) decode_by(*decoder->second, global);
        if (!global.in_block()) continue;
        ir::BlockMember& member = out.module.blocks[global.block].members[global.member];
        member.stored_as = stored_as(property);
        member.is_of_instance = property.binding == Binding::Instance;
        member.declared_in = declared_in(lowering, property);
    }
}

void tell_texts(Lowering& lowering) {
    Diagnostics said;  // when the file was read
    for (const nodelang::FunctionDecl& function : lowering.session.pass_file->ast.functions) {
        if (!function.attribute("foreign")) continue;
        for (const emit::InstanceInfo& instance : lowering.emitter.instances.of(function))
            lowering.out.module[instance.id].texts = texts_of(function.attributes, said);
    }
    // What a decoder asks for is asked for where its follower is called.
    for (const auto& [usage, decoder] : lowering.session.stages->decoders) {
        const std::vector<std::string_view> pair = attribute_words(*decoder->attribute("decodes"), 1);
        for (ir::Function& function : lowering.out.module.functions) {
            if (!pair.empty() && function.name == pair[0]) function.texts = texts_of(decoder->attributes, said);
        }
    }
}

}  // namespace patina::graph
