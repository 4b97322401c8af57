#include "compiler/api/keys/cached_result.h"

#include <algorithm>
#include <filesystem>

#include "compiler/api/compile_source.h"
#include "compiler/api/keys/request_fields.h"

namespace patina {
namespace {

// All but what the files say. The working folder is a part of the names of files.
std::string key_of(const Source& source, const CompileOptions& options) {
    Fields fields;
    std::error_code ignored;
    fields.add(std::filesystem::current_path(ignored).native()).add(source.path);
    fields.add_flag(source.text.has_value()).add(source.text.value_or(""));
    add_options(fields, options);
    for (const std::size_t most :
         {options.limits.nodes, options.limits.source_bytes, options.limits.shader_bytes, options.limits.instructions})
        fields.add(std::to_string(most));
    return fields.text();
}

// Programs hold the stages, and dumps are for people who look at one compilation.
bool may_be_cached(const CompilerImpl& compiler, const CompileOptions& options) {
    return compiler.overlay_errors.empty() && options.dump.empty() && !options.keep_programs;
}

bool is_same(const resolve::Files::Answer& now, const resolve::Files::Answer& then) {
    return now.text == then.text && now.why == then.why;
}

// Asks the same questions. A compilation after it does not ask them again, also if an answer has changed.
bool is_as_before(const CachedResult& cached, resolve::Files& files) {
    for (const auto& [from, name, path] : cached.resolved) {
        const resolve::Files::Path now = files.resolve(from, name);
        if (now.path != path.path || now.why != path.why) return false;
    }
    return std::all_of(cached.answers.begin(), cached.answers.end(), [&](const auto& each) {
        const auto& [path, then] = each;
        if (then.is_read && !is_same(files.read(path), then)) return false;
        return !then.exists || files.find(path).exists == then.exists;
    });
}

// If the program cancels, the compilation finds it out in its own way.
bool is_cancelled(const CompileOptions& options) {
    try {
        return options.limits.cancelled && options.limits.cancelled();
    } catch (...) {
        return true;
    }
}

// About how many bytes it has. A reflection is a few kilobytes.
std::size_t size_of(const CachedResult& cached) {
    constexpr std::size_t kReflection = std::size_t{16} << 10;
    std::size_t bytes = sizeof cached + kReflection;
    for (const Shader& shader : cached.result.shaders) {
        bytes += sizeof shader + shader.text.size();
        for (const LineOrigin& line : shader.line_map)
            bytes += sizeof line + line.file.size() + line.source_text.size();
    }
    for (const auto& [path, answer] : cached.answers)
        bytes += sizeof answer + path.size() + (answer.text ? answer.text->size() : 0);
    return bytes;
}

}  // namespace

Result compile_or_find(const CompilerImpl& compiler, const Source& source, const CompileOptions& options,
                       resolve::Files& files, Trail& trail) {
    if (!may_be_cached(compiler, options)) return compile_source(compiler, source, options, files, trail);
    std::string key = key_of(source, options);
    const auto [known, is_asked_again] = compiler.results.ask(key);
    if (known && is_as_before(*known, files) && !is_cancelled(options)) return known->result;
    Result made = compile_source(compiler, source, options, files, trail);
    if (made.ok && (known || is_asked_again)) {
        CachedResult now{.result = made, .answers = files.answers(), .resolved = files.resolved()};
        const std::size_t bytes = size_of(now);
        compiler.results.keep(std::move(key), std::move(now), bytes);
    }
    return made;
}

}  // namespace patina
