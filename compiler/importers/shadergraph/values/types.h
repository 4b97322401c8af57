// Types of shader graphs' slots, and the rules by which a dynamic slot gets one.
#pragma once

#include <span>
#include <string_view>

namespace patina::importers::shadergraph {

enum class Type {
    None,
    Bool,
    Float,
    Float2,
    Float3,
    Float4,
    Matrix2,
    Matrix3,
    Matrix4,
    Texture2D,
    Texture2DArray,
    Texture3D,
    Cubemap,
    Sampler,
    Gradient,
    Connection,  // whether an input of a sub-graph is connected
    VirtualTexture
};
// How a slot's type follows from what is connected to its node.
enum class Dynamic { No, Vector, Value, Matrix };

struct SlotType {
    Type type = Type::None;  // of a dynamic slot: if nothing is connected
    Dynamic dynamic = Dynamic::No;
};
SlotType type_of_slot(std::string_view kind);  // "Vector3", "DynamicVector", "Texture2DInput"
Type type_of_property(std::string_view kind);  // "Color", "Vector1"

bool is_vector(Type type);  // also a number, not a bool
bool is_matrix(Type type);
bool is_texture(Type type);
bool is_value(Type type);      // a bool, a number, a vector or a matrix
std::size_t width(Type type);  // components of a vector, rows of a matrix; of a bool 1
Type vector_type(std::size_t width);
Type matrix_type(std::size_t rows);
std::string_view word(Type type);  // in the node language: "float3"

// The type of dynamic slots, from the types of what is connected to them.
Type dynamic_vector(std::span<const Type> connected);
Type dynamic_matrix(std::span<const Type> connected);

}  // namespace patina::importers::shadergraph
