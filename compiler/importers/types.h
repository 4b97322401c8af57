// Types of the values on their way from node to node of an imported material.
#pragma once

#include <cstddef>
#include <string_view>

namespace patina::importers::terms {

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

bool is_vector(Type type);  // also a number, not a bool
bool is_matrix(Type type);
bool is_texture(Type type);
bool is_value(Type type);      // a bool, a number, a vector or a matrix
std::size_t width(Type type);  // components of a vector, rows of a matrix; of a bool 1
Type vector_type(std::size_t width);
Type matrix_type(std::size_t rows);
std::string_view word(Type type);  // in the node language: "float3"

}  // namespace patina::importers::terms
