// patina compile --variants: compiles the combinations of a graph's variants. Each different shader is written once; a
// manifest says which shaders each combination uses.
#pragma once

#include <string>

#include "compiler/cli/compile/depfile.h"
#include "compiler/cli/console.h"
#include "compiler/cli/outputs.h"
#include "patina/variants.h"

namespace patina::cli {

struct VariantOptions {
    std::string wanted{};  // all | listed | reachable; empty: one variant only
    std::size_t limit = kVariantLimit;
    bool file_hashes = false;
    std::string kind{};  // ends the names of the reflections and the manifest: ".deferred"
};

// Adds the files of one shader; false: it is wrong, and that has been reported.
using AddShader = std::function<bool(const Shader& shader, OutputFiles& files)>;

// Makes the files of a graph's variants. The last one is the manifest, `folder`/NAME.variants.json, or
// NAME.deferred.variants.json for the kind ".deferred".
Exit make_variants(const Console& console, const Compiler& compiler, const std::string& graph,
                   const VariantOptions& wanted, const CompileOptions& options, const std::string& folder,
                   const AddShader& add, OutputFiles& files, FilesRead& read);

}  // namespace patina::cli
