// The members of a Compiler: the library, and descriptions of it that are made when first requested.
#pragma once

#include <mutex>

#include "compiler/api/keys/kept_request.h"
#include "compiler/base/remembered.h"
#include "compiler/link/kept_results.h"
#include "compiler/resolve/library.h"
#include "patina/patina.h"

namespace patina {

struct Compiler::Impl {
    std::unique_ptr<graph::Library> library;
    std::vector<Diagnostic> overlay_errors;  // then nothing is compiled
    mutable link::KeptResults kept;          // of all compilations, by any thread
    mutable Remembered<KeptRequest> requests{KeptRequest::kMostBytes};

    mutable std::once_flag hash_once;
    mutable std::string hash;  // of the library

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

// What the other libraries of Patina and its tests need of a Compiler. with_files: files with paths below nodes/, of
// which engines have no public face yet; their texts must outlive the compiler.
struct CompilerAccess {
    using Impl = Compiler::Impl;
    static Compiler with_files(std::span<const nodelang::EmbeddedFile> more);
    static const graph::Library& library(const Compiler& compiler) { return *compiler.impl_->library; }
};

using CompilerImpl = CompilerAccess::Impl;

}  // namespace patina
