// Nodes of the standard library that are node graphs of other nodes, as the library (version 1.39) defines them.
#include "compiler/importers/mtlx/library.h"

#include <fmt/format.h>

#include <algorithm>

namespace patina::importers::mtlx {
namespace {

struct In {
    std::string_view name, type, value;  // "0.5"; "@freq": of the interface; "#moved": of a node
};

Element input(const In& in) {
    Element made{.category = "input", .attributes = {{"name", std::string(in.name)}, {"type", std::string(in.type)}}};
    const bool is_interface = in.value.starts_with('@'), is_node = in.value.starts_with('#');
    made.attributes.emplace_back(is_interface ? "interfacename"
                                 : is_node    ? "nodename"
                                              : "value",
                                 in.value.substr(is_interface || is_node ? 1 : 0));
    return made;
}

Element node(std::string_view category, std::string_view name, std::string_view type,
             std::initializer_list<In> inputs) {
    Element made{.category = std::string(category),
                 .attributes = {{"name", std::string(name)}, {"type", std::string(type)}}};
    for (const In& each : inputs) made.children.push_back(input(each));
    return made;
}

// A jitter of other noise than Worley's is a rotation of the place.
void add_unified_noise(Element& root, bool is_flat) {
    const std::string_view place = is_flat ? "texcoord" : "position", vector = is_flat ? "vector2" : "vector3",
                           end = is_flat ? "2d" : "3d";
    const std::string name = fmt::format("unifiednoise{}", end), noise = fmt::format("noise{}", end),
                      cell = fmt::format("cellnoise{}", end), worley = fmt::format("worleynoise{}", end);
    Element definition = node("nodedef", "ND_" + name, "",
                              {{"freq", vector, is_flat ? "1, 1" : "1, 1, 1"},
                               {"offset", vector, is_flat ? "0, 0" : "0, 0, 0"},
                               {"jitter", "float", "1"},
                               {"outmin", "float", "0"},
                               {"outmax", "float", "1"},
                               {"clampoutput", "boolean", "true"},
                               {"octaves", "integer", "3"},
                               {"lacunarity", "float", "2"},
                               {"diminish", "float", "0.5"},
                               {"type", "integer", "0"},
                               {"style", "integer", "0"}});
    definition.attributes = {{"name", "ND_" + name}, {"node", name}};
    definition.children.push_back({.category = "input",
                                   .attributes = {{"name", std::string(place)},
                                                  {"type", std::string(vector)},
                                                  {"defaultgeomprop", is_flat ? "UV0" : "Pobject"}}});
    definition.children.push_back({.category = "output", .attributes = {{"name", "out"}, {"type", "float"}}});
    Element graph{.category = "nodegraph", .attributes = {{"name", "NG_" + name}, {"nodedef", "ND_" + name}}};
    const std::string interface = "@" + std::string(place);
    const auto add = [&](Element each) { graph.children.push_back(std::move(each)); };
    add(node("multiply", "scaled", vector, {{"in1", vector, interface}, {"in2", vector, "@freq"}}));
    add(node("add", "moved", vector, {{"in1", vector, "#scaled"}, {"in2", vector, "@offset"}}));
    add(node("subtract", "less", "float", {{"in1", "float", "@jitter"}, {"in2", "float", "1"}}));
    add(node("multiply", "turn", "float", {{"in1", "float", "#less"}, {"in2", "float", "90000"}}));
    if (is_flat)
        add(node("rotate2d", "turned", vector, {{"in", vector, "#moved"}, {"amount", "float", "#turn"}}));
    else
        add(node("rotate3d", "turned", vector,
                 {{"in", vector, "#moved"}, {"amount", "float", "#turn"}, {"axis", vector, "0.1, 1, 0"}}));
    add(node(noise, "perlin", "float",
             {{place, vector, "#turned"}, {"amplitude", "float", "0.5"}, {"pivot", "float", "0.5"}}));
    add(node(cell, "cells", "float", {{place, vector, "#turned"}}));
    add(node(worley, "points", "float",
             {{place, vector, "#moved"}, {"jitter", "float", "@jitter"}, {"style", "integer", "@style"}}));
    if (is_flat) {
        add(node("extract", "across", "float", {{"in", vector, "#moved"}, {"index", "integer", "0"}}));
        add(node("extract", "up", "float", {{"in", vector, "#moved"}, {"index", "integer", "1"}}));
        add(node("combine3", "deep", "vector3",
                 {{"in1", "float", "#across"}, {"in2", "float", "#up"}, {"in3", "float", "#turn"}}));
    }
    add(node("fractal3d", "layers", "float",
             {{"octaves", "integer", "@octaves"},
              {"lacunarity", "float", "@lacunarity"},
              {"diminish", "float", "@diminish"},
              {"position", "vector3", is_flat ? "#deep" : "#turned"}}));
    add(node("switch", "chosen", "float",
             {{"in1", "float", "#perlin"},
              {"in2", "float", "#cells"},
              {"in3", "float", "#points"},
              {"in4", "float", "#layers"},
              {"which", "integer", "@type"}}));
    add(node("range", "ranged", "float",
             {{"in", "float", "#chosen"},
              {"outlow", "float", "@outmin"},
              {"outhigh", "float", "@outmax"},
              {"doclamp", "boolean", "@clampoutput"},
              {"inlow", "float", "0"},
              {"inhigh", "float", "1"}}));
    add({.category = "output", .attributes = {{"name", "out"}, {"type", "float"}, {"nodename", "ranged"}}});
    root.children.push_back(std::move(definition));
    root.children.push_back(std::move(graph));
}

}  // namespace

const Element& standard_library() {
    static const Element made = [] {
        Element root{.category = "materialx"};
        add_unified_noise(root, true);
        add_unified_noise(root, false);
        return root;
    }();
    return made;
}

bool is_of_library(const Element& node) {
    return std::ranges::any_of(standard_library().children, [&](const Element& graph) {
        return std::ranges::any_of(graph.children, [&](const Element& each) { return &each == &node; });
    });
}

}  // namespace patina::importers::mtlx
