// The room `include/patina` has the headers for programs that embed Patina. They include no other room.
//
// The compiler library: a material graph in, readable shaders and their reflection out. It needs no GPU and no shader
// compiler. Two other libraries, which are not installed, check the shaders with glslang and render them.
//
//   patina::Compiler compiler;
//   patina::Result result = compiler.compile_file("rust.graph.json");
//   for (const patina::Diagnostic& d : result.diagnostics) std::puts(patina::to_text(d).c_str());
//   for (const patina::Shader& s : result.shaders) save(s.file_name, s.text);
//
// A Compiler loads its node library once and never changes after that. Any number of threads may compile with one
// Compiler.
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

// The compiler library.
namespace patina {

// The location in the sources from which a line of emitted text comes.
struct LineOrigin {
    int line = 0;                            // of the shader, from 1
    std::string node;                        // id path of the node: "rust", "layers/mask"; empty: no node
    std::string file;                        // of the graph, or of the library
    int source_line = 0, source_column = 0;  // from 1; columns in bytes; 0: no location
    int source_end_column = 0;               // behind the last byte; 0: on another line
    std::string source_text;                 // the source line; empty if it is very long
};

// A text for a shader compiler or an engine: a stage of a pass, a file with all passes, or functions.
struct Shader {
    std::string pass;  // "forward"; empty for a file with all passes
    // Of the pass, or where the functions can be called. It has no meaning for a file with all passes.
    Stage stage = Stage::Vertex;
    Target target = Target::Glsl;                 // for which the text was written
    std::string file_name;                        // "rust.forward.frag.glsl"; begins as output_name.h says
    std::string text;                             // the entry point is `main`; functions have none
    std::vector<LineOrigin> line_map;             // ascending by line
    std::vector<int> light_loops{};               // the lines at which a loop over lights begins, from 1
    std::vector<Reflection::Shifts> hlsl_shifts;  // added to HLSL registers to get bindings, for glslang
    // The name in the engine's list of shaders, which must be unique there; empty if the engine has no such list.
    std::string listed_as{};
    bool has_main = true;  // false: functions, or a file with all passes
    // The hash of the stage's computations, which does not depend on the graph's names (CompileOptions::hashes). Stages
    // of one graph with the same hash can replace each other.
    std::string hash{};
};

// The result of a step of a compilation as text for people, whose form may change.
struct Dump {
    std::string stage;  // "ir", "forward.fragment.tidy"
    std::string text;   // of the graph or the IR after the step
};

struct Program;  // the unoptimised stages, for patina/interpret.h

// The most that a stage of any pass may cost, from the graph's "budget". Compiling does not measure costs. `patina
// check` does, with glslang, which the installed libraries do not link.
struct Budget {
    // One figure's limit.
    struct Limit {
        std::uint32_t most = 0;  // the highest figure that is allowed
        FileLocation place{};    // of the number in the graph; no file: the limit is not from a graph
    };
    std::optional<Limit> instructions, textures;  // SPIR-V instructions; texture reads
    // True if there is a limit to compare with.
    bool has_limits() const { return instructions || textures; }
};

// What a compilation makes.
struct Result {
    bool ok = false;                      // there are no errors; `shaders` and `reflection` are complete
    std::vector<Diagnostic> diagnostics;  // errors and warnings, file by file in the order of the text
    std::vector<Shader> shaders;  // engine by engine, then pass by pass, then target by target; none after an error
    Reflection reflection;        // for the first engine that draws the library's paths, else for the first one
    // Files that were read, the graph first; after an error also files that were searched for and do not exist.
    std::vector<std::string> dependencies;
    // Files that were searched for and do not exist, sorted. For example, a file is searched in the folder of the graph
    // before include_dirs. If one of these files appears, the result may change. A program that watches files must
    // watch these and `dependencies`.
    std::vector<std::string> missing;
    std::vector<std::string> nodes;          // ids of the graph's own nodes, in the order of the text
    Budget budget{};                         // of the graph; no limits if it has none
    std::vector<Dump> dumps;                 // of the steps in CompileOptions::dump
    std::shared_ptr<const Program> program;  // null unless keep_programs
};

// The result of Compiler::read_scene().
struct SceneResult {
    bool ok = false;                        // there are no errors; `scene` is complete
    SceneFile scene;                        // the part that could be read
    std::vector<Diagnostic> diagnostics;    // errors and warnings, in the order of the text
    std::vector<std::string> dependencies;  // files that were read: the scene
    std::vector<std::string> missing;       // files that were searched for and do not exist, sorted
};

// --- the library

// An engine of the library.
struct EngineInfo {
    std::string name;                    // as a target names it: "vulkan"
    std::string title;                   // "Vulkan"
    std::string doc;                     // a sentence about its files
    std::string file;                    // "stages": a file for each stage; else the format of one file for all
    std::vector<std::string> languages;  // of its shaders: "glsl", "hlsl"
    bool is_default = false;             // a target without an engine means this one
    bool has_own_passes = false;         // it draws its own rendering paths instead of the library's
    // The paths of its own passes, for CompileOptions::Passes::path; the first is the default.
    std::vector<std::string> paths;
    bool is_one_file = false;  // one file holds all passes of a material
    std::string folder;        // the folder that defines it: "nodes/engines/vulkan"
};

// A value of an enum of the node language.
struct EnumeratorInfo {
    std::string name, doc;  // the word in graphs; its meaning
};
// An input or an output of a node.
struct PortInfo {
    std::string name;                            // as graphs write it; "out" is what the node returns
    std::string type;                            // "float", "floatN", "Texture2D", or an enum's name
    bool is_output = false;                      // else an input
    std::string default_value;                   // as written: "0.5", "@uv0"; empty: must be linked (inputs)
    std::optional<std::array<double, 2>> range;  // the lowest and the highest value that make sense
    std::string unit;                            // "m"; empty: it has none
    std::string doc;                             // one line; may be empty
    std::vector<EnumeratorInfo> enumerators;     // of an enum, by index
};
// A node, which graphs name by "node".
struct NodeInfo {
    std::string name;                // as "node" names it
    std::string category;            // "Lighting/Distribution"
    std::vector<std::string> also;   // its names in other languages and programs: "Mix"
    std::string doc;                 // paragraphs, plain text
    std::string formula;             // an equation; may be empty
    std::string source;              // the paper; may be empty
    std::vector<PortInfo> ports;     // inputs in order, then outputs, the primary one first
    std::string file;                // where it is defined
    std::vector<std::string> tests;  // "Lerp(0, 10, 0.25) == 2.5"
};
// A value that graphs read with '@': of the mesh, the camera, the engine or, in a lighting graph, of the surface and
// the light.
struct SemanticInfo {
    std::string name;  // without '@': "uv0", "surface.roughness"
    std::string type;  // "float3"
    std::string doc;   // what it is
    std::string rate;  // how often it changes: "vertex", "pixel", "uniform"; "lighting": only lighting graphs read it
};
// An input of a workflow or a lighting model: an input of the surface, or a property.
struct ModelInputInfo {
    std::string name;           // as graphs write it
    std::string type;           // "float3"; of a property, the word of a PropertyType
    std::string default_value;  // as written: "[0.5, 0.5, 0.5]", "\"@geometryNormalWS\""; empty: none
    std::string doc;            // what it is
    std::optional<std::array<double, 2>> range{};  // the lowest and the highest value that make sense
    std::vector<std::string> values{};             // of an enum
    std::string gives{};                           // the input to which this one is an alternative: "normalWS"
    bool is_variant = false;                       // a property that is known when the graph is compiled
};
// A node of the graph of a workflow or a lighting model.
struct ModelNodeInfo {
    std::string id;                                           // unique in its graph
    std::string node;                                         // its name in the library; empty: an expression
    std::string expr;                                         // the expression, if it is one
    std::vector<std::pair<std::string, std::string>> inputs;  // port, and the value as written
    std::string doc;                                          // the comment above it
};
// A workflow or a lighting model. Its documentation is the comment above its graph, with the same keywords as that of a
// node.
struct ModelInfo {
    std::string name;                                          // as "workflow" and "lighting" name it
    std::string title;                                         // "Blinn-Phong"
    std::string doc;                                           // paragraphs, plain text
    std::string formula, source;                               // an equation, and the paper; both may be empty
    std::string use;                                           // when to use it
    std::string file;                                          // where it is defined
    std::vector<ModelInputInfo> inputs;                        // of the surface; a lighting model's own
    std::vector<ModelInputInfo> properties;                    // of a lighting model
    std::vector<ModelNodeInfo> nodes;                          // in the order of its file
    std::vector<std::pair<std::string, std::string>> outputs;  // "direct" and so on, and the value as written
};

// A pass of a rendering path, as its file declares it.
struct PassInfo {
    Pass state{};  // the state that does not depend on the material
    // How surfaces of one kind are blended.
    struct SurfaceBlend {
        std::optional<SurfaceKind> surface{};  // the kind that is drawn; nothing: every kind
        Blend blend{};                         // how their pixels are mixed with the target
    };
    std::vector<SurfaceBlend> blends{};  // of pass.targets; empty: every surface is drawn, and replaces the pixel
    bool is_optional = false;            // left out for a material that it cannot draw
};
// A rendering path: the passes that draw a material.
struct PathInfo {
    std::string name;              // as CompileOptions::Passes::path names it
    std::string doc;               // the comment that opens its file: paragraphs, plain text
    std::string source;            // the paper; may be empty
    std::string file;              // where it is defined
    std::vector<PassInfo> passes;  // in the order in which they are drawn
};

// --- a program's additions to the library

// A file of a LibraryOverlay.
struct LibraryFile {
    // Names the file in diagnostics. The ending of the name decides the kind:
    //
    //   .node.hlsl       nodes, functions that nodes call, and semantics
    //   .pass.hlsl       a rendering path, named by the file
    //   .lighting.json   a lighting model, named by the file
    //   .workflow.json   a workflow, named by the file
    std::string name;
    std::string text;  // all of the file
};

// A program's own nodes, semantics, workflows, lighting models and rendering paths, which are added to those of the
// library. Graphs and options name them in the same way: {"node": "Dots"}, "lighting": "my-toon".
//
//   const patina::Compiler compiler(patina::LibraryOverlay{.files = {{"mine/dots.node.hlsl", text}}});
//   for (const patina::Diagnostic& d : compiler.library_diagnostics()) ...   // a name twice, text that does not parse
struct LibraryOverlay {
    std::vector<LibraryFile> files;  // in any order
    // Later, a member here will hold a program's own engines. Now there are only those of the library.
};

// A `test:` line of a node's comment: `call` should equal `expected` within the tolerances.
struct NodeTest {
    std::string node;                   // whose comment has it
    std::string text;                   // the line; if it cannot run: the reason
    std::string file;                   // where the line is
    int line = 0;                       // from 1
    double relative = 0, absolute = 0;  // allowed difference: this share of the expected value, and this number
    // An input of the call.
    struct Argument {
        std::string name, type;      // "float3", or the enum's name
        std::vector<double> values;  // its components; enum: index
        std::string enumerator;      // enum arguments only
    };
    std::vector<Argument> arguments;  // only those that the line sets
    std::string output;               // port
    std::vector<double> expected;     // components, as the line has them
    std::vector<double> actual;       // computed by the CPU interpreter, in double
};

// The result of a check of a user's .node.hlsl file: its errors, and its test lines.
struct NodeFileResult {
    bool ok = false;                      // the file is valid; tests may still have failed
    std::vector<Diagnostic> diagnostics;  // errors and warnings, in the order of the text
    NodeInfo node;                        // what the file declares
    std::vector<NodeTest> tests;          // its test lines, run
};
// True if `actual` is within the test's tolerances of `expected`, NaN matching NaN.
PATINA_API bool passed(const NodeTest& test);

// One output of an evaluated node or expression.
struct EvalOutput {
    std::string name, type;      // the port, "out" of an expression; "float3"
    std::vector<double> values;  // components; matrices row by row; bool 0 or 1
};
// The result of an evaluation.
struct EvalResult {
    bool ok = false;                      // there are no errors
    std::vector<Diagnostic> diagnostics;  // of the arguments or the expression, with locations in their texts
    std::vector<EvalOutput> outputs;      // the primary one first
};

// A number, a vector (two to four components) or a matrix that expressions may read by its name.
struct NamedValue {
    std::string name;            // an identifier
    std::vector<double> values;  // one to four; of a matrix, row by row
    bool is_matrix = false;      // of 4, 9 or 16 values
};

class GraphBuilder;  // patina/graph_builder.h
struct VariantPlan;  // patina/variants.h
struct VariantProgram;
struct VariantSet;
enum class VariantsWanted;

// The compiler with its node library. Any number of threads may call its functions at once. A function whose result has
// diagnostics throws nothing. An exception inside of it becomes the error `out-of-memory` or `internal`. If there is no
// memory even for that error, the result is not ok and has no diagnostics. All other functions, and the constructors,
// throw only std::bad_alloc. After an error or an exception, the compiler is as usable as before.
class PATINA_API Compiler {
public:
    // Loads the library. Use one object for many compilations: each object has a library of its own.
    Compiler();
    // Also loads a program's additions. If these have errors, library_diagnostics() lists them. Then each result also
    // lists them, and is not ok.
    explicit Compiler(const LibraryOverlay& overlay);
    ~Compiler();
    Compiler(Compiler&&) noexcept;             // a moved-from compiler can only be assigned to or destroyed
    Compiler& operator=(Compiler&&) noexcept;  // no other thread may use either of the two

