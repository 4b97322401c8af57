// A material and everything that it stands on, found and checked: its workflow, its lighting, and all the properties
// that end up in its block (its own, its lighting graph's, its sub-graphs', and files named at ports).
#pragma once

#include "compiler/resolve/check_graph.h"

namespace patina::graph {

struct MaterialProperty {
    const Property* property = nullptr;
    std::string texture_path;  // a texture's default: a file, found on disk; or white, black, gray, bump
    bool is_file = false;      // `texture_path` is one
    bool is_own = false;       // the material itself says what its default is
    bool is_at_port = false;   // it is a file at a port
    double chosen = 0;         // of a keyword: bool 0 or 1; enum: index
    bool is_chosen = false;    // by the caller; else `chosen` is its default
};

struct Material {
    const CheckedGraph* graph = nullptr;
    const CheckedGraph* workflow = nullptr;
    const CheckedGraph* lighting = nullptr;
    std::string lighting_name;
    std::vector<PortValue> lighting_inputs;      // values for the lighting graph's properties
    std::map<const Property*, double> variants;  // the lighting graph's properties that are known by now
    std::vector<MaterialProperty> properties;    // in binding order
    std::map<std::string, std::size_t, std::less<>> property_index;
    bool is_preview = false;
    const ExtraPass* pass = nullptr;  // that it is; null: it is the material itself

    // What the surface may set: the workflow's inputs and those that the lighting model declares.
    std::vector<const Input*> surface_inputs() const;
};

// `preview`: "mask", "rust.amount" or "layers/mask" (in a sub-graph), or empty. Null after errors that leave nothing to
// go on with.
std::unique_ptr<Material> resolve_material(Session& session, std::shared_ptr<Graph> graph, std::string_view preview);

// The passes that the material adds, in its order, as materials of their own. Afterwards all have the same properties:
// the material's, then what the passes bring. Reports what is wrong.
std::vector<std::unique_ptr<Material>> resolve_passes(Session& session, Material& material);

// A material as its file has it: itself, and the passes that it adds. `material` is null after errors that leave
// nothing to go on with.
struct MaterialFile {
    std::unique_ptr<Material> material;
    std::vector<std::unique_ptr<Material>> passes;
};
// Of text that is among the session's sources from `base` on (read_material.cpp).
MaterialFile read_material(Session& session, std::uint32_t base, const std::string& path);

// --- properties of all graphs: one name is one property (join_properties.cpp)
struct JoinOptions {
    const std::string& from;  // the graph that names its file
    bool is_own = false;      // the material declares it
    bool is_at_port = false;  // it is a file at a port, which has no other name
    Span said_at{};           // the material gives a lighting graph's property this default
};
// Makes it the material's, or reports how it differs from the one of that name that the material has.
void join_property(Session& session, Material& material, const Property& property, const JoinOptions& options);
// Those of a graph and of its sub-graphs, in an order that has nothing to do with its nodes.
void join_graph(Session& session, Material& material, const CheckedGraph& graph);
// Its default is a file, and no word.
bool is_texture_file(const Property& property);

// --- keywords: properties that are known before a shader runs (keywords.cpp)
// Gives those from the property `first` on the values that the caller wants ("_DETAIL", "true"), and reports those that
// they cannot have.
void choose_keywords(Session& session, Material& material, std::size_t first);
// Reports what the graph lists under "variants" and does not have.
void check_listed(Session& session, const Material& material);
// The keyword of the material that an expression reads and nothing else, or null.
const MaterialProperty* keyword_named(const Material& material, const nodelang::Expr& expr);
// What such a property may be: "a bool", "one of Dry and Wet".
std::string told_values(const Property& property);
// Its values in words: "false" and "true", or an enum's.
std::vector<std::string_view> keyword_words(const Property& property);
// Names of all keywords.
std::vector<std::string_view> keyword_names(const Material& material);

// Warns of nodes that neither the material nor a pass of it reads, and of what its kind of surface does not heed
// (check_render.cpp); once there are no errors, which may be the reason.
void warn_unused(Session& session, const Material& material);
void warn_unheeded(Session& session, const Material& material);

// The name of the texture property that stands for a file at a port.
std::string file_texture_name(std::string_view path);

}  // namespace patina::graph
