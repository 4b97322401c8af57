// What nodes/stage and nodes/passes declare, and what a user's own .pass.hlsl adds to it: semantics with their recipes,
// the engine seam, switches, slots and passes. Knows none of them by name.
//
//   Stages stages;
//   collect_stages(ast, declarations, sources, stages, diagnostics);
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/ir/ir.h"
#include "compiler/nodelang/library.h"
#include "patina/reflection.h"

namespace patina::graph {

// Where a semantic's value comes from.
enum class Source {
    Attribute,  // a vertex attribute
    Builtin,    // the rasteriser
    Extern,     // a uniform of the engine
    Vertex,     // a recipe, run per vertex and interpolated
    Pixel,      // a recipe, run where it is read
    Uniform,    // a recipe over uniforms
    Given,      // handed to a lighting graph
};

struct SemanticDecl {
    std::string_view name;
    Source source = Source::Pixel;
    const nodelang::VariableDecl* variable = nullptr;  // Attribute, Builtin, Extern, Given
    const nodelang::FunctionDecl* function = nullptr;  // recipes
    bool is_vertex_output = false;                     // a material may write it in "vertex"
    bool is_of_pass = false;                           // declared in a pass file: no graph can read it
};

// [blend("fade", "srcAlpha", "one")]: surfaces of this kind take part, blended so.
struct BlendRow {
    std::string_view surface;  // empty: every kind
    Blend blend{};
};

struct PassDecl {
    std::string_view name;
    std::string path;  // the stem of its file: the rendering path that it belongs to
    Span span;
    const nodelang::FunctionDecl* vertex = nullptr;
    const nodelang::FunctionDecl* fragment = nullptr;
    Pass state;  // what of it no material changes
    std::vector<BlendRow> blends;
    // The pass says so itself; else the material does.
    bool has_cull = false, has_depth = false, has_depth_bias = false, has_stencil = false;
    bool draws_extra = false;                // it also draws the passes that materials add
    bool is_alone = false;                   // left out where the material adds passes
    bool is_optional = false;                // left out without a word where it cannot be had
    std::vector<std::string_view> needs;     // slots that must exist
    std::vector<std::string_view> holds;     // members of the lighting surface that it can tell; empty: all
    std::vector<std::string_view> excludes;  // switches that must be off
    std::vector<std::string_view> lighting;  // lighting models that it is for; empty: all
    std::string_view otherwise;              // what comes of a material's being without it, in words; may be empty
    std::vector<std::pair<std::string_view, std::string_view>> tags;  // for the tool whose files it is written into
    std::vector<std::string_view> guards;                             // by target: a condition, or empty
    // From another file than the one that is being read, which may put its own in their places.
    bool is_older_vertex = false, is_older_fragment = false;
};

// [gives("positionWS", "deferred-light")]: these passes' own recipe of a semantic, or their own body of an [extern]
// function. Without passes: of all passes of the same file, in both stages; then it may also be a value that an
// included file declares, in the place of an attribute or an [extern] value, and replace any function of the library.
struct GivenDecl {
    std::string_view what;
    const nodelang::FunctionDecl* function = nullptr;
    const nodelang::VariableDecl* variable = nullptr;
    std::vector<std::string_view> passes{};
    bool is_of_file = false;
    std::string path{};  // the stem of its file

    bool is_for(const PassDecl& pass) const;
};

struct SwitchDecl {
    const nodelang::VariableDecl* variable = nullptr;
    std::string_view brings;  // a pass that comes first when it is on
};

struct Stages {
    std::vector<SemanticDecl> semantics;
    std::map<std::string_view, std::uint32_t> semantic_index;
    std::vector<PassDecl> passes;
    std::vector<GivenDecl> given;
    std::vector<SwitchDecl> switches;
    std::vector<const nodelang::VariableDecl*> externs, statics;
    std::vector<const nodelang::VariableDecl*> foreign;                  // values that included files declare
    std::map<std::string_view, const nodelang::FunctionDecl*> decoders;  // by usage of a texture or property
    // The library's, which a file repeats: its functions mean what is declared again.
    std::vector<const nodelang::VariableDecl*> repeated;
    std::vector<const nodelang::FunctionDecl*> slots, exports;

    const PassDecl* pass(std::string_view name) const;
    // Those of a path, in the order of its file.
    std::vector<const PassDecl*> passes_of(std::string_view path) const;
    std::vector<std::string_view> paths() const;
    // What draws the passes that materials add: a pass of the path or, if it has none, of another one. Null: none does.
    const PassDecl* pass_for_extra(std::string_view path) const;
    const SemanticDecl* semantic(std::string_view name) const;
};

// Adds what `ast` declares and checks it. Structs that passes return are looked up in `declarations`.
void collect_stages(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const SourceMap& sources,
                    Stages& stages, Diagnostics& diagnostics);

// --- whether all of it can be (check_stages.cpp)
void check_stages(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const SourceMap& sources,
                  const Stages& stages, Diagnostics& diagnostics);
// --- whether its passes agree with each other (check_passes.cpp)
void check_passes(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const Stages& stages,
                  Diagnostics& diagnostics);
// Whether it stands in a .pass.hlsl.
bool is_of_pass(const SourceMap& sources, Span span);

// --- the state of a pass (pass_state.cpp)
// Reads the attributes of a pass's fragment function, and the targets that it returns.
void read_pass_state(const nodelang::FunctionDecl& fragment, const nodelang::Declarations& declarations, PassDecl& pass,
                     Diagnostics& diagnostics);
// What a function of a pass says at places of the text that it becomes.
std::vector<ir::StageText> texts_of(std::span<const nodelang::Attribute> attributes, Diagnostics& diagnostics);
std::vector<std::string_view> attribute_words(const nodelang::Attribute& attribute, std::size_t first = 0);

}  // namespace patina::graph
