// Terms of the OpenPBR Surface specification that other models may use, too: a rough diffuse term that keeps its energy,
// metals with a tinted edge, and what a coat does to the surface below it.

// What the improved Oren-Nayar term reflects of a uniform environment, before further bounces, of a white surface.
float eonShare(float cosine, float roughness) {
    float m = 1 - cosine;
    // The paper's fit of the directional integral over pi.
    float shape = m * (0.0571085289 + m * (0.491881867 + m * (0.0714429953 * m - 0.332181442)));
    return (1 + roughness * shape) / (1 + (0.5 - 2 / (3 * PI)) * roughness);
}

// The mean of eonShare over all directions.
float eonMeanShare(float roughness) {
    return (1 + (2.0 / 3 - 28 / (15 * PI)) * roughness) / (1 + (0.5 - 2 / (3 * PI)) * roughness);
}

// The colour of the light that bounces more than once.
float3 eonFurther(float3 color, float mean) {
    return color * color * mean / max(1 - color * (1 - mean), 0.01);
}

/// Oren and Nayar's rough diffuse light in a form that keeps its energy: clay, plaster, the full moon. It replaces colour
/// times Lambert's term, because bounces between facets deepen the colour.
///
/// formula: color A (n.l) (1 + r s / t) + further (1 - E(n.v)) (1 - E(n.l)) (n.l) / (1 - mean E)
/// source: Portsmouth, Kutz and Hill, "EON: A Practical Energy-Preserving Rough Diffuse BRDF", JCGT 14(1), 2025
/// test: EonDiffuse(float3(1, 0.5, 0), 0.5, 0.5, 0, 0) == float3(0.5, 0.25, 0)
[node("Lighting/Diffuse/EON")]
float3 EonDiffuse(
    [color] float3 color = 1,              ///< albedo of a facet
    [range(0, 1)] float ndotl,             ///< cosine of normal and light
    [range(0, 1)] float ndotv,             ///< cosine of normal and view
    [range(-1, 1)] float ldotv,            ///< cosine of light and view
    [range(0, 1)] float roughness = 0.5    ///< 0 is Lambert's term
) {
    float s = ldotv - ndotl * ndotv;
    float t = s > 0 ? max(max(ndotl, ndotv), 1e-4) : 1;
    float once = (1 + roughness * s / t) / (1 + (0.5 - 2 / (3 * PI)) * roughness);
    float mean = eonMeanShare(roughness);
    float missing = (1 - eonShare(ndotv, roughness)) * (1 - eonShare(ndotl, roughness)) / max(1 - mean, 1e-3);
    return max(color * once + eonFurther(color, mean) * max(missing, 0), 0) * ndotl;
}

/// The colour that EonDiffuse has in a uniform environment.
///
/// formula: color E(n.v) + further (1 - E(n.v))
/// source: Portsmouth, Kutz and Hill, JCGT 14(1), 2025
/// test: EonAlbedo(float3(1, 1, 1), 0.3, 1) == float3(1, 1, 1) within 1e-3
/// test: EonAlbedo(float3(0.5, 0.25, 0), 0.3, 0) == float3(0.5, 0.25, 0)
[node("Lighting/Diffuse/EON Albedo")] [range(0, 1)]
float3 EonAlbedo(
    [color] float3 color = 1,            ///< albedo of a facet
    [range(0, 1)] float ndotv,           ///< cosine of normal and view
    [range(0, 1)] float roughness = 0.5  ///< 0 is Lambert's term
) {
    float share = min(eonShare(ndotv, roughness), 1);
    return saturate(color * share + eonFurther(color, eonMeanShare(roughness)) * (1 - share));
}

/// The reflectance of a metal by its colours at normal incidence and at 82 degrees.
///
/// formula: schlick - a c (1 - c)^6, a so that it is edge times Schlick's value at a cosine of 1/7
/// source: Kutz, Hasan and Edmondson, "Novel Aspects of the Adobe Standard Material", 2023; Hoffman, "Generalization of
/// source: Adobe's Fresnel Model", 2023
/// test: FresnelF82(float3(0.9, 0.6, 0.3), 1, float3(0.5, 0.5, 0.5)) == float3(0.9, 0.6, 0.3)
/// test: FresnelF82(float3(0, 0, 0), 1 / 7.0, float3(0.5, 1, 0)) == float3(0.2313321, 0.4626642, 0) within 1e-4
/// test: FresnelF82(float3(0.5, 0.5, 0.5), 0.5, float3(1, 1, 1)) == float3(0.515625, 0.515625, 0.515625)
[node("Lighting/Fresnel/F82")] [range(0, 1)]
float3 FresnelF82(
    [color] float3 f0 = 0.9,      ///< reflectance at normal incidence
    [range(0, 1)] float cosine,   ///< cosine of light and half vector
    [color] float3 edge = 1       ///< tint at 82 degrees; white is Schlick's curve
) {
    // At a cosine of 1/7: (6/7)^5, and 1/7 (6/7)^6.
    float3 atEdge = f0 + (1 - f0) * 0.46266436;
    float3 dip = atEdge * (1 - edge) / 0.056652777;
    float m = saturate(1 - cosine);
    float m2 = m * m;
    return saturate(f0 + (1 - f0) * (m2 * m2 * m) - dip * (saturate(cosine) * m2 * m2 * m2));
}

