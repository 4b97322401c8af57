#include "compiler/importers/shadergraph/code/hlsl_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/importers/names.h"
#include "compiler/importers/shadergraph/code/condition.h"
#include "compiler/importers/shadergraph/code/engine_words.h"
#include "compiler/importers/shadergraph/code/hlsl_tokens.h"

namespace patina::importers::shadergraph {
namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '\r'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

std::string at_line(std::size_t line, std::string_view text) {
    return fmt::format("line {} of its code: {}", line, text);
}

// Lines keep their numbers.
std::string without_comments(std::string_view text, std::string& error) {
    std::string made;
    std::size_t line = 1;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.substr(i, 2) == "//") {
            i = std::min(text.find('\n', i), text.size());
        } else if (text.substr(i, 2) == "/*") {
            const std::size_t end = text.find("*/", i + 2);
            if (end == text.npos) {
                error = at_line(line, "a comment begins with '/*' and has no end");
                return made;
            }
            made += ' ';
            for (; i < end + 1; ++i)
                if (text[i] == '\n') made += '\n', ++line;
            continue;
        }
        if (i >= text.size()) break;
        made += text[i];
        if (text[i] == '\n') ++line;
    }
    return made;
}

// The lines that the preprocessor leaves; the others are empty.
class Preprocessor {
public:
    std::string run(std::string_view text) {
        std::string made;
        for (std::size_t at = 0; at < text.size() && error.empty();) {
            std::size_t end = std::min(text.find('\n', at), text.size());
            std::string line(trimmed(text.substr(at, end - at)));
            ++line_;
            at = end + 1;
            std::size_t more = 0;
            for (; line.starts_with("#") && line.ends_with("\\") && at < text.size(); ++more) {
                end = std::min(text.find('\n', at), text.size());
                line.back() = ' ';
                line += trimmed(text.substr(at, end - at));
                at = end + 1;
            }
            if (line.starts_with("#"))
                directive(trimmed(std::string_view(line).substr(1)));
            else if (is_open())
                made += line;
            made += std::string(more + 1, '\n');
            line_ += more;
        }
        if (!branches_.empty() && error.empty())
            error = at_line(branches_.back().line, "it has an '#if' without its '#endif'");
        return made;
    }

    Macros macros{};
    std::vector<HlslMacro> defines{};  // those with arguments
    std::string error{};

private:
    struct Branch {
        bool is_open = true, was_open = true;  // this part is taken; one of the parts was
        std::size_t line = 0;
    };
    bool is_open() const { return std::ranges::all_of(branches_, &Branch::is_open); }

    bool holds(std::string_view condition) {
        const Decision made = decided(condition, macros);
        if (!made.error.empty()) error = at_line(line_, "its condition cannot be decided: " + made.error);
        return made.holds;
    }

    void directive(std::string_view text) {
        const std::size_t space = std::min(text.find_first_of(" \t(!"), text.size());
        const std::string_view name = text.substr(0, space), rest = trimmed(text.substr(space));
        if (name == "if" || name == "ifdef" || name == "ifndef") {
            // Nobody asks for what lies in a part that is not taken.
            const bool is_taken =
                is_open() && (name == "if" ? holds(rest) : macros.contains(rest) == (name == "ifdef"));
            branches_.push_back({.is_open = is_taken, .was_open = is_taken || !is_open(), .line = line_});
        } else if (name == "else" || name == "elif" || name == "endif") {
            if (branches_.empty()) {
                error = at_line(line_, fmt::format("it has an '#{}' without its '#if'", name));
                return;
            }
            Branch& last = branches_.back();
            last.is_open = !last.was_open && (name == "else" || (name == "elif" && holds(rest)));
            last.was_open |= last.is_open;
            if (name == "endif") branches_.pop_back();
        } else if (name == "define" && is_open()) {
            const std::size_t stop = std::min(rest.find_first_of(" \t("), rest.size());
            if (stop < rest.size() && rest[stop] == '(')
                defines.push_back({.name = std::string(rest.substr(0, stop)), .text = fmt::format("#define {}", rest)});
            else
                macros[std::string(rest.substr(0, stop))] = trimmed(rest.substr(stop));
        } else if (name == "undef" && is_open()) {
            macros.erase(std::string(rest));
            std::erase_if(defines, [&](const HlslMacro& each) { return each.name == rest; });
        }
        // Includes bring words of the engine; whether one is missed, the compiler says. Pragmas say nothing here.
    }

    std::vector<Branch> branches_{};
    std::size_t line_ = 0;
};

// A bracket that closes nothing, or is not closed.
std::string unbalanced(std::string_view code) {
    std::vector<std::pair<char, std::size_t>> open;
    std::size_t line = 1;
    for (const char c : code) {
        if (c == '\n') ++line;
        const std::size_t kind = std::string_view("({[)}]").find(c);
        if (kind < 3) open.push_back({")}]"[kind], line});
        if (kind == std::string_view::npos || kind < 3) continue;
        if (open.empty() || open.back().first != c) return at_line(line, fmt::format("a '{}' closes nothing", c));
        open.pop_back();
    }
    return open.empty() ? "" : at_line(open.back().second, fmt::format("a '{}' is missing", open.back().first));
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
    {"UNITY_BRANCH", ""},
    {"UNITY_FLATTEN", ""},
    {"UNITY_LOOP", ""},
    {"UNITY_UNROLL", ""},
    {"UnityTexture2D", "Texture2D"},
    {"UnityTextureCube", "TextureCube"},
    {"UnityTexture2DArray", "Texture2DArray"},
    {"UnityTexture3D", "Texture3D"},
    {"UnitySamplerState", "SamplerState"},
};

