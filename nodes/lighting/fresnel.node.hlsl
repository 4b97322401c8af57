// Fresnel terms F: how much light a surface mirrors. Looked at straight it is f0; at grazing angles everything becomes
// a mirror. All use Schlick's curve, within 0.04 of the exact equations for glass.

/// How far a surface is on the way from its straight reflectance to its grazing one.
///
/// formula: (1 - cosine)^5
/// source: Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", Computer Graphics Forum 13(3), 1994
/// test: SchlickWeight(1) == 0
/// test: SchlickWeight(0.5) == 0.03125
/// test: SchlickWeight(0) == 1
/// test: SchlickWeight(1.000001) == 0
[node("Lighting/Fresnel/Schlick Weight")]
float SchlickWeight(
    [range(0, 1)] float cosine  ///< cosine of the angle of incidence
) {
    float m = saturate(1 - cosine);
    float m2 = m * m;
    return m2 * m2 * m;
}

/// Schlick's Fresnel reflectance, for the mirroring of a light.
///
/// formula: f0 + (f90 - f0) (1 - cosine)^5
/// source: Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", Computer Graphics Forum 13(3), 1994
/// test: FresnelSchlick(float3(0.04, 0.5, 1), 0.5) == float3(0.07, 0.515625, 1)
/// test: FresnelSchlick(0.02, 0.1) == float3(0.5986802, 0.5986802, 0.5986802)
/// test: FresnelSchlick(0.04, 1) == float3(0.04, 0.04, 0.04)
/// test: FresnelSchlick(0.04, 0, 0.7) == float3(0.7, 0.7, 0.7)
[node("Lighting/Fresnel/Schlick")]
float3 FresnelSchlick(
    [color] float3 f0 = 0.04,    ///< reflectance looked at straight
    [range(0, 1)] float cosine,  ///< cosine of light and half vector
    [range(0, 1)] float f90 = 1  ///< reflectance at a grazing angle
) {
    return f0 + (f90 - f0) * SchlickWeight(cosine);
}

/// Schlick's Fresnel reflectance, for the mirroring of the surroundings.
///
/// Its cosine is that of normal and view, as the surroundings have no half vector; f90 is GrazingTerm's.
///
/// formula: lerp(f0, f90, (1 - cosine)^5)
/// source: Schlick 1994; the use of a grazing reflectance below 1 as in Unity's Standard shader
/// test: FresnelLerp(0.04, 0.7, 0.6) == float3(0.0467584, 0.0467584, 0.0467584)
/// test: FresnelLerp(0.04, 0.7, 0.2) == float3(0.2562688, 0.2562688, 0.2562688)
/// test: FresnelLerp(float3(0.1, 0.2, 0.3), 0.7, 0) == float3(0.7, 0.7, 0.7)
[node("Lighting/Fresnel/Lerp")]
float3 FresnelLerp(
    [color] float3 f0 = 0.04,   ///< reflectance looked at straight
    [color] float3 f90 = 1,     ///< reflectance at a grazing angle
    [range(0, 1)] float cosine  ///< cosine of normal and view
) {
    return lerp(f0, f90, SchlickWeight(cosine));
}
