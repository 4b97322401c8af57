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

/// The angle whose sine is the value, from -pi/2 to pi/2.
///
/// test: ArcSine(0.5) == 0.5235987755982988
/// test: ArcSine(float3(0, 1, -2)) == float3(0, 1.5707963267948966, -1.5707963267948966)
[node("Math/Arc Sine")] [also("Asin", "Arcsin")]
floatN ArcSine(
    [range(-1, 1)] floatN value = 0  ///< a sine; beyond -1 and 1 the nearer of them counts
) {
    return asin(clamp(value, -1, 1));
}

/// The angle whose cosine is the value, from 0 to pi.
///
/// test: ArcCosine(0.5) == 1.0471975511965976
/// test: ArcCosine(float3(0, -1, 2)) == float3(1.5707963267948966, 3.141592653589793, 0)
[node("Math/Arc Cosine")] [also("Acos", "Arccos")]
floatN ArcCosine(
    [range(-1, 1)] floatN value = 1  ///< a cosine; beyond -1 and 1 the nearer of them counts
) {
    return acos(clamp(value, -1, 1));
}

/// The angle whose tangent is the value, from -pi/2 to pi/2: the angle of a slope.
///
/// test: ArcTangent(1) == 0.7853981633974483
/// test: ArcTangent(float2(0, -1.7320508075688772)) == float2(0, -1.0471975511965976)
[node("Math/Arc Tangent")] [also("Atan", "Arctan")]
floatN ArcTangent(
    floatN value = 0  ///< any number
) {
    return atan(value);
}

/// Converts an angle from degrees to radians.
///
/// formula: degrees pi / 180
/// test: DegreesToRadians(180) == 3.141592653589793
/// test: DegreesToRadians(float2(-90, 1)) == float2(-1.5707963267948966, 0.017453292519943295)
[node("Math/Degrees to Radians")] [also("Radians", "ToRadians")]
floatN DegreesToRadians(
    [unit("deg")] floatN angle = 0  ///< an angle in degrees
) {
    return radians(angle);
}

/// Converts an angle from radians to degrees.
///
/// formula: radians 180 / pi
/// test: RadiansToDegrees(3.141592653589793) == 180
/// test: RadiansToDegrees(float2(-1.5707963267948966, 1)) == float2(-90, 57.29577951308232)
[node("Math/Radians to Degrees")] [also("Degrees", "ToDegrees")]
floatN RadiansToDegrees(
    [unit("rad")] floatN angle = 0  ///< an angle in radians
) {
    return degrees(angle);
}

/// The hyperbolic sine: odd like a sine, and grows like an exponential on both sides.
///
/// formula: (exp(x) - exp(-x)) / 2
/// test: HyperbolicSine(1) == 1.1752011936438014
/// test: HyperbolicSine(float2(0, -2)) == float2(0, -3.626860407847019)
[node("Math/Hyperbolic Sine")] [also("Sinh")]
floatN HyperbolicSine(
    floatN value = 0  ///< any number
) {
    return sinh(value);
}

/// The hyperbolic cosine: the curve of a hanging chain, 1 at its lowest point.
///
/// formula: (exp(x) + exp(-x)) / 2
/// test: HyperbolicCosine(1) == 1.5430806348152437
/// test: HyperbolicCosine(float2(0, -2)) == float2(1, 3.7621956910836314)
[node("Math/Hyperbolic Cosine")] [also("Cosh")]
floatN HyperbolicCosine(
    floatN value = 0  ///< any number
) {
    return cosh(value);
}

/// The hyperbolic tangent: a soft limit, straight around zero and level at -1 and 1.
///
/// formula: (exp(x) - exp(-x)) / (exp(x) + exp(-x))
/// test: HyperbolicTangent(1) == 0.7615941559557649
/// test: HyperbolicTangent(float2(0, -0.5)) == float2(0, -0.46211715726000973)
[node("Math/Hyperbolic Tangent")] [also("Tanh")] [range(-1, 1)]
floatN HyperbolicTangent(
    floatN value = 0  ///< any number
) {
    return tanh(value);
}