    // Compiles the graph in a file. If the file cannot be read, the result has an error.
    Result compile_file(const std::string& path, const CompileOptions& options = {}) const;
    // Compiles a graph. `path` names the text in messages and output files; relative files are searched in its folder.
    Result compile_text(const std::string& path, std::string text, const CompileOptions& options = {}) const;
    // Compiles a graph that was built in code. Each diagnostic names the node and the port, if it is about one.
    Result compile(const GraphBuilder& graph, const CompileOptions& options = {}) const;

    // Counts the combinations of a material's variants before anything is compiled; more than `limit` are refused.
    // `progress` is called with the axes. For Reachable, which takes time, it is also called with each new count. If it
    // throws, the work ends with the error `cancelled`.
    VariantPlan plan_variants(const std::string& path, VariantsWanted wanted, const CompileOptions& options,
                              std::size_t limit, const std::function<void(const VariantPlan&)>& progress = {}) const;
    // Compiles the combinations of a plan. The path and the options must be those of the plan.
    // `progress` is called with the index of the next combination. `finished` is called with each different program as
    // soon as it is compiled. VariantSet::programs then has only its hash, so that few programs are in memory at a
    // time. If `progress` or `finished` throws, the work ends with the error `cancelled`.
    VariantSet compile_variants(const std::string& path, const VariantPlan& plan, CompileOptions options,
                                const std::function<void(std::size_t)>& progress = {},
                                const std::function<void(VariantProgram)>& finished = {}) const;

