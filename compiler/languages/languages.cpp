// Lists all languages. A language is a row here and a folder of its own.
#include <algorithm>

#include "compiler/languages/glsl/glsl.h"
#include "compiler/languages/hlsl/hlsl.h"
#include "compiler/languages/print.h"

namespace patina::languages {
namespace {

constexpr LanguageInfo kLanguages[] = {
    {.name = "glsl", .extension = "glsl", .legalize = glsl::legalize, .print = glsl::print},
    {.name = "hlsl", .extension = "hlsl", .legalize = hlsl::legalize, .print = hlsl::print, .takes_foreign = true},
};

}  // namespace

std::span<const LanguageInfo> all_languages() {
    return kLanguages;
}

const LanguageInfo* find_language(std::string_view name) {
    const auto found = std::find_if(std::begin(kLanguages), std::end(kLanguages),
                                    [&](const LanguageInfo& t) { return t.name == name; });
    return found == std::end(kLanguages) ? nullptr : found;
}

}  // namespace patina::languages
