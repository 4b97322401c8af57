// What a compilation is asked for.
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

// A target: a language as an engine takes it. The engine says where values come from and what holds a shader; the
// language says how a stage is spelled. `patina engines` and Compiler::engines() list all of them.
struct Target {
    std::string engine;    // EngineInfo::name; empty: the default engine
    std::string language;  // one of EngineInfo::languages: "glsl"

    // The target's name: the language, or the engine if it is not the default one.
    const std::string& name() const { return engine.empty() ? language : engine; }
    // True for the same engine and language. The default engine by its name is another one than "".
    friend bool operator==(const Target&, const Target&) = default;
    // An order for sorted containers: by engine, then by language.
    friend bool operator<(const Target& a, const Target& b) {
        return a.engine != b.engine ? a.engine < b.engine : a.language < b.language;
    }

    static const Target Glsl, Hlsl;  // of the default engine
};
inline const Target Target::Glsl{{}, "glsl"};
inline const Target Target::Hlsl{{}, "hlsl"};

// Where a compilation finds files: sub-graphs, lighting graphs, node files and pass files, whose texts it reads, and
// textures, which it never reads. The default is the disk.
//
//   options.files.read = [&](const std::string& path) { return pack.find(path); };  // std::optional<std::string>
//
// Each function may be called from any thread that compiles, also from several at the same time. Within one compilation
// each file is asked for once. A function may throw: the exception becomes the error `cannot-read` at the place that
// names the file, with its what(), and the compilation goes on to find other errors; std::bad_alloc becomes the error
// `out-of-memory`, which ends it.
struct FileSystem {
    // The path of the file that `name` means in the file `from`, or, if `from` ends with '/', below that folder of
    // CompileOptions::include_dirs. A path is any text that the program wants: a URI, an id. It is given to `exists`
    // and `read` as it is, and names the file in diagnostics, dependencies and the reflection. Default: paths and URIs
    // are joined as usual: "../rust.png" in "pack://stone/wet/a.graph.json" is "pack://stone/rust.png". A node's file
    // is a node file if its name or its path ends with ".hlsl", else a sub-graph.
    std::function<std::string(const std::string& from, const std::string& name)> resolve{};
    // True if the file is there. Textures are asked for by this function alone. Default: the file system that `read`
    // reads; if that is the program's own, a file is there if `read` returns a text.
    std::function<bool(const std::string& path)> exists{};
    // The text of the file; nothing if there is no such file. Throws an exception if the file is there and cannot be
    // read; its what() says why. Default: the disk.
    std::function<std::optional<std::string>(const std::string& path)> read{};
};

// Which part of the disk a compilation reads.
//
//   options.files = patina::disk({.root = "uploads/42"});   // a graph of a stranger's
struct DiskOptions {
    // Nothing outside of this folder is read, and nothing tells whether it is there, whatever a graph names: "..",
    // absolute paths and symbolic links that lead outside are errors. That holds for the graph and for
    // CompileOptions::include_dirs, too. Empty: all of the disk. A folder that is not there holds nothing.
    std::string root{};
    std::size_t most_bytes = std::size_t{64} << 20;  // of one file; at most 64 MiB. More is an error, and is not read
};

// The disk, with all three functions set: for a file system that adds to it.
PATINA_API FileSystem disk();
// The same for a part of it.
PATINA_API FileSystem disk(const DiskOptions& options);

// What a program allows a compilation. One that needs more ends with the error `over-budget`. The defaults are far
// above what materials need, so that a graph of a stranger ends in seconds and needs less than about 2 GB of memory. A
// program may set each of them to another number, or to kNone.
struct Limits {
    // No limit.
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    // The nodes of a graph; each use of a sub-graph counts all of its nodes. The error names the node that passes it.
    std::size_t nodes = std::size_t{1} << 22;
    // Of all texts that are read: the graph and the files that it names. Of a file of the disk, no more is read than
    // what is left; a single one has at most 64 MiB.
    std::size_t source_bytes = 256u << 20;
    std::size_t shader_bytes = 256u << 20;  // of all texts that are written
    // The instructions that nodes, functions and passes are made of, before they are simplified. The rounds of a loop
    // that is written out ([unroll]) count each. The error is at the statement or the node that passes it.
    std::size_t instructions = 500'000;
    // True: the compilation ends with the error `cancelled` and no other result. It is called often, at least every
    // 100 ms, from the thread that compiles. What it throws also ends the compilation; the error has its what().
    std::function<bool()> cancelled{};
};

// Asks for the shaders of passes.
struct PassesRequest {
    // A rendering path of the library, or a file that holds one: "deferred", "./mine.pass.hlsl". A material that
    // the path cannot draw is compiled for the path's fallback, with a warning; the reflection names the path that
    // was used. An engine with passes of its own takes only the paths of EngineInfo::paths and ignores others,
    // `only` and the passes' switches.
    std::string path = "forward";
    std::vector<std::string> only{};  // if not empty: these passes, of any path
};

// Asks for the material's functions for an engine's own shaders, and no passes. All other declarations begin with the
// prefix ("Rust_"); the reflection lists them.
struct FunctionsRequest {
    std::string prefix;  // an identifier in every shading language
};

// Asks for a material that shows a port, unlit, instead of the graph's surface: "mask", "rust.amount", "layers/mask"
// inside the sub-graph of the node "layers", or an input of the surface, "surface.roughness".
struct PreviewRequest {
    std::string port;        // what is shown
    PassesRequest passes{};  // what draws it
};

// What a compilation is asked for, and where it finds its files. By default: GLSL and HLSL of the path "forward", with
// files of the disk.
struct CompileOptions {
    // --- what is made
    // Each once; a repeated one has no effect. None: the graph is checked, and nothing is written.
    std::vector<Target> targets = {Target::Glsl, Target::Hlsl};
    using Passes = PassesRequest;                        // shaders of a rendering path
    using Functions = FunctionsRequest;                  // functions for shaders of your own
    using Preview = PreviewRequest;                      // shaders that show a port
    std::variant<Passes, Functions, Preview> request{};  // one of the three
    // The passes of the request; null if it asks for functions.
    Passes* passes();
    const Passes* passes() const;  // the same

    // --- of which values
    // Values of switches (optional parts of the passes), of the graph's variants and specialization constants, and of
    // the lighting model's variants (ModelInputInfo::is_variant): "shadows", "true"; "_Mode", "Wet". No value means
    // "true".
    std::vector<std::pair<std::string, std::string>> switches{};
    // Does not choose values for variants that `switches` leave open: both stages keep the code of all their values.
    bool keep_variants = false;
    // A lighting model of the library, or the path of a lighting graph, in place of the graph's own; empty: its own.
    // The values that the graph gives to its own model have no effect then.
    std::string lighting{};
    // Also accepts a lighting graph or a sub-graph, and puts it into the smallest material that uses it, to check it
    // alone.
    bool accept_parts = false;

    // --- what is read
    FileSystem files{};                       // default: the disk
    std::vector<std::string> include_dirs{};  // searched after the folder of the file that names another

    // --- what is allowed
    Limits limits{};  // default: those of Limits

    // --- what the result also has
    // The steps whose text goes to Result::dumps: "graph", "ir", "linked", "tidy", "rates".
    std::vector<std::string> dump{};
    bool keep_programs = false;  // keep what patina/interpret.h runs
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
