// Fresnel terms F: the share of light that a surface reflects. At normal incidence it is f0; at grazing angles every
// surface becomes a mirror. Schlick's curve is within 0.04 of the exact equations for glass; both are here.

/// Schlick's weight: 0 at normal incidence, 1 at a grazing angle.
///
/// formula: (1 - cosine)^5
/// source: Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", Computer Graphics Forum 13(3), 1994
/// test: SchlickWeight(1) == 0
/// test: SchlickWeight(0.5) == 0.03125
/// test: SchlickWeight(0) == 1
/// test: SchlickWeight(1.000001) == 0
[node("Lighting/Fresnel/Schlick Weight")] [range(0, 1)]
float SchlickWeight(
    [range(0, 1)] float cosine  ///< cosine of the angle of incidence
) {
    float m = saturate(1 - cosine);
    float m2 = m * m;
    return m2 * m2 * m;
}

/// Schlick's Fresnel reflectance, for direct light.
///
/// formula: f0 + (f90 - f0) (1 - cosine)^5
/// source: Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", Computer Graphics Forum 13(3), 1994
/// test: FresnelSchlick(float3(0.04, 0.5, 1), 0.5) == float3(0.07, 0.515625, 1)
/// test: FresnelSchlick(0.02, 0.1) == float3(0.5986802, 0.5986802, 0.5986802)
/// test: FresnelSchlick(0.04, 1) == float3(0.04, 0.04, 0.04)
/// test: FresnelSchlick(0.04, 0, 0.7) == float3(0.7, 0.7, 0.7)
[node("Lighting/Fresnel/Schlick")] [also("Fresnel", "FresnelTerm")] [range(0, 1)]
float3 FresnelSchlick(
    [color] float3 f0 = 0.04,    ///< reflectance at normal incidence
    [range(0, 1)] float cosine,  ///< cosine of light and half vector
    [range(0, 1)] float f90 = 1  ///< reflectance at a grazing angle
) {
    return f0 + (f90 - f0) * SchlickWeight(cosine);
}

/// Schlick's Fresnel reflectance, for light from the environment.
///
/// It uses the cosine of normal and view, because the environment has no half vector; GrazingTerm computes f90.
///
/// formula: lerp(f0, f90, (1 - cosine)^5)
/// source: Schlick 1994; the use of a grazing reflectance below 1 as in Unity's Standard shader
/// test: FresnelLerp(0.04, 0.7, 0.6) == float3(0.0467584, 0.0467584, 0.0467584)
/// test: FresnelLerp(0.04, 0.7, 0.2) == float3(0.2562688, 0.2562688, 0.2562688)
/// test: FresnelLerp(float3(0.1, 0.2, 0.3), 0.7, 0) == float3(0.7, 0.7, 0.7)
[node("Lighting/Fresnel/Lerp")] [range(0, 1)]
float3 FresnelLerp(
    [color] float3 f0 = 0.04,   ///< reflectance at normal incidence
    [color] float3 f90 = 1,     ///< reflectance at a grazing angle
    [range(0, 1)] float cosine  ///< cosine of normal and view
) {
    return lerp(f0, f90, SchlickWeight(cosine));
}

/// Schlick's reflectance with the fourth power instead of the fifth: cheaper, and slightly too bright.
///
/// formula: lerp(f0, f90, (1 - cosine)^4)
/// source: Unity built-in shaders, FresnelLerpFast
/// test: FresnelLerpFast(0.04, 0.7, 1) == float3(0.04, 0.04, 0.04)
/// test: FresnelLerpFast(0.04, 0.7, 0.2) == float3(0.310336, 0.310336, 0.310336)
/// test: FresnelLerpFast(0.04, 0.7, 0.6) == float3(0.056896, 0.056896, 0.056896)
[node("Lighting/Fresnel/Lerp Fast")] [range(0, 1)]
float3 FresnelLerpFast(
    [color] float3 f0 = 0.04,   ///< reflectance at normal incidence
    [color] float3 f90 = 1,     ///< reflectance at a grazing angle
    [range(0, 1)] float cosine  ///< cosine of normal and view
) {
    float m = saturate(1 - cosine);
    return lerp(f0, f90, m * m * (m * m));
}

