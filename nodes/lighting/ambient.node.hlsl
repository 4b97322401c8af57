// Light from the surroundings: spherical harmonics for the diffuse part, and two factors that stand for what a rough
// surface does to the mirrored part.

// The normalisation of each real spherical harmonic up to second order, times the factor of the convolution with the
// clamped cosine (pi, 2 pi / 3, pi / 4), over pi.
const float SH_CONSTANT = 0.28209479177387814;    // sqrt(1 / (4 pi))
const float SH_LINEAR = 0.32573500793527994;      // sqrt(1 / (3 pi))
const float SH_PRODUCT = 0.27313710764801977;     // sqrt(15 / (64 pi))
const float SH_POLAR = 0.078847891313130012;      // sqrt(5 / (256 pi))
const float SH_DIFFERENCE = 0.13656855382400989;  // sqrt(15 / (256 pi))

/// Diffuse light of the surroundings, from nine coefficients of their radiance.
///
/// It is E / pi, so a colour times it is radiance. The coefficients are numbered l (l + 1) + m, without the
/// Condon-Shortley sign, and the polynomials take the world's x, y and z as they are, as in Unity. Nine coefficients
/// can swing below zero opposite to a strong light: the result is clamped.
///
/// formula: E(n) / pi = sum over l, m of A_l / pi c_lm Y_lm(n), A = pi, 2 pi / 3, pi / 4
/// source: Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001
/// test: EvaluateSH9(float3(0.6, 0, 0.8), 3.5449077018110318, 0, 0, 0, 0, 0, 0, 0, 0) == float3(1, 1, 1)
/// test: EvaluateSH9(float3(0, 0, 1), 0.9, 0.12, -0.3, 0.25, 0.05, -0.07, 0.11, 0.03, -0.04) == 0.17351134630479498
/// test: EvaluateSH9(float3(0, 1, 0), 0.9, 0.12, -0.3, 0.25, 0.05, -0.07, 0.11, 0.03, -0.04) == 0.28976298765724
/// test: EvaluateSH9(float3(0, 0, -1), 0.886226925, 0, 1.023326708, 0, 0, 0, 0.495415912, 0, 0) == float3(0, 0, 0)
[node("Lighting/Ambient/Evaluate SH9")]
float3 EvaluateSH9(
    float3 normal = normal_ws,  ///< unit normal in the world
    float3 sh0,                 ///< l = 0: the mean, over sqrt(4 pi)
    float3 sh1,                 ///< l = 1: along y
    float3 sh2,                 ///< l = 1: along z
    float3 sh3,                 ///< l = 1: along x
    float3 sh4,                 ///< l = 2: x y
    float3 sh5,                 ///< l = 2: y z
    float3 sh6,                 ///< l = 2: 3 z^2 - 1
    float3 sh7,                 ///< l = 2: x z
    float3 sh8                  ///< l = 2: x^2 - y^2
) {
    float3 n = normal;
    float3 irradiance = sh0 * SH_CONSTANT;
    irradiance += (sh1 * n.y + sh2 * n.z + sh3 * n.x) * SH_LINEAR;
    irradiance += (sh4 * (n.x * n.y) + sh5 * (n.y * n.z) + sh7 * (n.x * n.z)) * SH_PRODUCT;
    irradiance += sh6 * (SH_POLAR * (3 * n.z * n.z - 1));
    irradiance += sh8 * (SH_DIFFERENCE * (n.x * n.x - n.y * n.y));
    return max(irradiance, 0);
}

/// How much of the mirrored surroundings a rough surface keeps: 1 for a mirror, one half for the roughest.
///
/// It is the share of GGX facets that mirror a straight look to above the horizon.
///
/// formula: 1 / (alpha^2 + 1)
/// source: the GGX distribution integrated up to 45 degrees; as in Unity's Standard shader
/// test: SurfaceReduction(0) == 1
/// test: SurfaceReduction(0.25) == 0.9411764705882353
/// test: SurfaceReduction(1) == 0.5
[node("Lighting/Ambient/Surface Reduction")]
float SurfaceReduction(
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    return 1 / (alpha * alpha + 1);
}

/// The reflectance of the surroundings at a grazing angle: 1 for smooth or metallic surfaces, less for rough ones.
///
/// formula: saturate(smoothness + reflectivity)
/// source: as in Unity's Standard shader
/// test: GrazingTerm(0.5, 0.96) == 0.54
/// test: GrazingTerm(0.9, 0.5) == 1
/// test: GrazingTerm(0.1, 1) == 0.1
[node("Lighting/Ambient/Grazing Term")]
float GrazingTerm(
    [range(0, 1)] float smoothness = 0.5,              ///< 1 - perceptual roughness
    [range(0, 1)] float one_minus_reflectivity = 0.96  ///< share of the light that is not mirrored
) {
    return saturate(smoothness + 1 - one_minus_reflectivity);
}
