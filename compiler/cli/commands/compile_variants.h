// patina compile --variants: every combination of a graph's variants, each different shader once, and a manifest.
#pragma once

#include <string>

#include "compiler/cli/console.h"
#include "compiler/cli/files.h"
#include "patina/variants.h"

namespace patina::cli {

struct VariantOptions {
    std::string wanted{};  // all | listed | reachable; empty: no variants but the one that is asked for
    std::size_t limit = kVariantLimit;
};

// What is written of one shader: false after a complaint.
using AddShader = std::function<bool(const Shader& shader, OutputFiles& files)>;

// The files of a graph's variants, its manifest `folder`/NAME.variants.json last.
Exit make_variants(const Console& console, const Compiler& compiler, const std::string& graph,
                   const VariantOptions& wanted, const CompileOptions& options, const std::string& folder,
                   const AddShader& add, OutputFiles& files, std::vector<std::string>& dependencies);

}  // namespace patina::cli