/// Schlick's reflectance for the environment, with a lower grazing reflectance for rough surfaces.
///
/// formula: f0 + (max(1 - roughness, f0) - f0) (1 - cosine)^5
/// source: Lagarde, "Adopting a physically based shading model", 2011
/// test: FresnelSchlickRoughness(0.04, 0.6, 0.3) == float3(0.0467584, 0.0467584, 0.0467584)
/// test: FresnelSchlickRoughness(0.04, 0.2, 0.3) == float3(0.2562688, 0.2562688, 0.2562688)
/// test: FresnelSchlickRoughness(float3(0.2, 0.5, 0.9), 0, 0.6) == float3(0.4, 0.5, 0.9)
[node("Lighting/Fresnel/Schlick Roughness")] [range(0, 1)]
float3 FresnelSchlickRoughness(
    [color] float3 f0 = 0.04,            ///< reflectance at normal incidence
    [range(0, 1)] float cosine,          ///< cosine of normal and view
    [range(0, 1)] float roughness = 0.5  ///< perceptual roughness
) {
    return f0 + (max(1 - roughness, f0) - f0) * SchlickWeight(cosine);
}

/// Schlick's reflectance with a power of two instead of the fifth power, which some processors compute faster.
///
/// formula: f0 + (1 - f0) 2^((-5.55473 c - 6.98316) c)
/// source: Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013, after Lagarde 2012
/// test: FresnelSphericalGaussian(0.04, 0.2) == float3(0.3525773422802083, 0.3525773422802083, 0.3525773422802083)
/// test: FresnelSphericalGaussian(0.04, 0.8) == float3(0.041699765111226, 0.041699765111226, 0.041699765111226)
/// test: FresnelSphericalGaussian(1, 0.3) == float3(1, 1, 1)
[node("Lighting/Fresnel/Spherical Gaussian")] [range(0, 1)]
float3 FresnelSphericalGaussian(
    [color] float3 f0 = 0.04,   ///< reflectance at normal incidence
    [range(0, 1)] float cosine  ///< cosine of light and half vector
) {
    return f0 + (1 - f0) * exp2((-5.55473 * cosine - 6.98316) * cosine);
}

/// The exact reflectance of glass, water and other dielectrics, for unpolarised light.
///
/// formula: 1/2 ((g - c) / (g + c))^2 (1 + ((c (g + c) - 1) / (c (g - c) + 1))^2), g^2 = eta^2 - 1 + c^2
/// source: Cook and Torrance, ACM TOG 1(1), 1982, after Fresnel 1823
/// test: FresnelDielectric(1, 1.5) == 0.04
/// test: FresnelDielectric(0.2, 1.5) == 0.3388943909565793
/// test: FresnelDielectric(0.8, 1 / 1.5) == 0.11414110022135383
/// test: FresnelDielectric(0.5, 1 / 1.5) == 1
[node("Lighting/Fresnel/Dielectric")] [range(0, 1)]
float FresnelDielectric(
    [range(0, 1)] float cosine,       ///< cosine of the angle of incidence
    [range(0.25, 4)] float eta = 1.5  ///< index of refraction behind the surface divided by that in front of it
) {
    float c = saturate(cosine);
    float g2 = eta * eta - 1 + c * c;
    float g = sqrt(max(g2, 0));
    float a = (g - c) / max(g + c, 1e-6);
    float b = (c * (g + c) - 1) / (c * (g - c) + 1);
    // Below the critical angle, all light is reflected.
    return g2 <= 0 ? 1 : saturate(0.5 * a * a * (1 + b * b));
}

