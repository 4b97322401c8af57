// Whether the body of a function is well-formed HLSL. It knows the grammar of statements and expressions, and no names
// and types: what a name stands for, the compiler or the engine says.
//
//   syntax_error("Out = In * ;")->text;   // "a value is missing before ';'"
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace patina::importers::shadergraph {

struct SyntaxError {
    int line = 0;        // of the body, from 1
    std::string text{};  // "a value is missing before ';'"
};
std::optional<SyntaxError> syntax_error(std::string_view body);

}  // namespace patina::importers::shadergraph
