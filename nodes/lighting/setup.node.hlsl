// Conversions from an artist's parameters (a base colour, metallic or specular, roughness or smoothness) to the
// parameters of lighting: a diffuse colour, the reflectance f0, and alpha.

/// How SpecularSetup prevents a surface from reflecting more light than it receives.
enum EnergyConservation {
    Monochrome,  ///< the diffuse colour is scaled by one minus the strongest specular channel, which keeps its hue
    Colored,     ///< each diffuse channel is scaled by one minus the same specular channel
    None         ///< the diffuse colour is not scaled
};

/// Diffuse colour and reflectance of a surface from base colour and metallic.
///
/// At normal incidence, a dielectric reflects 4 % of the light, without colour, and scatters the rest. A metal reflects
/// light in its own colour and scatters none.
///
/// formula: f0 = lerp(0.04, baseColor, metallic); diffuse = baseColor 0.96 (1 - metallic)
/// source: the metallic workflow of Unity's Standard shader, in linear colour space
/// test: MetallicSetup(float3(0.8, 0.4, 0.1), 0.3).diffuseColor == float3(0.5376, 0.2688, 0.0672)
/// test: MetallicSetup(float3(0.8, 0.4, 0.1), 0.3).f0 == float3(0.268, 0.148, 0.058)
/// test: MetallicSetup(float3(0.8, 0.4, 0.1), 0.3).oneMinusReflectivity == 0.672
/// test: MetallicSetup(float3(0.8, 0.4, 0.1), 1).diffuseColor == float3(0, 0, 0)
/// test: MetallicSetup(float3(0.8, 0.4, 0.1), 1).f0 == float3(0.8, 0.4, 0.1)
[node("Lighting/Setup/Metallic")] [inline]
void MetallicSetup(
    [color] float3 baseColor = 0.5,                ///< colour of the surface
    [range(0, 1)] float metallic = 0,               ///< 0 is a dielectric, 1 a metal
    [range(0, 1)] out float3 diffuseColor,         ///< colour of the scattered light
    [range(0, 1)] out float3 f0,                    ///< reflectance at normal incidence
    [range(0, 1)] out float oneMinusReflectivity  ///< share of the light that is not reflected specularly
) {
    const float dielectric = 0.04;
    oneMinusReflectivity = (1 - dielectric) * (1 - metallic);
    diffuseColor = baseColor * oneMinusReflectivity;
    f0 = lerp(dielectric, baseColor, metallic);
}

/// Diffuse colour and reflectance of a surface from base colour and specular colour.
///
/// formula: f0 = specular
/// formula: monochrome: diffuse = baseColor (1 - max(specular)); colored: diffuse = baseColor (1 - specular)
/// source: the specular workflow of Unity's Standard shader
/// test: SpecularSetup(float3(1, 1, 1), float3(0.5, 0.2, 0.1)).diffuseColor == float3(0.5, 0.5, 0.5)
/// test: SpecularSetup(float3(1, 1, 1), float3(0.5, 0.2, 0.1), Colored).diffuseColor == float3(0.5, 0.8, 0.9)
/// test: SpecularSetup(float3(1, 0.5, 0), float3(0.5, 0.2, 0.1), None).diffuseColor == float3(1, 0.5, 0)
/// test: SpecularSetup(float3(1, 1, 1), float3(0.5, 0.2, 0.1)).f0 == float3(0.5, 0.2, 0.1)
/// test: SpecularSetup(float3(1, 1, 1), float3(0.1, 0.2, 0.75)).oneMinusReflectivity == 0.25
[node("Lighting/Setup/Specular")] [inline]
void SpecularSetup(
    [color] float3 baseColor = 0.5,                     ///< colour of the scattered light, before conservation
    [color] float3 specular = 0.2,                       ///< reflectance at normal incidence
    const EnergyConservation conservation = Monochrome,  ///< how the diffuse colour is scaled
    [range(0, 1)] out float3 diffuseColor,              ///< colour of the scattered light
    [range(0, 1)] out float3 f0,                         ///< reflectance at normal incidence
    [range(0, 1)] out float oneMinusReflectivity       ///< share of the light that is not reflected specularly
) {
    oneMinusReflectivity = 1 - max(max(specular.r, specular.g), specular.b);
    diffuseColor = baseColor;
    if (conservation == Monochrome) { diffuseColor = baseColor * oneMinusReflectivity; }
    if (conservation == Colored) { diffuseColor = baseColor * (1 - specular); }
    f0 = specular;
}

