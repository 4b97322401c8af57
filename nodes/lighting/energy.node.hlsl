// Energy compensation: a microfacet term loses the light that bounces between facets more than once; these nodes
// restore it.

/// A factor on a microfacet specular term that restores the light of all further bounces.
///
/// A white metal then reflects all incident light, at any roughness. Tinted metals become more saturated, which is
/// correct: each further bounce is tinted again.
///
/// formula: 1 + f0 (1 - E) / E, E = albedo
/// source: Turquin, "Practical multiple scattering compensation for microfacet models", 2019
/// test: EnergyCompensation(float3(1, 1, 1), 0.5) == float3(2, 2, 2)
/// test: EnergyCompensation(float3(0.04, 0.5, 0), 0.8) == float3(1.01, 1.125, 1)
/// test: EnergyCompensation(float3(1, 1, 1), 1) == float3(1, 1, 1)
[node("Lighting/Energy/Energy Compensation")]
float3 EnergyCompensation(
    [color] float3 f0 = 0.04,            ///< reflectance at normal incidence
    [range(0.25, 1)] float albedo = 1    ///< share of light that perfectly reflecting facets return after one bounce:
                                         ///< the split sum's scale + offset
) {
    return 1 + f0 * (1 / max(albedo, 0.01) - 1);
}

/// The share of a uniform environment that a specular term reflects to the viewer, including all further bounces.
///
/// formula: (f0 scale + offset) (1 + f0 (1 - E) / E), E = scale + offset
/// source: Turquin, "Practical multiple scattering compensation for microfacet models", 2019
/// test: CompensatedAlbedo(float3(1, 1, 1), 0.5, 0.1) == float3(1, 1, 1)
/// test: CompensatedAlbedo(float3(0.5, 0, 0), 0.6, 0.2) == float3(0.5625, 0.2, 0.2)
[node("Lighting/Energy/Compensated Albedo")]
float3 CompensatedAlbedo(
    [color] float3 f0 = 0.04,        ///< reflectance at normal incidence
    [range(0.25, 1)] float scale,    ///< of f0, from the split sum
    [range(0, 1)] float offset       ///< added to it
) {
    return (f0 * scale + offset) * EnergyCompensation(f0, scale + offset);
}

/// The split sum's reflectance for the environment, including the light of all further bounces.
///
/// formula: E = scale + offset, f = f0 scale + offset, fa = f0 + (1 - f0) / 21, out = f + f fa (1 - E) / (1 - fa (1 - E))
/// source: Fdez-Agüera, "A Multiple-Scattering Microfacet Model for Real-Time Image-based Lighting", JCGT 8(1), 2019
/// test: MultipleScattering(float3(1, 1, 1), 0.5, 0.25) == float3(1, 1, 1)
/// test: MultipleScattering(float3(0, 0, 0), 0.6, 0.2) == 0.2 + 0.2 * 0.2 / (21 - 0.2)
[node("Lighting/Energy/Multiple Scattering")]
float3 MultipleScattering(
    [color] float3 f0 = 0.04,       ///< reflectance at normal incidence
    [range(0.25, 1)] float scale,   ///< of f0, from the split sum
    [range(0, 1)] float offset      ///< added to it
) {
    float missing = 1 - scale - offset;
    float3 single = f0 * scale + offset;
    float3 mean = f0 + (1 - f0) / 21;
    return single + single * mean * missing / max(1 - mean * missing, 0.01);
}
