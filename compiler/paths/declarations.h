// The room `paths` reads the declarations of nodes/stage, nodes/passes, an engine's pass file and a user's own
// .pass.hlsl: semantics with their recipes, values of the engine, switches, slots and passes. It reads each attribute
// once, into the types below; no room behind this one looks at nodelang::Attribute. It knows no declaration by name,
// resolves nothing of a graph, and makes no IR.
//
//   PathDeclarations paths;
//   collect(ast, declarations, sources, paths, diagnostics);
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/ir/ir.h"
#include "compiler/nodelang/library.h"
#include "patina/reflection.h"

namespace patina::paths {

// Where a semantic's value comes from.
enum class SemanticSource {
    Attribute,  // a vertex attribute
    Builtin,    // the rasteriser
    Extern,     // a uniform of the engine
    Vertex,     // a recipe, run per vertex and interpolated
    Pixel,      // a recipe, run where it is read
    Uniform,    // a recipe over uniforms
    Given,      // passed to a lighting graph
};

struct SemanticDecl {
    std::string_view name;
    SemanticSource source = SemanticSource::Pixel;
    const nodelang::VariableDecl* variable = nullptr;  // Attribute, Builtin, Extern, Given
    const nodelang::FunctionDecl* function = nullptr;  // recipes
    ir::Builtin builtin = ir::Builtin::None;           // of Builtin
    bool is_vertex_output = false;                     // a material may replace it in "vertex"
    bool is_uv = false;                                // texture coordinates of the mesh
    bool is_of_pass = false;                           // declared in a pass file: graphs cannot read it
};

// [extern("Camera")] float4x4 m; [extern] Texture2D t; [reads("depth")] Texture2D d;
struct ExternDecl {
    const nodelang::VariableDecl* variable = nullptr;
    std::string_view block;              // the block of a number; empty: a texture
    std::string_view reads;              // for a texture: the target of a pass; empty: a texture of the engine
    std::vector<std::string_view> with;  // switches and paths; it exists where one of them is on. Empty: always
    bool is_per_object = false;          // it belongs to the drawn object

    bool is_target() const { return !reads.empty(); }
};

// [static("surface", "cutout")] bool b; it is true if the value of "surface" is one of the listed words.
struct StaticDecl {
    enum class About { Surface, Cull, Slot, Reads, Pass, Clip, UvOrigin };
    const nodelang::VariableDecl* variable = nullptr;
    About about = About::Surface;
    std::vector<std::string_view> words;

    // True if the value is known only while the passes are lowered.
    bool is_of_passes() const { return about == About::Slot || about == About::Reads || about == About::Pass; }
    bool is_of_engine() const { return about == About::Clip || about == About::UvOrigin; }
};

// [static("surface", "chosen")]: true if each material chooses its kind of surface.
inline constexpr std::string_view kChosenKind = "chosen";

// [foreign("_Time.y")] float seconds; an included file declares it.
struct ForeignDecl {
    const nodelang::VariableDecl* variable = nullptr;
    std::string_view spelling;
    std::string include;  // the file that declares it for materials; empty: it always exists
};

// [foreign("MACRO({0})")] float f(float x); a function of an included file.
struct ForeignFunctionDecl {
    const nodelang::FunctionDecl* function = nullptr;
    std::vector<ir::StageText> texts;  // lines for each stage that calls it
};

// A function that passes call and do not define.
struct SlotDecl {
    // The origin of a slot's body.
    enum class Making {
        Graph,    // the material, its workflow or its lighting graph; or the slot's own body
        Part,     // [part("final", "sum.direct")]: the part of another slot that is linear in a value
        Without,  // [without("indirect", "EnvironmentRadiance")]: another slot without the contribution of a function
        Pack,     // [pack("direct")] [holds("f0")]: stores values that those slots read, and that no target holds, in a
                  // struct of float4
        Unpack,   // [unpack("packSurface")]
    };
    const nodelang::FunctionDecl* function = nullptr;
    Making making = Making::Graph;
    std::string_view of;                     // Part, Without, Unpack: the other slot
    std::string_view source;                 // Part, Without: "sum.direct", or a function
    bool is_componentwise = false;           // Part: each component depends on the same component alone
    std::vector<std::string_view> readers;   // Pack: slots
    std::vector<std::string_view> holds;     // Pack: members that a target holds already
    std::optional<std::size_t> light_param;  // the parameter that is one light of many
    std::string_view otherwise;              // what a material loses without it, in words; may be empty

