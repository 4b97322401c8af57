// Diffuse terms. Light is given as E / pi, the radiance of a white Lambert surface that faces the light. Therefore none
// of these terms is divided by pi: diffuse colour * term * light is radiance.

/// Lambert's diffuse light: a matte surface looks equally bright from everywhere.
///
/// In these units Lambert's BRDF is 1; only the cosine of the incident light remains.
///
/// formula: max(0, n.l)
/// source: Lambert, "Photometria", 1760
/// test: LambertDiffuse(0.5) == 0.5
/// test: LambertDiffuse(-0.5) == 0
[node("Lighting/Diffuse/Lambert")] [range(0, 1)]
float LambertDiffuse(
    [range(-1, 1)] float ndotl  ///< cosine of normal and light; below zero, the light is behind the surface
) {
    return max(ndotl, 0);
}

/// How HalfLambert shapes the wrapped cosine.
enum HalfLambertCurve {
    Linear,  ///< keeps it: the softer of the two forms
    Squared  ///< squares it, as in the game that introduced it
};

/// Lambert's light wrapped around to the far side, so that no part of an object is flat black. It is not physical.
///
/// formula: linear: scale n.l + offset, not clamped; squared: max(0, scale n.l + offset)^2
/// source: Mitchell, McTaggart and Green, "Shading in Valve's Source Engine", SIGGRAPH 2006
/// test: HalfLambert(1, Linear) == 1
/// test: HalfLambert(-0.5, Linear) == 0.25
/// test: HalfLambert(-0.5, Squared) == 0.0625
/// test: HalfLambert(0.8660254037844387, Squared) == 0.8705127018922195
/// test: HalfLambert(0.5, Linear, 0.75, 0.25) == 0.625
/// test: HalfLambert(-1, Linear, 0.75, 0.25) == -0.5
/// test: HalfLambert(-1, Squared, 0.75, 0.25) == 0
[node("Lighting/Diffuse/Half Lambert")]
float HalfLambert(
    [range(-1, 1)] float ndotl,              ///< cosine of normal and light, Signed: not clamped
    const HalfLambertCurve curve = Squared,  ///< shape of the falloff
    [range(0, 1)] float scale = 0.5,         ///< factor of the cosine; the sources call it alpha
    [range(0, 1)] float offset = 0.5         ///< added to it; the sources call it beta
) {
    float wrapped = scale * ndotl + offset;
    float lit = max(wrapped, 0);
    return curve == Linear ? wrapped : lit * lit;
}

/// Lambert's BRDF with its 1 / pi, for light that is given as irradiance.
///
/// The lights of this library are E / pi already: use LambertDiffuse with them.
///
/// formula: albedo / pi
/// source: Lambert, "Photometria", 1760
/// test: LambertBrdf(0.8) == float3(0.25464790894703254, 0.25464790894703254, 0.25464790894703254)
/// test: LambertBrdf(float3(0, 1, 0.5)) == float3(0, 0.3183098861837907, 0.15915494309189535)
[node("Lighting/Diffuse/Lambert BRDF")]
float3 LambertBrdf(
    [color] float3 albedo = 0.5  ///< share of the light that is scattered
) {
    return albedo * INV_PI;
}

/// Disney's diffuse term: darker at the silhouette of a smooth surface, brighter at that of a rough one.
///
/// Multiply by the cosine n.l as well. It is not divided by pi, and may exceed 1: it does not conserve energy.
///
/// formula: (1 + (f90 - 1) (1 - n.l)^5) (1 + (f90 - 1) (1 - n.v)^5), f90 = 0.5 + 2 roughness (l.h)^2
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, section 5.3
/// test: DisneyDiffuse(1, 1, 1, 0) == 1
/// test: DisneyDiffuse(0.5, 0.5, 0.5, 0.5) == 0.98443603515625
/// test: DisneyDiffuse(0.1, 0.1, 0.1, 0) == 0.4966796100249999
/// test: DisneyDiffuse(0, 0, 1, 1) == 6.25
[node("Lighting/Diffuse/Disney")] [range(0.25, 6.25)]
float DisneyDiffuse(
    [range(0, 1)] float ndotv,           ///< cosine of normal and view
    [range(0, 1)] float ndotl,           ///< cosine of normal and light
    [range(0, 1)] float ldoth,           ///< cosine of light and half vector
    [range(0, 1)] float roughness = 0.5  ///< perceptual roughness
) {
    float f90MinusOne = 2 * roughness * ldoth * ldoth - 0.5;
    float lightScatter = 1 + f90MinusOne * SchlickWeight(ndotl);
    float viewScatter = 1 + f90MinusOne * SchlickWeight(ndotv);
    return lightScatter * viewScatter;
}

