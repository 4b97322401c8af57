#include "compiler/importers/shadergraph/code/unknown_words.h"

#include <algorithm>
#include <set>

#include "compiler/importers/shadergraph/code/hlsl_tokens.h"

namespace patina::importers::shadergraph {
namespace {

constexpr std::string_view kWords[] = {
    // statements
    "break", "case", "const", "continue", "default", "do", "else", "false", "for", "if", "return", "static", "struct",
    "switch", "true", "while", "in", "out", "inout", "unroll", "loop", "branch", "flatten", "uniform", "row_major",
    "column_major", "precise",
    // functions
    "abs", "acos", "all", "any", "asfloat", "asin", "asint", "asuint", "atan", "atan2", "ceil", "clamp", "cos", "cosh",
    "countbits", "cross", "ddx", "ddx_coarse", "ddx_fine", "ddy", "ddy_coarse", "ddy_fine", "degrees", "determinant",
    "distance", "dot", "dst", "exp", "exp2", "f16tof32", "f32tof16", "faceforward", "firstbithigh", "firstbitlow",
    "floor", "fma", "fmod", "frac", "frexp", "fwidth", "isfinite", "isinf", "isnan", "ldexp", "length", "lerp", "lit",
    "log", "log10", "log2", "mad", "max", "min", "modf", "mul", "normalize", "pow", "radians", "rcp", "reflect",
    "refract", "reversebits", "round", "rsqrt", "saturate", "sign", "sin", "sincos", "sinh", "smoothstep", "sqrt",
    "step", "tan", "tanh", "transpose", "trunc"};

// "float", "int2", "half3x4"
bool is_type(std::string_view word) {
    for (const std::string_view scalar : {"float", "half", "int", "uint", "bool", "double"})
        if (word.starts_with(scalar))
            return word.substr(scalar.size()).find_first_not_of("1234x") == std::string_view::npos;
    return false;
}

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> made;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at + 1;
        if (is_letter(text[at]))
            while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
        else if (is_digit(text[at]))
            while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]) || text[end] == '.')) ++end;
        if (std::string_view(" \t\r\n").find(text[at]) == std::string_view::npos)
            made.push_back(text.substr(at, end - at));
        at = end;
    }
    return made;
}

// What the text declares: "float a = 1, b[2];" declares a and b.
std::set<std::string_view> declared_in(const std::vector<std::string_view>& tokens) {
    std::set<std::string_view> made;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (!is_type(tokens[i]) || !is_letter(tokens[i + 1][0])) continue;
        int depth = 0;
        bool is_name = true;
        for (std::size_t k = i + 1; k < tokens.size() && tokens[k] != ";" && depth >= 0; ++k) {
            if (is_name) made.insert(tokens[k]);
            const char c = tokens[k][0];
            if (c == '(' || c == '[' || c == '{') ++depth;
            if (c == ')' || c == ']' || c == '}') --depth;
            is_name = c == ',' && depth == 0;
        }
    }
    return made;
}

}  // namespace

std::string unknown_word(std::string_view body, const std::vector<std::string>& known) {
    const std::vector<std::string_view> tokens = words_of(body);
    const std::set<std::string_view> declared = declared_in(tokens);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string_view word = tokens[i];
        const bool is_member = i > 0 && tokens[i - 1] == ".";
        if (!is_letter(word[0]) || is_member || is_type(word) || declared.contains(word)) continue;
        if (std::ranges::find(kWords, word) != std::end(kWords)) continue;
        if (std::ranges::find(known, word) == known.end()) return std::string(word);
    }
    return {};
}

}  // namespace patina::importers::shadergraph
