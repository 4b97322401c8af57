// Angles and waves. Every angle is in radians; a full turn is 2 pi.

/// The sine of an angle.
///
/// test: Sine(0.5235987755982988) == 0.5
/// test: Sine(float2(0, 1.5707963267948966)) == float2(0, 1)
[node("Math/Sine")] [also("Sin")]
floatN Sine(
    [unit("rad")] floatN angle = 0  ///< any angle
) {
    return sin(angle);
}

/// The cosine of an angle.
///
/// test: Cosine(1.0471975511965976) == 0.5
/// test: Cosine(float2(0, 3.141592653589793)) == float2(1, -1)
[node("Math/Cosine")] [also("Cos")]
floatN Cosine(
    [unit("rad")] floatN angle = 0  ///< any angle
) {
    return cos(angle);
}

/// The tangent of an angle: the slope of a line at that angle.
///
/// test: Tangent(0.7853981633974483) == 1
/// test: Tangent(float2(0, -1.0471975511965976)) == float2(0, -1.7320508075688772)
[node("Math/Tangent")] [also("Tan")]
floatN Tangent(
    [unit("rad")] floatN angle = 0  ///< any angle but a quarter turn
) {
    return tan(angle);
}

/// The angle of the direction (x, y) from the positive x axis, from -pi to pi.
///
/// At the origin, the result is not defined.
///
/// test: ArcTangent2(1, 1) == 0.7853981633974483
/// test: ArcTangent2(1, -1) == 2.356194490192345
/// test: ArcTangent2(-2, 0) == -1.5707963267948966
[node("Math/Arc Tangent 2")] [also("Atan2")]
floatN ArcTangent2(
    floatN rise = 0,  ///< y of the direction
    floatN run = 1    ///< x of the direction
) {
    return atan2(rise, run);
}
