// Arithmetic, component by component. A scalar combined with a vector is repeated for each component.

/// The sum of two values.
///
/// test: Add(1, 2) == 3
/// test: Add(float3(1, 2, 3), 0.5) == float3(1.5, 2.5, 3.5)
[node("Math/Add")]
floatN Add(
    floatN left = 0,  ///< first term
    floatN right = 0  ///< second term
) {
    return left + right;
}

/// The left value minus the right one.
///
/// test: Subtract(1, 3) == -2
/// test: Subtract(1, float2(0.25, 2)) == float2(0.75, -1)
[node("Math/Subtract")] [also("Sub")]
floatN Subtract(
    floatN left = 0,  ///< the value to subtract from
    floatN right = 0  ///< the value to subtract
) {
    return left - right;
}

/// The product of two values.
///
/// test: Multiply(3, -2) == -6
/// test: Multiply(float4(1, 2, 3, 4), 0.5) == float4(0.5, 1, 1.5, 2)
[node("Math/Multiply")] [also("Mul")]
floatN Multiply(
    floatN left = 1,  ///< first factor
    floatN right = 1  ///< second factor
) {
    return left * right;
}

/// The left value divided by the right one.
///
/// Division by zero gives infinity, and zero divided by zero is not a number: keep the divisor away from zero.
///
/// test: Divide(1, 4) == 0.25
/// test: Divide(float2(3, -6), 2) == float2(1.5, -3)
[node("Math/Divide")] [also("Div")]
floatN Divide(
    floatN left = 1,  ///< dividend
    floatN right = 1  ///< divisor
) {
    return left / right;
}

/// One divided by the value.
///
/// test: Reciprocal(4) == 0.25
/// test: Reciprocal(float2(-2, 0.5)) == float2(-0.5, 2)
[node("Math/Reciprocal")] [also("Rcp")]
floatN Reciprocal(
    floatN value = 1  ///< divisor, not zero
) {
    return 1 / value;
}

/// The value with its sign reversed.
///
/// test: Negate(2) == -2
/// test: Negate(float2(-1, 3)) == float2(1, -3)
[node("Math/Negate")]
floatN Negate(
    floatN value = 0  ///< any number
) {
    return -value;
}

/// One minus the value: the opposite of a mask.
///
/// test: OneMinus(0.25) == 0.75
/// test: OneMinus(float3(0, 1, 2)) == float3(1, 0, -1)
[node("Math/One Minus")] [also("Invert")]
floatN OneMinus(
    floatN value = 0  ///< any number
) {
    return 1 - value;
}

/// The value without its sign.
///
/// test: Absolute(-1.5) == 1.5
/// test: Absolute(float2(-2, 2)) == float2(2, 2)
[node("Math/Absolute")] [also("Abs", "Absval")]
floatN Absolute(
    floatN value = 0  ///< any number
) {
    return abs(value);
}

/// -1 for a negative value, 0 for zero, 1 for a positive one.
///
/// test: Sign(-0.5) == -1
/// test: Sign(float3(3, 0, -7)) == float3(1, 0, -1)
[node("Math/Sign")]
floatN Sign(
    floatN value = 0  ///< any number
) {
    return sign(value);
}
