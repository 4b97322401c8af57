// Highlights as complete terms: empirical ones that predate microfacet theory, and those of Unity's two simpler
// models. Light is given as E / pi, as for the diffuse terms: specular colour * term * light is radiance.

/// The brightness of the middle of a highlight.
enum HighlightNormalization {
    Classic,    ///< 1 whatever the exponent: a sharper highlight is a smaller one
    Normalized  ///< brighter the sharper it is: a view along the normal gets exactly the incident light
};

/// Phong's highlight: a lobe around the mirrored light direction.
///
/// The lobe alone reaches around to the dark side. Multiply the classic form by 1 if the light is in front of the
/// surface, else by 0; multiply the normalised form by the cosine n.l.
///
/// formula: classic: max(0, r.v)^exponent, r = 2 (n.l) n - l; normalised: (exponent + 2) / 2 of that
/// source: Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975
/// source: Lafortune and Willems, "Using the Modified Phong Reflectance Model", 1994 (the normalisation, here times pi)
/// test: PhongHighlight(float3(0, 0, 1), float3(0.6, 0, 0.8), float3(-0.6, 0, 0.8)) == 1
/// test: PhongHighlight(float3(0, 0, 1), float3(0.6, 0, 0.8), float3(0, 0, 1), 2) == 0.64
/// test: PhongHighlight(float3(0, 0, 1), float3(0.6, 0, 0.8), float3(0, 0, 1), 2, Normalized) == 1.28
/// test: PhongHighlight(float3(0, 0, 1), float3(0.6, 0, 0.8), float3(0.8, 0, 0.6), 8) == 0
/// test: PhongHighlight(float3(0, 0, 1), float3(0.8, 0, 0.6), float3(0.8, 0, 0.6), 0) == 0
[node("Lighting/Specular/Phong")]
float PhongHighlight(
    float3 normal = normalWS,                             ///< unit normal
    float3 lightDir = light.direction,                    ///< unit direction to the light
    float3 view = viewDirWS,                             ///< unit direction to the viewer
    [range(0, 1000)] float exponent = 32,                  ///< sharpness
    const HighlightNormalization normalization = Classic  ///< brightness of its middle
) {
    float lobe = HighlightLobe(RdotV(normal, lightDir, view), exponent);
    return normalization == Classic ? lobe : lobe * (0.5 * exponent + 1);
}

/// Blinn's highlight: a lobe around the half vector, longer than Phong's at grazing angles, as real ones are.
///
/// It is about as wide as Phong's with a fourth of the exponent. Treat the dark side as for PhongHighlight.
///
/// formula: classic: max(0, n.h)^e; normalised: (e + 2) (e + 4) / (8 (2^(-e / 2) + e)) of that
/// source: Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977
/// source: Giesen, "Phong and Blinn-Phong Normalization Factors", 2009 (the exact integral, here times pi)
/// test: BlinnPhongHighlight(float3(0, 0, 1), float3(0.6, 0, 0.8), float3(-0.6, 0, 0.8)) == 1
/// test: BlinnPhongHighlight(float3(0, 0, 1), float3(0.6, 0, 0.8), float3(0, 0, 1), 4) == 0.81
/// test: BlinnPhongHighlight(float3(0, 0, 1), float3(0.6, 0, 0.8), float3(0, 0, 1), 4, Normalized) == 1.143529411764706
/// test: BlinnPhongHighlight(float3(0, 0, 1), float3(0, 1, 0), float3(0, 0, 1), 0, Normalized) == 1
/// test: BlinnPhongHighlight(float3(0, 0, 1), float3(0.6, 0, -0.8), float3(0.6, 0, -0.8), 8) == 0
[node("Lighting/Specular/Blinn-Phong")]
float BlinnPhongHighlight(
    float3 normal = normalWS,                             ///< unit normal
    float3 lightDir = light.direction,                    ///< unit direction to the light
    float3 view = viewDirWS,                             ///< unit direction to the viewer
    [range(0, 1000)] float exponent = 32,                  ///< sharpness
    const HighlightNormalization normalization = Classic  ///< brightness of its middle
) {
    float e = exponent;
    float lobe = HighlightLobe(NdotH(normal, HalfVectorExact(view, lightDir)), e);
    if (normalization == Classic) { return lobe; }
    return lobe * ((e + 2) / (8 * (exp2(-0.5 * e) + e)) * (e + 4));
}

