// The forms of values, for the tables of keys (keys.cpp).
//
//   KeyInfo{"fov", "the vertical field of view in degrees, 1 to 170; default: 30", number(1, 170)}
//   KeyInfo{"shadow", "true, or the settings of the shadow", {boolean(), object(ObjectKind::Shadow)}}
#pragma once

#include "compiler/format/keys.h"
#include "compiler/format/words.h"

namespace patina::format {

constexpr Form text() {
    return {.of = Form::Of::Text};
}
constexpr Form pattern(std::string_view expression) {
    return {.of = Form::Of::Pattern, .text = expression};
}
constexpr Form identifier() {
    return {.of = Form::Of::Identifier};
}
constexpr Form boolean() {
    return {.of = Form::Of::Boolean};
}
constexpr Form integer(double low, double high) {
    return {.of = Form::Of::Integer, .low = low, .high = high};
}
constexpr Form number(double low, double high) {
    return {.of = Form::Of::Number, .low = low, .high = high};
}
constexpr Form number() {
    return {.of = Form::Of::Number};
}
constexpr Form numbers(std::size_t count) {
    return {.of = Form::Of::Numbers, .count = count};
}
constexpr Form vector(double low = -kFarthest, double high = kFarthest) {
    return {.of = Form::Of::Numbers, .low = low, .high = high, .count = 3};
}
constexpr Form color() {
    return {.of = Form::Of::Color};
}
constexpr Form color_with_alpha() {
    return {.of = Form::Of::ColorWithAlpha};
}
constexpr Form any_of(std::span<const std::string_view> words) {
    return {.of = Form::Of::Words, .words = words};
}
// The words of an enum. Hidden: a plugin that contains the library would show it for each public enum.
template <HasWords E>
[[gnu::visibility("hidden")]] inline constexpr auto kTextsOf = texts<E>();
template <HasWords E>
constexpr Form words() {
    return any_of(kTextsOf<E>);
}
constexpr Form object(ObjectKind kind) {
    return {.of = Form::Of::Object, .kind = kind};
}
constexpr Form objects(ObjectKind kind, std::size_t most = 0) {
    return {.of = Form::Of::Objects, .count = most, .kind = kind};
}
constexpr Form definition(std::string_view name) {
    return {.of = Form::Of::Definition, .text = name};
}
constexpr Form library(std::string_view what) {
    return {.of = Form::Of::Library, .text = what};
}
constexpr Form schema(std::string_view json) {
    return {.of = Form::Of::Schema, .text = json};
}
// What nodes compute with: a number, a link, an expression; and an object of them.
constexpr Form value() {
    return definition("value");
}
constexpr Form values() {
    return schema(R"({"type":"object","additionalProperties":{"$ref":"#/$defs/value"}})");
}

}  // namespace patina::format
