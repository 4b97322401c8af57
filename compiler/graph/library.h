// The built-in library, loaded once and then only read: declarations of nodes/**, the semantics that nodes/stage
// states, the passes, and the workflow and lighting graphs. Knows none of them by name.
//
//   const Library library = load_library(nodelang::embedded_files());
//   library.declarations.function("Lerp");
#pragma once

#include <map>
#include <memory>

#include "compiler/base/diagnostics.h"
#include "compiler/graph/graph.h"
#include "compiler/nodelang/embedded.h"
#include "compiler/nodelang/library.h"

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
};

struct PassDecl {
    std::string_view name;
    const nodelang::FunctionDecl* vertex = nullptr;
    const nodelang::FunctionDecl* fragment = nullptr;
};

struct Library {
    SourceMap sources;
    nodelang::Ast ast;
    Diagnostics diagnostics;
    nodelang::Declarations declarations;
    std::vector<SemanticDecl> semantics;
    std::map<std::string_view, std::uint32_t> semantic_index;
    std::vector<PassDecl> passes;
    std::map<std::string, std::shared_ptr<Graph>, std::less<>> workflows;
    std::map<std::string, std::shared_ptr<Graph>, std::less<>> lighting_models;
};

std::unique_ptr<Library> load_library(std::span<const nodelang::EmbeddedFile> files);

}  // namespace patina::graph
