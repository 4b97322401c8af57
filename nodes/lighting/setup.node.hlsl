// From what an artist gives (a base colour, metallic or specular, roughness or smoothness) to what lighting computes
// with: a diffuse colour, the reflectance f0, and alpha.

/// How SpecularSetup keeps a surface from sending out more light than falls on it.
enum EnergyConservation {
    Monochrome,  ///< the diffuse colour is scaled by one minus the strongest specular channel: it keeps its hue
    Colored,     ///< each diffuse channel is scaled by one minus the same specular channel
    None         ///< the diffuse colour stays
};

/// Diffuse colour and reflectance of a surface between plastic and metal.
///
/// A dielectric mirrors 4 % of the light looked at straight, without colour, and scatters the rest; a metal mirrors in
/// its own colour and scatters nothing.
///
/// formula: f0 = lerp(0.04, base_color, metallic); diffuse = base_color 0.96 (1 - metallic)
/// source: the metallic workflow of Unity's Standard shader, in linear colour space
/// test: MetallicSetup(float3(0.8, 0.4, 0.1), 0.3).diffuse_color == float3(0.5376, 0.2688, 0.0672)
/// test: MetallicSetup(float3(0.8, 0.4, 0.1), 0.3).f0 == float3(0.268, 0.148, 0.058)
/// test: MetallicSetup(float3(0.8, 0.4, 0.1), 0.3).one_minus_reflectivity == 0.672
/// test: MetallicSetup(float3(0.8, 0.4, 0.1), 1).diffuse_color == float3(0, 0, 0)
/// test: MetallicSetup(float3(0.8, 0.4, 0.1), 1).f0 == float3(0.8, 0.4, 0.1)
[node("Lighting/Setup/Metallic")]
void MetallicSetup(
    [color] float3 base_color = 0.5,   ///< colour of the surface
    [range(0, 1)] float metallic = 0,  ///< 0 is a dielectric, 1 a metal
    out float3 diffuse_color,          ///< colour of the scattered light
    out float3 f0,                     ///< reflectance looked at straight
    out float one_minus_reflectivity   ///< share of the light that is not mirrored
) {
    const float dielectric = 0.04;
    one_minus_reflectivity = (1 - dielectric) * (1 - metallic);
    diffuse_color = base_color * one_minus_reflectivity;
    f0 = lerp(dielectric, base_color, metallic);
}

/// Diffuse colour and reflectance of a surface whose reflectance is given.
///
/// formula: f0 = specular
/// formula: monochrome: diffuse = base_color (1 - max(specular)); colored: diffuse = base_color (1 - specular)
/// source: the specular workflow of Unity's Standard shader
/// test: SpecularSetup(float3(1, 1, 1), float3(0.5, 0.2, 0.1)).diffuse_color == float3(0.5, 0.5, 0.5)
/// test: SpecularSetup(float3(1, 1, 1), float3(0.5, 0.2, 0.1), Colored).diffuse_color == float3(0.5, 0.8, 0.9)
/// test: SpecularSetup(float3(1, 0.5, 0), float3(0.5, 0.2, 0.1), None).diffuse_color == float3(1, 0.5, 0)
/// test: SpecularSetup(float3(1, 1, 1), float3(0.5, 0.2, 0.1)).f0 == float3(0.5, 0.2, 0.1)
/// test: SpecularSetup(float3(1, 1, 1), float3(0.1, 0.2, 0.75)).one_minus_reflectivity == 0.25
[node("Lighting/Setup/Specular")]
void SpecularSetup(
    [color] float3 base_color = 0.5,                     ///< colour of the scattered light, before conservation
    [color] float3 specular = 0.2,                       ///< reflectance looked at straight
    const EnergyConservation conservation = Monochrome,  ///< how the diffuse colour is scaled
    out float3 diffuse_color,                            ///< colour of the scattered light
    out float3 f0,                                       ///< reflectance looked at straight
    out float one_minus_reflectivity                     ///< share of the light that is not mirrored
) {
    one_minus_reflectivity = 1 - max(max(specular.r, specular.g), specular.b);
    diffuse_color = base_color;
    if (conservation == Monochrome) { diffuse_color = base_color * one_minus_reflectivity; }
    if (conservation == Colored) { diffuse_color = base_color * (1 - specular); }
    f0 = specular;
}

/// Perceptual roughness, from smoothness or glossiness.
///
/// formula: 1 - smoothness
/// test: RoughnessFromSmoothness(0.75) == 0.25
/// test: RoughnessFromSmoothness(1) == 0
[node("Lighting/Setup/Roughness from Smoothness")]
float RoughnessFromSmoothness(
    [range(0, 1)] float smoothness = 0.5  ///< 0 is dull, 1 a mirror
) {
    return 1 - smoothness;
}

/// The roughness that the microfacet formulas take: the square of the one that an artist sees as even steps.
///
/// The lower limit keeps the highlight of a lamp, which has no size, from becoming smaller than a pixel. Set it to zero
/// for the mapping alone.
///
/// formula: alpha = max(roughness^2, minimum)
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, section 5.4; the limit is Unity's
/// test: AlphaFromRoughness(0.5) == 0.25
/// test: AlphaFromRoughness(0) == 0.002
/// test: AlphaFromRoughness(0.01, 0) == 0.0001
[node("Lighting/Setup/Alpha from Roughness")]
float AlphaFromRoughness(
    [range(0, 1)] float roughness = 0.5,   ///< perceptual roughness
    [range(0, 0.1)] float minimum = 0.002  ///< lower limit of the result
) {
    return max(roughness * roughness, minimum);
}
