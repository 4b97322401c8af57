// The room `output` makes the results of a compilation: the texts of shaders with their line maps, and the reflection.
// It decides nothing about a shader; it asks a language for the text, and an engine's writer for the file around it.
//
// A Writer makes files of finished passes. There is one for a file for each stage, one for functions that are pasted
// into an engine's own shaders (print_shaders.h), and one for each format of a file that holds all passes
// (compiler/writers/FORMAT/, listed in writers/writers.cpp).
#pragma once

#include "compiler/languages/print.h"
#include "compiler/link/link_pass.h"
#include "compiler/output/reflect.h"

namespace patina::output {

// The input of a writer: a compiled material.
struct Compiled {
    resolve::Session& session;
    const resolve::Material& material;
    const lower::Lowered& lowered;
    std::span<const link::LinkedPass> passes;
    const link::Linked& linked;  // of the material itself
    std::string name;            // of its files, without extensions
};

struct Writer {
    std::string_view format;  // as engine.json names it
    // Returns whether it can write what the options request; otherwise reports why.
    bool (*accepts)(resolve::Session& session) = nullptr;
    // Names the values that the shaders share with their host.
    void (*name)(const resolve::Session& session, lower::Lowered& lowered) = nullptr;
    // Returns whether the pass can be drawn; otherwise reports why, and the pass is left out.
    bool (*takes)(resolve::Session& session, const link::Linked& linked, const link::LinkedPass& pass) = nullptr;
    // Puts the passes into the order in which the file holds them.
    void (*order)(std::vector<link::LinkedPass>& passes) = nullptr;
    // Reports what the files cannot express.
    void (*check)(const Compiled& compiled, const Reflection& reflection) = nullptr;
    // Adds the shaders, and the parts of the reflection that depend on the texts.
    void (*write)(const Compiled& compiled, Result& result) = nullptr;
};

// The places in the sources that the printed lines come from.
std::vector<LineOrigin> line_map(const languages::Printed& printed, std::span<const ir::Origin> origins,
                                 const SourceMap& sources);

}  // namespace patina::output
