// How the names and comments that the compiler makes are spelled: camelCase, from words that have a spelling already.
// It is no table of taken names; languages/names.h is.
//
//   camel_case("DistributionGGX")      // distributionGGX
//   joined("vertex", "positionOS")     // vertexPositionOS
//   numbered("albedo", 2)              // albedo2
#pragma once

#include <string>
#include <string_view>

namespace patina {

// "LightingSurface" -> "lightingSurface", "GGXTerm" -> "ggxTerm", "FORWARD_DELTA" -> "forwardDelta"
std::string camel_case(std::string_view name);

// The second word begins with a capital: "out", "color" -> "outColor". An underscore at its front stays: "own", "_Tint"
// -> "own_Tint".
std::string joined(std::string_view first, std::string_view second);

// The number stands behind the name. Behind a digit it needs an underscore: "uv0", 2 -> "uv0_2".
std::string numbered(std::string_view name, unsigned number);

// "a random number" -> "A random number."
std::string sentence(std::string_view words);

// Of the words of a camelCase name: "lightingSurface" -> "ls".
std::string initials(std::string_view name);

}  // namespace patina
