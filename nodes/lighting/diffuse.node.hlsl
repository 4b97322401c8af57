// Diffuse terms. Light is given as E / pi, what a white Lambert surface sends out when the light falls on it straight.
// So none of these terms is divided by pi: diffuse colour * term * light is radiance.

/// Lambert's diffuse light: a matte surface looks equally bright from everywhere.
///
/// In these units Lambert's BRDF is 1; what is left is the cosine with which the light falls in.
///
/// formula: max(0, n.l)
/// source: Lambert, "Photometria", 1760
/// test: LambertDiffuse(0.5) == 0.5
/// test: LambertDiffuse(-0.5) == 0
[node("Lighting/Diffuse/Lambert")]
float LambertDiffuse(
    [range(-1, 1)] float ndotl  ///< cosine of normal and light; below zero the light is behind
) {
    return max(ndotl, 0);
}

/// What HalfLambert does with the wrapped cosine.
enum HalfLambertCurve {
    Linear,  ///< nothing: the softer form of the two
    Squared  ///< squares it, as in the game that it comes from
};

/// Lambert's light wrapped around to the far side, so that no part of an object is flat black. It is not physical.
///
/// formula: linear: 0.5 n.l + 0.5; squared: (0.5 n.l + 0.5)^2
/// source: Mitchell, McTaggart and Green, "Shading in Valve's Source Engine", SIGGRAPH 2006
/// test: HalfLambert(1, Linear) == 1
/// test: HalfLambert(-0.5, Linear) == 0.25
/// test: HalfLambert(-0.5, Squared) == 0.0625
/// test: HalfLambert(0.8660254037844387, Squared) == 0.8705127018922195
[node("Lighting/Diffuse/Half Lambert")]
float HalfLambert(
    [range(-1, 1)] float ndotl,             ///< cosine of normal and light, Signed: not clamped
    const HalfLambertCurve curve = Squared  ///< how soft
) {
    float wrapped = 0.5 * ndotl + 0.5;
    return curve == Linear ? wrapped : wrapped * wrapped;
}

/// Disney's diffuse term: darker at the outline of a smooth surface, brighter at that of a rough one.
///
/// Multiply by the cosine n.l as well. It is not divided by pi, and may exceed 1: it does not conserve energy.
///
/// formula: (1 + (f90 - 1) (1 - n.l)^5) (1 + (f90 - 1) (1 - n.v)^5), f90 = 0.5 + 2 roughness (l.h)^2
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, section 5.3
/// test: DisneyDiffuse(1, 1, 1, 0) == 1
/// test: DisneyDiffuse(0.5, 0.5, 0.5, 0.5) == 0.98443603515625
/// test: DisneyDiffuse(0.1, 0.1, 0.1, 0) == 0.4966796100249999
/// test: DisneyDiffuse(0, 0, 1, 1) == 6.25
[node("Lighting/Diffuse/Disney")]
float DisneyDiffuse(
    [range(0, 1)] float ndotv,           ///< cosine of normal and view
    [range(0, 1)] float ndotl,           ///< cosine of normal and light
    [range(0, 1)] float ldoth,           ///< cosine of light and half vector
    [range(0, 1)] float roughness = 0.5  ///< perceptual roughness
) {
    float f90 = 0.5 + 2 * roughness * ldoth * ldoth;
    float light_scatter = 1 + (f90 - 1) * SchlickWeight(ndotl);
    float view_scatter = 1 + (f90 - 1) * SchlickWeight(ndotv);
    return light_scatter * view_scatter;
}
