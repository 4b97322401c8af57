// The room `include/patina` is what embedders see. Its headers include no other room.
//
// The compiler library: a material graph in, readable shaders and their reflection out. No GPU and no shader compiler
// is needed here. Checking the shaders with glslang and rendering them are libraries of their own, which are not
// installed.
//
//   patina::Compiler compiler;
//   patina::Result result = compiler.compile_file("rust.graph.json");
//   for (const patina::Diagnostic& d : result.diagnostics) std::puts(patina::to_text(d).c_str());
//   for (const patina::Shader& s : result.shaders) save(s.file_name, s.text);
//
// A Compiler loads its node library once and is immutable after that: any number of threads may compile with one.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "patina/diagnostic.h"
#include "patina/export.h"
#include "patina/options.h"
#include "patina/reflection.h"
#include "patina/scene.h"
#include "patina/version.h"

namespace patina {

// The place in the sources that a line of emitted text comes from.
struct LineOrigin {
    int line = 0;  // of the shader, from 1
    std::string node;
    std::string file;
    int source_line = 0, source_column = 0, source_end_column = 0;
    std::string source_text;  // the source line; empty if it is very long
};

struct Shader {
    std::string pass;  // "forward"; empty for a file that holds all passes
    Stage stage = Stage::Vertex;
    Target target = Target::Glsl;
    std::string file_name;                        // "rust.forward.frag.glsl"
    std::string text;                             // the entry point is `main`; functions have none
    std::vector<LineOrigin> line_map;             // ascending by line
    std::vector<Reflection::Shifts> hlsl_shifts;  // the distances from HLSL registers to bindings, for glslang
    // The name by which the engine lists the file, which must be unique there; empty if it lists none.
    std::string listed_as{};
    bool has_main = true;  // false: functions, or a file that holds all passes
    // The hash of what the stage computes, whatever the graph's names are (CompileOptions::hashes). Stages of one graph
    // with the same hash can replace each other.
    std::string hash{};
};

struct Dump {
    std::string stage;  // "ir", "forward.fragment.tidy"
    std::string text;
};

struct Program;  // the unoptimised stages, for patina/interpret.h

struct Result {
    bool ok = false;  // there are no errors; `shaders` and `reflection` are complete
    std::vector<Diagnostic> diagnostics;
    std::vector<Shader> shaders;
    Reflection reflection;
    std::vector<std::string> dependencies;  // files that were read, the graph first
    std::vector<Dump> dumps;
    std::shared_ptr<const Program> program;  // null unless keep_programs
};

struct SceneResult {
    bool ok = false;
    SceneFile scene;  // what could be read
    std::vector<Diagnostic> diagnostics;
    std::vector<std::string> dependencies;  // files that were read: the scene
};

// --- what the library has

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

// A `test:` line of a node's comment: `call` should equal `expected` within the tolerances.
struct NodeTest {
    std::string node;
    std::string text;  // the line
    std::string file;
    int line = 0;
    double relative = 0, absolute = 0;
    struct Argument {
        std::string name, type;      // "float3", or the enum's name
        std::vector<double> values;  // its components; enum: index
        std::string enumerator;      // enum arguments only
    };
    std::vector<Argument> arguments;  // given ones only
    std::string output;               // port
    std::vector<double> expected;
    std::vector<double> actual;  // the CPU interpreter, in double
};

// The result of a check of a user's .node.hlsl file: its errors, and its test lines.
struct NodeFileResult {
    bool ok = false;  // the file is valid; tests may still have failed
    std::vector<Diagnostic> diagnostics;
    NodeInfo node;
    std::vector<NodeTest> tests;
};
// True if `actual` is within the test's tolerances of `expected`, NaN matching NaN.
PATINA_API bool passed(const NodeTest& test);

struct EvalOutput {
    std::string name, type;
    std::vector<double> values;
};
struct EvalResult {
    bool ok = false;
    std::vector<Diagnostic> diagnostics;
    std::vector<EvalOutput> outputs;  // the primary one first
};

// A number or vector (one to four components) that expressions may read by its name.
struct NamedValue {
    std::string name;
    std::vector<double> values;
};

class GraphBuilder;  // patina/graph_builder.h
struct VariantPlan;  // patina/variants.h
struct VariantProgram;
struct VariantSet;
enum class VariantsWanted;

class PATINA_API Compiler {
public:
    Compiler();
    // If the overlay has errors, library_diagnostics() has them, and so has each result, which is not ok.
    explicit Compiler(const LibraryOverlay& overlay);
    ~Compiler();
    Compiler(Compiler&&) noexcept;
    Compiler& operator=(Compiler&&) noexcept;