/// An index of refraction whose reflectance at normal incidence is a share of the original one's.
///
/// formula: (1 + e) / (1 - e), e = sign(n - 1) sqrt(weight f0)
/// source: Academy Software Foundation, "OpenPBR Surface", version 1.1, 2024, section on the dielectric base
/// test: ModulatedIor(1.5, 1) == 1.5
/// test: ModulatedIor(1.5, 0) == 1
/// test: ModulatedIor(1.5, 0.25) == 1.2222222222222223
[node("Lighting/Setup/Modulated IOR")] [range(1, 4)]
float ModulatedIor(
    [range(1, 3)] float ior = 1.5,    ///< index of refraction
    [range(0, 1)] float weight = 1    ///< share of the reflectance
) {
    float e = (ior - 1) / (ior + 1) * sqrt(saturate(weight));
    return (1 + e) / (1 - e);
}

/// The roughness of a surface below a rough coat.
///
/// formula: lerp(r, min(1, r^4 + 2 c^4)^(1/4), weight)
/// source: Academy Software Foundation, "OpenPBR Surface", version 1.1, 2024, "Roughening"
/// test: RoughnessUnderCoat(0.3, 0, 1) == 0.3
/// test: RoughnessUnderCoat(0, 0.5, 1) == 0.5946035575013605
/// test: RoughnessUnderCoat(0, 0.5, 0.5) == 0.29730177875068026
[node("Lighting/Setup/Roughness under Coat")] [range(0, 1)]
float RoughnessUnderCoat(
    [range(0, 1)] float roughness = 0.3,   ///< of the surface below
    [range(0, 1)] float coatRoughness = 0, ///< of the coat
    [range(0, 1)] float weight = 1         ///< of the coat
) {
    float base2 = roughness * roughness;
    float coat2 = coatRoughness * coatRoughness;
    float both = sqrt(sqrt(min(1, base2 * base2 + 2 * coat2 * coat2)));
    return lerp(roughness, both, weight);
}

/// The widths of OpenPBR's stretched lobe.
///
/// formula: along = r^2 sqrt(2 / (1 + (1 - a)^2)), across = (1 - a) along
/// source: Academy Software Foundation, "OpenPBR Surface", version 1.1, 2024, "Microfacet model"
/// test: OpenPbrAlphas(0.5, 0) == float2(0.25, 0.25)
/// test: OpenPbrAlphas(0.5, 1) == float2(0.35355339059327373, 0)
[node("Lighting/Setup/OpenPBR Alphas")] [range(0, 1)]
float2 OpenPbrAlphas(
    [range(0, 1)] float roughness = 0.3,  ///< perceptual roughness
    [range(0, 1)] float anisotropy = 0    ///< 0: a round lobe
) {
    float keep = 1 - anisotropy;
    float along = min(roughness * roughness * sqrt(2 / (1 + keep * keep)), 1);
    return float2(along, along * keep);
}

/// How much darker a coat makes the surface below it: light that the coat's inner face sends back is absorbed again.
///
/// formula: (1 - K) / (1 - E K), K = lerp(F(n.v), 1 - (1 - mean F) / n^2, roughness), mean F = (n - 1) / (4.08567 + n)
/// source: Academy Software Foundation, "OpenPBR Surface", version 1.1, 2024, "Darkening"; the mean: Kulla and Conty,
/// source: "Revisiting Physically Based Shading at Imageworks", SIGGRAPH 2017
/// test: CoatDarkening(float3(1, 1, 1), 1.6, 1, 0.5) == float3(1, 1, 1)
/// test: CoatDarkening(float3(0, 0, 0), 1, 1, 1) == float3(1, 1, 1)
/// test: CoatDarkening(float3(0, 0, 0), 1.5, 1, 0) == float3(0.96, 0.96, 0.96)
[node("Lighting/Energy/Coat Darkening")] [range(0, 1)]
float3 CoatDarkening(
    [color] float3 albedo = 0.5,          ///< of the surface below
    [range(1, 3)] float ior = 1.6,        ///< index of refraction of the coat
    [range(0, 1)] float ndotv,            ///< cosine of normal and view
    [range(0, 1)] float roughness = 1     ///< of the surface below; 1 for a matte one
) {
    float n = max(ior, 1);
    float rough = 1 - (1 - (n - 1) / (4.08567 + 1.00071 * n)) / (n * n);
    float f0 = F0FromIor(1, n);
    float smooth = f0 + (1 - f0) * SchlickWeight(ndotv) * step(1.0001, n);
    float back = clamp(lerp(smooth, rough, roughness), 0, 0.99);
    return (1 - back) / (1 - saturate(albedo) * back);
}

/// The tint that a coat gives to what is below it: its colour is that of light which crosses it twice along the normal,
/// and slanted light has a longer way.
///
/// formula: color^(1 / m), m = sqrt(1 - (1 - (n.v)^2) / ior^2)
/// source: Academy Software Foundation, "OpenPBR Surface", version 1.1, 2024, "Absorption", for light on the view's way
/// test: CoatTint(float3(0.5, 1, 0.25), 1.6, 1) == float3(0.5, 1, 0.25)
/// test: CoatTint(float3(0.25, 1, 1), 1.25, 0) == float3(0.09921256574801246, 1, 1)
[node("Lighting/Energy/Coat Tint")] [range(0, 1)]
float3 CoatTint(
    [color] float3 color = 1,        ///< coat colour
    [range(1, 3)] float ior = 1.6,   ///< index of refraction of the coat
    [range(0, 1)] float ndotv        ///< cosine of normal and view
) {
    float inside2 = 1 - (1 - ndotv * ndotv) / (max(ior, 1) * max(ior, 1));
    return exp2(log2(clamp(color, 1e-4, 1)) * rsqrt(max(inside2, 0.01)));
}
