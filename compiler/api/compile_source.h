// Compiles a graph, with files that several compilations share: for several engines, or of several variants.
#pragma once

#include "compiler/api/compiler_impl.h"
#include "compiler/resolve/files.h"
#include "compiler/seam/seam.h"

namespace patina {

struct Source {
    std::string path;
    std::optional<std::string> text{};  // nothing: that of the file
};

Result compile_source(const CompilerImpl& compiler, const Source& source, const CompileOptions& options,
                      resolve::Files& files, Trail& trail);
// The same, for a request of its own: `files` has been asked for nothing yet.
Result compile_or_find(const CompilerImpl& compiler, const Source& source, const CompileOptions& options,
                       resolve::Files& files, Trail& trail);

// Compiler::compile_file() and compile_text(), for functions that end exceptions themselves.
Result compile_file(const CompilerImpl& compiler, const std::string& path, const CompileOptions& options, Trail& trail);
Result compile_text(const CompilerImpl& compiler, const std::string& path, std::string text,
                    const CompileOptions& options, Trail& trail);

}  // namespace patina
