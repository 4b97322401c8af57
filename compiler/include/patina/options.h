// The request for a compilation: what is made, from which files, within which limits.
//
//   patina::CompileOptions options;
//   options.targets = {patina::Target::Glsl};
//   options.request = patina::CompileOptions::Passes{.path = "deferred"};
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "patina/export.h"

namespace patina {

// A target: a language as an engine takes it. The engine defines bindings and files; the language defines how a stage
// is spelled. `patina engines` and Compiler::engines() list all of them.
struct Target {
    std::string engine;    // EngineInfo::name; empty: the default engine
    std::string language;  // one of EngineInfo::languages: "glsl"

    // The target's name: the language, or the engine if it is not the default one.
    const std::string& name() const { return engine.empty() ? language : engine; }
    // True for the same engine and language. The default engine by its name differs from "".
    friend bool operator==(const Target&, const Target&) = default;
    // An order for sorted containers: by engine, then by language.
    friend bool operator<(const Target& a, const Target& b) {
        return a.engine != b.engine ? a.engine < b.engine : a.language < b.language;
    }

    static const Target Glsl, Hlsl;  // of the default engine
};
inline const Target Target::Glsl{{}, "glsl"};
inline const Target Target::Hlsl{{}, "hlsl"};

// Where a compilation finds files. It reads the texts of sub-graphs, lighting graphs, node files and pass files. It
// only checks that textures exist. The default is the disk.
//
//   options.files.read = [&](const std::string& path) { return pack.find(path); };  // std::optional<std::string>
//
// Each function may be called from any thread that compiles, also from several at the same time. Within one compilation
// it is called once for each file. A function may throw. The exception becomes the error `cannot-read` with its what(),
// at the location that names the file, and the compilation continues to find other errors. std::bad_alloc becomes the
// error `out-of-memory`, which ends the compilation.
struct FileSystem {
    // The path of the file that `name` means in the file `from`, or, if `from` ends with '/', below that folder of
    // CompileOptions::include_dirs. A path is any text that the program chooses: a URI, an id. `exists` and `read` get
    // it unchanged, and it names the file in diagnostics, dependencies and the reflection. Default: paths and URIs are
    // joined as usual: "../rust.png" in "pack://stone/wet/a.graph.json" is "pack://stone/rust.png". The file of a node
    // is a node file if its name or its path ends with ".hlsl", else a sub-graph.
    std::function<std::string(const std::string& from, const std::string& name)> resolve{};
    // True if the file exists. For textures, only this function is called. Default: the disk if `read` is not set
    // either; else a file exists if `read` returns a text.
    std::function<bool(const std::string& path)> exists{};
    // The text of the file; nothing if there is no such file. Throws an exception if the file exists and cannot be
    // read; its what() says why. Default: the disk.
    std::function<std::optional<std::string>(const std::string& path)> read{};
};

// Which part of the disk a compilation reads.
//
//   options.files = patina::disk({.root = "uploads/42"});   // an untrusted graph
struct DiskOptions {
    // Nothing outside of this folder is read, and no message shows whether a file outside exists. If a graph names
    // "..", an absolute path or a symbolic link that leads outside, that is an error. The same is true for the path of
    // the graph and for CompileOptions::include_dirs. Empty: all of the disk. A folder that does not exist has no
    // files.
    std::string root{};
    std::size_t most_bytes = std::size_t{64} << 20;  // of one file; at most 64 MiB. A larger file is an error
};

// The disk, with all three functions set: for a file system that adds to it.
PATINA_API FileSystem disk();
// The same for a part of it.
PATINA_API FileSystem disk(const DiskOptions& options);

// The most that a compilation may use. A compilation that needs more ends with the error `over-budget`. The defaults
// are far above the needs of materials. They make an untrusted graph end in seconds and in less than about 2 GB of
// memory. A program may set each limit to another number, or to kNone.
struct Limits {
    // No limit.
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    // The nodes of a graph; each use of a sub-graph counts all of its nodes. The error names the node that exceeds the
    // limit.
    std::size_t nodes = std::size_t{1} << 22;
    // Bytes of all texts that are read: the graph and the files that it names. A file of the disk is read only as far
    // as the limit allows, and at most 64 MiB of it.
    std::size_t source_bytes = 256u << 20;
    std::size_t shader_bytes = 256u << 20;  // of all texts that are written
    // The instructions of nodes, functions and passes, before they are simplified. Each round of a loop that is written
    // out ([unroll]) counts. The error is at the statement or the node that exceeds the limit.
    std::size_t instructions = 500'000;
    // True: the compilation ends with the error `cancelled` and no other result. The function is called often, at least
    // every 100 ms, from the thread that compiles. If it throws, the compilation ends, too, and the error has the
    // exception's what().
    std::function<bool()> cancelled{};
};

// Asks for the shaders of passes.
struct PassesRequest {
    // A rendering path of the library, or a file of one: "deferred", "./mine.pass.hlsl". If the path cannot draw a
    // material, the material is compiled for the path's fallback, with a warning; the reflection names the path that
    // was used. An engine with passes of its own has only the paths of EngineInfo::paths. It ignores other paths,
    // `only` and the passes' switches.
    std::string path = "forward";
    std::vector<std::string> only{};  // if not empty: these passes, of any path
};

// Asks for the material's functions for an engine's own shaders, without passes. All other declarations begin with the
// prefix ("Rust_"); the reflection lists them.
struct FunctionsRequest {
    std::string prefix;  // an identifier in every shading language
};

// Asks for a material that shows a port, unlit, instead of the graph's surface: "mask", "rust.amount", "layers/mask"
// inside the sub-graph of the node "layers", or an input of the surface, "surface.roughness".
struct PreviewRequest {
    std::string port;        // the port that is shown
    PassesRequest passes{};  // the passes that draw it
};

// The options of a compilation. By default: GLSL and HLSL of the path "forward", with files of the disk.
struct CompileOptions {
    // --- what to make
    // A repeated target has no effect. Empty: the graph is checked, and no shader is written.
    std::vector<Target> targets = {Target::Glsl, Target::Hlsl};
    using Passes = PassesRequest;                        // shaders of a rendering path
    using Functions = FunctionsRequest;                  // functions for shaders of your own
    using Preview = PreviewRequest;                      // shaders that show a port
    std::variant<Passes, Functions, Preview> request{};  // one of the three
    // The passes of the request; null if it asks for functions.
    Passes* passes();
    const Passes* passes() const;  // the same