/// Converts smoothness or glossiness to perceptual roughness.
///
/// formula: 1 - smoothness
/// test: RoughnessFromSmoothness(0.75) == 0.25
/// test: RoughnessFromSmoothness(1) == 0
[node("Lighting/Setup/Roughness from Smoothness")] [also("SmoothnessToPerceptualRoughness")] [range(0, 1)]
float RoughnessFromSmoothness(
    [range(0, 1)] float smoothness = 0.5  ///< 0 is dull, 1 a mirror
) {
    return 1 - smoothness;
}

/// The roughness alpha of the microfacet formulas: the square of perceptual roughness.
///
/// The lower limit keeps the highlight of a punctual light from becoming smaller than a pixel. Set it to zero for the
/// mapping alone.
///
/// formula: alpha = max(roughness^2, minimum)
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, section 5.4; the limit is Unity's
/// test: AlphaFromRoughness(0.5) == 0.25
/// test: AlphaFromRoughness(0) == 0.002
/// test: AlphaFromRoughness(0.01, 0) == 0.0001
[node("Lighting/Setup/Alpha from Roughness")] [also("PerceptualRoughnessToRoughness")] [range(0, 1)]
float AlphaFromRoughness(
    [range(0, 1)] float roughness = 0.5,   ///< perceptual roughness
    [range(0, 0.1)] float minimum = 0.002  ///< lower limit of the result
) {
    return max(roughness * roughness, minimum);
}

/// The colour space that an engine computes lighting in.
enum WorkingSpace {
    Linear,  ///< linear light: dielectrics reflect 0.04
    Gamma    ///< encoded as for a screen: dielectrics reflect 0.2209
};

/// The reflectance at normal incidence of dielectrics in the metallic workflow.
///
/// formula: linear: 0.04; gamma: 0.220916301
/// source: Unity built-in shaders, unity_ColorSpaceDielectricSpec
/// test: DielectricF0() == 0.04
/// test: DielectricF0(Gamma) == 0.220916301
[node("Lighting/Setup/Dielectric F0")] [range(0, 1)]
float DielectricF0(
    const WorkingSpace space = Linear  ///< colour space that lighting is computed in
) {
    return space == Linear ? 0.04 : 0.220916301;
}

/// The share of light that a surface does not reflect specularly, from metallic.
///
/// formula: (1 - d) - metallic (1 - d), d as DielectricF0's
/// source: Unity built-in shaders, OneMinusReflectivityFromMetallic
/// test: OneMinusReflectivityFromMetallic(0) == 0.96
/// test: OneMinusReflectivityFromMetallic(0.5) == 0.48
/// test: OneMinusReflectivityFromMetallic(0, Gamma) == 0.779083699
[node("Lighting/Setup/One Minus Reflectivity from Metallic")] [range(0, 1)]
float OneMinusReflectivityFromMetallic(
    [range(0, 1)] float metallic = 0,  ///< 0 is a dielectric, 1 a metal
    const WorkingSpace space = Linear  ///< colour space that lighting is computed in
) {
    return (1 - DielectricF0(space)) * (1 - metallic);
}

/// How a specular colour becomes one number.
enum SpecularStrengthForm {
    Largest,  ///< the strongest channel: no channel reflects more light than it receives
    Red       ///< the red channel, as for shader model 2
};

/// The specular strength of a surface, as one number.
///
/// formula: max(r, g, b), or r
/// source: Unity built-in shaders, SpecularStrength
/// test: SpecularStrength(float3(0.5, 0.2, 0.1)) == 0.5
/// test: SpecularStrength(float3(0.1, 0.2, 0.75)) == 0.75
/// test: SpecularStrength(float3(0.1, 0.2, 0.75), Red) == 0.1
[node("Lighting/Setup/Specular Strength")] [range(0, 1)]
float SpecularStrength(
    [color] float3 specular = 0.2,             ///< reflectance at normal incidence
    const SpecularStrengthForm form = Largest  ///< which channel is used
) {
    return form == Largest ? max(max(specular.r, specular.g), specular.b) : specular.r;
}

