// Layers over a base surface: cloth fibres and transparent films. glTF's material extensions and OpenPBR name them.

/// The alpha of Charlie's terms: sheen roughness squared, at least 0.01. A sharper lobe would lie within a degree of
/// the silhouette, and its power has no digits left.
///
/// formula: alpha = max(roughness^2, 0.01)
/// source: Khronos Group, KHR_materials_sheen, 2020; the limit is ours
/// test: SheenAlpha(0.5) == 0.25
/// test: SheenAlpha(0) == 0.01
[node("Lighting/Layer/Sheen Alpha")] [range(0.01, 1)]
float SheenAlpha(
    [range(0, 1)] float roughness = 0.3  ///< sheen roughness
) {
    return max(roughness * roughness, 0.01);
}

/// Charlie: fibres that stand upright, and lean the more the rougher they are. It shines where the view grazes.
///
/// formula: D = (2 + 1/alpha) sin^(1/alpha) / (2 pi), sin^2 = 1 - (n.h)^2
/// source: Estevez and Kulla, "Production Friendly Microfacet Sheen BRDF", SIGGRAPH 2017, equation 2
/// test: DistributionCharlie(0, 0.5) == 0.6366197723675814
/// test: DistributionCharlie(1, 0.5) == 0
/// test: DistributionCharlie(0.6, 1) == 0.3819718634205488
[node("Lighting/Distribution/Charlie")]
float DistributionCharlie(
    [range(0, 1)] float ndoth,           ///< cosine of normal and half vector
    [range(0.01, 1)] float alpha = 0.25  ///< width of the lobe, see SheenAlpha
) {
    float inverse = 1 / max(alpha, 0.01);
    float sine2 = max((1 - ndoth) * (1 + ndoth), 1e-7);
    return (2 + inverse) * pow(sine2, 0.5 * inverse) / (2 * PI);
}

// The paper's fit of ln(Lambda) for cosines up to 0.5. Its five constants are blended between those for alpha 1 and
// alpha 0.
float charlieCurve(float cosine, float alpha) {
    float t = (1 - alpha) * (1 - alpha);
    float rise = lerp(3.82987, 3.32435, t) * pow(max(cosine, 0), max(lerp(0.19823, 0.16801, t), 0.1));
    return lerp(21.5473, 25.3245, t) / (1 + rise) + lerp(-1.9776, -1.27393, t) * cosine + lerp(-4.32054, -4.85967, t);
}

/// Smith's Lambda for Charlie: how strongly fibres hide each other.
///
/// formula: exp(L(c)) below 0.5, exp(2 L(0.5) - L(1 - c)) above; L(x) = a / (1 + b x^c) + d x + e
/// source: Estevez and Kulla, "Production Friendly Microfacet Sheen BRDF", SIGGRAPH 2017, section 3
/// test: CharlieLambda(0.5, 1) == 0.710027789045483
/// test: CharlieLambda(0.9, 0.25) == 0.18791686651851733
[node("Lighting/Visibility/Charlie Lambda")]
float CharlieLambda(
    [range(0, 1)] float cosine,          ///< cosine of the normal and a direction
    [range(0.01, 1)] float alpha = 0.25  ///< width of the lobe
) {
    float near = charlieCurve(min(cosine, 1 - cosine), alpha);
    return exp(cosine < 0.5 ? near : 2 * charlieCurve(0.5, alpha) - near);
}

/// The visibility of Charlie's fibres.
///
/// formula: V = 1 / (4 (1 + lambda(n.l) + lambda(n.v)) (n.l) (n.v))
/// source: Estevez and Kulla 2017; Khronos Group, KHR_materials_sheen, 2020
/// test: VisibilityCharlie(0.5, 0.5, 1) == 0.4132136505678266
[node("Lighting/Visibility/Charlie")]
float VisibilityCharlie(
    [range(0, 1)] float ndotl,           ///< cosine of normal and light
    [range(0, 1)] float ndotv,           ///< cosine of normal and view
    [range(0.01, 1)] float alpha = 0.25  ///< width of the lobe
) {
    float hidden = 1 + CharlieLambda(ndotv, alpha) + CharlieLambda(ndotl, alpha);
    return 1 / max(hidden * (4 * ndotl * ndotv), 1e-5);
}

