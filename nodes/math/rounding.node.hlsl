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
[node("Math/Modulo")] [also("Mod")]
floatN Modulo(
    floatN value = 0,   ///< any number
    floatN divisor = 1  ///< the length of a period, not zero
) {
    return value - divisor * floor(value / divisor);
}

/// The value without its fraction: the next whole number towards zero.
///
/// test: Truncate(1.75) == 1
/// test: Truncate(float3(-1.75, 0.5, 3)) == float3(-1, 0, 3)
[node("Math/Truncate")] [also("Trunc")]
floatN Truncate(
    floatN value = 0  ///< any number
) {
    return trunc(value);
}

/// The remainder of a division, with the sign of the value: it is mirrored at zero.
///
/// Modulo repeats without a seam at zero instead.
///
/// formula: value - divisor trunc(value / divisor)
/// source: the function fmod of C and HLSL
/// test: Remainder(7.5, 2) == 1.5
/// test: Remainder(-7.5, 2) == -1.5
/// test: Remainder(float2(5, -1), float2(-4, 4)) == float2(1, -1)
[node("Math/Remainder")] [also("Fmod", "ModuloUnity")]
floatN Remainder(
    floatN value = 0,   ///< any number
    floatN divisor = 1  ///< the length of a period, not zero
) {
    return fmod(value, divisor);
}

/// Reduces a value to a few equal steps, each as high as its lowest value.
///
/// formula: floor(value steps) / steps
/// test: Posterize(0.6, 4) == 0.5
/// test: Posterize(float3(0.25, -0.1, 0.99), 4) == float3(0.25, -0.25, 0.75)
/// test: Posterize(0.99, float2(2, 10)) == float2(0.5, 0.9)
[node("Math/Posterize")] [also("Quantize", "Stairs")]
floatN Posterize(
    floatN value = 0,  ///< any number; a colour from 0 to 1
    floatN steps = 4   ///< steps from 0 to 1, not zero
) {
    return floor(value * steps) / steps;
}
