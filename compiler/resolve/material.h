// Finds and checks a material with everything that it uses: its workflow, its lighting model, and the properties of its
// uniform block. These are its own, those of its lighting graph and sub-graphs, and files named at ports.
#pragma once

#include <set>

#include "compiler/resolve/check_graph.h"

namespace patina::resolve {

struct MaterialProperty {
    const format::Property* property = nullptr;
    std::string texture_path;  // a texture's default: a file that exists, or white, black, gray, bump
    bool is_file = false;      // `texture_path` is one
    bool is_own = false;       // the material itself states the default
    bool is_at_port = false;   // it is a file at a port
    double chosen = 0;         // for a keyword: bool 0 or 1; enum: index
    bool is_chosen = false;    // by the caller; else `chosen` is its default
};

struct Material {
    const CheckedGraph* graph = nullptr;
    const CheckedGraph* workflow = nullptr;
    const CheckedGraph* lighting = nullptr;
    std::string lighting_name;
    std::vector<format::PortValue> lighting_inputs;      // values for the lighting graph's properties
    std::map<const format::Property*, double> variants;  // the lighting graph's properties that are known already
    std::set<std::string, std::less<>> unused_variants;  // of a preview: those of the lighting that it leaves out
    std::vector<MaterialProperty> properties;            // in binding order
    std::map<std::string, std::size_t, std::less<>> property_index;
    bool is_preview = false;
    // Of a preview of a value that lighting computes or reads: it takes the place of the lighting graph's outputs. Its
    // value is null in other previews.
    format::PortValue shown_value{};
    bool shows_all_light = false;             // a preview of a value that the lighting graph does not compute itself
    Shown shown_in_lighting{};                // the port of the lighting graph that this reads; else null
    const format::ExtraPass* pass = nullptr;  // the extra pass that this is; null: the material itself

    // The inputs that the surface may set: the workflow's and those that the lighting model declares.
    std::vector<const format::Input*> surface_inputs() const;
    // The value that the workflow gives an input of the lighting model, so that the surface may not; else null.
    const format::PortValue* given_by_workflow(const format::Input& input) const;
};

// `preview`: "mask", "rust.amount" or "layers/mask" (in a sub-graph), or nothing. Null after errors that leave nothing
// to continue with.
std::unique_ptr<Material> resolve_material(Session& session, std::shared_ptr<format::Graph> graph,
                                           const std::optional<std::string>& preview);

// The extra passes of the material, in its order, as materials of their own. Afterwards all have the same properties:
// the material's, then those that the passes add. Reports errors.
std::vector<std::unique_ptr<Material>> resolve_passes(Session& session, Material& material);

// A material as its file has it: itself and its extra passes. `material` is null after errors that leave nothing to
// continue with.
struct MaterialFile {
    std::unique_ptr<Material> material;
    std::vector<std::unique_ptr<Material>> passes;
};
// Reads a material from the text that starts at `base` in the session's sources (read_material.cpp).
MaterialFile read_material(Session& session, std::uint32_t base, const std::string& path);

// The workflow that the material names. Null after an error.
const CheckedGraph* find_workflow(Session& session, const format::Graph& graph);
// A workflow without lighting keeps its own, which is none; the material's has no effect (check_render.cpp).
const format::LightingUse& lighting_of(const format::Graph& graph, const format::Graph& workflow);
// The lighting graph and its name. Null after an error.
const CheckedGraph* find_lighting(Session& session, const format::Graph& graph, const format::LightingUse& use,
                                  std::string& name, const Shown& shown = {});
// Turns the graph into one that shows a value (preview.cpp). `shown`: where the graph itself has it. False after an
// error.
bool make_preview(Session& session, format::Graph& graph, std::string_view preview, Material& material, Shown& shown);

// --- lighting that the caller chooses (choose_lighting.cpp)
// Gives the material, and the extra passes that share its lighting, the model that the options name.
void choose_lighting(Session& session, format::Graph& graph);
// The value that the options give to a variant of the lighting model, or nothing. Reports one that it cannot have.
std::optional<double> chosen_value(Session& session, const Material& material, const format::Property& variant);

// --- "materialOverride" (surface_choices.cpp)
// The properties that choose the kind of a surface: a bool, an enum of the kinds that blend, and a bool.
inline constexpr std::string_view kTransparentChoice = "_Surface", kBlendChoice = "_Blend", kClipChoice = "_AlphaClip";
struct BlendingKind {
    SurfaceKind kind;
    std::string_view word;
};
inline constexpr BlendingKind kBlendingKinds[] = {{SurfaceKind::Fade, "Alpha"},
                                                  {SurfaceKind::Transparent, "Premultiply"},
                                                  {SurfaceKind::Additive, "Additive"},
                                                  {SurfaceKind::Multiply, "Multiply"}};
// Adds them to the graph, if the engine has keywords. Otherwise nothing of the graph can be changed.
void add_surface_choices(Session& session, format::Graph& graph);

// --- properties of all graphs: one name is one property (join_properties.cpp)
struct JoinOptions {
    const std::string& from;  // the graph that names its file
    bool is_own = false;      // the material declares it
    bool is_at_port = false;  // it is a file at a port, which has no other name
    Span said_at{};           // where the material gives this default to a lighting graph's property
};
// Adds the property to the material's. If the material has one of that name, reports how the two differ.
void join_property(Session& session, Material& material, const format::Property& property, const JoinOptions& options);
// Joins the properties of a graph and of its sub-graphs, in an order that does not depend on their nodes.
void join_graph(Session& session, Material& material, const CheckedGraph& graph);
// True if the default is a file and not a word.
bool is_texture_file(const format::Property& property);

// --- keywords: properties that are known before a shader runs (keywords.cpp)
// Gives the properties from index `first` on the values that the caller chose ("_DETAIL", "true"). Reports values that
// they cannot have.
void choose_keywords(Session& session, Material& material, std::size_t first);
// Reports properties and values under "variants" that do not exist.
void check_listed(Session& session, const Material& material);
// The keyword of the material, if the expression reads only that; else null.
const MaterialProperty* keyword_named(const Material& material, const nodelang::Expr& expr);
// The possible values of such a property: "a bool", "one of Dry and Wet".
std::string values_text(const format::Property& property);
// The value of such a property that the caller's word means; no word: true. Reports one that it cannot have.
std::optional<double> keyword_value(Session& session, const format::Property& property, const std::string& word);
// The words of its values: "false" and "true", or an enum's.
std::vector<std::string_view> keyword_words(const format::Property& property);
// Names of all keywords.
std::vector<std::string_view> keyword_names(const Material& material);

// Warns of nodes that neither the material nor its passes read, and of inputs that have no effect for its kind of
// surface (check_render.cpp). Called only if there are no errors, because an error may be the reason.
void warn_unused(Session& session, const Material& material);
void warn_unheeded(Session& session, const Material& material);

// The name of the texture property that represents a file at a port.
std::string file_texture_name(std::string_view path);

}  // namespace patina::resolve
