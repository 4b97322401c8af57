#include "compiler/api/describe/list_json.h"

namespace patina {
namespace {

void write(JsonWriter& json, const PortInfo& port) {
    json.begin('{');
    json.if_any("name", port.name);
    json.if_any("type", port.type);
    json.if_any("default", port.default_value);
    json.if_any("range", port.range);
    json.if_any("unit", port.unit);
    json.if_any("doc", port.doc);
    std::vector<std::string> names, docs;
    for (const EnumeratorInfo& each : port.enumerators) {
        names.push_back(each.name);
        docs.push_back(each.doc);
    }
    json.if_any("values", names);
    json.if_any("valueDocs", docs);
    json.end();
}

void write_ports(JsonWriter& json, std::string_view key, const NodeInfo& node, bool outputs) {
    json.begin(key, '[');
    for (const PortInfo& port : node.ports)
        if (port.is_output == outputs) write(json, port);
    json.end();
}

void write(JsonWriter& json, const PassInfo& pass) {
    const Pass& state = pass.state;
    json.begin('{');
    json.if_any("name", state.name);
    json.write("draws", state.draws);
    json.write("each", state.each);
    json.write("lights", state.lights);
    json.write("camera", state.camera);
    json.if_any("fallback", state.fallback);
    json.write("optional", pass.is_optional);
    json.if_any("depthTarget", state.depth_target);
    json.begin("targets", '[');
    for (const RenderTarget& target : state.targets) {
        json.begin('{');
        json.if_any("name", target.name);
        json.write("format", target.format);
        json.end();
    }
    json.end();
    json.begin("blends", '[');
    for (const auto& [surface, blend] : pass.blends) {
        json.begin('{');
        json.if_any("surface", surface);
        json.write("source", blend.source);
        json.write("destination", blend.destination);
        json.write("sourceAlpha", blend.source_alpha);
        json.write("destinationAlpha", blend.destination_alpha);
        json.end();
    }
    json.end();
    json.end();
}

}  // namespace

void write_json(JsonWriter& json, const NodeInfo& node, const std::string& example) {
    json.begin('{');
    json.if_any("name", node.name);
    json.if_any("category", node.category);
    json.write("also", node.also);
    json.if_any("doc", node.doc);
    json.if_any("formula", node.formula);
    json.if_any("source", node.source);
    json.if_any("file", node.file);
    write_ports(json, "inputs", node, false);
    write_ports(json, "outputs", node, true);
    json.if_any("example", example);
    json.if_any("tests", node.tests);
    json.end();
}

void write_json(JsonWriter& json, const PathInfo& path) {
    json.begin('{');
    json.if_any("name", path.name);
    json.if_any("doc", path.doc);
    json.if_any("source", path.source);
    json.if_any("file", path.file);
    json.begin("passes", '[');
    for (const PassInfo& pass : path.passes) write(json, pass);
    json.end();
    json.end();
}

void write_json(JsonWriter& json, const EngineInfo& engine) {
    json.begin('{');
    json.if_any("name", engine.name);
    json.if_any("title", engine.title);
    json.if_any("doc", engine.doc);
    json.if_any("file", engine.file);
    json.if_any("languages", engine.languages);
    json.write("default", engine.is_default);
    json.write("ownPasses", engine.has_own_passes);
    json.if_any("paths", engine.paths);
    json.write("oneFile", engine.is_one_file);
    json.if_any("folder", engine.folder);
    json.end();
}

}  // namespace patina
