#include "compiler/importers/shadergraph/code/hlsl_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "compiler/base/text.h"

namespace patina::importers::shadergraph {
namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '\r'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

std::string without_comments(std::string_view text) {
    std::string made;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.substr(i, 2) == "//") {
            while (i < text.size() && text[i] != '\n') ++i;
            if (i < text.size()) made += '\n';
        } else if (text.substr(i, 2) == "/*") {
            const std::size_t end = text.find("*/", i + 2);
            made += ' ';
            i = end == text.npos ? text.size() : end + 1;
        } else {
            made += text[i];
        }
    }
    return made;
}

using Macros = std::map<std::string, std::string, std::less<>>;

// A condition of the preprocessor: "defined(A) && !B", "X", "0". Nothing is defined but what the text defines: the
// engine's own words are for its previews and its pipelines.
bool condition(std::string_view text, const Macros& macros) {
    text = trimmed(text);
    for (const std::string_view op : {"||", "&&"}) {
        int depth = 0;
        for (std::size_t i = 0; i + 1 < text.size(); ++i) {
            if (text[i] == '(') ++depth;
            if (text[i] == ')') --depth;
            if (depth > 0 || text.substr(i, 2) != op) continue;
            const bool left = condition(text.substr(0, i), macros), right = condition(text.substr(i + 2), macros);
            return op == "||" ? left || right : left && right;
        }
    }
    if (text.starts_with("!")) return !condition(text.substr(1), macros);
    if (text.starts_with("(") && text.ends_with(")")) return condition(text.substr(1, text.size() - 2), macros);
    if (text.starts_with("defined")) {
        std::string_view name = trimmed(text.substr(7));
        if (name.starts_with("(") && name.ends_with(")")) name = trimmed(name.substr(1, name.size() - 2));
        return macros.contains(name);
    }
    if (const auto found = macros.find(text); found != macros.end()) text = found->second;
    return !text.empty() && is_digit(text[0]) && text.find_first_not_of("0.") != text.npos;
}

// The lines that the preprocessor leaves.
std::string preprocessed(std::string_view text, Macros& macros, std::string& error) {
    struct Branch {
        bool is_open = true, was_open = true;  // this part is taken; one of the parts was
    };
    std::vector<Branch> branches;
    std::string made;
    const auto decided = [&](std::string_view asked) {
        constexpr std::size_t kLongest = 1000;  // condition() calls itself
        if (asked.size() <= kLongest) return condition(asked, macros);
        error = "a condition of its preprocessor is too long";
        return false;
    };
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = trimmed(text.substr(at, end - at));
        at = end + 1;
        const bool is_open = std::ranges::all_of(branches, &Branch::is_open);
        if (!line.starts_with("#")) {
            if (is_open) made += std::string(line) + "\n";
            continue;
        }
        const std::string_view word = trimmed(line.substr(1));
        const std::size_t space = std::min(word.find_first_of(" \t("), word.size());
        const std::string_view name = word.substr(0, space), rest = trimmed(word.substr(space));
        if (name == "if" || name == "ifdef" || name == "ifndef") {
            const bool holds = name == "if" ? decided(rest) : macros.contains(rest) == (name == "ifdef");
            branches.push_back({.is_open = holds, .was_open = holds});
        } else if ((name == "else" || name == "elif") && !branches.empty()) {
            Branch& last = branches.back();
            last.is_open = !last.was_open && (name == "else" || decided(rest));
            last.was_open |= last.is_open;
        } else if (name == "endif" && !branches.empty()) {
            branches.pop_back();
        } else if (name == "define" && is_open) {
            const std::size_t stop = std::min(rest.find_first_of(" \t("), rest.size());
            if (stop < rest.size() && rest[stop] == '(') {
                error = fmt::format("it has the macro '{}' with arguments", rest.substr(0, stop));
                continue;
            }
            macros[std::string(rest.substr(0, stop))] = std::string(trimmed(rest.substr(stop)));
        }
        // Includes bring words of the engine; whether one is missed, the compiler says. Pragmas say nothing here.
    }
    if (!branches.empty() && error.empty()) error = "it has an '#if' without its '#endif'";
    return made;
}

// Names of the engine for types of the language.
constexpr std::pair<std::string_view, std::string_view> kWords[] = {
    {"real", "float"},
    {"real2", "float2"},
    {"real3", "float3"},
    {"real4", "float4"},
    {"fixed", "half"},
    {"fixed2", "half2"},
    {"fixed3", "half3"},
    {"fixed4", "half4"},
    {"min16float", "half"},
    {"dword", "uint"},
    {"UnityTexture2D", "Texture2D"},
    {"UnityTextureCube", "TextureCube"},
};

// Calls and values of the engine: what stands for them, and the parameter that brings it.
struct EngineWord {
    std::string_view word;
    bool is_call;  // its arguments are dropped, or, if `keeps` is true, kept
    bool keeps;
    std::string_view ours, parameter;
};
constexpr EngineWord kEngine[] = {
    {"GetMainLight", true, false, "engineLight", "[hidden] Light engineLight = light"},
    {"TransformWorldToShadowCoord", true, false, "float4(0)", ""},
    {"SampleSH", true, true, "AmbientIrradiance", ""},
    {"distanceAttenuation", false, false, "attenuation", ""},
    {"shadowAttenuation", false, false, "shadow", ""},
    {"_WorldSpaceCameraPos", false, false, "engineCamera", "[hidden] float3 engineCamera = cameraPositionWS"},
    {"_Time", false, false, "float4(0.05, 1, 2, 3) * engineTime", "[hidden] float engineTime = time"},
    {"_ScreenParams", false, false, "engineScreen.xyxy", "[hidden] float2 engineScreen = screenSize"},
};

