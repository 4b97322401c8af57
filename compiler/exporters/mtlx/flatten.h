// The surface as one function: calls become the bodies of what they call, but for functions that a document can name,
// and a node of the vertex stage becomes what it computes.
#pragma once

#include <optional>

#include "compiler/lower/lower.h"

namespace patina::exporters::mtlx {

// How a normal map is read: two functions of the library that a document has one node for.
inline constexpr std::string_view kUnpackNormal = "UnpackNormalRedGreen", kToWorld = "NormalTangentToWorld";

// MaterialX has a node for it (calls.cpp).
bool has_node(std::string_view function);

// Nothing: the function would be too long.
std::optional<ir::Function> flatten(lower::Lowered& lowered, const ir::Function& function);

}  // namespace patina::exporters::mtlx
