// What a Compiler holds: the library, and descriptions of it that are made when first asked for.
#pragma once

#include <functional>
#include <mutex>

#include "compiler/resolve/library.h"
#include "patina/patina.h"

namespace patina {

struct Compiler::Impl {
    std::unique_ptr<graph::Library> library;

    // Filled by describe() under `once`.
    mutable std::once_flag once;
    mutable std::vector<NodeInfo> nodes;
    mutable std::vector<SemanticInfo> semantics;
    mutable std::vector<ModelInfo> workflows, lighting_models;
    mutable std::vector<PathInfo> paths;

    void describe() const;
    // Whether the target's files are another tool's: passes of their own, and all variants in one.
    bool is_tool(Target target) const { return library->tools.contains(to_string(target)); }
    Result compile_targets(const CompileOptions& options,
                           const std::function<Result(const CompileOptions&)>& compile) const;
};

// Takes those out that are a part of the path's passes.
void without_switches(std::vector<std::pair<std::string, std::string>>& given, const Reflection& of_path);

}  // namespace patina
