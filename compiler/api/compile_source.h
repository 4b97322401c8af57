// Compiles a graph, with files that several compilations share: for several engines, or of several variants.
#pragma once

#include "compiler/api/compiler_impl.h"
#include "compiler/resolve/files.h"

namespace patina {

struct Source {
    std::string path;
    std::optional<std::string> text{};  // nothing: that of the file
};

Result compile_source(const CompilerImpl& compiler, const Source& source, const CompileOptions& options,
                      graph::Files& files);
// The same, for a request of its own: `files` has been asked for nothing yet.
Result compile_or_remember(const CompilerImpl& compiler, const Source& source, const CompileOptions& options,
                           graph::Files& files);

}  // namespace patina