/// Scales a diffuse colour so that diffuse and specular light together do not exceed the incident light.
///
/// formula: monochrome: albedo (1 - max(specular)); colored: albedo (1 - specular); none: albedo
/// source: Unity built-in shaders, EnergyConservationBetweenDiffuseAndSpecular
/// test: ConserveEnergy(float3(1, 1, 1), float3(0.5, 0.2, 0.1)) == float3(0.5, 0.5, 0.5)
/// test: ConserveEnergy(float3(1, 1, 1), float3(0.5, 0.2, 0.1), Colored) == float3(0.5, 0.8, 0.9)
/// test: ConserveEnergy(float3(1, 0.5, 0), float3(0.5, 0.2, 0.1), None) == float3(1, 0.5, 0)
/// test: ConserveEnergy(float3(1, 1, 1), float3(0.5, 0.2, 0.1), Colored).oneMinusReflectivity == 0.5
[node("Lighting/Setup/Conserve Energy")] [range(0, 1)]
float3 ConserveEnergy(
    [color] float3 albedo = 0.5,                         ///< diffuse colour
    [color] float3 specular = 0.2,                       ///< reflectance at normal incidence
    const EnergyConservation conservation = Monochrome,  ///< how it is scaled
    [range(0, 1)] out float oneMinusReflectivity       ///< 1 - the strongest specular channel
) {
    oneMinusReflectivity = SpecularSetup(albedo, specular, conservation).oneMinusReflectivity;
    return SpecularSetup(albedo, specular, conservation).diffuseColor;
}

/// A diffuse colour for blending with pre-multiplied alpha: reflections stay as the material fades.
///
/// formula: diffuse alpha; alpha' = 1 - r + alpha r, r = one minus reflectivity
/// source: Unity built-in shaders, PreMultiplyAlpha
/// test: PremultiplyAlpha(float3(0.5, 0.4, 0.3), 0.5, 0.2) == float3(0.25, 0.2, 0.15)
/// test: PremultiplyAlpha(float3(0.5, 0.4, 0.3), 0.5, 0.2).outAlpha == 0.9
/// test: PremultiplyAlpha(float3(0.5, 0.4, 0.3), 0, 0.96).outAlpha == 0.04
[node("Lighting/Setup/Premultiply Alpha")] [range(0, 1)]
float3 PremultiplyAlpha(
    [color] float3 diffuseColor = 0.5,                 ///< colour of the scattered light
    [range(0, 1)] float alpha = 1,                      ///< coverage
    [range(0, 1)] float oneMinusReflectivity = 0.96,  ///< share of the light that is not reflected specularly
    [range(0, 1)] out float outAlpha                   ///< alpha for blending: one, one minus source alpha
) {
    outAlpha = 1 - oneMinusReflectivity + alpha * oneMinusReflectivity;
    return diffuseColor * alpha;
}

/// Converts perceptual roughness to smoothness.
///
/// formula: 1 - roughness
/// test: SmoothnessFromRoughness(0.25) == 0.75
/// test: SmoothnessFromRoughness(0) == 1
[node("Lighting/Setup/Smoothness from Roughness")] [range(0, 1)]
float SmoothnessFromRoughness(
    [range(0, 1)] float roughness = 0.5  ///< perceptual roughness
) {
    return 1 - roughness;
}

/// Converts smoothness to alpha, without a lower limit.
///
/// formula: (1 - smoothness)^2
/// source: Unity built-in shaders, SmoothnessToRoughness
/// test: AlphaFromSmoothness(0.1) == 0.81
/// test: AlphaFromSmoothness(1) == 0
[node("Lighting/Setup/Alpha from Smoothness")] [also("SmoothnessToRoughness")] [range(0, 1)]
float AlphaFromSmoothness(
    [range(0, 1)] float smoothness = 0.5  ///< 0 is dull, 1 a mirror
) {
    return (1 - smoothness) * (1 - smoothness);
}

/// Converts alpha to perceptual roughness.
///
/// formula: sqrt(alpha)
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, section 5.4
/// test: RoughnessFromAlpha(0.25) == 0.5
/// test: RoughnessFromAlpha(0) == 0
[node("Lighting/Setup/Roughness from Alpha")] [also("RoughnessToPerceptualRoughness")] [range(0, 1)]
float RoughnessFromAlpha(
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    return sqrt(max(alpha, 0));
}

/// Converts perceptual roughness to a Blinn-Phong exponent, as Unity does.
///
/// formula: max(2 / max(roughness^4, 0.0001) - 2, 0.0001), from 0.0001 to 19998
/// source: Unity built-in shaders, PerceptualRoughnessToSpecPower
/// test: SpecPowerFromRoughness(0.25) == 510
/// test: SpecPowerFromRoughness(0) == 19998
/// test: SpecPowerFromRoughness(1) == 0.0001
[node("Lighting/Setup/Spec Power from Roughness")] [range(0.0001, 19998)]
float SpecPowerFromRoughness(
    [range(0, 1)] float roughness = 0.5  ///< perceptual roughness
) {
    return BlinnPhongExponentFromAlpha(roughness * roughness);
}

