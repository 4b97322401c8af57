// Powers, roots and logarithms.

/// The base raised to a power.
///
/// A base below zero counts as zero, because a fractional power of it does not exist. Everything to the power of zero is
/// one, zero too.
///
/// test: Power(3, 2) == 9
/// test: Power(4, -0.5) == 0.5
/// test: Power(float2(2, 9), float2(10, 0.5)) == float2(1024, 3)
/// test: Power(-2, 2) == 0
/// test: Power(0, 0) == 1
/// test: Power(float3(0, 0, 2), float3(0, 2, 0)) == float3(1, 0, 1)
[node("Math/Power")] [also("Pow")]
floatN Power(
    floatN base = 1,     ///< the base, 0 or more
    floatN exponent = 2  ///< the power
) {
    return pow(max(base, 0), exponent);
}

/// The square root; for a value below zero the result is zero.
///
/// test: SquareRoot(2.25) == 1.5
/// test: SquareRoot(float2(16, -4)) == float2(4, 0)
[node("Math/Square Root")] [also("Sqrt")]
floatN SquareRoot(
    floatN value = 1  ///< 0 or more
) {
    return sqrt(max(value, 0));
}

/// Euler's number raised to a power: growth if the power is positive, decay if it is negative.
///
/// test: Exponential(1) == 2.718281828459045
/// test: Exponential(float2(0, -0.6931471805599453)) == float2(1, 0.5)
[node("Math/Exponential")] [also("Exp")]
floatN Exponential(
    floatN exponent = 0  ///< the power
) {
    return exp(exponent);
}

/// The logarithm to base two: how many times a value can be halved until it is 1.
///
/// test: Log2(8) == 3
/// test: Log2(float2(0.25, 1)) == float2(-2, 0)
[node("Math/Log2")]
floatN Log2(
    floatN value = 1  ///< above 0
) {
    return log2(value);
}

/// Two raised to a power: it doubles with each whole step.
///
/// test: Exponential2(10) == 1024
/// test: Exponential2(float3(0, -2, 0.5)) == float3(1, 0.25, 1.4142135623730951)
[node("Math/Exponential2")] [also("Exp2")]
floatN Exponential2(
    floatN exponent = 0  ///< the power
) {
    return exp2(exponent);
}

/// The natural logarithm, to the base e: the inverse of Exponential.
///
/// test: Log(2.718281828459045) == 1
/// test: Log(float3(1, 10, 0.5)) == float3(0, 2.302585092994046, -0.6931471805599453)
[node("Math/Log")] [also("Ln", "Logarithm")]
floatN Log(
    floatN value = 1  ///< above 0
) {
    return log(value);
}

/// The logarithm to base ten: the number of zeros of 10, 100, 1000 ...
///
/// formula: log2(value) / log2(10)
/// test: Log10(1000) == 3
/// test: Log10(float3(0.01, 1, 2)) == float3(-2, 0, 0.3010299956639812)
[node("Math/Log10")]
floatN Log10(
    floatN value = 1  ///< above 0
) {
    return log2(value) * 0.30102999566398120;
}

/// One divided by the square root: what a vector's squared length is multiplied by to normalize the vector.
///
/// formula: 1 / sqrt(value)
/// test: ReciprocalSquareRoot(4) == 0.5
/// test: ReciprocalSquareRoot(float3(1, 0.25, 2)) == float3(1, 2, 0.7071067811865476)
[node("Math/Reciprocal Square Root")] [also("InverseSquareRoot", "Rsqrt")]
floatN ReciprocalSquareRoot(
    floatN value = 1  ///< above 0
) {
    return rsqrt(value);
}