/// The exact reflectance of a metal, for unpolarised light. Each channel has its own index.
///
/// formula: (Rs + Rp) / 2 with the complex index n + i k
/// source: Born and Wolf, "Principles of Optics", section 14.2, written without complex numbers
/// test: FresnelConductor(1, 0.2, 3.9) == float3(0.951951951951952, 0.951951951951952, 0.951951951951952)
/// test: FresnelConductor(0.6, 0.2, 3.9) == float3(0.9481898551584201, 0.9481898551584201, 0.9481898551584201)
/// test: FresnelConductor(0.2, 1.5, 0) == float3(0.3388943909565793, 0.3388943909565793, 0.3388943909565793)
[node("Lighting/Fresnel/Conductor")] [range(0, 1)]
float3 FresnelConductor(
    [range(0, 1)] float cosine,                          ///< cosine of the angle of incidence
    [range(0, 10)] float3 n = float3(0.18, 0.42, 1.37),  ///< index of refraction, of red, green and blue; this is gold
    [range(0, 10)] float3 k = float3(3.42, 2.35, 1.77)   ///< coefficient of extinction
) {
    float c = saturate(cosine);
    float c2 = c * c;
    float s2 = 1 - c2;
    float3 difference = n * n - k * k - s2;
    float3 squares = sqrt(difference * difference + 4 * n * n * k * k);
    float3 sum = squares + c2;
    float3 product = 2 * c * sqrt(max(0.5 * (squares + difference), 0));
    float3 rs = (sum - product) / max(sum + product, 1e-6);
    float3 above = c2 * squares + s2 * s2;
    float3 beside = product * s2;
    float3 rp = rs * (above - beside) / max(above + beside, 1e-6);
    return saturate(0.5 * (rs + rp));
}

/// The reflectance at normal incidence of the boundary between two media.
///
/// formula: ((n1 - n2) / (n1 + n2))^2
/// source: Fresnel's equations at normal incidence
/// test: F0FromIor(1, 1.5) == 0.04
/// test: F0FromIor(1, 1.33) == 0.020059312199524774
/// test: F0FromIor(1.5, 1.5) == 0
[node("Lighting/Fresnel/F0 from IOR")] [range(0, 1)]
float F0FromIor(
    [range(1, 4)] float before = 1,   ///< index of refraction of the medium that the light comes from: 1 is air
    [range(1, 4)] float behind = 1.5  ///< index of refraction of the surface
) {
    float ratio = (before - behind) / (before + behind);
    return ratio * ratio;
}

/// The index of refraction, in air, of a reflectance at normal incidence.
///
/// formula: (1 + sqrt(f0)) / (1 - sqrt(f0))
/// source: Fresnel's equations at normal incidence
/// test: IorFromF0(0.04) == 1.5
/// test: IorFromF0(0.25) == 3
/// test: IorFromF0(0) == 1
[node("Lighting/Fresnel/IOR from F0")] [range(1, 400)]
float IorFromF0(
    [range(0, 0.99)] float f0 = 0.04  ///< reflectance at normal incidence
) {
    float root = sqrt(clamp(f0, 0, 0.9999));
    return (1 + root) / (1 - root);
}

/// The reflectance at normal incidence of a metal.
///
/// formula: ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2)
/// source: Born and Wolf, "Principles of Optics", section 14.2
/// test: F0FromConductor(0.2, 3.9) == float3(0.951951951951952, 0.951951951951952, 0.951951951951952)
/// test: F0FromConductor(1.5, 0) == float3(0.04, 0.04, 0.04)
[node("Lighting/Fresnel/F0 from Conductor")] [range(0, 1)]
float3 F0FromConductor(
    [range(0, 10)] float3 n = float3(0.18, 0.42, 1.37),  ///< index of refraction, of red, green and blue; this is gold
    [range(0, 10)] float3 k = float3(3.42, 2.35, 1.77)   ///< coefficient of extinction
) {
    float3 k2 = k * k;
    return ((n - 1) * (n - 1) + k2) / ((n + 1) * (n + 1) + k2);
}

/// The reflectance at normal incidence of a dielectric, on an artist's scale from 0 to 1: 0.5 is common plastic.
///
/// formula: 0.08 specular
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, section 5.5
/// test: F0FromSpecularLevel(0.5) == 0.04
/// test: F0FromSpecularLevel(1) == 0.08
[node("Lighting/Fresnel/F0 from Specular Level")] [range(0, 0.08)]
float F0FromSpecularLevel(
    [range(0, 1)] float specular = 0.5  ///< specular level
) {
    return 0.08 * specular;
}
