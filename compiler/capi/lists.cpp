// The functions of patina/patina_c.h that list what the library has.
#include <memory>

#include "compiler/capi/handles.h"
#include "compiler/capi/json_writer.h"

namespace patina::capi {
namespace {

// Gives the list, which is made at the first request. `entry_of` makes an entry of an info and its JSON, which stays
// where it is.
template <class Entry, class Info, class Json, class EntryOf>
patina_status give(const MadeOnce<List<Entry>>& made, const std::vector<Info>& (Compiler::*infos)() const,
                   const patina_compiler* compiler, const Json& json_of, const EntryOf& entry_of, const Entry** entries,
                   std::size_t* count) {
    return guarded([&] {
        const List<Entry>& list = made.get([&] {
            auto all = std::make_unique<List<Entry>>();
            const std::vector<Info>& known = (compiler->compiler.*infos)();
            all->texts.reserve(known.size());
            all->entries.reserve(known.size());
            for (const Info& info : known) {
                all->texts.push_back(json_of(info));
                all->entries.push_back(entry_of(info, all->texts.back().c_str()));
            }
            return all;
        });
        *entries = list.entries.data();
        *count = list.entries.size();
        return PATINA_OK;
    });
}

template <class Entry>
bool is_complete(const patina_compiler* compiler, const Entry** entries, std::size_t* count) {
    if (entries) *entries = nullptr;
    if (count) *count = 0;
    return compiler && entries && count;
}

void write(JsonWriter& json, const PortInfo& port) {
    json.begin('{');
    json.text("name", port.name);
    json.text("type", port.type);
    json.text("default", port.default_value);
    if (port.range) json.numbers("range", *port.range);
    json.text("unit", port.unit);
    json.text("doc", port.doc);
    std::vector<std::string> names, docs;
    for (const EnumeratorInfo& each : port.enumerators) {
        names.push_back(each.name);
        docs.push_back(each.doc);
    }
    json.list("values", names);
    json.list("valueDocs", docs);
    json.end('}');
}

std::string json_of_node(const NodeInfo& node) {
    JsonWriter json;
    json.begin('{');
    json.text("name", node.name);
    json.text("category", node.category);
    json.list("also", node.also);
    json.text("doc", node.doc);
    json.text("formula", node.formula);
    json.text("source", node.source);
    json.text("file", node.file);
    for (const bool is_output : {false, true}) {
        json.begin(is_output ? "outputs" : "inputs", '[');
        for (const PortInfo& port : node.ports)
            if (port.is_output == is_output) write(json, port);
        json.end(']');
    }
    json.list("tests", node.tests);
    json.end('}');
    return json.take();
}

void write(JsonWriter& json, const PassInfo& pass) {
    const Pass& state = pass.state;
    json.begin('{');
    json.text("name", state.name);
    json.word("draws", state.draws);
    json.word("each", state.each);
    json.word("lights", state.lights);
    json.word("camera", state.camera);
    json.text("fallback", state.fallback);
    json.flag("optional", pass.is_optional);
    json.text("depthTarget", state.depth_target);
    json.begin("targets", '[');
    for (const RenderTarget& target : state.targets) {
        json.begin('{');
        json.text("name", target.name);
        json.word("format", target.format);
        json.end('}');
    }
    json.end(']');
    json.begin("blends", '[');
    for (const auto& [surface, blend] : pass.blends) {
        json.begin('{');
        if (surface) json.word("surface", *surface);
        json.word("source", blend.source);
        json.word("destination", blend.destination);
        json.word("sourceAlpha", blend.source_alpha);
        json.word("destinationAlpha", blend.destination_alpha);
        json.end('}');
    }
    json.end(']');
    json.end('}');
}

std::string json_of_path(const PathInfo& path) {
    JsonWriter json;
    json.begin('{');
    json.text("name", path.name);
    json.text("doc", path.doc);
    json.text("source", path.source);
    json.text("file", path.file);
    json.begin("passes", '[');
    for (const PassInfo& pass : path.passes) write(json, pass);
    json.end(']');
    json.end('}');
    return json.take();
}

std::string json_of_engine(const EngineInfo& engine) {
    JsonWriter json;
    json.begin('{');
    json.text("name", engine.name);
    json.text("title", engine.title);
    json.text("doc", engine.doc);
    json.text("file", engine.file);
    json.list("languages", engine.languages);
    json.flag("default", engine.is_default);
    json.flag("ownPasses", engine.has_own_passes);
    json.list("paths", engine.paths);
    json.flag("oneFile", engine.is_one_file);
    json.text("folder", engine.folder);
    json.end('}');
    return json.take();
}

}  // namespace
}  // namespace patina::capi

using namespace patina::capi;

extern "C" {

patina_status patina_nodes(const patina_compiler* compiler, const patina_node** nodes, size_t* count) {
    if (!is_complete(compiler, nodes, count)) return PATINA_BAD_ARGUMENT;
    const auto entry = [](const patina::NodeInfo& node, const char* json) {
        return patina_node{.name = node.name.c_str(),
                           .category = node.category.c_str(),
                           .doc = node.doc.c_str(),
                           .file = node.file.c_str(),
                           .json = json};
    };
    return give(compiler->nodes, &patina::Compiler::nodes, compiler, json_of_node, entry, nodes, count);
}

patina_status patina_paths(const patina_compiler* compiler, const patina_path** paths, size_t* count) {
    if (!is_complete(compiler, paths, count)) return PATINA_BAD_ARGUMENT;
    const auto entry = [](const patina::PathInfo& path, const char* json) {
        return patina_path{.name = path.name.c_str(), .doc = path.doc.c_str(), .file = path.file.c_str(), .json = json};
    };
    return give(compiler->paths, &patina::Compiler::paths, compiler, json_of_path, entry, paths, count);
}

patina_status patina_engines(const patina_compiler* compiler, const patina_engine** engines, size_t* count) {
    if (!is_complete(compiler, engines, count)) return PATINA_BAD_ARGUMENT;
    const auto entry = [](const patina::EngineInfo& engine, const char* json) {
        return patina_engine{
            .name = engine.name.c_str(), .title = engine.title.c_str(), .doc = engine.doc.c_str(), .json = json};
    };
    return give(compiler->engines, &patina::Compiler::engines, compiler, json_of_engine, entry, engines, count);
}

}  // extern "C"
