#include "compiler/cli/node_json.h"

#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

namespace patina::cli {
namespace {

using Writer = rapidjson::PrettyWriter<rapidjson::StringBuffer>;

void write_text(Writer& writer, const char* key, const std::string& text) {
    if (text.empty()) return;
    writer.Key(key);
    writer.String(text.c_str());
}

void write_port(Writer& writer, const PortInfo& port) {
    writer.StartObject();
    write_text(writer, "name", port.name);
    write_text(writer, "type", port.type);
    write_text(writer, "default", port.default_value);
    if (port.range) {
        writer.Key("range");
        writer.StartArray();
        for (double limit : *port.range) writer.Double(limit);
        writer.EndArray();
    }
    write_text(writer, "unit", port.unit);
    write_text(writer, "doc", port.doc);
    if (!port.enumerators.empty()) {
        writer.Key("values");
        writer.StartArray();
        for (const std::string& enumerator : port.enumerators) writer.String(enumerator.c_str());
        writer.EndArray();
    }
    writer.EndObject();
}

void write_ports(Writer& writer, const char* key, const NodeInfo& node, bool outputs) {
    writer.Key(key);
    writer.StartArray();
    for (const PortInfo& port : node.ports) {
        if (port.is_output == outputs) write_port(writer, port);
    }
    writer.EndArray();
}

void write_node(Writer& writer, const NodeInfo& node) {
    writer.StartObject();
    write_text(writer, "name", node.name);
    write_text(writer, "category", node.category);
    write_text(writer, "doc", node.doc);
    write_text(writer, "formula", node.formula);
    write_text(writer, "source", node.source);
    write_text(writer, "file", node.file);
    write_ports(writer, "inputs", node, false);
    write_ports(writer, "outputs", node, true);
    writer.EndObject();
}

std::string finished(const rapidjson::StringBuffer& buffer) {
    return std::string(buffer.GetString()) + "\n";
}

}  // namespace

std::string to_json(const NodeInfo& node) {
    rapidjson::StringBuffer buffer;
    Writer writer(buffer);
    writer.SetIndent(' ', 2);
    write_node(writer, node);
    return finished(buffer);
}

std::string to_json(std::span<const NodeInfo* const> nodes) {
    rapidjson::StringBuffer buffer;
    Writer writer(buffer);
    writer.SetIndent(' ', 2);
    writer.StartArray();
    for (const NodeInfo* node : nodes) write_node(writer, *node);
    writer.EndArray();
    return finished(buffer);
}

}  // namespace patina::cli
