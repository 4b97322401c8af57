#include "compiler/interpret/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/base/bits.h"

namespace patina::interpret {

double to_half(double value) {
    constexpr double kLargest = 65504;
    constexpr double kSmallestNormal = 0x1p-14;
    constexpr double kSubnormalUnit = 0x1p-24;
    if (!std::isfinite(value)) return value;
    // Below the normal numbers the unit stays the same; multiplying by a power of two is exact.
    if (std::fabs(value) < kSmallestNormal) return std::nearbyint(value / kSubnormalUnit) * kSubnormalUnit;
    // 52 bits of fraction become 10: add just under half a unit, or just half where the last kept bit is odd, and cut.
    constexpr int kDropped = 52 - 10;
    std::uint64_t bits = bits_as<std::uint64_t>(value);
    bits += (std::uint64_t{1} << (kDropped - 1)) - 1 + (bits >> kDropped & 1);
    bits &= ~((std::uint64_t{1} << kDropped) - 1);
    const double rounded = bits_as<double>(bits);
    if (std::fabs(rounded) <= kLargest) return rounded;
    return std::copysign(std::numeric_limits<double>::infinity(), value);
}

double to_float(double value) {
    static_assert(std::numeric_limits<float>::is_iec559, "the conversion must overflow to infinity");
    return static_cast<double>(static_cast<float>(value));
}

double wrap(ir::Scalar scalar, std::int64_t value) {
    const auto low = static_cast<std::uint32_t>(value);
    return scalar == ir::Scalar::Int ? static_cast<double>(static_cast<std::int32_t>(low)) : static_cast<double>(low);
}

double fit(ir::Scalar scalar, Precision precision, double value) {
    switch (scalar) {
        case ir::Scalar::Bool: return value != 0 ? 1 : 0;
        case ir::Scalar::Int: return std::isnan(value) ? 0 : std::clamp(std::trunc(value), -0x1p31, 0x1p31 - 1);
        case ir::Scalar::Uint: return std::isnan(value) ? 0 : std::clamp(std::trunc(value), 0.0, 0x1p32 - 1);
        case ir::Scalar::Half: return to_half(value);
        case ir::Scalar::Float: return precision == Precision::Float ? to_float(value) : value;
    }
    return value;
}

}  // namespace patina::interpret
