// The code of a custom function for a node file that is read by HLSL's rules: what the preprocessor leaves, without the
// engine's words for types and numbers. The compiler decides if the result is valid.
//
//   HlslText text = in_node_language("#ifdef SHADERGRAPH_PREVIEW\nOut = 1;\n#else\nOut = A * 2.0h;\n#endif");
//   text.code;   // "Out = A * 2.0;"
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace patina::importers::shadergraph {

// A macro with arguments.
struct HlslMacro {
    std::string name{}, text{};  // "#define NAME(x) ..."
};
struct HlslText {
    std::string code{};
    std::vector<HlslMacro> macros{};
    std::string parameters{};  // that the code needs for values of the engine: "[hidden] float engineTime = time"
    std::string error{};  // what cannot be said in the node language, and in which line; empty: nothing of this kind
};
HlslText in_node_language(std::string_view hlsl);

struct HlslFunction {
    std::string result{}, name{}, parameters{}, body{};  // "void", "Noise_float", "float2 UV, out float Out", "..."
};
// The functions that a text defines, in order.
std::vector<HlslFunction> functions_in(std::string_view code);

// Something is assigned to the variable, or a function takes it.
bool assigns(std::string_view code, std::string_view variable);

// How many arguments each call of the function has.
std::vector<std::size_t> argument_counts(std::string_view code, std::string_view function);

// Behind the bracket that closes the one at `open`.
std::size_t behind_bracket(std::string_view text, std::size_t open);

// The word stands in the code by itself.
bool has_identifier(std::string_view code, std::string_view word);

}  // namespace patina::importers::shadergraph
