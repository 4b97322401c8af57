// Types of shader graphs' slots, and the rules by which a dynamic slot gets one.
#pragma once

#include <span>
#include <string_view>

#include "compiler/importers/types.h"

namespace patina::importers::shadergraph {

using namespace terms;

// How a slot's type follows from what is connected to its node.
enum class Dynamic { No, Vector, Value, Matrix };

struct SlotType {
    Type type = Type::None;  // of a dynamic slot: if nothing is connected
    Dynamic dynamic = Dynamic::No;
};
SlotType type_of_slot(std::string_view kind);  // "Vector3", "DynamicVector", "Texture2DInput"
Type type_of_property(std::string_view kind);  // "Color", "Vector1"

// The type of dynamic slots, from the types of what is connected to them.
Type dynamic_vector(std::span<const Type> connected);
Type dynamic_matrix(std::span<const Type> connected);

}  // namespace patina::importers::shadergraph
