// The members of a Compiler: the library, and descriptions of it that are made when first requested.
#pragma once

#include "compiler/api/keys/cached_result.h"
#include "compiler/base/cache.h"
#include "compiler/base/made_once.h"
#include "compiler/resolve/library.h"
#include "patina/patina.h"

namespace patina {

struct Compiler::Impl {
    std::unique_ptr<resolve::Library> library;
    std::vector<Diagnostic> overlay_errors;  // then nothing is compiled
    mutable Cache<CachedResult> results{CachedResult::kMostBytes};

    MadeOnce<std::string> hash;  // of the library

    struct Described {
        std::vector<NodeInfo> nodes;
        std::vector<SemanticInfo> semantics;
        std::vector<ModelInfo> workflows, lighting_models;
        std::vector<PathInfo> paths;
    };
    MadeOnce<Described> described;
    // Apart from the others, which are many: each compilation of the command asks for the engines.
    MadeOnce<std::vector<EngineInfo>> engines;

    const Described& describe() const;
};

// What the other libraries of Patina and its tests need of a Compiler. with_files: files with paths below nodes/, of
// which engines have no public face yet; their texts must outlive the compiler.
struct CompilerAccess {
    using Impl = Compiler::Impl;
    static Compiler with_files(std::span<const nodelang::EmbeddedFile> more);
    static const resolve::Library& library(const Compiler& compiler) { return *compiler.impl_->library; }
    static const Impl& impl(const Compiler& compiler) { return *compiler.impl_; }
};

using CompilerImpl = CompilerAccess::Impl;

}  // namespace patina
