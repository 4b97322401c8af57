// Checked material -> IR functions: one each for the surface, the workflow's set-up, the three outputs of the lighting
// graph, each vertex output and each interpolator, and the bodies of the passes. Types are checked here, as they become
// known. What the functions read of mesh and camera stays `semantic` instructions until a pass is linked (assemble/).
#pragma once

#include "compiler/lower/declare.h"
#include "compiler/lower/place.h"

namespace patina::graph {

// How a semantic (an index into Module::semantics) is had.
struct SemanticRecipe {
    Source source = Source::Pixel;
    ir::FunctionId recipe{};                    // Vertex, Pixel, Uniform: a function whose body reads other semantics
    std::optional<std::uint32_t> location{};    // Attribute: of the vertex input; none: it is numbered later
    std::string_view hlsl{};                    // Attribute: its HLSL semantic
    ir::FunctionId override{};                  // what the material's "vertex" block writes instead of the attribute
    const SemanticDecl* declaration = nullptr;  // null: an interpolator of the graph
};

struct LoweredPass {
    const PassDecl* declaration = nullptr;
    std::string name{};  // the declaration's or, of a pass that the material adds, its own
    ir::FunctionId vertex{}, fragment{};
    std::vector<std::pair<ir::SemanticId, ir::FunctionId>> recipes{};   // its own, in the fragment stage
    std::vector<std::pair<ir::FunctionId, ir::FunctionId>> replaced{};  // functions of the seam, and what it puts there
    std::vector<std::pair<ir::SemanticId, ir::GlobalId>> attributes{};  // that an included file declares
    std::vector<ir::FunctionId> in_both_stages{};                       // of the recipes and replacements
    std::vector<std::pair<ir::SemanticId, ir::FunctionId>> at_vertices{};  // recipes of what is interpolated

    // Those of the stage.
    std::optional<ir::FunctionId> recipe_of(ir::SemanticId semantic, ir::StageKind stage) const;
    std::optional<ir::FunctionId> replacement_of(ir::FunctionId function, ir::StageKind stage) const;
    std::optional<ir::GlobalId> attribute_of(ir::SemanticId semantic) const;
};
// How a pass blends surfaces of a kind; null: it does not draw them.
const BlendRow* blend_of(const PassDecl& pass, SurfaceKind surface);
// Where an engine picks passes by their tags, its users know a pass by its tag: "ShadowCaster".
std::string_view known_as(const PassDecl& pass);

// A function for an engine's own shaders.
struct LoweredFunction {
    ir::FunctionId id{};
    bool is_vertex = false;
};

struct Lowered {
    ir::Module module;
    std::vector<SemanticRecipe> semantics;
    std::string path;  // that the passes belong to: the wanted one, or its fallback
    std::vector<LoweredPass> passes;
    std::vector<LoweredFunction> functions;  // instead of passes, where CompileOptions::functions asks for them
    std::vector<std::pair<std::string, bool>> switches;
    std::map<std::uint32_t, std::string> reads;     // by global: the target of another pass that it shows
    std::vector<PropertyGlobals> property_globals;  // one per Material::properties
    std::uint32_t instances = 0;                    // that one draw can hold; 0: it draws one object (instances.h)
    std::set<std::uint32_t> instance_globals;       // which are arrays of as many
    std::vector<SetShifts> shifts;                  // by set: HLSL registers to bindings
    std::uint32_t target_set = 0;                   // of what other passes have drawn
    ClipDepth clip_depth = ClipDepth::NearToFar;    // of what the camera sees
    bool keeps_functions = false;  // passes that show the surface leave functions as they are, to share their text
};

// Reports what is wrong; the result may be used only if the session has no errors. `material`: itself with all passes
// of the path, or a pass that it adds (Material::pass) with that one.
Lowered lower(Session& session, const Material& material, ir::BuildOptions options);
// Whether the passes that the material adds are drawn beside these.
bool draws_extra(const Session& session, const Lowered& lowered);

}  // namespace patina::graph
