// Limiting values to a range, and mapping them from one range to another.

/// The smaller of two values.
///
/// test: Minimum(2, -3) == -3
/// test: Minimum(float2(1, 5), 3) == float2(1, 3)
[node("Math/Minimum")] [also("Min")]
floatN Minimum(
    floatN left = 0,  ///< first value
    floatN right = 0  ///< second value
) {
    return min(left, right);
}

/// The larger of two values.
///
/// test: Maximum(2, -3) == 2
/// test: Maximum(float2(1, 5), 3) == float2(3, 5)
[node("Math/Maximum")] [also("Max")]
floatN Maximum(
    floatN left = 0,  ///< first value
    floatN right = 0  ///< second value
) {
    return max(left, right);
}

/// Limits a value to a range.
///
/// test: Clamp(5, 0, 2) == 2
/// test: Clamp(float3(-1, 0.5, 3), 0, 2) == float3(0, 0.5, 2)
[node("Math/Clamp")]
floatN Clamp(
    floatN value = 0,    ///< any number
    floatN minimum = 0,  ///< lower limit
    floatN maximum = 1   ///< upper limit, not below the lower one
) {
    return clamp(value, minimum, maximum);
}

/// Limits a value to the range from 0 to 1.
///
/// test: Saturate(1.5) == 1
/// test: Saturate(float2(-0.5, 0.25)) == float2(0, 0.25)
[node("Math/Saturate")]
floatN Saturate(
    floatN value = 0  ///< any number
) {
    return saturate(value);
}

/// Interpolates linearly between two values.
///
/// If t is outside 0 to 1, the result continues along the same line.
///
/// formula: from + (to - from) t
/// test: Lerp(0, 10, 0.25) == 2.5
/// test: Lerp(float2(1, 2), float2(3, 6), 0.5) == float2(2, 4)
/// test: Lerp(1, 2, -1) == 0
[node("Math/Lerp")] [also("Mix")]
floatN Lerp(
    floatN from = 0,              ///< the value at t = 0
    floatN to = 1,                ///< the value at t = 1
    [range(0, 1)] floatN t = 0.5  ///< the interpolation factor
) {
    return lerp(from, to, t);
}

/// The position of a value between two others: the inverse of Lerp.
///
/// formula: (value - from) / (to - from)
/// test: InverseLerp(10, 20, 12.5) == 0.25
/// test: InverseLerp(float2(0, 1), float2(4, 0), 1) == float2(0.25, 0)
[node("Math/Inverse Lerp")]
floatN InverseLerp(
    floatN from = 0,  ///< where the result is 0
    floatN to = 1,    ///< where the result is 1; not the same as `from`
    floatN value = 0  ///< any number
) {
    return (value - from) / (to - from);
}

/// Maps a value from one range to the same place in another.
///
/// A value outside the first range maps to a value outside the second; use Clamp or Saturate to prevent that.
///
/// formula: outMin + (outMax - outMin) (value - inMin) / (inMax - inMin)
/// test: Remap(0, -1, 1, 0, 1) == 0.5
/// test: Remap(15, 10, 20, 100, 0) == 50
/// test: Remap(float2(0, 2), 0, 1, 10, 20) == float2(10, 30)
[node("Math/Remap")] [also("Range", "MapRange")]
floatN Remap(
    floatN value = 0,    ///< a number in the first range
    floatN inMin = -1,  ///< where the first range begins
    floatN inMax = 1,   ///< where it ends; not equal to the beginning
    floatN outMin = 0,  ///< where the second range begins
    floatN outMax = 1   ///< where it ends
) {
    return lerp(outMin, outMax, InverseLerp(inMin, inMax, value));
}

/// 1 if the value has reached the edge, else 0.
///
/// test: Step(0.5, 0.25) == 0
/// test: Step(0.5, 0.5) == 1
/// test: Step(0.5, float2(0.4, 0.6)) == float2(0, 1)
[node("Math/Step")]
floatN Step(
    floatN edge = 0.5,  ///< where the result becomes 1
    floatN value = 0    ///< any number
) {
    return step(edge, value);
}

/// A soft step: 0 up to the first edge, 1 from the second edge on, and a smooth curve between them.
///
/// formula: t^2 (3 - 2 t), t = saturate((value - edge0) / (edge1 - edge0))
/// test: Smoothstep(0, 1, 0.5) == 0.5
/// test: Smoothstep(2, 6, 3) == 0.15625
/// test: Smoothstep(0, 1, float2(-1, 2)) == float2(0, 1)
[node("Math/Smoothstep")]
floatN Smoothstep(
    floatN edge0 = 0,  ///< where the rise begins
    floatN edge1 = 1,  ///< where it ends; above `edge0`
    floatN value = 0   ///< any number
) {
    return smoothstep(edge0, edge1, value);
}
