// Rounding and remainders.

/// The largest whole number that is not above the value.
///
/// test: Floor(1.75) == 1
/// test: Floor(float2(-0.25, 3)) == float2(-1, 3)
[node("Math/Floor")]
floatN Floor(
    floatN value = 0  ///< any number
) {
    return floor(value);
}

/// The smallest whole number that is not below the value.
///
/// test: Ceiling(1.25) == 2
/// test: Ceiling(float2(-0.25, 3)) == float2(0, 3)
[node("Math/Ceiling")] [also("Ceil")]
floatN Ceiling(
    floatN value = 0  ///< any number
) {
    return ceil(value);
}

/// The nearest whole number; a half goes to the even neighbour.
///
/// test: Round(1.75) == 2
/// test: Round(float4(0.5, 1.5, 2.5, -1.5)) == float4(0, 2, 2, -2)
[node("Math/Round")]
floatN Round(
    floatN value = 0  ///< any number
) {
    return round(value);
}

/// The fractional part of a value: 0 or more, and less than 1.
///
/// formula: value - floor(value)
/// test: Fraction(2.75) == 0.75
/// test: Fraction(float2(-0.25, 3)) == float2(0.75, 0)
[node("Math/Fraction")] [also("Frac", "Fract")]
floatN Fraction(
    floatN value = 0  ///< any number
) {
    return frac(value);
}

/// The remainder of a division: it repeats without a seam at zero.
///
/// The result has the sign of the divisor. (The operator % has the sign of the value.)
///
/// formula: value - divisor floor(value / divisor)
/// test: Modulo(7.5, 2) == 1.5
/// test: Modulo(-7.5, 2) == 0.5
/// test: Modulo(float2(5, -1), 4) == float2(1, 3)
[node("Math/Modulo")] [also("Mod", "Fmod")]
floatN Modulo(
    floatN value = 0,   ///< any number
    floatN divisor = 1  ///< the length of a period, not zero
) {
    return value - divisor * floor(value / divisor);
}
