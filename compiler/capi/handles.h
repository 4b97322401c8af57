// The objects behind the pointers of patina/patina_c.h, and what all of its functions share: exceptions become
// statuses, and impossible sizes are refused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "compiler/base/made_once.h"
#include "patina/patina.h"
#include "patina/patina_c.h"
#include "patina/variants.h"

namespace patina::capi {

// A list as C sees it, and the texts that its pointers lead to.
template <class Entry>
struct List {
    std::vector<std::string> texts{};
    std::vector<Entry> entries{};
};

}  // namespace patina::capi

struct patina_compiler {
    patina::Compiler compiler;
    // Made when they are asked for.
    patina::MadeOnce<patina::capi::List<patina_node>> nodes{};
    patina::MadeOnce<patina::capi::List<patina_path>> paths{};
    patina::MadeOnce<patina::capi::List<patina_engine>> engines{};
};

struct patina_result {
    patina::Result result{};
    std::string messages{}, diagnostics{}, reflection{};
    std::vector<patina_shader> shaders{};
};

namespace patina::capi {

inline const char* or_empty(const char* text) {
    return text ? text : "";
}

// A list of texts of an object; null: there is no object.
inline std::size_t size_of(const std::vector<std::string>* texts) {
    return texts ? texts->size() : 0;
}
// Null behind the end.
inline const char* text_at(const std::vector<std::string>* texts, std::size_t index) {
    return texts && index < texts->size() ? (*texts)[index].c_str() : nullptr;
}

// False for what no object in memory can be.
inline bool is_possible(const void* begin, std::size_t count, std::size_t size_of_one = 1) {
    return (begin || count == 0) && count <= static_cast<std::size_t>(PTRDIFF_MAX) / size_of_one;
}

// Runs `work`, which may throw as C++ does.
template <class Work>
patina_status guarded(const Work& work) noexcept {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return PATINA_OUT_OF_MEMORY;
    } catch (...) {
        return PATINA_INTERNAL_ERROR;
    }
}

// Throws std::bad_alloc if the diagnostics say that there is not enough memory: in C that is a status.
void refuse_without_memory(bool ok, std::span<const Diagnostic> diagnostics);
// The texts of diagnostics: for people, and as a JSON array.
std::string messages_of(std::span<const Diagnostic> diagnostics);
std::string json_of(std::span<const Diagnostic> diagnostics);
// Fills in what the functions return of a result. The texts of its shaders stay where they are.
void complete(patina_result& made);

// Reads the options, and sets the callbacks. Returns what is wrong with the text.
std::vector<Diagnostic> settle(const patina_compiler& compiler, const char* options_text,
                               const patina_callbacks* callbacks, CompileOptions& options);

}  // namespace patina::capi