// Behind the bracket that closes the one at `open`.
std::size_t behind_bracket(std::string_view text, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        if (text[i] == '(') ++depth;
        if (text[i] == ')' && --depth == 0) return i + 1;
    }
    return text.size();
}

void use_engine_words(HlslText& text) {
    for (const EngineWord& each : kEngine) {
        bool is_used = false;
        for (std::size_t at = 0; (at = text.code.find(each.word, at)) != text.code.npos;) {
            std::size_t end = at + each.word.size();
            const bool is_word =
                has_identifier(std::string_view(text.code).substr(at, each.word.size() + 1), each.word) &&
                (at == 0 || (!is_letter(text.code[at - 1]) && !is_digit(text.code[at - 1])));
            if (!is_word) {
                at = end;
                continue;
            }
            is_used = true;
            const std::size_t open = text.code.find_first_not_of(' ', end);
            if (each.is_call && !each.keeps && open != text.code.npos && text.code[open] == '(')
                end = behind_bracket(text.code, open);
            const bool is_member = end < text.code.size() && text.code[end] == '.';
            const std::string ours = is_member && each.ours.find(' ') != each.ours.npos ? fmt::format("({})", each.ours)
                                                                                        : std::string(each.ours);
            text.code.replace(at, end - at, ours);
            at += ours.size();
        }
        if (is_used && !each.parameter.empty())
            text.parameters += (text.parameters.empty() ? "" : ", ") + std::string(each.parameter);
    }
}

}  // namespace

bool has_identifier(std::string_view code, std::string_view word) {
    for (std::size_t at = 0; (at = code.find(word, at)) != code.npos; ++at) {
        const bool before = at > 0 && (is_letter(code[at - 1]) || is_digit(code[at - 1]));
        const std::size_t end = at + word.size();
        if (!before && (end == code.size() || (!is_letter(code[end]) && !is_digit(code[end])))) return true;
    }
    return false;
}

HlslText in_node_language(std::string_view hlsl) {
    HlslText made;
    Macros macros;
    std::string text = without_comments(hlsl);
    for (std::size_t at = 0; (at = text.find("$precision", at)) != text.npos;) text.replace(at, 10, "float");
    text = preprocessed(text, macros, made.error);
    for (std::size_t i = 0; i < text.size();) {
        if (is_letter(text[i])) {
            std::size_t end = i;
            while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
            std::string word = text.substr(i, end - i);
            if (const auto macro = macros.find(word); macro != macros.end()) word = macro->second;
            for (const auto& [engine, ours] : kWords)
                if (word == engine) word = ours;
            for (const std::string_view ending : {"_float", "_half"})
                if (word.size() > ending.size() && word.ends_with(ending)) word.resize(word.size() - ending.size());
            made.code += word;
            i = end;
        } else if (is_digit(text[i]) || (text[i] == '.' && i + 1 < text.size() && is_digit(text[i + 1]))) {
            std::size_t end = i;
            while (end < text.size() &&
                   (is_digit(text[end]) || text[end] == '.' ||
                    ((text[end] == '-' || text[end] == '+') && (text[end - 1] == 'e' || text[end - 1] == 'E')) ||
                    is_letter(text[end])))
                ++end;
            std::string number = text.substr(i, end - i);
            const bool is_hex = number.starts_with("0x");
            while (!is_hex && !number.empty() &&
                   std::string_view("fFhHlL").find(number.back()) != std::string_view::npos)
                number.pop_back();
            if (number.ends_with(".")) number += "0";
            made.code += number;
            i = end;
        } else {
            made.code += text[i++];
        }
    }
    use_engine_words(made);
    return made;
}

std::vector<HlslFunction> functions_in(std::string_view code) {
    std::vector<HlslFunction> made;
    std::size_t begin = 0;  // of the declaration
    for (std::size_t i = 0; i < code.size(); ++i) {
        if (code[i] == ';') begin = i + 1;
        if (code[i] != '{') continue;
        std::size_t depth = 1, end = i + 1;
        while (end < code.size() && depth > 0) {
            depth += code[end] == '{' ? 1 : 0;
            depth -= code[end] == '}' ? 1 : 0;
            ++end;
        }
        std::string head(code.substr(begin, i - begin));
        std::replace(head.begin(), head.end(), '\n', ' ');
        const std::size_t open = head.find('('), close = head.rfind(')');
        if (open != head.npos && close != head.npos && close > open) {
            const std::vector<std::string_view> words = split(std::string_view(head).substr(0, open), " ");
            if (words.size() >= 2)
                made.push_back({.result = std::string(words[words.size() - 2]),
                                .name = std::string(words.back()),
                                .parameters = head.substr(open + 1, close - open - 1),
                                .body = std::string(code.substr(i + 1, end - i - 2))});
        }
        i = end - 1;
        begin = end;
    }
    return made;
}

}  // namespace patina::importers::shadergraph