    // --- which values to use
    // Values of switches (optional parts of the passes), of the graph's variants and specialization constants, and of
    // the lighting model's variants (ModelInputInfo::is_variant): "shadows", "true"; "_Mode", "Wet". No value means
    // "true".
    std::vector<std::pair<std::string, std::string>> switches{};
    // True: variants that `switches` do not set get no value, and both stages have the code of all values.
    bool keep_variants = false;
    // A lighting model of the library, or the path of a lighting graph, that replaces the graph's own model; empty: the
    // graph's own. If it is set, the graph's values for its own model have no effect.
    std::string lighting{};
    // Also accepts a lighting graph or a sub-graph, and checks it alone: in the smallest material that uses it.
    bool accept_parts = false;

    // --- what to read
    FileSystem files{};                       // default: the disk
    std::vector<std::string> include_dirs{};  // searched after the folder of the file that has the name

    // --- limits
    Limits limits{};  // default: those of Limits

    // --- more for the result
    // The steps whose text goes to Result::dumps: "graph", "ir", "linked", "tidy", "rates".
    std::vector<std::string> dump{};
    bool keep_programs = false;  // the result also has the programs for patina/interpret.h
    bool hashes = false;         // Shader::hash and Pass::hash
};

inline const CompileOptions::Passes* CompileOptions::passes() const {
    if (const Preview* preview = std::get_if<Preview>(&request)) return &preview->passes;
    return std::get_if<Passes>(&request);
}
inline CompileOptions::Passes* CompileOptions::passes() {
    return const_cast<Passes*>(std::as_const(*this).passes());
}

}  // namespace patina
