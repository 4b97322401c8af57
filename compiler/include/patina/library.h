// What the library of a Compiler has: nodes, semantics, workflows, lighting models, rendering paths and engines. And
// how a program adds to it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "patina/reflection.h"

namespace patina {

// An engine of the library.
struct EngineInfo {
    std::string name;   // as a target names it: "vulkan"
    std::string title;  // "Vulkan"
    std::string doc;    // a sentence on the files that it gets
    std::string file;   // how stages become files: "stages" for one each, else the format of the one file
    std::vector<std::string> languages;
    bool is_default = false;
    bool has_own_passes = false;  // it draws its own rendering paths instead of the library's
    // Of its own passes: those that CompileOptions::Passes::path can name; the first is the default.
    std::vector<std::string> paths;
    bool is_one_file = false;  // one file holds all passes of a material
    std::string folder;        // the folder that defines it: "nodes/engines/vulkan"
};

struct EnumeratorInfo {
    std::string name, doc;
};
struct PortInfo {
    std::string name;
    std::string type;  // "float", "floatN", "Texture2D", or an enum's name
    bool is_output = false;
    std::string default_value;  // as written: "0.5", "@uv0"; empty: must be linked (inputs)
    std::optional<std::array<double, 2>> range;
    std::string unit;
    std::string doc;
    std::vector<EnumeratorInfo> enumerators;
};
struct NodeInfo {
    std::string name;               // as "node" names it
    std::string category;           // "Lighting/Distribution"
    std::vector<std::string> also;  // its names in other languages and programs: "Mix"
    std::string doc;                // paragraphs, plain text
    std::string formula;
    std::string source;              // the paper
    std::vector<PortInfo> ports;     // inputs in order, then outputs, the primary one first
    std::string file;                // where it is defined
    std::vector<std::string> tests;  // "Lerp(0, 10, 0.25) == 2.5"
};
struct SemanticInfo {
    std::string name, type, doc, rate;
};
// An input of a workflow or a lighting model: an input of the surface, or a property.
struct ModelInputInfo {
    std::string name, type;
    std::string default_value;  // as written: "[0.5, 0.5, 0.5]", "\"@geometryNormalWS\""; empty: none
    std::string doc;
    std::optional<std::array<double, 2>> range{};
    std::vector<std::string> values{};  // of an enum
    std::string gives{};                // this input is an alternative to that one: "normalWS"
    bool is_variant = false;            // a property that is known when the graph is compiled
};
struct ModelNodeInfo {
    std::string id;
    std::string node;  // its name in the library; empty: an expression
    std::string expr;
    std::vector<std::pair<std::string, std::string>> inputs;  // port, and the value as written
    std::string doc;                                          // the comment above it
};
// A workflow or a lighting model. Its documentation is the comment above its graph, with the keywords of a node's.
struct ModelInfo {
    std::string name;   // as "workflow" and "lighting" name it
    std::string title;  // "Blinn-Phong"
    std::string doc;    // paragraphs, plain text
    std::string formula, source;
    std::string use;  // when to use it
    std::string file;
    std::vector<ModelInputInfo> inputs;      // of the surface; a lighting model's own
    std::vector<ModelInputInfo> properties;  // of a lighting model
    std::vector<ModelNodeInfo> nodes;
    std::vector<std::pair<std::string, std::string>> outputs;  // "direct" and so on, and the value as written
};

// A pass of a rendering path, as its file states it.
struct PassInfo {
    Pass state{};  // the state that no material changes
    struct SurfaceBlend {
        std::optional<SurfaceKind> surface{};  // the kind that is drawn; nothing: every kind
        Blend blend{};
    };
    std::vector<SurfaceBlend> blends{};  // of pass.targets; empty: every surface is drawn, and replaces the pixel
    bool is_optional = false;            // left out for a material that it cannot draw
};
struct PathInfo {
    std::string name;  // as CompileOptions::Passes::path names it
    std::string doc;   // the comment that opens its file: paragraphs, plain text
    std::string source;
    std::string file;
    std::vector<PassInfo> passes;
};

// --- a program's own part of the library

struct LibraryFile {
    // Names the file in diagnostics. Its ending says what it holds:
    //   .node.hlsl       nodes, functions that nodes call, and semantics
    //   .pass.hlsl       a rendering path, named by the file
    //   .lighting.json   a lighting model, named by the file
    //   .workflow.json   a workflow, named by the file
    std::string name;
    std::string text;
};

// Nodes, semantics, workflows, lighting models and rendering paths of a program's own, beside those of the library.
// Everything finds them by name, as it finds the library's: {"node": "Dots"}, "lighting": "my-toon".
//
//   const patina::Compiler compiler(patina::LibraryOverlay{.files = {{"mine/dots.node.hlsl", text}}});
//   for (const patina::Diagnostic& d : compiler.library_diagnostics()) ...   // a name twice, text that does not parse
struct LibraryOverlay {
    std::vector<LibraryFile> files;
    // An engine of the program's own will be a member here. Until then there are the library's.
};

}  // namespace patina
