// What HLSL lets its authors leave out, written out for the node language: conversions of numbers, sizes that are cut,
// several variables of one declaration, "x++", "sincos". The text stays as it is in all other places, and wherever a
// type is not known.
//
//   "float2 a = In, b = 1; Out = a * i;"   ->   "float2 a = In.xy; float2 b = 1; Out = a * float(i);"
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/importers/shadergraph/code/hlsl_text.h"

namespace patina::importers::shadergraph {

// The function's body. `others` are those that it may call. `values` are more parameters.
std::string with_conversions(const HlslFunction& function, const std::vector<HlslFunction>& others,
                             std::string_view values);

// The functions that such bodies call, as text of the node language.
std::string functions_for_conversions(std::string_view body);

}  // namespace patina::importers::shadergraph
