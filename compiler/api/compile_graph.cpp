// The Compiler class: compiling.
#include <filesystem>

#include "compiler/api/compilation.h"
#include "compiler/api/compile_targets.h"
#include "compiler/api/compiler_impl.h"
#include "compiler/api/report.h"

namespace patina {
namespace {

Result finish(graph::Session& session, Result result) {
    result.diagnostics = to_public(session.diagnostics, session.sources);
    result.dependencies = std::move(session.dependencies);
    result.ok = !session.diagnostics.has_errors();
    if (!result.ok) {
        result.shaders.clear();
        result.program = nullptr;
    }
    return result;
}

}  // namespace

Result Compiler::compile_file(const std::string& path, const CompileOptions& options) const {
    return compile_targets(*impl_->library, options, [&](const CompileOptions& of_engine) {
        graph::Session session(*impl_->library, of_engine);
        Result result;
        if (const std::optional<std::uint32_t> base = graph::load_source(session, path, {})) {
            Compilation compilation{.session = session, .source = *base, .path = path, .result = result};
            compile(compilation);
        }
        return finish(session, std::move(result));
    });
}

Result Compiler::compile_text(const std::string& path, std::string text, const CompileOptions& options) const {
    return compile_targets(*impl_->library, options, [&](const CompileOptions& of_engine) {
        graph::Session session(*impl_->library, of_engine);
        Result result;
        session.dependencies.push_back(path);
        // A part is used by its name, and must not be what a file of that name holds.
        if (of_engine.accept_parts)
            session.loaded[std::filesystem::path(path).lexically_normal().generic_string()] = text;
        Compilation compilation{
            .session = session, .source = session.sources.add(path, text), .path = path, .result = result};
        compile(compilation);
        return finish(session, std::move(result));
    });
}

}  // namespace patina
