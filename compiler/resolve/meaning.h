// The meaning of a value: a position, a direction, a texel, data. Arithmetic keeps or loses it: a position plus an
// offset is a position. This file knows values alone; meanings.h follows the links of a graph.
//
//   const Meaning moved = sum_of({.meaning = meaning_of("positionWS")}, {.is_constant = true}, true);  // a position
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace patina::resolve {

struct Meaning {
    enum class Kind : std::uint8_t { Unknown, Texel, NormalMap, Data, Direction, Position };
    Kind kind = Kind::Unknown;
    std::string_view space{};  // as names end with it: "WS"; empty: not known

    bool is_vector() const { return kind == Kind::Direction || kind == Kind::Position; }
    friend bool operator==(const Meaning&, const Meaning&) = default;
};

// "normalTS", "positionWS", "texel"; of textures: "normalMap", "data"; without a space: "position", "direction".
Meaning meaning_of(std::string_view name);
// "a position in world space"
std::string described(const Meaning& meaning);

// A part of an expression.
struct Operand {
    Meaning meaning{};
    bool is_constant = false;  // numbers alone: it is nothing in particular
};
// a + b, or a - b
Meaning sum_of(const Operand& a, const Operand& b, bool is_plus);
// a * b, or a / b
Meaning product_of(const Operand& a, const Operand& b, bool is_division);
// One of the two, or a value between them.
Meaning mix_of(const Operand& a, const Operand& b);

}  // namespace patina::resolve
