// The Compiler class: compiling.
#include "compiler/api/compilation.h"
#include "compiler/api/compile_source.h"
#include "compiler/api/compile_targets.h"
#include "compiler/api/report.h"

namespace patina {
namespace {

// Where the graph begins in the session's sources. Nothing after an error.
std::optional<std::uint32_t> add_source(resolve::Session& session, const Source& source) {
    if (!source.text) return resolve::load_source(session, source.path, {});
    session.dependencies.push_back(source.path);
    const std::uint32_t base = session.sources.add(source.path, *source.text);
    return resolve::is_over_bytes(session, {base, base}) ? std::nullopt : std::optional(base);
}

Result compile_for_engine(const CompilerImpl& compiler, const Source& source, const CompileOptions& options,
                          resolve::Files& files, Trail& trail) {
    resolve::Session session(*compiler.library, options, &files);
    ShortName pass;
    const TrailGuard guard(trail, session.diagnostics, &pass);
    Result result;
    resolve::until_stopped(session, [&] {
        const std::optional<std::uint32_t> base = add_source(session, source);
        if (!base) return;
        Compilation compilation{
            .session = session, .source = *base, .path = source.path, .result = result, .pass = pass};
        compile(compilation);
    });
    if (session.stopped) result = {};
    result.diagnostics = to_public(session.diagnostics, session.sources, compiler.library->sources, source.path);
    result.dependencies = std::move(session.dependencies);
    result.missing.assign(session.missing.begin(), session.missing.end());
    result.ok = !session.diagnostics.has_errors();
    if (!result.ok) {
        result.shaders.clear();
        result.program = nullptr;
    }
    return result;
}

}  // namespace

Result compile_source(const CompilerImpl& compiler, const Source& source, const CompileOptions& options,
                      resolve::Files& files, Trail& trail) {
    if (!compiler.overlay_errors.empty()) {
        Result result;
        result.diagnostics = compiler.overlay_errors;
        return result;
    }
    return compile_targets(*compiler.library, options, [&](const CompileOptions& of_engine) {
        return compile_for_engine(compiler, source, of_engine, files, trail);
    });
}

Result compile_file(const CompilerImpl& compiler, const std::string& path, const CompileOptions& options,
                    Trail& trail) {
    resolve::Files files(options);
    return compile_or_find(compiler, {.path = path}, options, files, trail);
}

Result compile_text(const CompilerImpl& compiler, const std::string& path, std::string text,
                    const CompileOptions& options, Trail& trail) {
    resolve::Files files(options);
    files.add_bytes(text.size());
    if (options.accept_parts) files.give_part(path, text);
    return compile_or_find(compiler, {.path = path, .text = std::move(text)}, options, files, trail);
}

Result Compiler::compile_file(const std::string& path, const CompileOptions& options) const {
    return guarded<Result>(path, [&](Trail& trail) { return patina::compile_file(*impl_, path, options, trail); });
}

Result Compiler::compile_text(const std::string& path, std::string text, const CompileOptions& options) const {
    return guarded<Result>(
        path, [&](Trail& trail) { return patina::compile_text(*impl_, path, std::move(text), options, trail); });
}

}  // namespace patina
