// Vectors in relation to one another: their parts, rotations, and masks of space.

/// The part of a vector that lies along another one: its shadow on that line.
///
/// formula: onto dot(vector, onto) / dot(onto, onto)
/// test: Projection(float3(3, 4, 5), float3(0, 2, 0)) == float3(0, 4, 0)
/// test: Projection(float2(2, 0), float2(1, 1)) == float2(1, 1)
/// test: Projection(float3(1, 2, 3), float3(1, 1, -1)) == float3(0, 0, 0)
[node("Vector/Projection")] [also("ProjectOnto")]
floatN Projection(
    floatN vector = 0,  ///< any vector
    floatN onto = 1     ///< the direction, of any length but zero
) {
    return onto * (dot(vector, onto) / dot(onto, onto));
}

/// The part of a vector that is perpendicular to another one: what Projection leaves.
///
/// formula: vector - from dot(vector, from) / dot(from, from)
/// test: Rejection(float3(3, 4, 5), float3(0, 2, 0)) == float3(3, 0, 5)
/// test: Rejection(float2(2, 0), float2(1, 1)) == float2(1, -1)
/// test: Rejection(float3(2, 4, 6), float3(1, 2, 3)) == float3(0, 0, 0)
[node("Vector/Rejection")]
floatN Rejection(
    floatN vector = 0,  ///< any vector
    floatN from = 1     ///< the direction whose part is taken away, of any length but zero
) {
    return vector - Projection(vector, from);
}

/// Rotates a vector about an axis through the origin.
///
/// Seen against the axis, a positive angle turns counter-clockwise: from x to y about z.
///
/// formula: v cos + cross(k, v) sin + k dot(k, v) (1 - cos), k the axis
/// source: Rodrigues, 1840: rotation about an axis
/// test: RotateAboutAxis(float3(1, 0, 0), float3(0, 0, 2), 1.5707963267948966) == float3(0, 1, 0)
/// test: RotateAboutAxis(float3(1, 2, 3), float3(1, 1, 1), 2.0943951023931953) == float3(3, 1, 2)
/// test: RotateAboutAxis(float3(1, 2, 3), float3(0, 5, 0), 0) == float3(1, 2, 3)
/// test: RotateAboutAxis(float3(1, 2, 3), float3(0, 0, 0), 1) == float3(1, 2, 3)
[node("Vector/Rotate About Axis")] [also("Rotate3D")]
float3 RotateAboutAxis(
    float3 vector = 0,              ///< any vector
    float3 axis = float3(0, 1, 0),  ///< direction of the axis, of any length; if it is zero, nothing turns
    [unit("rad")] float angle = 0   ///< angle of the rotation
) {
    float3 k = SafeNormalize(axis);
    float turns = dot(k, k);
    float cosine = lerp(1, cos(angle), turns);
    return vector * cosine + cross(k, vector) * sin(angle) + k * (dot(k, vector) * (1 - cosine));
}

/// A mask in the form of a ball with a soft edge: 1 inside, 0 outside.
///
/// formula: 1 - saturate((|position - center| - radius) / (1 - hardness))
/// test: SphereMask(float3(0.5, 0.5, 0.5), float3(0.5, 0.5, 0.5)) == 1
/// test: SphereMask(float2(3, 4), float2(0, 0), 4.5, 0) == 0.5
/// test: SphereMask(float3(2, 0, 0), float3(0, 0, 0), 1, 0.5) == 0
/// test: SphereMask(2, 0, 2, 1) == 1
/// test: SphereMask(2.1, 0, 2, 1) == 0
[node("Vector/Sphere Mask")] [range(0, 1)]
float SphereMask(
    floatN position = positionWS,       ///< any point, as wide as `center`
    floatN center = 0.5,                ///< the middle of the ball
    float radius = 0.1,                 ///< where the edge begins
    [range(0, 1)] float hardness = 0.8  ///< 1 is a sharp edge; else the edge is 1 - hardness wide
) {
    // A sharp edge has this width, so that a point on it has a value.
    return 1 - saturate((distance(position, center) - radius) / max(1 - hardness, 1e-5));
}

