// Values of shader graphs on their way from slot to slot.
#pragma once

#include <span>

#include "compiler/importers/shadergraph/values/types.h"
#include "compiler/importers/terms.h"

namespace patina::importers::shadergraph {

// A vector of numbers and vectors, which are as many components as its type has: "float3(a, b.xy)". Constants, and
// components of one vector that are together again, become shorter: "a.xyz".
Term vector_term(Type type, std::span<const Term> arguments);

}  // namespace patina::importers::shadergraph
