// Texture coordinates that are bent around a centre. The formulas take uv as it is given: v grows downwards here, so turns are
// mirrored against an engine whose v grows upwards; with its coordinates (u, 1 - v), they give its results.

/// Rotates texture coordinates the more, the farther they are from a centre. A positive strength turns u towards v.
///
/// formula: center + R(strength |d|) d + offset, d = uv - center, R(a) = (cos a, -sin a; sin a, cos a)
/// source: Unity Shader Graph, node Twirl
/// test: Twirl(float2(0.5, 0.5), 0.5, 10, 0) == float2(0.5, 0.5)
/// test: Twirl(float2(1, 0.5), 0.5, 3.141592653589793, 0) == float2(0.5, 1)
/// test: Twirl(float2(1, 0.5), 0.5, 6.283185307179586, float2(0.25, -1)) == float2(0.25, -0.5)
[node("UV/Twirl")] [also("Swirl", "Vortex")]
float2 Twirl(
    float2 uv = uv0,      ///< texture coordinates
    float2 center = 0.5,  ///< what stays where it is
    float strength = 10,  ///< radians in one unit of distance
    float2 offset = 0     ///< added to the result
) {
    return Rotate(uv, strength * length(uv - center), center) + offset;
}

/// Bends texture coordinates around a centre, like a wave that runs around it.
///
/// formula: uv + (d.y, -d.x) dot(d, d) strength + offset, d = uv - center
/// source: Unity Shader Graph, node Radial Shear
/// test: RadialShear(float2(0.5, 0.5)) == float2(0.5, 0.5)
/// test: RadialShear(float2(1, 0.5), 0.5, float2(10, 4), 0) == float2(1, 0)
/// test: RadialShear(float2(0.5, 0), 0.5, 2, float2(0.5, 1)) == float2(0.75, 1)
[node("UV/Radial Shear")]
float2 RadialShear(
    float2 uv = uv0,       ///< texture coordinates
    float2 center = 0.5,   ///< what stays where it is
    float2 strength = 10,  ///< strength along u and v
    float2 offset = 0      ///< added to the result
) {
    float2 d = uv - center;
    return uv + float2(d.y, -d.x) * dot(d, d) * strength + offset;
}

/// Magnifies texture coordinates around a centre, like a fisheye lens.
///
/// formula: uv + d dot(d, d)^2 strength + offset, d = uv - center
/// source: Unity Shader Graph, node Spherize
/// test: Spherize(float2(0.5, 0.5)) == float2(0.5, 0.5)
/// test: Spherize(float2(1, 0.5), 0.5, float2(16, 1), 0) == float2(1.5, 0.5)
/// test: Spherize(float2(0, 0), 0.5, 2, float2(0, 0.25)) == float2(-0.25, 0)
[node("UV/Spherize")] [also("Fisheye", "Bulge")]
float2 Spherize(
    float2 uv = uv0,       ///< texture coordinates
    float2 center = 0.5,   ///< what stays where it is
    float2 strength = 10,  ///< strength along u and v
    float2 offset = 0      ///< added to the result
) {
    float2 d = uv - center;
    float squared = dot(d, d);
    return uv + d * squared * squared * strength + offset;
}

/// PolarCoordinates as Unity computes them: the direction is 0 towards growing v, and a turn is 6.28 instead of 2 pi.
///
/// formula: (2 |d| radialScale, atan2(d.x, d.y) / 6.28 lengthScale), d = uv - center
/// source: Unity Shader Graph, node Polar Coordinates
/// test: PolarCoordinatesUnity(float2(0.5, 1)) == float2(1, 0)
/// test: PolarCoordinatesUnity(float2(1, 0.5)) == float2(1, 0.2501268036297606)
/// test: PolarCoordinatesUnity(float2(0.25, 0.25), 0.5, 2, 8) == float2(1.4142135623730951, -3.001521643557127)
[node("UV/Polar Coordinates (Unity)")]
float2 PolarCoordinatesUnity(
    float2 uv = uv0,        ///< texture coordinates; Unity's are (u, 1 - v)
    float2 center = 0.5,    ///< where the distance is zero
    float radialScale = 1,  ///< factor on the distance
    float lengthScale = 1   ///< factor on the direction
) {
    float2 d = uv - center;
    return float2(length(d) * 2 * radialScale, atan2(d.x, d.y) / 6.28 * lengthScale);
}