/// A bright rim: strongest where the surface turns away from the viewer. It is an effect; FresnelSchlick is the
/// reflectance of a surface.
///
/// formula: (1 - saturate(n.v))^power
/// test: FresnelEffect(float3(0, 0, 1), float3(0, 0, 1), 2) == 0
/// test: FresnelEffect(float3(0, 0, 3), float3(0.8, 0, 0.6), 2) == 0.16
/// test: FresnelEffect(float3(0, 0, 1), float3(0.6, 0, -0.8), 5) == 1
[node("Vector/Fresnel Effect")] [also("RimLight", "Facing")] [range(0, 1)]
float FresnelEffect(
    float3 normal = normalWS,        ///< normal, of any length but zero
    float3 viewDir = viewDirWS,      ///< unit direction to the viewer
    [range(0.1, 10)] float power = 1  ///< the larger, the thinner the rim
) {
    float rim = 1 - saturate(dot(normalize(normal), viewDir));
    return pow(max(rim, 0), power);
}

/// What RefractUnity returns for a ray that is totally reflected.
enum RefractMode {
    Safe,          ///< a ray along the surface
    CriticalAngle  ///< the mirrored ray
};

/// The direction of a ray that crosses the border of two media, and how much light crosses it.
///
/// Both indices count as 1 if they are smaller.
///
/// formula: eta i - (eta (n.i) + sqrt(max(k, 0))) n, eta = source / medium, k = 1 - eta^2 (1 - (n.i)^2)
/// formula: intensity: into the denser medium (1 - f0) (1 - (1 + n.i)^5), f0 = ((medium - source) / (medium + source))^2;
/// formula: into the thinner one Fresnel's reflectance, as Unity's node computes it; if k < 0, 1 for Safe and 0 for CriticalAngle
/// source: Snell's law; Schlick, "An Inexpensive BRDF Model for Physically-Based Rendering", 1994; Unity's Refract
/// test: RefractUnity(float3(0, 0, 1), float3(0, 0, -1)) == float3(0, 0, 1)
/// test: RefractUnity(float3(0, 0, 1), float3(0, 0, -1)).intensity == 0.96
/// test: RefractUnity(float3(0.6, 0, -0.8), float3(0, 0, 1), 1, 2) == float3(0.3, 0, -0.9539392014169457)
/// test: RefractUnity(float3(0.6, 0, -0.8), float3(0, 0, 1), 1, 2).intensity == 0.8886044444444444
/// test: RefractUnity(float3(0.8, 0, -0.6), float3(0, 0, 1), 1.5, 0.5, Safe) == float3(1.2, 0, 0)
/// test: RefractUnity(float3(0.8, 0, -0.6), float3(0, 0, 1), 1.5, 1, CriticalAngle) == float3(0.8, 0, 0.6)
/// test: RefractUnity(float3(0.8, 0, -0.6), float3(0, 0, 1), 1.5, 1, CriticalAngle).intensity == 0
/// test: RefractUnity(float3(0.8, 0, -0.6), float3(0, 0, 1), 1.5, 1, Safe).intensity == 1
/// test: RefractUnity(float3(0, 0, -1), float3(0, 0, 1), 1.5, 1, Safe).intensity == 0.04
[node("Vector/Refract Unity")]
float3 RefractUnity(
    float3 incident = float3(0, 0, 1),       ///< unit vector towards the surface
    float3 normal = float3(0, 0, -1),        ///< unit normal, on the side the ray comes from
    [range(1, 3)] float iorSource = 1,       ///< index of refraction before the surface
    [range(1, 3)] float iorMedium = 1.5,     ///< index of refraction behind it
    const RefractMode mode = Safe,           ///< the result of total reflection
    [range(0, 1)] out float intensity        ///< the share of light that crosses the border into a denser medium; see the formula for a thinner one
) {
    float before = max(iorSource, 1);
    float behind = max(iorMedium, 1);
    float eta = before / behind;
    float cosine = dot(incident, normal);
    float k = 1 - eta * eta * (1 - cosine * cosine);
    float f0 = (behind - before) / (behind + before);
    float grazing = SchlickWeight(saturate(-cosine));
    float total = mode == Safe ? 1 : 0;
    float exact = k >= 0 ? FresnelDielectric(saturate(-cosine), behind / before) : total;
    intensity = before <= behind ? (1 - f0 * f0) * (1 - grazing) : exact;
    float3 bent = eta * incident - (eta * cosine + sqrt(max(k, 0))) * normal;
    if (mode == Safe) { return bent; }
    return k >= 0 ? bent : reflect(incident, normal);
}
