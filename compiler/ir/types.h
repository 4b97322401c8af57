// The types of the IR, as small values that compare by ==. Structs and arrays refer to tables of their Module.
// A type never appears in an op's name: `Add` of two half3 is Add with type half3.
//
//   Type::vector(Scalar::Float, 3)      float3
//   Type::scalar_of(Scalar::Bool)       bool
#pragma once

#include <cstdint>
#include <functional>

#include "compiler/base/ids.h"

namespace patina::ir {

enum class Scalar : std::uint8_t { Bool, Int, Uint, Half, Float };

enum class Kind : std::uint8_t {
    Void,
    Numeric,  // scalar (rows = cols = 1), vector (rows = width, cols = 1) or matrix (rows x cols, Half or Float)
    Array,    // ref: Module::arrays
    Struct,   // ref: Module::structs
    Texture2D,
    TextureCube,
    Texture2DArray,
    Texture3D,
    Sampler,
    Error,  // the type of a value that could not be made; silences what follows from it
};

struct Type {
    Kind kind = Kind::Void;
    Scalar scalar = Scalar::Float;
    std::uint8_t rows = 1;
    std::uint8_t cols = 1;
    std::uint32_t ref = 0;

    friend constexpr bool operator==(Type, Type) = default;

    static constexpr Type none() { return {}; }
    static constexpr Type error() { return {.kind = Kind::Error}; }
    static constexpr Type scalar_of(Scalar s) { return {.kind = Kind::Numeric, .scalar = s}; }
    static constexpr Type vector(Scalar s, unsigned width) {
        return {.kind = Kind::Numeric, .scalar = s, .rows = static_cast<std::uint8_t>(width)};
    }
    static constexpr Type matrix(Scalar s, unsigned rows, unsigned cols) {
        return {.kind = Kind::Numeric,
                .scalar = s,
                .rows = static_cast<std::uint8_t>(rows),
                .cols = static_cast<std::uint8_t>(cols)};
    }
    static constexpr Type structure(std::uint32_t index) { return {.kind = Kind::Struct, .ref = index}; }
    static constexpr Type array(std::uint32_t index) { return {.kind = Kind::Array, .ref = index}; }
    static constexpr Type of(Kind opaque) { return {.kind = opaque}; }

    constexpr bool is_numeric() const { return kind == Kind::Numeric; }
    constexpr bool is_scalar() const { return is_numeric() && rows == 1 && cols == 1; }
    constexpr bool is_vector() const { return is_numeric() && rows > 1 && cols == 1; }
    constexpr bool is_matrix() const { return is_numeric() && cols > 1; }
    constexpr bool is_floating() const { return is_numeric() && (scalar == Scalar::Half || scalar == Scalar::Float); }
    constexpr bool is_integer() const { return is_numeric() && (scalar == Scalar::Int || scalar == Scalar::Uint); }
    constexpr bool is_bool() const { return is_numeric() && scalar == Scalar::Bool; }
    constexpr bool is_texture() const {
        return kind == Kind::Texture2D || kind == Kind::TextureCube || kind == Kind::Texture2DArray ||
               kind == Kind::Texture3D;
    }
    constexpr bool is_opaque() const { return is_texture() || kind == Kind::Sampler; }
    constexpr bool is_error() const { return kind == Kind::Error; }
    // Width of a scalar or vector.
    constexpr unsigned width() const { return rows; }
    constexpr unsigned components() const { return static_cast<unsigned>(rows) * cols; }
    constexpr Type with_scalar(Scalar s) const {
        Type t = *this;
        t.scalar = s;
        return t;
    }
    // The scalar or vector of this type's scalar kind and the given width.
    constexpr Type with_width(unsigned width) const { return vector(scalar, width); }
};

inline constexpr Type kBool = Type::scalar_of(Scalar::Bool);
inline constexpr Type kInt = Type::scalar_of(Scalar::Int);
inline constexpr Type kUint = Type::scalar_of(Scalar::Uint);
inline constexpr Type kHalf = Type::scalar_of(Scalar::Half);
inline constexpr Type kFloat = Type::scalar_of(Scalar::Float);
inline constexpr Type kFloat2 = Type::vector(Scalar::Float, 2);
inline constexpr Type kFloat3 = Type::vector(Scalar::Float, 3);
inline constexpr Type kFloat4 = Type::vector(Scalar::Float, 4);

}  // namespace patina::ir

template <>
struct std::hash<patina::ir::Type> {
    std::size_t operator()(patina::ir::Type t) const noexcept {
        const std::uint64_t packed = static_cast<std::uint64_t>(t.kind) | static_cast<std::uint64_t>(t.scalar) << 8 |
                                     static_cast<std::uint64_t>(t.rows) << 16 |
                                     static_cast<std::uint64_t>(t.cols) << 24 | static_cast<std::uint64_t>(t.ref) << 32;
        return std::hash<std::uint64_t>{}(packed);
    }
};
