// Light from the environment: spherical harmonics for the diffuse part, and factors for the specular part of a rough
// surface.

// The normalisation of each real spherical harmonic up to second order, times the factor of the convolution with the
// clamped cosine (pi, 2 pi / 3, pi / 4), over pi.
const float SH_CONSTANT = 0.28209479177387814;    // sqrt(1 / (4 pi))
const float SH_LINEAR = 0.32573500793527994;      // sqrt(1 / (3 pi))
const float SH_PRODUCT = 0.27313710764801977;     // sqrt(15 / (64 pi))
const float SH_POLAR = 0.078847891313130012;      // sqrt(5 / (256 pi))
const float SH_DIFFERENCE = 0.13656855382400989;  // sqrt(15 / (256 pi))

/// Diffuse light of the environment, from nine coefficients of its radiance.
///
/// The result is E / pi, so a colour times it is radiance. The coefficients are numbered l (l + 1) + m, without the
/// Condon-Shortley sign, and the polynomials use the world's x, y and z unchanged, as in Unity. Nine coefficients can
/// swing below zero opposite to a strong light: the result is clamped.
///
/// formula: E(n) / pi = sum over l, m of A_l / pi c_lm Y_lm(n), A = pi, 2 pi / 3, pi / 4
/// source: Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001
/// test: EvaluateSH9(float3(0.6, 0, 0.8), 3.5449077018110318, 0, 0, 0, 0, 0, 0, 0, 0) == float3(1, 1, 1)
/// test: EvaluateSH9(float3(0, 0, 1), 0.9, 0.12, -0.3, 0.25, 0.05, -0.07, 0.11, 0.03, -0.04) == 0.17351134630479498
/// test: EvaluateSH9(float3(0, 1, 0), 0.9, 0.12, -0.3, 0.25, 0.05, -0.07, 0.11, 0.03, -0.04) == 0.28976298765724
/// test: EvaluateSH9(float3(0, 0, -1), 0.886226925, 0, 1.023326708, 0, 0, 0, 0.495415912, 0, 0) == float3(0, 0, 0)
[node("Lighting/Ambient/Evaluate SH9")]
float3 EvaluateSH9(
    float3 normal = normalWS,  ///< unit normal in the world
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

/// Which curve SurfaceReduction follows.
enum SurfaceReductionForm {
    Linear,      ///< Unity's best model (BRDF1), in linear colour space
    Gamma,       ///< a fit of it for lighting in gamma space
    SimpleLinear ///< Unity's second model (BRDF2), in linear colour space
};

/// The share of environment reflections that a rough surface keeps: 1 for a mirror, 0.5 for the roughest.
///
/// It is the share of GGX facets that reflect the view to above the horizon; exact for a view along the normal.
///
/// formula: linear: 1 / (alpha^2 + 1); gamma: 1 - 0.28 r^3; simple: 1 - r^3 (0.6 - 0.08 r); r = sqrt(alpha)
/// source: the GGX distribution integrated up to 45 degrees; Unity built-in shaders, BRDF1 and BRDF2
/// test: SurfaceReduction(0) == 1
/// test: SurfaceReduction(0.25) == 0.9411764705882353
/// test: SurfaceReduction(1) == 0.5
/// test: SurfaceReduction(0.09, Gamma) == 0.99244
/// test: SurfaceReduction(0.09, SimpleLinear) == 0.984448
[node("Lighting/Ambient/Surface Reduction")] [range(0.48, 1)]
float SurfaceReduction(
    [range(0, 1)] float alpha = 0.25,         ///< roughness squared
    const SurfaceReductionForm form = Linear  ///< which curve
) {
    float r = sqrt(max(alpha, 0));
    if (form == Gamma) { return 1 - 0.28 * alpha * r; }
    if (form == SimpleLinear) { return 1 - alpha * r * (0.6 - 0.08 * r); }
    return 1 / (alpha * alpha + 1);
}

/// The reflectance at a grazing angle, for the environment: 1 for smooth or metallic surfaces, less for rough ones.
///
/// formula: saturate(smoothness + reflectivity)
/// source: as in Unity's Standard shader
/// test: GrazingTerm(0.5, 0.96) == 0.54
/// test: GrazingTerm(0.9, 0.5) == 1
/// test: GrazingTerm(0.1, 1) == 0.1
[node("Lighting/Ambient/Grazing Term")] [range(0, 1)]
float GrazingTerm(
    [range(0, 1)] float smoothness = 0.5,              ///< 1 - perceptual roughness
    [range(0, 1)] float oneMinusReflectivity = 0.96  ///< share of the light that is not reflected specularly
) {
    return saturate(smoothness + 1 - oneMinusReflectivity);
}

/// Which axis of the spherical harmonics points up.
enum SHOrder {
    ZUp,  ///< the order of the papers, and of Unity: y, z, x; xy, yz, 3z^2 - 1, xz, x^2 - y^2
    YUp   ///< y and z exchanged
};

/// The nine real spherical harmonics of a direction, up to second order.
///
/// They have no Condon-Shortley sign, and are grouped by order: the constant, then l = 1, then l = 2.
///
/// formula: Y_00 = sqrt(1 / (4 pi)), Y_1m = sqrt(3 / (4 pi)) (y, z, x), ...
/// source: Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001
/// test: SHBasis(float3(0.6, 0, 0.8)).l0 == 0.28209479177387814
/// test: SHBasis(float3(0.6, 0, 0.8)).l1 == float3(0, 0.390882009522336, 0.29316150714175193)
/// test: SHBasis(float3(0.6, 0, 0.8)).l2 == float4(0, 0, 0.29016024003231855, 0.5244232466841979)
/// test: SHBasis(float3(0.6, 0, 0.8)).l2Last == 0.19665871750657424
/// test: SHBasis(float3(0.6, 0.8, 0), YUp).l1 == float3(0, 0.390882009522336, 0.29316150714175193)
[node("Lighting/Ambient/SH Basis")]
void SHBasis(
    float3 direction = normalWS,  ///< unit direction
    const SHOrder order = ZUp,     ///< which axis is up
    out float l0,                  ///< the constant
    out float3 l1,                 ///< m = -1, 0, 1
    out float4 l2,                 ///< m = -2, -1, 0, 1
    out float l2Last              ///< m = 2
) {
    float3 n = order == ZUp ? direction : direction.xzy;
    l0 = 0.28209479177387814;
    l1 = 0.4886025119029199 * n.yzx;
    l2 = float4(1.0925484305920792 * n.x * n.y, 1.0925484305920792 * n.y * n.z,
                0.31539156525252005 * (3 * n.z * n.z - 1), 1.0925484305920792 * n.x * n.z);
    l2Last = 0.5462742152960396 * (n.x * n.x - n.y * n.y);
}

/// The factors that convolve each order of spherical harmonics with the clamped cosine.
///
/// formula: pi, 2 pi / 3, pi / 4
/// source: Ramamoorthi and Hanrahan, SIGGRAPH 2001, eq. 8
/// test: SHCosineFactors() == float3(3.141592653589793, 2.0943951023931953, 0.7853981633974483)
[node("Lighting/Ambient/SH Cosine Factors")]
float3 SHCosineFactors() {
    return PI * float3(1, 2.0 / 3, 0.25);
}

/// Packs nine radiance coefficients of one channel into the seven-vector form that Unity's shaders read.
///
/// Use it for red, green and blue: a is unity_SHAr (g, b), b is unity_SHBr, and c is one channel of unity_SHC.
///
/// formula: u_i = c_i A_l / pi K_i; a = (u3, u1, u2, u0 - u6), b = (u4, u5, 3 u6, u7), c = u8
/// source: Sloan, "Stupid Spherical Harmonics Tricks", GDC 2008, appendix A10
/// test: PackSH9(0.9, float3(0.12, -0.3, 0.25), float4(0.05, -0.07, 0.11, 0.03), -0.04).a == float4(0.08143375198381998, 0.03908820095223359, -0.09772050238058397, 0.24521204455204604)
/// test: PackSH9(0.9, float3(0.12, -0.3, 0.25), float4(0.05, -0.07, 0.11, 0.03), -0.04).b == float4(0.01365685538240099, -0.019119597535361386, 0.026019804133332908, 0.008194113229440594)
/// test: PackSH9(0.9, float3(0.12, -0.3, 0.25), float4(0.05, -0.07, 0.11, 0.03), -0.04).c == -0.005462742152960396
[node("Lighting/Ambient/Pack SH9")]
void PackSH9(
    float l0,       ///< coefficient of l = 0
    float3 l1,      ///< of l = 1: m = -1, 0, 1
    float4 l2,      ///< of l = 2: m = -2, -1, 0, 1
    float l2Last,  ///< of l = 2: m = 2
    out float4 a,   ///< for the linear part
    out float4 b,   ///< for the first four of the quadratic part
    out float c     ///< for the fifth
) {
    float polar = l2.z * SH_POLAR;
    a = float4(l1.z * SH_LINEAR, l1.x * SH_LINEAR, l1.y * SH_LINEAR, l0 * SH_CONSTANT - polar);
    b = float4(l2.x * SH_PRODUCT, l2.y * SH_PRODUCT, 3 * polar, l2.w * SH_PRODUCT);
    c = l2Last * SH_DIFFERENCE;
}

/// The constant and linear part of Unity's packed ambient light.
///
/// formula: dot((ar, ag, ab), (n, 1))
/// source: Unity built-in shaders, SHEvalLinearL0L1
/// test: EvaluateSHLinear(float3(0, 0, 1), float4(1, 2, 3, 4), float4(0, 0, 0, 1), 0) == float3(7, 1, 0)
/// test: EvaluateSHLinear(float3(0.6, 0.8, 0), float4(1, 2, 3, 4), 0, 0) == float3(6.2, 0, 0)
[node("Lighting/Ambient/Evaluate SH Linear")]
float3 EvaluateSHLinear(
    float3 normal = normalWS,  ///< unit normal in the world
    float4 ar,                  ///< of red
    float4 ag,                  ///< of green
    float4 ab                   ///< of blue
) {
    float4 n = float4(normal, 1);
    return float3(dot(ar, n), dot(ag, n), dot(ab, n));
}

/// The quadratic part of Unity's packed ambient light.
///
/// formula: dot((br, bg, bb), (x y, y z, z z, z x)) + c (x^2 - y^2), (x, y, z) = n
/// source: Unity built-in shaders, SHEvalLinearL2
/// test: EvaluateSHQuadratic(float3(0, 0, 1), float4(1, 2, 3, 4), float4(0, 0, 2, 0), 0, float3(1, 1, 1)) == float3(3, 2, 0)
/// test: EvaluateSHQuadratic(float3(0.6, 0.8, 0), 1, 0, 0, float3(1, 0, 2)) == float3(0.2, 0, -0.56)
[node("Lighting/Ambient/Evaluate SH Quadratic")]
float3 EvaluateSHQuadratic(
    float3 normal = normalWS,  ///< unit normal in the world
    float4 br,                  ///< of red
    float4 bg,                  ///< of green
    float4 bb,                  ///< of blue
    float3 c                    ///< of all three
) {
    float4 products = normal.xyzz * normal.yzzx;
    float difference = normal.x * normal.x - normal.y * normal.y;
    return float3(dot(br, products), dot(bg, products), dot(bb, products)) + c * difference;
}

/// The reflectance of a rough surface for the environment, with a grazing reflectance of 1: f0 scale + offset.
///
/// formula: x = 1 - r, y = 0.0425 - 0.0275 r, a = min(x^2, 2^(-9.28 n.v)) x + y,
/// formula: scale = 1.04 - 0.572 r - 1.04 a, offset = 1.04 a + 0.022 r - 0.04
/// source: Karis, "Physically Based Shading on Mobile", 2014
/// test: EnvBRDFApprox(0.5, 0.5).scale == 0.7032443291646028
/// test: EnvBRDFApprox(0.5, 0.5).offset == 0.021755670835397204
/// test: EnvBRDFApprox(0.2, 0.1).scale == 0.44983206981951396
/// test: EnvBRDFApprox(0.2, 0.1) == float3(0.458161212973, 0.458161212973, 0.458161212973) within 1e-4
[node("Lighting/Ambient/Environment BRDF")]
float3 EnvBRDFApprox(
    [range(0, 1)] float roughness = 0.5,  ///< perceptual roughness
    [range(0, 1)] float ndotv,            ///< cosine of normal and view
    [color] float3 f0 = 0.04,             ///< reflectance at normal incidence
    out float scale,                      ///< of f0
    out float offset                      ///< added to it; for the roughest surfaces a little below zero
) {
    float a = EnvBRDFApproxNonmetal(roughness, ndotv);
    scale = 1.04 - 0.572 * roughness - 1.04 * a;
    offset = 1.04 * a + 0.022 * roughness - 0.04;
    return max(f0 * scale + offset, 0);
}

/// EnvBRDFApprox for dielectrics, whose reflectance at normal incidence is 4 %.
///
/// formula: min(x^2, 2^(-9.28 n.v)) x + 0.0425 - 0.0275 r, x = 1 - r
/// source: Karis, "Physically Based Shading on Mobile", 2014
/// test: EnvBRDFApproxNonmetal(0, 0) == 1.0425
/// test: EnvBRDFApproxNonmetal(0.2, 0.1) == 0.4574691636350827
/// test: EnvBRDFApproxNonmetal(1, 0.5) == 0.015
[node("Lighting/Ambient/Environment BRDF Nonmetal")]
float EnvBRDFApproxNonmetal(
    [range(0, 1)] float roughness = 0.5,  ///< perceptual roughness
    [range(0, 1)] float ndotv             ///< cosine of normal and view
) {
    float x = 1 - roughness;
    return min(x * x, exp2(-9.28 * ndotv)) * x + 0.0425 - 0.0275 * roughness;
}

/// Lazarov's fit of the reflectance for the environment, for a surface with a Blinn-Phong highlight.
///
/// formula: t = (1 / 0.96, 0.475, 0.0175 / 0.96, 0.25) g + (0, 0, -0.015 / 0.96, 0.75),
/// formula: offset = t.x min(t.y, 2^(-9.28 n.v)) + t.z, scale = t.w - offset
/// source: Lazarov, "Getting More Physical in Call of Duty: Black Ops II", SIGGRAPH 2013
/// test: EnvBRDFLazarov(1, 0.5).scale == 0.9556176465637075
/// test: EnvBRDFLazarov(1, 0.5).offset == 0.044382353436292474
/// test: EnvBRDFLazarov(0, 0.5).offset == -0.015625
/// test: EnvBRDFLazarov(0, 0.5) == float3(0.015, 0.015, 0.015)
[node("Lighting/Ambient/Environment BRDF Lazarov")] [range(0, 1)]
float3 EnvBRDFLazarov(
    [range(0, 1)] float gloss = 0.5,  ///< 0 is dull, 1 a mirror
    [range(0, 1)] float ndotv,        ///< cosine of normal and view
    [color] float3 f0 = 0.04,         ///< reflectance at normal incidence
    out float scale,                  ///< of f0
    out float offset                  ///< added to it
) {
    float4 t = float4(1 / 0.96, 0.475, 0.0175 / 0.96, 0.25) * gloss + float4(0, 0, -0.015 / 0.96, 0.75);
    offset = t.x * min(t.y, exp2(-9.28 * ndotv)) + t.z;
    scale = t.w - offset;
    return saturate(f0 * scale + offset);
}

/// The split sum: the light that a surface reflects from a pre-filtered environment.
///
/// formula: prefiltered (f0 scale + f90 offset)
/// source: Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013
/// test: SplitSum(float3(1, 1, 1), float3(0.04, 0.04, 0.04), 0.8, 0.05) == float3(0.082, 0.082, 0.082)
/// test: SplitSum(float3(2, 1, 0), 1, 0.5, 0.25) == float3(1.5, 0.75, 0)
[node("Lighting/Ambient/Split Sum")]
float3 SplitSum(
    [color] float3 prefiltered = 1,     ///< radiance of the environment, blurred by roughness
    [color] float3 f0 = 0.04,           ///< reflectance at normal incidence
    [range(0, 1)] float scale,          ///< of f0
    [range(0, 1)] float offset,         ///< of the grazing reflectance
    [range(0, 1)] float f90 = 1         ///< grazing reflectance
) {
    return prefiltered * (f0 * scale + f90 * offset);
}

/// The level of a pre-filtered cube map for a roughness.
///
/// formula: r (1.7 - 0.7 r) steps
/// source: Unity built-in shaders, Unity_GlossyEnvironment
/// test: MipFromRoughness(0.1) == 0.978
/// test: MipFromRoughness(0.5) == 4.05
/// test: MipFromRoughness(1, 4) == 4
[node("Lighting/Ambient/Mip from Roughness")] [range(0, 12)]
float MipFromRoughness(
    [range(0, 1)] float roughness = 0.5,  ///< perceptual roughness
    [range(0, 12)] float steps = 6        ///< index of the last mip level that is used
) {
    return roughness * (1.7 - 0.7 * roughness) * steps;
}

/// Parallax-corrects a reflected direction: the direction from the centre of a cube map to the walls of its box.
///
/// A direction parallel to a wall never meets it; that wall is ignored. At a wall, the direction to it changes with a jump
/// where the reflected ray turns from the room to the wall. So that an object may reach through a wall that is not
/// there, as between two probes that are blended, no wall is nearer than `nearest`, and a point outside of the box is as
/// far from the wall behind it as one inside.
///
/// formula: position - center + t d, t = the smallest max(|wall - position|, nearest) / |d| over the axes
/// source: Lagarde and Zanuttini, "Local Image-based Lighting With Parallax-corrected Cubemaps", SIGGRAPH 2012
/// test: BoxProjectedDirection(float3(0, 0, 1), float3(0, 0, 0), float3(0.1, 0.2, 0.3), -2, float3(2, 3, 4)) == float3(-0.1, -0.2, 3.7)
/// test: BoxProjectedDirection(float3(1, 1, 0), float3(1, 0, 0), float3(0.1, 0.2, 0.3), -2, float3(2, 3, 4)) == float3(1.9, 0.8, -0.3)
/// test: BoxProjectedDirection(float3(-0.3, 0.2, -0.9), float3(0.5, -0.5, 1), float3(0.1, 0.2, 0.3), -2, float3(2, 3, 4)) == float3(-0.6, -0.033333333333333326, -2.3)
/// test: BoxProjectedDirection(float3(1, 0, 0), float3(2.5, 0, 0), 0, -2, 2) == float3(3, 0, 0)
/// test: BoxProjectedDirection(float3(-1, 0, 0), float3(2.5, 0, 0), 0, -2, 2) == float3(-2, 0, 0)
/// test: BoxProjectedDirection(float3(0.8, 0, 0.6), float3(2, 0, 0), 0, -2, 2, 0.5) == float3(2.5, 0, 0.375)
/// test: BoxProjectedDirection(float3(0.8, 0, 0.6), float3(1, 0, 0), 0, -2, 2, 0.5) == float3(2, 0, 0.75)
[node("Lighting/Ambient/Box Projected Direction")]
float3 BoxProjectedDirection(
    float3 direction,                           ///< reflected direction; its length does not matter
    [unit("m")] float3 position = positionWS,  ///< the reflecting point
    [unit("m")] float3 center = 0,              ///< where the cube map was taken
    [unit("m")] float3 boxMin = -1,            ///< smallest corner of the box
    [unit("m")] float3 boxMax = 1,             ///< largest corner of the box
    [unit("m")] float nearest = 0              ///< no wall counts as nearer
) {
    float3 wall = direction > 0 ? boxMax : boxMin;
    float3 isAlong = step(abs(direction), 1e-6);
    float3 times = max(abs(wall - position), nearest) / (abs(direction) + isAlong) + isAlong * 60000;
    return position - center + direction * min(min(times.x, times.y), times.z);
}

/// Decodes the radiance of a high-dynamic-range texel by Unity's decode instructions.
///
/// formula: instructions.x (instructions.w (a - 1) + 1)^instructions.y rgb
/// source: Unity built-in shaders, DecodeHDR
/// test: DecodeHDR(float4(0.5, 0.25, 0.125, 0.5), float4(5, 2.2, 0, 1)) == float3(0.5440941020600775, 0.27204705103003873, 0.13602352551501937)
/// test: DecodeHDR(float4(2, 1, 0.5, 1), float4(1, 1, 0, 0)) == float3(2, 1, 0.5)
/// test: DecodeHDR(float4(0.5, 0.25, 0.125, 0.5), float4(5, 2.2, 0, 1), Gamma) == float3(1.25, 0.625, 0.3125)
[node("Lighting/Ambient/Decode HDR")]
float3 DecodeHDR(
    float4 encoded = 1,                          ///< the texel
    float4 instructions = float4(1, 1, 0, 0),    ///< x: factor, y: exponent of alpha, w: 1 if alpha is used
    const WorkingSpace space = Linear            ///< colour space that lighting is computed in; in gamma, y is ignored
) {
    float scale = instructions.w * (encoded.a - 1) + 1;
    float factor = space == Linear ? pow(max(scale, 1e-6), instructions.y) : scale;
    return instructions.x * factor * encoded.rgb;
}

/// The texture coordinates of a view-space normal in a matcap: a normal that points up reads the top of the picture.
///
/// formula: (0.5 + 0.5 n.x, 0.5 - 0.5 n.y), n = normalize(normalVS); where v grows upwards it is 0.5 n.xy + 0.5
/// source: Sloan et al., "The Lit Sphere", Graphics Interface 2001
/// test: MatcapUV(float3(0, 0, 1)) == float2(0.5, 0.5)
/// test: MatcapUV(float3(0.6, 0, 0.8)) == float2(0.8, 0.5)
/// test: MatcapUV(float3(0, -3, 4)) == float2(0.5, 0.8)
[node("Lighting/Ambient/Matcap UV")] [also("Matcap")] [range(0, 1)]
float2 MatcapUV(
    float3 normalVS = normalVS  ///< normal in view space: x right, y up, z to the viewer
) {
    return normalVS.xy * rsqrt(max(dot(normalVS, normalVS), 1e-7)) * float2(0.5, -0.5) + 0.5;
}

/// Weakens or strengthens ambient occlusion.
///
/// formula: lerp(1, occlusion, strength), then to the given power
/// source: Unity built-in shaders, LerpOneTo
/// test: OcclusionStrength(0.2, 0.5) == 0.6
/// test: OcclusionStrength(0.5, 1, 2) == 0.25
/// test: OcclusionStrength(0, 1, 2) == 0
[node("Lighting/Ambient/Occlusion Strength")] [range(0, 1)]
float OcclusionStrength(
    [range(0, 1)] float occlusion = 1,  ///< 1 open, 0 closed
    [range(0, 1)] float strength = 1,   ///< 0 disables occlusion
    [range(0, 8)] float power = 1       ///< above 1 darker
) {
    float open = lerp(1, saturate(occlusion), strength);
    // Zero to the power of zero is not defined; zero to any other power stays zero.
    return power == 1 ? open : open > 0 ? pow(max(open, 1e-6), power) : 0;
}

/// Ambient occlusion of a bright surface with interreflections between its parts.
///
/// formula: max(o, ((o a + b) o + c) o), a = 2.0404 rho - 0.3324, b = -4.7951 rho + 0.6417, c = 2.7552 rho + 0.6903
/// source: Jimenez et al., "Practical Realtime Strategies for Accurate Indirect Occlusion", SIGGRAPH 2016
/// test: OcclusionMultiBounce(0.5, float3(0.5, 0.5, 0.5)) == float3(0.6809625, 0.6809625, 0.6809625)
/// test: OcclusionMultiBounce(0.2, float3(0.9, 0.9, 0.9)) == float3(0.49907208, 0.49907208, 0.49907208)
/// test: OcclusionMultiBounce(0, float3(1, 1, 1)) == float3(0, 0, 0)
[node("Lighting/Ambient/Occlusion Multi-Bounce")]
float3 OcclusionMultiBounce(
    [range(0, 1)] float occlusion = 1,  ///< 1 open, 0 closed
    [color] float3 albedo = 0.5         ///< diffuse colour
) {
    float3 a = 2.0404 * albedo - 0.3324;
    float3 b = 0.6417 - 4.7951 * albedo;
    float3 c = 2.7552 * albedo + 0.6903;
    return max(occlusion, ((occlusion * a + b) * occlusion + c) * occlusion);
}

/// Specular occlusion: the visible share of environment reflections, from ambient occlusion.
///
/// formula: saturate((n.v + o)^(2^(-16 alpha - 1)) - 1 + o)
/// source: Lagarde and de Rousiers, "Moving Frostbite to PBR", SIGGRAPH 2014, section 4.10.2
/// test: SpecularOcclusion(0.5, 0.5, 0.5) == 0.5
/// test: SpecularOcclusion(1, 0.3, 0) == 0.44017542509913804
/// test: SpecularOcclusion(0.2, 1, 0.4) == 1
[node("Lighting/Ambient/Specular Occlusion")] [range(0, 1)]
float SpecularOcclusion(
    [range(0, 1)] float ndotv,           ///< cosine of normal and view
    [range(0, 1)] float occlusion = 1,   ///< 1 open, 0 closed
    [range(0, 1)] float alpha = 0.25     ///< roughness squared
) {
    return saturate(pow(max(ndotv + occlusion, 1e-6), exp2(-16 * alpha - 1)) - 1 + occlusion);
}