/// Which fit of Oren and Nayar's model OrenNayarDiffuse computes.
enum OrenNayarForm {
    Qualitative,  ///< the short form of the paper
    Improved      ///< Fujii's: closer to the full model, and without its dark ring
};

/// Oren and Nayar's diffuse term, for rough matt surfaces like clay or the moon: flatter than Lambert.
///
/// Multiply by the cosine n.l as well. It is not divided by pi.
///
/// formula: s = l.v - (n.l) (n.v); qualitative: A + B max(0, s) / max(n.l, n.v), A = 1 - 0.5 r^2 / (r^2 + 0.33),
/// formula: B = 0.45 r^2 / (r^2 + 0.09); improved: (1 + r s / t) / (1 + (1/2 - 2/(3 pi)) r), t = max(n.l, n.v) or 1
/// source: Oren and Nayar, "Generalization of Lambert's Reflectance Model", SIGGRAPH 1994; Fujii, "A tiny improvement
/// source: of Oren-Nayar reflectance model", 2012
/// test: OrenNayarDiffuse(0.6, 0.8, 0.96, 0.5, Qualitative) == 0.9830121703853956
/// test: OrenNayarDiffuse(0.6, 0.8, 0, 0.5, Qualitative) == 0.7844827586206897
/// test: OrenNayarDiffuse(0.6, 0.8, 0.96, 0.5) == 1.1364662515121469
/// test: OrenNayarDiffuse(0.6, 0.8, 0, 0.5) == 0.6643956547301781
/// test: OrenNayarDiffuse(1, 1, 1, 0) == 1
[node("Lighting/Diffuse/Oren-Nayar")]
float OrenNayarDiffuse(
    [range(0, 1)] float ndotv,            ///< cosine of normal and view
    [range(0, 1)] float ndotl,            ///< cosine of normal and light
    [range(-1, 1)] float ldotv,           ///< cosine of light and view
    [range(0, 1)] float roughness = 0.5,  ///< spread of the facets' slopes: an angle in radians, or Fujii's 0 to 1
    const OrenNayarForm form = Improved   ///< which fit
) {
    float s = ldotv - ndotl * ndotv;
    float larger = max(max(ndotl, ndotv), 1e-4);
    if (form == Qualitative) {
        float r2 = roughness * roughness;
        return 1 - 0.5 * r2 / (r2 + 0.33) + 0.45 * r2 / (r2 + 0.09) * max(s, 0) / larger;
    }
    float t = s > 0 ? larger : 1;
    return (1 + roughness * s / t) / (1 + (0.5 - 0.6666666666666666 * INV_PI) * roughness);
}

/// Disney's flat diffuse term, which imitates light that passes through a thin layer below the surface, as in skin.
///
/// Multiply by the cosine n.l as well. It is not divided by pi.
///
/// formula: 1.25 (F (1 / (n.l + n.v) - 0.5) + 0.5), F as DisneyDiffuse with f90 = roughness (l.h)^2
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, section 5.3, after Hanrahan and Krueger 1993
/// test: DisneySubsurface(1, 1, 1, 0.5) == 0.625
/// test: DisneySubsurface(0.5, 0.5, 0.5, 0.5) == 1.216287612915039
/// test: DisneySubsurface(0.9, 0.1, 0.7, 0.3) == 0.9351923727864899
[node("Lighting/Diffuse/Disney Subsurface")]
float DisneySubsurface(
    [range(0, 1)] float ndotv,           ///< cosine of normal and view
    [range(0, 1)] float ndotl,           ///< cosine of normal and light
    [range(0, 1)] float ldoth,           ///< cosine of light and half vector
    [range(0, 1)] float roughness = 0.5  ///< perceptual roughness
) {
    float f90 = ldoth * ldoth * roughness;
    float f = (1 + (f90 - 1) * SchlickWeight(ndotl)) * (1 + (f90 - 1) * SchlickWeight(ndotv));
    return 1.25 * (f * (1 / max(ndotl + ndotv, 1e-4) - 0.5) + 0.5);
}
