// Arithmetic that stays finite: where a formula has no value, these have one of your choice.

/// A quotient, or a value of your choice where the divisor is zero.
///
/// test: SafeDivide(6, 3) == 2
/// test: SafeDivide(6, 0) == 0
/// test: SafeDivide(float2(1, 2), float2(0, 4), 9) == float2(9, 0.5)
[node("Math/Safe/Divide")]
floatN SafeDivide(
    floatN dividend = 1,  ///< what is divided
    floatN divisor = 1,   ///< by what
    floatN fallback = 0   ///< the result where the divisor is zero
) {
    floatN isZero = step(abs(divisor), 1e-30);
    // No mixture of the two: where the quotient is infinite, zero times it would be no number.
    return isZero > 0.5 ? fallback : dividend / (divisor + isZero);
}

/// A power of anything: a base below zero counts as zero, and zero to a power of zero or less is zero.
///
/// test: SafePower(2, 3) == 8
/// test: SafePower(-2, 0.5) == 0
/// test: SafePower(0, 0) == 0
/// test: SafePower(0, -1) == 0
[node("Math/Safe/Power")]
floatN SafePower(
    floatN base = 1,     ///< what is raised
    floatN exponent = 2  ///< to which power
) {
    // Of anything else the power of one is taken, so that no infinity is multiplied away.
    floatN isPositive = 1 - step(base, 0);
    return pow(max(base, 0) + (1 - isPositive), exponent) * isPositive;
}

/// The value itself where it is a finite number, else another.
///
/// test: FiniteOr(2, 5) == 2
/// test: FiniteOr(asfloat(0x7fc00000u), 5) == 5
/// test: FiniteOr(asfloat(0x7f800000u), 5) == 5
/// test: FiniteOr(float2(3, asfloat(0xff800000u)), 5) == float2(3, 5)
[node("Math/Safe/Finite or Else")]
floatN FiniteOr(
    floatN value = 0,    ///< any value
    floatN fallback = 0  ///< the result where it is infinite or no number
) {
    return isnan(value) || isinf(value) ? fallback : value;
}

/// The vector's direction as Unity's shaders compute it: a vector shorter than 0.032 gives a shorter result.
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