    // Reads a scene; its graphs are found, not compiled. Of the options only `include_dirs`, `files` and `limits`
    // count.
    SceneResult read_scene(const std::string& path, const CompileOptions& options = {}) const;

    // The hash of the library, the overlay and the compiler itself: 32 hexadecimal digits. Compilers with the same hash
    // give the same result for the same request.
    std::string library_hash() const;
    // The hash of everything that a result depends on: the library, the graph, the files that it reads, the textures
    // that it finds, and the options without Limits. If a result is ok, each request with the same key has the same
    // result. The function reads the graph, and compiles nothing. If Limits::cancelled returns true, the key is empty.
    std::string cache_key(const std::string& path, const CompileOptions& options = {}) const;
    // The same, for compile_text().
    std::string cache_key(const std::string& path, std::string text, const CompileOptions& options) const;

    // Errors of the library and the overlay: all texts are parsed, and the bodies of functions are checked. The names
    // that a lighting model or a pass reads and calls are checked when a material uses it.
    std::vector<Diagnostic> library_diagnostics() const;
    const std::vector<NodeInfo>& nodes() const;         // by category, then name
    const NodeInfo* node(std::string_view name) const;  // null if there is none of this name
    // A hint for a name that no node has: "did you mean 'Lerp'?", "'Mix' is the node 'Lerp' here", or nothing.
    std::string node_advice(std::string_view name) const;
    const std::vector<SemanticInfo>& semantics() const;     // in the order of the library's files
    const std::vector<ModelInfo>& workflows() const;        // by name
    const std::vector<ModelInfo>& lighting_models() const;  // by name
    const std::vector<PathInfo>& paths() const;             // by name
    const std::vector<EngineInfo>& engines() const;         // the default one first, then by name
    // The targets that a word means: a language of the default engine ("glsl"), or an engine with all its languages
    // ("unity"). Empty if the word is unknown.
    std::vector<Target> targets(std::string_view word) const;
    // The test lines of a node of the library, run on the CPU; see passed(). None if there is no such node.
    std::vector<NodeTest> tests(std::string_view node) const;

