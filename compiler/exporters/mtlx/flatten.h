// The surface as one function: calls become the bodies of what they call, but for functions that a document can name.
#pragma once

#include <optional>

#include "compiler/ir/ir.h"

namespace patina::exporters::mtlx {

// How a normal map is read: two functions of the library that a document has one node for.
inline constexpr std::string_view kUnpackNormal = "UnpackNormalRedGreen", kToWorld = "NormalTangentToWorld";

// Nothing: the function would be too long.
std::optional<ir::Function> flatten(ir::Module& module, const ir::Function& function);

}  // namespace patina::exporters::mtlx