    std::string_view name() const { return function->name; }
    bool is_derived() const { return making != Making::Graph; }
    bool packs() const { return making == Making::Pack; }
};

// [export("direct")] float3 f(...); functions for an engine's own shaders are made of these.
struct ExportDecl {
    const nodelang::FunctionDecl* function = nullptr;
    std::string_view name;
};

// [decodes("normal", "follower", "at_once")]: values of that usage go through this function when they are read. Where
// the result is passed to `follower`, `at_once` does both.
struct DecoderDecl {
    const nodelang::FunctionDecl* function = nullptr;
    std::string_view follower, at_once;
    std::vector<ir::StageText> texts;
};

// [blend("fade", "srcAlpha", "one")]: the pass draws surfaces of this kind, with this blending.
struct BlendRow {
    std::optional<SurfaceKind> surface{};  // nothing: every kind
    Blend blend{};
};

struct PassDecl {
    std::string_view name;
    std::string path;  // the stem of its file, which is the name of its rendering path
    Span span;
    const nodelang::FunctionDecl* vertex = nullptr;
    const nodelang::FunctionDecl* fragment = nullptr;
    Pass state;  // the state that no material changes
    std::vector<BlendRow> blends;
    // True if the pass states it; else the material decides.
    bool has_cull = false, has_depth = false, has_depth_bias = false, has_stencil = false;
    bool draws_extra = false;                // it also draws the extra passes of materials
    bool draws_extra_alone = false;          // along the requested path it draws these and no material
    bool is_alone = false;                   // left out if the material has extra passes
    bool is_optional = false;                // left out without a warning if it cannot draw the material
    std::vector<std::string_view> needs;     // slots that must exist
    std::vector<std::string_view> holds;     // members of the lighting surface that it can provide; empty: all
    std::vector<std::string_view> excludes;  // switches that must be off
    // Values that a material cannot read here: each row names some, and switches that turn the row off.
    std::vector<std::vector<std::string_view>> lacks;
    std::vector<std::string_view> lighting;     // lighting models that it supports; empty: all
    std::string_view otherwise;                 // what a material loses without it, in words; may be empty
    std::vector<std::string_view> along;        // an engine's own pass: the requested paths that have it; empty: all
    std::vector<std::string_view> extra_along;  // further requested paths for which it draws the extra passes
    std::vector<std::pair<std::string_view, std::string_view>> tags;  // for an engine that selects passes by tag
    std::vector<std::string_view> guards;                             // by render target: a condition, or empty
    std::uint32_t optional_targets = 0;                               // the last so many; not written if nobody reads
    std::vector<ir::StageText> vertex_texts, fragment_texts;          // lines of the engine's file
    // An earlier file declared it, so the current file may replace it.
    bool is_older_vertex = false, is_older_fragment = false;
};

// [gives("positionWS", "deferred-light")]: a recipe of a semantic, or a body of an [extern] function, for these passes
// only, in both stages; with [fragment], in the fragment stage only. If no pass is named, it applies to all passes of
// the same file, except where another one names the pass. If no pass is named, it may replace any function of the
// library. Then it may also be a variable: a value that an included file declares, in place of an attribute or an
// [extern] value.
struct GivenDecl {
    std::string_view what;
    const nodelang::FunctionDecl* function = nullptr;
    const nodelang::VariableDecl* variable = nullptr;
    std::vector<std::string_view> passes{};
    bool is_of_file = false;
    bool is_of_fragment = false;  // the vertex stage keeps what it has
    std::string path{};           // the stem of its file

    bool is_for(const PassDecl& pass) const;
};

// [wraps("position")] [with("tiles")] float4 f(float4 position): while one of the switches is on, f changes every
// position in every pass that draws from the camera.
struct WrapDecl {
    enum class What {
        Position,  // of a vertex, in clip space
        Pixel,     // the builtin fragCoord
        Reads,     // the position at which a target of the picture is read; by default, that of the pixel
    };
    const nodelang::FunctionDecl* function = nullptr;
    What what = What::Position;
    std::vector<std::string_view> with;
};

struct SwitchDecl {
    const nodelang::VariableDecl* variable = nullptr;
    std::string_view brings;     // a pass that is drawn first if the switch is on
    std::string_view otherwise;  // what to do about a material that needs it, in words; may be empty
};

struct PathDeclarations {
    std::vector<SemanticDecl> semantics;
    std::map<std::string_view, std::uint32_t> semantic_index;
    std::vector<PassDecl> passes;
    std::vector<GivenDecl> given;
    std::vector<SwitchDecl> switches;
    std::vector<WrapDecl> wraps;
    std::vector<ExternDecl> externs;
    std::vector<const nodelang::FunctionDecl*> extern_functions;  // functions that an engine may define itself
    std::vector<StaticDecl> statics;
    std::vector<ForeignDecl> foreign;
    std::vector<ForeignFunctionDecl> foreign_functions;
    std::map<std::string_view, DecoderDecl> decoders;  // by usage of a texture or property
    // Library variables that a pass file declares again. The library's functions then read the file's declaration.
    std::vector<const nodelang::VariableDecl*> repeated;
    std::vector<SlotDecl> slots;
    std::vector<ExportDecl> exports;
    std::vector<std::string_view> hdr_members;  // [hdr] members of structs: light, which may be brighter than white

    const PassDecl* pass(std::string_view name) const;
    // The passes of a path that draw materials, in the order of its file.
    std::vector<const PassDecl*> passes_of(std::string_view path) const;
    std::vector<std::string_view> names() const;  // of the paths
    // True if a frame of the path can have the pass: as a pass of the path or of its fallback, or because a switch or a
    // material adds it.
    bool is_drawn_along(std::string_view path, const PassDecl& pass) const;
    // The pass that draws the extra passes of materials: a pass of the path or, if it has none, of another path. Null
    // if there is none.
    const PassDecl* pass_for_extra(std::string_view path) const;
    const SemanticDecl* semantic(std::string_view name) const;
    const SlotDecl* slot(std::string_view name) const;
    bool is_hdr(std::string_view member) const;
    const SwitchDecl* switch_of(const nodelang::VariableDecl* variable) const;
    const SwitchDecl* switch_named(std::string_view name) const;
    // Null if the variable is not [extern].
    const ExternDecl* extern_of(const nodelang::VariableDecl* variable) const;
};

// Adds the declarations of `ast` and checks them. Structs that passes return are looked up in `declarations`.
void collect(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const SourceMap& sources,
             PathDeclarations& paths, Diagnostics& diagnostics);

// Checks the members of the lighting surface that a file names (check_members.cpp). `inputs`: the lighting model's own
// members.
void check_members(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const PathDeclarations& paths,
                   std::span<const std::string_view> inputs, Diagnostics& diagnostics);
}  // namespace patina::paths
