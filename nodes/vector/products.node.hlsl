// Products of vectors, directions and distances.

/// The dot product: for unit vectors, the cosine of the angle between them.
///
/// formula: left.x right.x + left.y right.y + ...
/// test: Dot(float3(1, 2, 3), float3(4, -5, 6)) == 12
/// test: Dot(float2(3, 4), float2(-4, 3)) == 0
[node("Vector/Dot")] [also("DotProduct")]
float Dot(
    floatN left,  ///< first vector
    floatN right  ///< second vector
) {
    return dot(left, right);
}

/// The cross product: perpendicular to both vectors, as long as the area of the parallelogram that they span.
///
/// The axes are right-handed: the cross product of the x axis and the y axis is the z axis.
///
/// test: Cross(float3(1, 0, 0), float3(0, 1, 0)) == float3(0, 0, 1)
/// test: Cross(float3(1, 2, 3), float3(4, 5, 6)) == float3(-3, 6, -3)
[node("Vector/Cross")] [also("CrossProduct")]
float3 Cross(
    float3 left,  ///< first vector
    float3 right  ///< second vector
) {
    return cross(left, right);
}

/// The direction of a vector: the same vector with length one.
///
/// For the zero vector the result is not a number; SafeNormalize accepts it.
///
/// test: Normalize(float3(0, 3, -4)) == float3(0, 0.6, -0.8)
/// test: Normalize(float3(2, 2, 1)) == float3(2 / 3, 2 / 3, 1 / 3)
[node("Vector/Normalize")]
float3 Normalize(
    float3 value  ///< any vector but zero
) {
    return normalize(value);
}

/// The direction of a vector, or a fallback if the vector is zero.
///
/// test: SafeNormalize(float3(0, 3, 4), float3(0, 0, 1)) == float3(0, 0.6, 0.8)
/// test: SafeNormalize(float3(0, 0, 0), float3(0, 0, 1)) == float3(0, 0, 1)
/// test: SafeNormalize(float3(0, 1e-10, 0)) == float3(0, 1, 0)
[node("Vector/Safe Normalize")]
float3 SafeNormalize(
    float3 value,        ///< any vector
    float3 fallback = 0  ///< the result for a zero vector
) {
    float squared = dot(value, value);
    return squared > 1e-30 ? value * rsqrt(squared) : fallback;
}

/// The length of a vector.
///
/// test: Length(float3(2, 3, 6)) == 7
/// test: Length(float2(-3, 4)) == 5
[node("Vector/Length")] [also("Magnitude")]
float Length(
    floatN value  ///< any vector
) {
    return length(value);
}

/// The distance between two points.
///
/// test: Distance(float3(1, 1, 1), float3(3, 4, 7)) == 7
/// test: Distance(float2(1, 2), float2(4, -2)) == 5
[node("Vector/Distance")]
float Distance(
    floatN from,  ///< first point
    floatN to     ///< second point
) {
    return distance(from, to);
}

/// The direction of a ray after reflection at a mirror.
///
/// formula: incident - 2 dot(normal, incident) normal
/// test: Reflect(float3(0.6, 0, -0.8), float3(0, 0, 1)) == float3(0.6, 0, 0.8)
/// test: Reflect(float3(1, 2, 3), float3(0, 1, 0)) == float3(1, -2, 3)
[node("Vector/Reflect")] [also("Reflection")]
float3 Reflect(
    float3 incident,           ///< towards the surface: for a view vector, its negative
    float3 normal = normalWS  ///< unit normal of the mirror
) {
    return reflect(incident, normal);
}

/// The direction of a ray after refraction by Snell's law; zero if it is totally reflected.
///
/// formula: eta i - (eta (n.i) + sqrt(1 - eta^2 (1 - (n.i)^2))) n
/// test: Refract(float3(0, 0, -1), float3(0, 0, 1), 0.75) == float3(0, 0, -1)
/// test: Refract(float3(0.6, 0, -0.8), float3(0, 0, 1), 0.5) == float3(0.3, 0, -0.9539392014169457)
/// test: Refract(float3(0.8, 0, -0.6), float3(0, 0, 1), 1.5) == float3(0, 0, 0)
[node("Vector/Refract")]
float3 Refract(
    float3 incident,                    ///< unit vector towards the surface
    float3 normal = normalWS,          ///< unit normal, on the side the ray comes from
    [range(0.4, 2.5)] float eta = 0.75  ///< index of refraction before over behind: air into water is 0.75
) {
    return refract(incident, normal, eta);
}
