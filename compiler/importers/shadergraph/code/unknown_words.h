// Words of a function's text that neither the text declares nor HLSL has: they come from files that the text includes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace patina::importers::shadergraph {

// The first such word of the body; empty: there is none. `known`: names of parameters and of other functions.
std::string unknown_word(std::string_view body, const std::vector<std::string>& known);

}  // namespace patina::importers::shadergraph