    Result compile_file(const std::string& path, const CompileOptions& options = {}) const;
    // `path` names the text in messages and output files; relative files are searched in its folder.
    Result compile_text(const std::string& path, std::string text, const CompileOptions& options = {}) const;
    Result compile(const GraphBuilder& graph, const CompileOptions& options = {}) const;

    // Counts the combinations of a material's variants before anything is compiled; more than `limit` are refused.
    // `progress` is called with the axes, and then with each new count for Reachable, which takes time.
    VariantPlan plan_variants(const std::string& path, VariantsWanted wanted, const CompileOptions& options,
                              std::size_t limit, const std::function<void(const VariantPlan&)>& progress = {}) const;
    // `progress` is called with the index of the next combination. `finished` is called with each different program as
    // soon as it is compiled: VariantSet::programs then keeps only its hash, so that few are in memory at a time. What
    // either throws ends the work with the error `cancelled`.
    VariantSet compile_variants(const std::string& path, const VariantPlan& plan, CompileOptions options,
                                const std::function<void(std::size_t)>& progress = {},
                                const std::function<void(VariantProgram)>& finished = {}) const;

    // A scene; its graphs are found, not compiled. Of the options only `include_dirs`, `files` and `limits` count.
    SceneResult read_scene(const std::string& path, const CompileOptions& options = {}) const;

    // The hash of the library, the overlay and the compiler itself: 32 hexadecimal digits. Compilers with the same hash
    // give the same result for the same request.
    std::string library_hash() const;
    // The hash of all that a result depends on: the library, the graph, the files that it reads, the textures that it
    // finds, and the options without Limits. Two requests with the same key have the same result, if that is ok. It
    // reads the graph, and compiles nothing.
    std::string cache_key(const std::string& path, const CompileOptions& options = {}) const;
    std::string cache_key(const std::string& path, std::string text, const CompileOptions& options) const;

    // Errors of the library and the overlay, which are read completely for this.
    std::vector<Diagnostic> library_diagnostics() const;
    const std::vector<NodeInfo>& nodes() const;  // by category, then name
    const NodeInfo* node(std::string_view name) const;
    // For a name that is no node's: "did you mean 'Lerp'?", "'Mix' is the node 'Lerp' here", or nothing.
    std::string node_advice(std::string_view name) const;
    const std::vector<SemanticInfo>& semantics() const;
    const std::vector<ModelInfo>& workflows() const;
    const std::vector<ModelInfo>& lighting_models() const;
    const std::vector<PathInfo>& paths() const;      // by name
    const std::vector<EngineInfo>& engines() const;  // the default one first, then by name
    // The targets that a word stands for: a language of the default engine ("glsl"), or an engine with all its
    // languages ("unity"). Empty if the word is unknown.
    std::vector<Target> targets(std::string_view word) const;
    std::vector<NodeTest> tests(std::string_view node) const;

    // Reads a node file, describes its node and runs its test lines on the CPU.
    NodeFileResult check_node_file(const std::string& path, const CompileOptions& options = {}) const;

    // Runs one node, of the library or of a .node.hlsl file, on the CPU with arguments in the graph format's value
    // grammar without links ("0.5", "0,0,1", "Reoriented", "#ff8800"), or expressions over `names`. `single` computes
    // in float rather than double.
    EvalResult evaluate(std::string_view node, std::span<const std::pair<std::string, std::string>> arguments,
                        bool single = false, std::span<const NamedValue> names = {}) const;
    // The value of an expression of the node language over `names`: "sqrt(a2) * PI".
    EvalResult evaluate_expression(std::string_view expression, std::span<const NamedValue> names,
                                   bool single = false) const;

    // JSON Schema (draft 2020-12) of the graph format, with the library's nodes, ports and words.
    std::string schema() const;
    // Canonical text of a graph: key order, spacing, comments kept. Not ok if it cannot be read.
    struct Formatted {
        bool ok = false;
        std::string text;
        std::vector<Diagnostic> diagnostics;
    };
    Formatted format(const std::string& path, std::string text) const;

private:
    friend struct CompilerAccess;
    struct Impl;
    explicit Compiler(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

PATINA_API std::string_view version();  // "0.1.0"

}  // namespace patina
