// The room `lower` turns a checked material into IR functions. The surface, the workflow's set-up, the outputs of the
// lighting graph, each vertex output and each interpolator have a function each; then come the functions of the passes.
// It checks types, because they are first known here (expressions are emitted by compiler/emit), and decides which
// passes can draw the material. It resolves no files or names of files, and prints nothing. Reads of the mesh and the
// camera stay `semantic` instructions until a pass is linked (compiler/link).
#pragma once

#include "compiler/lower/declare.h"
#include "compiler/lower/place.h"

namespace patina::lower {

// How a stage gets the value of a semantic (an index into Module::semantics).
struct SemanticRecipe {
    paths::SemanticSource source = paths::SemanticSource::Pixel;
    ir::FunctionId recipe{};                  // Vertex, Pixel, Uniform: a function whose body reads other semantics
    std::optional<std::uint32_t> location{};  // Attribute: of the vertex input; none: numbered later
    std::string_view hlsl{};                  // Attribute: its HLSL semantic
    ir::FunctionId override{};                // the value of the material's "vertex" block that replaces the attribute
    const paths::SemanticDecl* declaration = nullptr;  // null: an interpolator of the graph
};

// What a pass has in place of the usual recipe of a semantic, or in place of a function (GivenDecl).
template <class What>
struct Given {
    What what{};
    ir::FunctionId by{};
    // A semantic that the mesh has or that is interpolated is computed in the vertex stage for both.
    bool in_vertex_stage = true, in_fragment_stage = true;
    Span span{};  // of the name of its function
};

struct LoweredPass {
    const paths::PassDecl* declaration = nullptr;
    std::string name{};  // the declaration's, or that of the extra pass
    ir::FunctionId vertex{}, fragment{};
    std::vector<Given<ir::SemanticId>> recipes{};
    std::vector<Given<ir::FunctionId>> replaced{};                      // functions of the engine
    std::vector<std::pair<ir::SemanticId, ir::GlobalId>> attributes{};  // those that an included file declares

    // Each finds what this pass uses in the given stage; null if that is the usual.
    const Given<ir::SemanticId>* recipe_of(ir::SemanticId semantic, ir::StageKind stage) const;
    const Given<ir::FunctionId>* replacement_of(ir::FunctionId function, ir::StageKind stage) const;
    std::optional<ir::GlobalId> attribute_of(ir::SemanticId semantic) const;
};
// How a pass blends surfaces of a kind; null if it does not draw them.
const paths::BlendRow* blend_of(const paths::PassDecl& pass, SurfaceKind surface);
// The name that users know a pass by: its tag, if the engine selects passes by tag ("ShadowCaster").
std::string_view known_as(const paths::PassDecl& pass);

// A function for an engine's own shaders.
struct LoweredFunction {
    ir::FunctionId id{};
    bool is_vertex = false;
};

// What every pass that draws from the camera does with values of a kind (WrapDecl), while a switch is on. Null ids:
// nothing.
struct Wraps {
    ir::FunctionId position{}, pixel{}, reads{};
    // The place of the pixel itself, at which a pass may read targets that hold only a part of the picture.
    std::optional<ir::SemanticId> own_pixel{};
};

struct Lowered {
    ir::Module module;
    std::vector<SemanticRecipe> semantics;
    std::string path;  // the path of the passes: the requested one, or its fallback
    std::vector<LoweredPass> passes;
    std::vector<LoweredFunction> functions;  // replaces passes, if the request is for them
    std::vector<std::pair<std::string, bool>> switches;
    std::map<std::uint32_t, std::string> reads;  // by global: the target of another pass that the texture reads
    std::set<std::uint32_t> picture_reads;       // those of them whose target has the size of the picture
    Wraps wraps;
    std::vector<PropertyGlobals> property_globals;  // one per Material::properties
    std::uint32_t instances = 0;                    // how many one draw can hold; 0: it draws one object (instances.h)
    std::set<std::uint32_t> instance_globals;       // globals that are arrays with an element for each instance
    std::vector<SetShifts> shifts;                  // by set: from HLSL registers to bindings
    std::uint32_t target_set = 0;                   // the set of the other passes' targets
    ClipDepth clip_depth = ClipDepth::NearToFar;    // the order of depth in the camera's view
    bool keeps_functions = false;  // passes that draw the surface print identical functions, to share their text
};

// Reports errors; the result may be used only if the session has none. `material`: the material itself with all passes
// of the path, or an extra pass (Material::pass) with only that one.
Lowered lower(resolve::Session& session, const resolve::Material& material, ir::BuildOptions options);
// True if the material's extra passes are drawn in addition to these.
bool draws_extra(const resolve::Session& session, const Lowered& lowered);

}  // namespace patina::lower