// The text with the types and numbers of the language, and what stands for the names of macros without arguments.
std::string with_our_words(std::string_view text, const Macros& macros) {
    std::string made;
    for (std::size_t i = 0; i < text.size();) {
        if (is_letter(text[i])) {
            std::size_t end = i;
            while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
            std::string word(text.substr(i, end - i));
            if (const auto macro = macros.find(word); macro != macros.end()) word = macro->second;
            for (const auto& [engine, ours] : kWords)
                if (word == engine) word = ours;
            for (const std::string_view ending : {"_float", "_half"})
                if (word.size() > ending.size() && word.ends_with(ending)) word.resize(word.size() - ending.size());
            made += word;
            i = end;
        } else if (is_digit(text[i]) || (text[i] == '.' && i + 1 < text.size() && is_digit(text[i + 1]))) {
            std::size_t end = i;
            while (end < text.size() &&
                   (is_digit(text[end]) || text[end] == '.' ||
                    ((text[end] == '-' || text[end] == '+') && (text[end - 1] == 'e' || text[end - 1] == 'E')) ||
                    is_letter(text[end])))
                ++end;
            std::string number(text.substr(i, end - i));
            const bool is_hex = number.starts_with("0x");
            const bool is_real = !is_hex && number.find_first_of("fFhH") != number.npos;
            while (!is_hex && !number.empty() &&
                   std::string_view("fFhHlL").find(number.back()) != std::string_view::npos)
                number.pop_back();
            if (is_real && number.find_first_of(".eE") == number.npos) number += ".";
            if (number.ends_with(".")) number += "0";
            made += number;
            i = end;
        } else {
            made += text[i++];
        }
    }
    return made;
}

}  // namespace

std::size_t behind_bracket(std::string_view text, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        if (text[i] == '(') ++depth;
        if (text[i] == ')' && --depth == 0) return i + 1;
    }
    return text.size();
}

bool has_identifier(std::string_view code, std::string_view word) {
    for (std::size_t at = 0; (at = code.find(word, at)) != code.npos; ++at) {
        const bool before = at > 0 && (is_letter(code[at - 1]) || is_digit(code[at - 1]));
        const std::size_t end = at + word.size();
        if (!before && (end == code.size() || (!is_letter(code[end]) && !is_digit(code[end])))) return true;
    }
    return false;
}

std::vector<std::size_t> argument_counts(std::string_view code, std::string_view function) {
    std::vector<std::size_t> made;
    for (std::size_t at = 0; (at = code.find(function, at)) != code.npos; at += function.size()) {
        const std::size_t before = at > 0 ? at - 1 : 0, open = code.find_first_not_of(" \n", at + function.size());
        const bool is_call = open != code.npos && code[open] == '(' &&
                             has_identifier(code.substr(before, at + function.size() + 1 - before), function);
        if (!is_call) continue;
        const std::size_t end = behind_bracket(code, open);
        made.push_back(terms::arguments_of(code.substr(open + 1, end - open - 2)).size());
    }
    return made;
}

HlslText in_node_language(std::string_view hlsl) {
    HlslText made;
    std::string text = without_comments(hlsl, made.error);
    for (std::size_t at = 0; (at = text.find("$precision", at)) != text.npos;) text.replace(at, 10, "float");
    Preprocessor preprocessor;
    text = preprocessor.run(text);
    const Macros& macros = preprocessor.macros;
    if (made.error.empty()) made.error = preprocessor.error;
    if (made.error.empty()) made.error = unbalanced(text);
    if (!made.error.empty()) return made;
    made.code = with_our_words(text, macros);
    for (HlslMacro& each : preprocessor.defines) {
        each.text = with_our_words(each.text, macros);
        with_engine_words(each.text, made.parameters);
        made.macros.push_back(std::move(each));
    }
    with_engine_words(made.code, made.parameters);
    return made;
}

bool assigns(std::string_view code, std::string_view variable) {
    if (variable.empty()) return false;
    for (std::size_t at = 0; (at = code.find(variable, at)) != code.npos; at += variable.size()) {
        const std::size_t behind = at + variable.size();
        if (!has_identifier(code.substr(at > 0 ? at - 1 : 0, variable.size() + (at > 0 ? 2 : 1)), variable)) continue;
        // "Out.xy[0] +=", or an argument of a function.
        std::size_t i = behind;
        while (i < code.size() && (is_letter(code[i]) || is_digit(code[i]) ||
                                   std::string_view(" .[]\n").find(code[i]) != std::string_view::npos))
            ++i;
        const std::string_view rest = code.substr(i, 2);
        if (rest.starts_with(",") || rest.starts_with(")")) return true;
        if (rest.starts_with("=") && rest != "==") return true;
        if (rest.size() == 2 && (rest[1] == '=' || rest[1] == rest[0]) &&
            std::string_view("+-*/").find(rest[0]) != std::string_view::npos)
            return true;
    }
    return false;
}

// "in float3 A, const float B" -> "float3 A, float B": both say only what a parameter is anyway.
static std::string without_qualifiers(std::string parameters) {
    for (const std::string_view word : {"in", "const"})
        for (std::size_t at = 0; (at = parameters.find(word, at)) != parameters.npos;) {
            const std::size_t end = at + word.size();
            const bool is_word = (at == 0 || !(is_letter(parameters[at - 1]) || is_digit(parameters[at - 1]))) &&
                                 end < parameters.size() && parameters[end] == ' ';
            is_word ? static_cast<void>(parameters.erase(at, word.size() + 1)) : static_cast<void>(at = end);
        }
    return parameters;
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
                                .parameters = without_qualifiers(head.substr(open + 1, close - open - 1)),
                                .body = std::string(code.substr(i + 1, end - i - 2))});
        }
        i = end - 1;
        begin = end;
    }
    return made;
}

}  // namespace patina::importers::shadergraph
