// The members of a Compiler: the library, and descriptions of it that are made when first requested.
#pragma once

#include <mutex>

#include "compiler/api/compilation.h"
#include "compiler/resolve/library.h"
#include "patina/patina.h"

namespace patina {

struct Compiler::Impl {
    std::unique_ptr<graph::Library> library;
    std::unique_ptr<Known> known = std::make_unique<Known>();  // behind the library, which its keys refer to

    // Filled by describe() under `once`.
    mutable std::once_flag once;
    mutable std::vector<NodeInfo> nodes;
    mutable std::vector<SemanticInfo> semantics;
    mutable std::vector<ModelInfo> workflows, lighting_models;
    mutable std::vector<PathInfo> paths;
    // Apart from the others, which are many: each compilation of the command asks for the engines.
    mutable std::once_flag engines_once;
    mutable std::vector<EngineInfo> engines;

    void describe() const;
};

// The place for a library of an embedder's own, which has no public face yet: an engine, nodes and passes as files with
// paths below nodes/.
struct CompilerAccess {
    static Compiler with_files(std::span<const nodelang::EmbeddedFile> more);
    static const graph::Library& library(const Compiler& compiler) { return *compiler.impl_->library; }
    // For tests: each compilation makes all of its results.
    static void keep_nothing(Compiler& compiler) { compiler.impl_->known.reset(); }
};

}  // namespace patina
