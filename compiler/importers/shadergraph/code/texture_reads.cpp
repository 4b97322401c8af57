#include "compiler/importers/shadergraph/code/texture_reads.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "compiler/importers/names.h"

namespace patina::importers::shadergraph {
namespace {

bool is_of_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// The first place of the word, from `from` on.
std::size_t find_word(std::string_view code, std::string_view word, std::size_t from) {
    for (std::size_t at = from; (at = code.find(word, at)) != code.npos; ++at) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_of_word(code[at - 1])) && (end == code.size() || !is_of_word(code[end]))) return at;
    }
    return code.npos;
}

// The word that ends before `end`.
std::string_view word_before(std::string_view code, std::size_t end) {
    std::size_t begin = end;
    while (begin > 0 && is_of_word(code[begin - 1])) --begin;
    return code.substr(begin, end - begin);
}

// A macro's arguments are a texture, a sampler, a place, and then, of an array, a layer.
struct Macro {
    std::string_view name, method;
    bool is_flat = true, has_layer = false;
};
constexpr Macro kMacros[] = {
    {"SAMPLE_TEXTURE2D", "Sample"},
    {"SAMPLE_TEXTURE2D_BIAS", "SampleBias"},
    {"SAMPLE_TEXTURE2D_LOD", "SampleLevel"},
    {"SAMPLE_TEXTURE2D_GRAD", "SampleGrad"},
    {"SAMPLE_TEXTURE2D_ARRAY", "Sample", true, true},
    {"SAMPLE_TEXTURE2D_ARRAY_LOD", "SampleLevel", true, true},
    {"SAMPLE_TEXTURECUBE", "Sample", false},
    {"SAMPLE_TEXTURECUBE_LOD", "SampleLevel", false},
};

std::string call_of(const Macro& macro, std::vector<std::string> arguments) {
    std::string& place = arguments[2];
    if (macro.is_flat) place = fmt::format("float2(0, 1) + float2(1, -1) * ({})", place);
    if (macro.has_layer) {
        place = fmt::format("float3({}, {})", place, arguments[3]);
        arguments.erase(arguments.begin() + 3);
    }
    std::string made = fmt::format("{}.{}({}, {}", arguments[0], macro.method, arguments[1], place);
    for (std::size_t i = 3; i < arguments.size(); ++i) made += ", " + arguments[i];
    return made + ")";
}

// Behind the bracket that closes the one at `open`.
std::size_t behind_bracket(std::string_view code, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < code.size(); ++i) {
        if (code[i] == '(') ++depth;
        if (code[i] == ')' && --depth == 0) return i + 1;
    }
    return code.npos;
}

void replace_macro(std::string& code, const Macro& macro) {
    for (std::size_t at = 0; (at = find_word(code, macro.name, at)) != code.npos; ++at) {
        const std::size_t open = code.find_first_not_of(" \t\n", at + macro.name.size());
        const std::size_t end = open == code.npos || code[open] != '(' ? code.npos : behind_bracket(code, open);
        if (end == code.npos) continue;
        const std::string_view list = std::string_view(code).substr(open + 1, end - open - 2);
        std::vector<std::string> arguments = terms::arguments_of(list);
        if (arguments.size() < (macro.has_layer ? 4u : 3u)) continue;
        code.replace(at, end - at, call_of(macro, std::move(arguments)));
    }
}

}  // namespace

std::string with_texture_reads(std::string code, std::set<std::string, std::less<>> samplers) {
    constexpr std::string_view kType = "SamplerState", kMember = "samplerstate";
    for (std::size_t at = 0; (at = find_word(code, kType, at)) != code.npos; ++at) {
        const std::size_t begin = code.find_first_not_of(" \t\n", at + kType.size());
        std::size_t end = std::min(begin, code.size());
        while (end < code.size() && is_of_word(code[end])) ++end;
        samplers.emplace(word_before(code, end));
    }
    for (std::size_t at = 0; (at = find_word(code, kMember, at)) != code.npos;) {
        if (at == 0 || code[at - 1] != '.') {
            at += kMember.size();
            continue;
        }
        const bool is_sampler = samplers.contains(word_before(code, at - 1));
        code.replace(is_sampler ? at - 1 : at, kMember.size() + (is_sampler ? 1 : 0), is_sampler ? "" : "sampler");
    }
    for (std::size_t at = 0; (at = find_word(code, "tex", at)) != code.npos;)
        at > 0 && code[at - 1] == '.' ? static_cast<void>(code.erase(at - 1, 4)) : static_cast<void>(at += 3);
    for (const Macro& macro : kMacros) replace_macro(code, macro);
    return code;
}

}  // namespace patina::importers::shadergraph
