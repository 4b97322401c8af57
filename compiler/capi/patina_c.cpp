// The functions of patina/patina_c.h that compile. Each calls a function of patina::Compiler and stores its result.
// variants.cpp, scene.cpp and lists.cpp have the others.
#include <memory>
#include <optional>
#include <stdexcept>

#include "compiler/base/diagnostics.h"
#include "compiler/capi/handles.h"
#include "compiler/capi/read_options.h"

struct patina_reply {
    std::optional<std::string> text;
    std::optional<std::string> error;
    bool is_without_memory = false;  // there was none for the answer
};

namespace patina::capi {
namespace {

// The text that a callback gave, or nothing. Throws if it gave a reason instead.
std::optional<std::string> answer(patina_reply reply) {
    if (reply.is_without_memory) throw std::bad_alloc();
    if (reply.error) throw std::runtime_error(*reply.error);
    return std::move(reply.text);
}

void use(const patina_callbacks& given, CompileOptions& options) {
    // If the program's own function reads, then the program also decides which files exist, and not the disk: by its
    // `exists`, or by reading.
    if (given.read) {
        options.files.exists = nullptr;
        options.files.read = [given](const std::string& path) {
            patina_reply reply;
            given.read(given.user, path.c_str(), &reply);
            return answer(std::move(reply));
        };
    }
    if (given.exists) {
        options.files.exists = [given](const std::string& path) { return given.exists(given.user, path.c_str()) != 0; };
    }
    if (given.resolve) {
        options.files.resolve = [given](const std::string& from, const std::string& name) {
            patina_reply reply;
            given.resolve(given.user, from.c_str(), name.c_str(), &reply);
            return answer(std::move(reply)).value_or(name);
        };
    }
    if (given.cancelled) options.limits.cancelled = [given] { return given.cancelled(given.user) != 0; };
}

// `work` compiles with the options.
template <class Work>
patina_status compile(const patina_compiler* compiler, const char* options_text, const patina_callbacks* callbacks,
                      patina_result** result, const Work& work) noexcept {
    if (!result) return PATINA_BAD_ARGUMENT;
    *result = nullptr;
    if (!compiler) return PATINA_BAD_ARGUMENT;
    return guarded([&] {
        auto made = std::make_unique<patina_result>();
        CompileOptions options;
        made->result.diagnostics = settle(*compiler, options_text, callbacks, options);
        if (made->result.diagnostics.empty()) made->result = work(options);
        refuse_without_memory(made->result.ok, made->result.diagnostics);
        complete(*made);
        const bool is_ok = made->result.ok;
        *result = made.release();
        return is_ok ? PATINA_OK : PATINA_HAS_ERRORS;
    });
}

// Copies a key to where there is room for PATINA_KEY_SIZE bytes.
patina_status give(const std::string& made, char* key) {
    if (made.size() >= PATINA_KEY_SIZE) return PATINA_INTERNAL_ERROR;
    key[made.copy(key, PATINA_KEY_SIZE - 1)] = '\0';
    return PATINA_OK;
}

}  // namespace

void refuse_without_memory(bool ok, std::span<const Diagnostic> diagnostics) {
    if (!ok && diagnostics.empty()) throw std::bad_alloc();
    for (const Diagnostic& each : diagnostics)
        if (each.code == info(Code::OutOfMemory).name) throw std::bad_alloc();
}

std::string messages_of(std::span<const Diagnostic> diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) text += to_text(diagnostic) + "\n";
    return text;
}

std::string json_of(std::span<const Diagnostic> diagnostics) {
    std::string text = "[";
    for (const Diagnostic& diagnostic : diagnostics) text += (text.size() > 1 ? ",\n" : "") + to_json(diagnostic);
    return text + "]";
}

void complete(patina_result& made) {
    made.messages = messages_of(made.result.diagnostics);
    made.diagnostics = json_of(made.result.diagnostics);
    if (!made.result.ok) {
        made.result.shaders.clear();
        return;
    }
    made.reflection = made.result.reflection.to_json();
    for (const Shader& shader : made.result.shaders) {
        made.shaders.push_back({.file_name = shader.file_name.c_str(),
                                .text = shader.text.c_str(),
                                .size = shader.text.size(),
                                .pass = shader.pass.c_str(),
                                .stage = to_string(shader.stage).data(),
                                .engine = shader.target.engine.c_str(),
                                .language = shader.target.language.c_str()});
    }
}

std::vector<Diagnostic> settle(const patina_compiler& compiler, const char* options_text,
                               const patina_callbacks* callbacks, CompileOptions& options) {
    std::vector<Diagnostic> wrong;
    if (options_text) wrong = read_options(compiler.compiler, options_text, options);
    if (callbacks) use(*callbacks, options);
    return wrong;
}

}  // namespace patina::capi

using namespace patina::capi;