/// Converts a Blinn-Phong exponent to perceptual roughness.
///
/// formula: (2 / (exponent + 2))^(1/4)
/// source: the inverse of SpecPowerFromRoughness
/// test: RoughnessFromSpecPower(510) == 0.25
/// test: RoughnessFromSpecPower(0) == 1
[node("Lighting/Setup/Roughness from Spec Power")] [range(0, 1)]
float RoughnessFromSpecPower(
    [range(0, 20000)] float exponent = 32  ///< Blinn-Phong exponent, 0 or more
) {
    return sqrt(AlphaFromBlinnPhongExponent(exponent));
}

/// Converts a metallic/roughness surface to specular/gloss. The conversion is always exact.
///
/// The specular workflow scales its diffuse colour by one minus the strongest specular channel; the result compensates
/// for that.
///
/// formula: specular = lerp(0.04, baseColor, metallic), glossiness = 1 - roughness,
/// formula: diffuse = baseColor 0.96 (1 - metallic) / (1 - max(specular))
/// source: the two set-ups of Unity's Standard shader, made equal
/// test: SpecularFromMetallic(float3(0.8, 0.4, 0.1), 0, 0.3).specular == float3(0.04, 0.04, 0.04)
/// test: SpecularFromMetallic(float3(0.8, 0.4, 0.1), 0, 0.3).diffuse == float3(0.8, 0.4, 0.1)
/// test: SpecularFromMetallic(float3(0.8, 0.4, 0.1), 1, 0.3).specular == float3(0.8, 0.4, 0.1)
/// test: SpecularFromMetallic(float3(0.8, 0.4, 0.1), 1, 0.3).diffuse == float3(0, 0, 0)
/// test: SpecularFromMetallic(float3(0.8, 0.4, 0.1), 0.5, 0.3).diffuse == float3(0.384, 0.192, 0.048) / 0.58
/// test: SpecularFromMetallic(float3(0.8, 0.4, 0.1), 0.5, 0.3).glossiness == 0.7
[node("Lighting/Setup/Specular from Metallic")]
void SpecularFromMetallic(
    [color] float3 baseColor = 0.5,      ///< colour of the surface
    [range(0, 1)] float metallic = 0,     ///< 0 is a dielectric, 1 a metal
    [range(0, 1)] float roughness = 0.5,  ///< perceptual roughness
    [range(0, 1)] out float3 diffuse,     ///< base colour of the specular workflow
    [range(0, 1)] out float3 specular,    ///< reflectance at normal incidence
    [range(0, 1)] out float glossiness    ///< 1 - roughness
) {
    specular = MetallicSetup(baseColor, metallic).f0;
    float rest = 1 - SpecularStrength(specular, Largest);
    // A white metal has no diffuse colour: the limit only prevents a division by zero.
    diffuse = MetallicSetup(baseColor, metallic).diffuseColor / max(rest, 1e-4);
    glossiness = 1 - roughness;
}

/// How well MetallicFromSpecular fits a surface that has no exact description.
enum MetallicFit {
    Quick,  ///< metallic from the strongest channels
    Best    ///< metallic from a search: too slow for rendering, suited to converting a material once
};

// The nearest base colour for a given metallic: in each channel, its diffuse and specular colours have equal errors. It
// is exact if an exact one exists.
float3 fittedBaseColor(float3 scattered, float3 specular, float metallic) {
    float dielectric = 1 - metallic;
    return saturate((scattered + specular - 0.04 * dielectric) / (0.96 * dielectric + metallic));
}

// The largest difference in any channel of the diffuse and the specular colour.
float metallicFitError(float3 scattered, float3 specular, float metallic) {
    float3 baseColor = fittedBaseColor(scattered, specular, metallic);
    float3 offDiffuse = abs(MetallicSetup(baseColor, metallic).diffuseColor - scattered);
    float3 offSpecular = abs(MetallicSetup(baseColor, metallic).f0 - specular);
    return max(SpecularStrength(offDiffuse, Largest), SpecularStrength(offSpecular, Largest));
}

