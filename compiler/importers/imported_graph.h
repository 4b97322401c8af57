// A graph in the making, which all importers fill: what its file holds, the names that are taken, and what became of
// each part of the source. The parts of a source have numbers, which the importer gives.
//
// The file is one that a person would write: canonical key order and layout (`patina fmt` changes nothing), comments
// where the author of the graph wants them, and nothing that only repeats a default.
//
//   ImportedGraph graph("rust");
//   graph.workflow = "metallic-roughness";
//   graph.properties.push_back({.name = "_Tint", .type = "color", .value = "#b04020"});
//   graph.add({.id = "mask", .node = "Noise", .inputs = {{"scale", 4}}}, {7});   // part 7 of the source is written
//   there graph.surface.push_back({"baseColor", "$_Tint.rgb"}); std::string json = graph.text();
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/importers/importer.h"
#include "compiler/importers/names.h"
#include "compiler/importers/terms.h"
#include "patina/graph_builder.h"
#include "patina/patina.h"

namespace patina::importers {

struct ImportedProperty {
    std::string name, type;             // "_Tint", "color"
    std::optional<GraphValue> value{};  // "default"
    GraphMembers more{};                // further keys: "usage", "range", "sampler", "label", ...
    std::string comment{};
};
struct ImportedNode {
    std::string id;
    std::string node{};        // a library node or a file; or
    std::string expression{};  // an expression in its place: "mask * 2"
    GraphMembers inputs{};     // "in"
    GraphMembers more{};       // further keys: "stage", "precision", "note"
    std::string comment{};
};

class ImportedGraph {
public:
    explicit ImportedGraph(std::string graph_name) : name(std::move(graph_name)) {}

    // --- the file. What is empty is not written, and neither is a number that is not finite. Comments are plain text.
    std::string comment{};  // above the graph: where it came from
    std::string name;
    std::string kind = "material", workflow{};
    std::string lighting{};  // a model's name or file; empty: the workflow's own
    GraphMembers lighting_inputs{};
    std::vector<ImportedProperty> properties{};
    std::vector<ImportedProperty> inputs{};  // of a sub-graph
    std::vector<ImportedNode> nodes{};
    GraphMembers vertex{}, surface{}, outputs{};
    GraphMembers more{};  // further keys of the file: "help", "render", "meta", ...

    // Empty if there is no such graph: a name or comment is not UTF-8, or a property has a type that is none.
    std::string text() const;

    // --- names
    terms::Names ids{}, property_names{};
    // Adds a node that stands for parts of the source, and returns its id.
    std::string add(ImportedNode node, std::set<std::size_t> owners);
    // A link to the term, which becomes a node of its own unless it is a link already. `id` says what it is called; it
    // is asked if the node is new. A swizzle stays with the reader.
    terms::Term named(const terms::Term& term, const std::function<std::string()>& id, std::set<std::size_t> owners,
                      GraphMembers more = {});
    std::map<std::string, std::set<std::size_t>, std::less<>> owners{};  // of a node: the parts of the source
    std::map<std::string, terms::Type, std::less<>> types{};  // of expressions by id, of inputs: "surface.emission"

    // --- what became of the parts of the source
    struct Outcome {
        Remark::Kind kind = Remark::Kind::Taken;
        std::string where{};  // in the graph, in words
        std::string text{};   // how it differs, or why it is refused
        std::string label{};  // before the name of the part
    };
    std::map<std::size_t, Outcome> outcomes{};
    void taken(std::size_t part, std::string where);                // the first counts
    void written(const terms::Term& term, std::string_view where);  // the same of all parts that it holds
    void approximate(std::size_t part, const std::string& difference);

    // Has the compiler read the graph until it refuses nothing more: what it refuses becomes a constant, which is noted
    // at the node and at the parts of the source. So whatever is imported passes `patina check`. `files`: that the
    // graph reads. `otherwise`: reports what belongs to no part. Returns nothing, or what is wrong where no constant
    // can be:
    // "'uv.tiling' would not be valid: ...".
    std::string refuse_invalid(std::span<const TextFile> files,
                               const std::function<void(const Diagnostic&, const std::string& reason)>& otherwise);

private:
    GraphBuilder builder(const std::string& path) const;
    bool puts_constant(const Diagnostic& wrong);

    std::map<std::string, terms::Term, std::less<>> named_{};  // by the text of the expression
};

// The library, of which graphs name nodes.
const Compiler& library();

std::string in_canonical_form(std::string text);  // of a graph or a scene
// Lights of a scene: those of `patina render`, whose studio lights what has none.
GraphValue default_lights();
// A scene: `members` are all keys but "patina" and "kind".
std::string write_scene(const GraphMembers& members);

}  // namespace patina::importers