    // Reads a node file, describes its node and runs its test lines on the CPU.
    NodeFileResult check_node_file(const std::string& path, const CompileOptions& options = {}) const;

    // Runs one node, of the library or of a .node.hlsl file, on the CPU. The arguments are values as in the graph
    // format, without links ("0.5", "0,0,1", "Reoriented", "#ff8800"), or expressions over `names`. If `single` is
    // true, the numbers are float, else double.
    EvalResult evaluate(std::string_view node, std::span<const std::pair<std::string, std::string>> arguments,
                        bool single = false, std::span<const NamedValue> names = {}) const;
    // The value of an expression of the node language over `names`: "sqrt(a2) * PI".
    EvalResult evaluate_expression(std::string_view expression, std::span<const NamedValue> names,
                                   bool single = false) const;

    // JSON Schema (draft 2020-12) of the graph format, with the library's nodes, ports and words.
    std::string schema() const;
    // The result of format().
    struct Formatted {
        bool ok = false;                      // the text could be read
        std::string text;                     // the canonical form
        std::vector<Diagnostic> diagnostics;  // why it could not be read
    };
    // The canonical text of a graph: order of keys and spacing are fixed, comments stay. `path` names the text in
    // messages. Of the limits, only `source_bytes` and `cancelled` count.
    Formatted format(const std::string& path, std::string text, const Limits& limits = {}) const;

private:
    friend struct CompilerAccess;
    struct Impl;
    explicit Compiler(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

// The version of the library that runs: "0.1.0". PATINA_VERSION_STRING is the version of the headers.
PATINA_API std::string_view version();

}  // namespace patina
