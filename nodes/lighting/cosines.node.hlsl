// The cosines that lighting formulas use: between the normal n, the direction to the light l, the direction to the
// viewer v, and the half vector h between l and v. All directions are unit vectors in world space.

/// How a cosine below zero is treated: the light or the viewer is behind the surface.
enum CosineMode {
    Clamped,   ///< it becomes zero
    Absolute,  ///< it becomes positive: a normal map may turn a visible pixel's normal away from the viewer
    Signed     ///< it is kept, for wrapped lighting such as HalfLambert
};

// Rounding can leave the dot product of unit vectors a little above 1, and sqrt(1 - c^2) would then not be a number:
// so both other modes saturate.
float CosineBetween(float3 from, float3 to, const CosineMode mode) {
    float cosine = dot(from, to);
    return mode == Clamped ? saturate(cosine) : mode == Absolute ? saturate(abs(cosine)) : cosine;
}

/// The cosine between normal and light: the share of the light's power that falls on the surface.
///
/// formula: n.l
/// source: Lambert, "Photometria", 1760
/// test: NdotL(float3(0, 0, 1), float3(0.8660254037844386, 0, 0.5)) == 0.5
/// test: NdotL(float3(0, 0, 1), float3(0.6, 0, -0.8)) == 0
/// test: NdotL(float3(0, 0, 1), float3(0.6, 0, -0.8), Absolute) == 0.8
/// test: NdotL(float3(0, 0, 1), float3(0.6, 0, -0.8), Signed) == -0.8
[node("Lighting/Cosine/N.L")] [also("LambertTerm")] [range(-1, 1)]
float NdotL(
    float3 normal = normalWS,           ///< unit normal
    float3 lightDir = light.direction,  ///< unit direction to the light
    const CosineMode mode = Clamped      ///< how a light behind the surface is treated
) {
    return CosineBetween(normal, lightDir, mode);
}

/// The cosine between normal and view: 1 where the surface faces the viewer, 0 at its silhouette.
///
/// formula: n.v
/// test: NdotV(float3(0, 0, 1), float3(0, 0.6, 0.8)) == 0.8
/// test: NdotV(float3(0, 0, 1), float3(0, 0.6, -0.8)) == 0
/// test: NdotV(float3(0, 0, 1), float3(0, 0.6, -0.8), Absolute) == 0.8
/// test: NdotV(float3(0, 0, 1), float3(0, 0.6, -0.8), Signed) == -0.8
[node("Lighting/Cosine/N.V")] [range(-1, 1)]
float NdotV(
    float3 normal = normalWS,       ///< unit normal
    float3 view = viewDirWS,       ///< unit direction to the viewer
    const CosineMode mode = Clamped  ///< how a normal that points away from the viewer is treated
) {
    return CosineBetween(normal, view, mode);
}

/// The direction half-way between the light and the viewer.
///
/// If the light is exactly opposite to the viewer, the direction does not exist: near that, the vector shrinks to zero.
///
/// formula: h = (l + v) / sqrt(max(|l + v|^2, 0.001))
/// source: Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977
/// test: HalfVector(float3(0.6, 0, 0.8), float3(-0.6, 0, 0.8)) == float3(0, 0, 1)
/// test: HalfVector(float3(0, 0, 1), float3(0, 1, 0)) == float3(0, 0.7071067811865476, 0.7071067811865476)
/// test: HalfVector(float3(0.6, 0, 0.8), float3(0, 1, 0)) == float3(0.6, 1, 0.8) / 1.4142135623730951
/// test: HalfVector(float3(0, 0, 1), float3(0, 0, -1)) == float3(0, 0, 0)
[node("Lighting/Half Vector")] [range(-1, 1)]
float3 HalfVector(
    float3 view = viewDirWS,          ///< unit direction to the viewer
    float3 lightDir = light.direction  ///< unit direction to the light
) {
    float3 sum = lightDir + view;
    return sum * rsqrt(max(dot(sum, sum), 0.001));
}

/// The cosine between normal and half vector: the argument of every normal distribution.
///
/// formula: n.h
/// test: NdotH(float3(0, 0, 1), float3(0.6, 0, 0.8)) == 0.8
/// test: NdotH(float3(0, 0, 1), float3(0.6, 0, -0.8)) == 0
[node("Lighting/Cosine/N.H")] [range(0, 1)]
float NdotH(
    float3 normal = normalWS,  ///< unit normal
    float3 halfVector          ///< unit half vector
) {
    return saturate(dot(normal, halfVector));
}

/// The cosine between light and half vector, which is also that between view and half vector: the argument of Fresnel.
///
/// formula: l.h = v.h
/// test: LdotH(float3(0.6, 0, 0.8), float3(0, 0, 1)) == 0.8
/// test: LdotH(float3(0, 0, 1), float3(0, 0, -1)) == 0
[node("Lighting/Cosine/L.H")] [range(0, 1)]
float LdotH(
    float3 lightDir = light.direction,  ///< unit direction to the light
    float3 halfVector                   ///< unit half vector
) {
    return saturate(dot(lightDir, halfVector));
}