extern "C" {

const char* patina_status_text(patina_status status) {
    switch (status) {
        case PATINA_OK: return "all is well";
        case PATINA_HAS_ERRORS: return "there are errors";
        case PATINA_WRONG_ABI: return "the program was compiled for another version of patina_c.h than the library";
        case PATINA_BAD_ARGUMENT: return "a pointer is null that must not be, or a size or a word is impossible";
        case PATINA_OUT_OF_MEMORY: return "there is not enough memory";
        case PATINA_INTERNAL_ERROR: return "a bug in the library";
    }
    return "an unknown status";
}

uint32_t patina_c_abi(void) {
    return PATINA_C_ABI;
}

const char* patina_version(void) {
    return PATINA_VERSION_STRING;
}

patina_status patina_compiler_create(uint32_t abi, const patina_library_file* files, size_t count,
                                     patina_compiler** compiler) {
    if (!compiler) return PATINA_BAD_ARGUMENT;
    *compiler = nullptr;
    if (abi != PATINA_C_ABI) return PATINA_WRONG_ABI;
    if (!is_possible(files, count, sizeof *files)) return PATINA_BAD_ARGUMENT;
    return guarded([&] {
        patina::LibraryOverlay overlay;
        for (size_t i = 0; i < count; ++i) {
            if (!files[i].name || !is_possible(files[i].text, files[i].size)) return PATINA_BAD_ARGUMENT;
            overlay.files.push_back({.name = files[i].name, .text = {or_empty(files[i].text), files[i].size}});
        }
        *compiler = new patina_compiler{.compiler = patina::Compiler(overlay)};
        return PATINA_OK;
    });
}

void patina_compiler_free(patina_compiler* compiler) {
    delete compiler;
}

void patina_reply_text(patina_reply* reply, const char* text, size_t size) {
    if (!reply) return;
    if (!is_possible(text, size)) return patina_reply_error(reply, "the program gave a text of an impossible size");
    const patina_status status = guarded([&] {
        reply->text = std::string(or_empty(text), size);
        return PATINA_OK;
    });
    if (status != PATINA_OK) reply->is_without_memory = true;
}

void patina_reply_error(patina_reply* reply, const char* reason) {
    if (!reply) return;
    const patina_status status = guarded([&] {
        reply->error = or_empty(reason);
        return PATINA_OK;
    });
    if (status != PATINA_OK) reply->is_without_memory = true;
}

patina_status patina_compile(const patina_compiler* compiler, const char* path, const char* text, size_t size,
                             const char* options, const patina_callbacks* callbacks, patina_result** result) {
    const bool is_complete = path && is_possible(text, size);
    return compile(is_complete ? compiler : nullptr, options, callbacks, result,
                   [&](const patina::CompileOptions& read) {
                       return compiler->compiler.compile_text(path, std::string(or_empty(text), size), read);
                   });
}

patina_status patina_compile_file(const patina_compiler* compiler, const char* path, const char* options,
                                  const patina_callbacks* callbacks, patina_result** result) {
    return compile(path ? compiler : nullptr, options, callbacks, result,
                   [&](const patina::CompileOptions& read) { return compiler->compiler.compile_file(path, read); });
}

patina_status patina_cache_key(const patina_compiler* compiler, const char* path, const char* text, size_t size,
                               const char* options, const patina_callbacks* callbacks, char* key) {
    if (!key) return PATINA_BAD_ARGUMENT;
    *key = '\0';
    if (!compiler || !path || !is_possible(text, size)) return PATINA_BAD_ARGUMENT;
    return guarded([&] {
        patina::CompileOptions read;
        if (!settle(*compiler, options, callbacks, read).empty()) return PATINA_HAS_ERRORS;
        return give(text ? compiler->compiler.cache_key(path, std::string(text, size), read)
                         : compiler->compiler.cache_key(path, read),
                    key);
    });
}

patina_status patina_library_hash(const patina_compiler* compiler, char* key) {
    if (!key) return PATINA_BAD_ARGUMENT;
    *key = '\0';
    if (!compiler) return PATINA_BAD_ARGUMENT;
    return guarded([&] { return give(compiler->compiler.library_hash(), key); });
}

void patina_result_free(patina_result* result) {
    delete result;
}

const char* patina_result_messages(const patina_result* result) {
    return result ? result->messages.c_str() : "";
}

const char* patina_result_diagnostics(const patina_result* result) {
    return result ? result->diagnostics.c_str() : "[]";
}

size_t patina_result_shader_count(const patina_result* result) {
    return result ? result->shaders.size() : 0;
}

const patina_shader* patina_result_shader(const patina_result* result, size_t index) {
    return result && index < result->shaders.size() ? &result->shaders[index] : nullptr;
}

const char* patina_result_reflection(const patina_result* result) {
    return result ? result->reflection.c_str() : "";
}

size_t patina_result_dependency_count(const patina_result* result) {
    return size_of(result ? &result->result.dependencies : nullptr);
}

const char* patina_result_dependency(const patina_result* result, size_t index) {
    return text_at(result ? &result->result.dependencies : nullptr, index);
}

size_t patina_result_missing_count(const patina_result* result) {
    return size_of(result ? &result->result.missing : nullptr);
}

const char* patina_result_missing(const patina_result* result, size_t index) {
    return text_at(result ? &result->result.missing : nullptr, index);
}

}  // extern "C"