// The metallic with the smallest error: the best of 64, refined by golden-section search between its neighbours.
float bestMetallic(float3 scattered, float3 specular, float quick) {
    float best = quick;
    float least = metallicFitError(scattered, specular, quick);
    for (int i = 0; i < 65; i++) {
        float error = metallicFitError(scattered, specular, float(i) / 64);
        best = error < least ? float(i) / 64 : best;
        least = min(error, least);
    }
    float low = max(best - 1.0 / 64, 0);
    float high = min(best + 1.0 / 64, 1);
    for (int k = 0; k < 16; k++) {
        float a = lerp(high, low, 0.6180339887);
        float b = lerp(low, high, 0.6180339887);
        bool left = metallicFitError(scattered, specular, a) < metallicFitError(scattered, specular, b);
        low = left ? low : a;
        high = left ? b : high;
    }
    float middle = 0.5 * (low + high);
    return metallicFitError(scattered, specular, middle) < least ? middle : best;
}

/// Converts a specular/gloss surface to metallic/roughness, exactly if possible and approximately otherwise.
///
/// The conversion is exact if the specular colour lies between 0.04 and the base colour. Otherwise (a reflectance below
/// 0.04, or a coloured one on a diffuse surface of another hue), `fit` selects how metallic is found, and the base
/// colour is the nearest for that metallic. `error` is the largest difference in any channel of the resulting diffuse
/// and specular colours; it is 0 if the conversion is exact.
///
/// formula: metallic m solves 0.04 (1 - m) + b m = s and 0.96 (1 - m) b = d for the strongest channel:
/// formula: 0.04 m^2 + (d / 0.96 + s - 0.08) m + 0.04 - s = 0; b = (d + s - 0.04 (1 - m)) / (0.96 (1 - m) + m)
/// source: Khronos, KHR_materials_pbrSpecularGlossiness, appendix, with 0.96 for the diffuse share as here
/// test: MetallicFromSpecular(float3(0.8, 0.4, 0.1), float3(0.04, 0.04, 0.04), 0.7).metallic == 0
/// test: MetallicFromSpecular(float3(0.8, 0.4, 0.1), float3(0.04, 0.04, 0.04), 0.7).baseColor == float3(0.8, 0.4, 0.1)
/// test: MetallicFromSpecular(float3(0, 0, 0), float3(0.8, 0.4, 0.1), 0.7).metallic == 1
/// test: MetallicFromSpecular(float3(0, 0, 0), float3(0.8, 0.4, 0.1), 0.7).baseColor == float3(0.8, 0.4, 0.1)
/// test: MetallicFromSpecular(float3(0, 0, 0), float3(0, 0, 0), 0.7).error == 0.04
/// test: MetallicFromSpecular(float3(0, 0, 0), float3(0, 0, 0), 0.7, Best).error == 0 within 1e-3
/// test: MetallicFromSpecular(float3(0.5, 0.5, 0.5), float3(0.2, 0.2, 0.2), 0.7).roughness == 0.3
[node("Lighting/Setup/Metallic from Specular")]
void MetallicFromSpecular(
    [color] float3 diffuse = 0.5,          ///< base colour of the specular workflow
    [color] float3 specular = 0.04,        ///< reflectance at normal incidence
    [range(0, 1)] float glossiness = 0.5,  ///< 1 - roughness
    const MetallicFit fit = Quick,         ///< how to find metallic if no conversion is exact
    [range(0, 1)] out float3 baseColor,   ///< colour of the surface
    [range(0, 1)] out float metallic,      ///< 0 is a dielectric, 1 a metal
    [range(0, 1)] out float roughness,     ///< perceptual roughness
    [range(0, 1)] out float error          ///< largest difference in diffuse or specular colour
) {
    float3 scattered = diffuse * (1 - SpecularStrength(specular, Largest));
    float d = SpecularStrength(scattered, Largest);
    float s = SpecularStrength(specular, Largest);
    float halfB = 0.5 * (d / 0.96 + s - 0.08);
    float c = 0.04 - s;
    // The root between 0 and 1 of 0.04 m^2 + 2 halfB m + c, in the form that stays precise for a small c.
    float root = sqrt(max(halfB * halfB - 0.04 * c, 0));
    float plain = halfB > 0 ? -c / max(halfB + root, 1e-6) : (root - halfB) / 0.04;
    metallic = saturate(s <= 0.04 ? 0 : plain);
    if (fit == Best) { metallic = bestMetallic(scattered, specular, metallic); }
    baseColor = fittedBaseColor(scattered, specular, metallic);
    roughness = 1 - glossiness;
    error = metallicFitError(scattered, specular, metallic);
}