/// The share of a uniform environment that Charlie's lobe reflects, of a sheen colour of 1: what the layer takes from
/// the surface below.
///
/// It is a fit, within 0.009 of the integral for cosines from 0.02 and roughness from 0.17; both end there. At sharper
/// lobes the integral is above 1 near the silhouette, and is limited.
///
/// formula: exp of a polynomial in sqrt(n.v), with coefficients in roughness: a + b r + c r^2 + d / r + e / r^2
/// source: the integral of D V (n.l) of DistributionCharlie and VisibilityCharlie; the fit is ours
/// test: SheenAlbedo(1, 1) == 0.16376 within 0.05
/// test: SheenAlbedo(0.5, 0.62) == 0.2438 within 0.03
/// test: SheenAlbedo(0.1, 0.335) == 0.53891 within 0.02
[node("Lighting/Energy/Sheen Albedo")] [range(0, 1)]
float SheenAlbedo(
    [range(0, 1)] float ndotv,           ///< cosine of normal and view
    [range(0, 1)] float roughness = 0.3  ///< sheen roughness
) {
    float r = clamp(roughness, 0.17, 1);
    float i = 1 / r;
    float x = sqrt(clamp(ndotv, 0.02, 1));
    float at0 = -1.9856 + r * (2.6122 - r * 1.0412) + i * (0.53229 - i * 0.031455);
    float at1 = -11.746 + r * (16.288 - r * 7.5947) + i * (2.1684 - i * 0.14723);
    float at2 = 27.318 + r * (r * 18.712 - 41.189) + i * (i * 0.22012 - 5.8038);
    float at3 = -14.069 + r * (24.547 - r * 11.656) + i * (0.98339 + i * 0.11663);
    return saturate(exp(at0 + x * (at1 + x * (at2 + x * at3))));
}

/// What a sheen leaves of the light for the surface below.
///
/// formula: 1 - max(color) E(n.v)
/// source: Khronos Group, KHR_materials_sheen, 2020, "albedo scaling", in the form that depends on the view alone
/// test: SheenScaling(float3(0, 0, 0), 0.5) == 1
/// test: SheenScaling(float3(0.2, 0.5, 0.1), 0.4) == 0.8
[node("Lighting/Energy/Sheen Scaling")] [range(0, 1)]
float SheenScaling(
    [color] float3 color = 0,        ///< sheen colour
    [range(0, 1)] float albedo = 0   ///< of the sheen, see SheenAlbedo
) {
    return 1 - max(max(color.r, color.g), color.b) * albedo;
}

/// The widths of a GGX lobe that is stretched along one direction: at strength 1 it reaches the horizon there.
///
/// formula: along = lerp(alpha, 1, strength^2), across = alpha
/// source: Khronos Group, KHR_materials_anisotropy, 2023
/// test: AnisotropicAlpha(0.25, 0) == 0.25
/// test: AnisotropicAlpha(0.25, 0.5) == 0.4375
/// test: AnisotropicAlpha(0.25, 1) == 1
[node("Lighting/Setup/Anisotropic Alpha")] [range(0, 1)]
float AnisotropicAlpha(
    [range(0, 1)] float alpha = 0.25,   ///< roughness squared, which stays across the direction
    [range(0, 1)] float strength = 0.5  ///< 0: a round lobe
) {
    return lerp(alpha, 1, strength * strength);
}

/// The normal with which a stretched lobe reflects the environment: bent towards the view, around the direction in
/// which the lobe is stretched.
///
/// formula: n' = normalize(lerp(normalize(cross(cross(b, v), b)), n, (1 - strength (1 - roughness))^4))
/// source: Revie, "Implementing Fur in Deferred Shading", GPU Pro 2, 2011; the blend as Khronos' glTF viewer's
/// test: BentNormal(float3(0, 0, 1), float3(1, 0, 0), float3(0.6, 0, 0.8), 0, 0.5) == float3(0, 0, 1)
/// test: BentNormal(float3(0, 0, 1), float3(0, 1, 0), float3(0.6, 0, 0.8), 1, 0) == float3(0.6, 0, 0.8)
[node("Lighting/Direction/Bent Normal")] [range(-1, 1)]
float3 BentNormal(
    float3 normal = normalWS,            ///< unit normal
    float3 across,                       ///< unit direction across the stretch
    float3 view = viewDirWS,             ///< unit direction to the viewer
    [range(0, 1)] float strength = 0.5,  ///< of the anisotropy
    [range(0, 1)] float roughness = 0.5  ///< perceptual roughness
) {
    float3 around = cross(cross(across, view), across);
    float3 facing = around * rsqrt(max(dot(around, around), 1e-7));
    float keep = 1 - strength * (1 - roughness);
    float keep2 = keep * keep;
    float3 bent = lerp(facing, normal, keep2 * keep2);
    // A view along the direction across has no bent normal.
    float squared = dot(bent, bent);
    return squared > 1e-4 ? bent * rsqrt(max(squared, 1e-4)) : normal;
}