// Where the cosine is zero, the highlight is zero for every exponent, of zero too.
float HighlightLobe(float cosine, float exponent) {
    float lobe = pow(cosine > 0 ? cosine : 1, exponent);
    return cosine > 0 ? lobe : 0;
}

/// The highlight of Unity's second model (BRDF2), a Cook-Torrance form with few divisions: D, V and F in one.
///
/// In linear space it is pi DistributionGGXMinimalist VisibilityMinimalist. The form for gamma space is the square root
/// of a similar one.
///
/// formula: d = (n.h)^2 (alpha^2 - 1) + 1.00001, alpha = (1 - smoothness)^2,
/// formula: linear: alpha^2 / (4 max(0.1, (l.h)^2) (alpha + 0.5) d^2); gamma: alpha / (max(0.32, l.h) (1.5 + alpha) d)
/// source: Schüler, "An Efficient and Physically Plausible Real Time Shading Model", ShaderX 7, 2009
/// source: Zioma, "Optimizing PBR for Mobile", SIGGRAPH 2015; Unity built-in shaders, BRDF2_Unity_PBS
/// test: MinimalistHighlight(float3(0, 0, 1), float3(0, 0, 1), float3(0, 0, 1), 0.5) == 5.331627076179292
/// test: MinimalistHighlight(float3(0, 0, 1), float3(0, 0, 1), float3(0, 0, 1), 0.5, Gamma) == 2.2853486299334937
/// test: MinimalistHighlight(float3(0, 0, 1), float3(0, 0, 1), float3(0, 0, 1), 0) == 0.16666333338333264
/// test: MinimalistHighlight(float3(0, 0, 1), float3(0.6, 0, 0.8), float3(-0.6, 0, 0.8), 1, Gamma) == 0
[node("Lighting/Specular/Minimalist")]
float MinimalistHighlight(
    float3 normal = normalWS,             ///< unit normal
    float3 lightDir = light.direction,    ///< unit direction to the light
    float3 view = viewDirWS,             ///< unit direction to the viewer
    [range(0, 1)] float smoothness = 0.5,  ///< 1 - perceptual roughness
    const WorkingSpace space = Linear      ///< colour space that lighting is computed in
) {
    float3 halfVector = HalfVector(view, lightDir);
    float ndoth = NdotH(normal, halfVector);
    float ldoth = LdotH(lightDir, halfVector);
    float alpha = AlphaFromSmoothness(smoothness);
    if (space == Gamma) { return MinimalistPeak(ndoth, alpha) / (max(ldoth, 0.32) * (1.5 + alpha)); }
    return PI * DistributionGGXMinimalist(ndoth, alpha) * VisibilityMinimalist(ldoth, alpha);
}

/// The highlight of Unity's third model (BRDF3): Phong's lobe, as an early release documents its table.
///
/// The table itself is not public. It holds values up to 16, and is read with (r.l)^4.
///
/// formula: (e + 2) / (2 pi^2) (r.l)^e, e = SpecPowerFromRoughness / 4
/// source: Unity built-in shaders 5.0, BRDF3_Unity_PBS, the branch that is not compiled
/// test: PhongHighlightUnity(1, 0.5) == 0.48127562230110443
/// test: PhongHighlightUnity(0.9, 0.5) == 0.21837991118711467
/// test: PhongHighlightUnity(1, 0) == 0.1013224501571333
/// test: PhongHighlightUnity(0, 0.9) == 0
[node("Lighting/Specular/Phong Unity")]
float PhongHighlightUnity(
    [range(0, 1)] float rdotl,            ///< cosine of mirrored view and light
    [range(0, 1)] float smoothness = 0.5  ///< 1 - perceptual roughness
) {
    float exponent = PhongExponentFromBlinnPhong(SpecPowerFromRoughness(1 - smoothness));
    return (exponent + 2) * (0.5 * INV_PI * INV_PI) * HighlightLobe(saturate(rdotl), exponent);
}
