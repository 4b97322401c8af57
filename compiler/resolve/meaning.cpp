#include "compiler/resolve/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace patina::resolve {
namespace {

using Kind = Meaning::Kind;

constexpr std::array<std::string_view, 4> kSpaces = {"OS", "WS", "VS", "TS"};

std::string_view words_of_space(std::string_view space) {
    if (space == "OS") return "object space";
    if (space == "WS") return "world space";
    if (space == "VS") return "view space";
    return "tangent space";
}

}  // namespace

Meaning meaning_of(std::string_view name) {
    if (name == "texel") return {.kind = Kind::Texel};
    if (name == "normalMap") return {.kind = Kind::NormalMap};
    if (name == "data") return {.kind = Kind::Data};
    Meaning made;
    if (name.size() > 2) {
        const std::string_view ending = name.substr(name.size() - 2);
        const auto* const space = std::find(kSpaces.begin(), kSpaces.end(), ending);
        if (space != kSpaces.end()) made.space = *space;
    }
    const bool is_position = name.find("osition") != name.npos || name.starts_with("point");
    if (made.space.empty() && name != "position" && name != "direction") return {};
    made.kind = is_position ? Kind::Position : Kind::Direction;
    return made;
}

std::string described(const Meaning& meaning) {
    const std::string_view what = meaning.kind == Kind::Position ? "a position" : "a direction";
    return meaning.space.empty() ? std::string(what) : fmt::format("{} in {}", what, words_of_space(meaning.space));
}

Meaning sum_of(const Operand& a, const Operand& b, bool is_plus) {
    const bool is_position = a.meaning.kind == Kind::Position, is_from = b.meaning.kind == Kind::Position;
    // The difference of positions is a direction.
    if (is_position && a.meaning == b.meaning)
        return {.kind = is_plus ? Kind::Position : Kind::Direction, .space = a.meaning.space};
    if (is_position && is_from) return {};
    // What is subtracted and is not known may be a position, too.
    if (is_position) return is_plus || b.is_constant || b.meaning.is_vector() ? a.meaning : Meaning{};
    if (is_from) return is_plus ? b.meaning : Meaning{};
    // A texel plus a number may be decoded.
    if (a.meaning.kind == Kind::Texel || b.meaning.kind == Kind::Texel) return {};
    return mix_of(a, b);
}

Meaning product_of(const Operand& a, const Operand& b, bool is_division) {
    if (b.is_constant) return a.meaning;
    return a.is_constant && !is_division ? b.meaning : Meaning{};
}

Meaning mix_of(const Operand& a, const Operand& b) {
    if (a.meaning == b.meaning || b.is_constant) return a.meaning;
    return a.is_constant ? b.meaning : Meaning{};
}

}  // namespace patina::resolve
