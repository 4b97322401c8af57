// Arithmetic that stays finite: where a formula has no value, these nodes return a fallback.

/// Divides two values, and returns a fallback if the divisor is zero.
///
/// test: SafeDivide(6, 3) == 2
/// test: SafeDivide(6, 0) == 0
/// test: SafeDivide(float2(1, 2), float2(0, 4), 9) == float2(9, 0.5)
[node("Math/Safe/Divide")]
floatN SafeDivide(
    floatN dividend = 1,  ///< the dividend
    floatN divisor = 1,   ///< the divisor
    floatN fallback = 0   ///< the result where the divisor is zero
) {
    floatN isZero = step(abs(divisor), 1e-30);
    // This does not blend the two values: zero times an infinite quotient would not be a number.
    return isZero > 0.5 ? fallback : dividend / (divisor + isZero);
}

/// A power that is always defined: a base below zero counts as zero, and zero to a power of zero or less is zero.
///
/// test: SafePower(2, 3) == 8
/// test: SafePower(-2, 0.5) == 0
/// test: SafePower(0, 0) == 0
/// test: SafePower(0, -1) == 0
[node("Math/Safe/Power")]
floatN SafePower(
    floatN base = 1,     ///< the base
    floatN exponent = 2  ///< the power
) {
    // A base of zero or less is replaced by one, because its power may not be a number.
    floatN power = pow(base > 0 ? base : 1, exponent);
    return base > 0 ? power : 0;
}

/// Returns the value if it is finite, else a fallback.
///
/// test: FiniteOr(2, 5) == 2
/// test: FiniteOr(asfloat(0x7fc00000u), 5) == 5
/// test: FiniteOr(asfloat(0x7f800000u), 5) == 5
/// test: FiniteOr(float2(3, asfloat(0xff800000u)), 5) == float2(3, 5)
[node("Math/Safe/Finite or Else")]
floatN FiniteOr(
    floatN value = 0,    ///< any value
    floatN fallback = 0  ///< the result if the value is infinite or not a number
) {
    return isnan(value) || isinf(value) ? fallback : value;
}

/// The direction of a vector as Unity's shaders compute it: a vector shorter than 0.032 gives a shorter result.
///
/// formula: v / sqrt(max(|v|^2, 0.001))
/// source: Unity built-in shaders, Unity_SafeNormalize
/// test: NormalizeFloored(float3(0, 3, 4)) == float3(0, 0.6, 0.8)
/// test: NormalizeFloored(float3(0.01, 0, 0)) == float3(0.31622776601683794, 0, 0)
/// test: NormalizeFloored(float3(0, 0, 0)) == float3(0, 0, 0)
[node("Math/Safe/Normalize Floored")] [range(-1, 1)]
float3 NormalizeFloored(
    float3 value  ///< any vector
) {
    return value * rsqrt(max(dot(value, value), 0.001));
}
