#include "compiler/languages/literals.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "compiler/base/bits.h"
#include "compiler/base/text.h"

namespace patina::languages {
namespace {

Text integer(double value) {
    const auto whole = static_cast<long long>(value);
    // A literal of the lowest int would be the negation of a number that does not fit in an int.
    if (whole == std::numeric_limits<std::int32_t>::min()) return {"-2147483647 - 1", Precedence::Additive};
    return {fmt::format("{}", whole), whole < 0 ? Precedence::Unary : Precedence::Primary};
}

Text floating(const Language& language, ir::Scalar scalar, float value) {
    if (!std::isfinite(value)) {
        const std::string bits = fmt::format("{}(0x{:08x}u)", language.bitcast(ir::Scalar::Float, ir::Scalar::Uint),
                                             bits_as<std::uint32_t>(value));
        if (scalar == ir::Scalar::Float) return {bits, Precedence::Postfix};
        return {fmt::format("{}({})", language.type_name(ir::Type::scalar_of(scalar)), bits), Precedence::Postfix};
    }
    const std::string_view name = language.name_of_number ? language.name_of_number(value) : std::string_view();
    if (!name.empty()) return {std::string(name), Precedence::Primary};
    std::string text = shortest(value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    if (scalar == ir::Scalar::Half) text += language.half_suffix;
    return {text, std::signbit(value) ? Precedence::Unary : Precedence::Primary};
}

}  // namespace

Text literal(const Language& language, ir::Scalar scalar, double value) {
    switch (scalar) {
        case ir::Scalar::Bool: return {value != 0 ? "true" : "false"};
        case ir::Scalar::Int: return integer(value);
        case ir::Scalar::Uint: return {fmt::format("{}u", static_cast<unsigned long long>(value))};
        case ir::Scalar::Half:
        case ir::Scalar::Float: return floating(language, scalar, static_cast<float>(value));
    }
    return {};
}

}  // namespace patina::languages
