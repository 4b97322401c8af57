// The directions that lighting formulas use, from the positions of light, viewer and surface. All are in world space,
// and point away from the surface.

/// The direction and distance from a point to a light in Unity's form: a position, or a direction.
///
/// formula: light.xyz - position light.w
/// source: Unity built-in shaders, UnityWorldSpaceLightDir
/// test: LightVector(float4(3, 4, 5, 1), float3(1, 1, 1)) == float3(2, 3, 4)
/// test: LightVector(float4(0.6, 0.8, 0, 0), float3(1, 1, 1)) == float3(0.6, 0.8, 0)
/// test: LightVector(float4(3, 5, 5, 1), float3(1, 1, 1)).distance == 6
/// test: LightVector(float4(3, 5, 5, 1), float3(1, 1, 1)).direction == float3(1 / 3, 2 / 3, 2 / 3)
[node("Lighting/Direction/Light Vector")]
float3 LightVector(
    float4 lightPosition = float4(0, 1, 0, 0),  ///< xyz: position, or direction to the light; w: 1 or 0
    [unit("m")] float3 position = positionWS,   ///< the point that is lit
    [range(-1, 1)] out float3 direction,         ///< unit direction to the light
    [unit("m")] out float distance               ///< length of the vector
) {
    float3 toLight = lightPosition.xyz - position * lightPosition.w;
    float squared = max(dot(toLight, toLight), 1e-7);
    direction = toLight * rsqrt(squared);
    distance = sqrt(squared);
    return toLight;
}

/// The direction half-way between light and viewer, of unit length wherever it exists.
///
/// HalfVector shrinks where the light is almost opposite to the viewer, as Unity's does; this node divides by the true
/// length.
///
/// formula: h = (l + v) / |l + v|
/// source: Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977
/// test: HalfVectorExact(float3(0.6, 0, 0.8), float3(-0.6, 0, 0.8)) == float3(0, 0, 1)
/// test: HalfVectorExact(float3(0, 0, 1), float3(0, 1, 0)) == float3(0, 0.7071067811865476, 0.7071067811865476)
[node("Lighting/Half Vector Exact")] [range(-1, 1)]
float3 HalfVectorExact(
    float3 view = viewDirWS,          ///< unit direction to the viewer
    float3 lightDir = light.direction  ///< unit direction to the light
) {
    float3 sum = lightDir + view;
    return sum * rsqrt(max(dot(sum, sum), 1e-7));
}

/// The mirrored view direction, in which the environment is sampled.
///
/// formula: 2 (n.v) n - v
/// source: Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975
/// test: ReflectionVector(float3(0.6, 0, 0.8), float3(0, 0, 1)) == float3(-0.6, 0, 0.8)
/// test: ReflectionVector(float3(0, 1, 0), float3(0, 1, 0)) == float3(0, 1, 0)
[node("Lighting/Direction/Reflection Vector")] [range(-1, 1)]
float3 ReflectionVector(
    float3 direction = viewDirWS,  ///< unit direction to the viewer (or to the light: the mirror works both ways)
    float3 normal = normalWS        ///< unit normal
) {
    return reflect(-direction, normal);
}

/// The cosine between light and view.
///
/// formula: l.v
/// test: LdotV(float3(0.6, 0, 0.8), float3(0, 0, 1)) == 0.8
/// test: LdotV(float3(0, 0, 1), float3(0.6, 0, -0.8), Signed) == -0.8
/// test: LdotV(float3(0, 0, 1), float3(0.6, 0, -0.8), Clamped) == 0
/// test: LdotV(float3(0, 0, 1), float3(0.6, 0, -0.8), Absolute) == 0.8
[node("Lighting/Cosine/L.V")] [range(-1, 1)]
float LdotV(
    float3 lightDir = light.direction,  ///< unit direction to the light
    float3 view = viewDirWS,           ///< unit direction to the viewer
    const CosineMode mode = Signed       ///< how a light opposite to the viewer is treated
) {
    return CosineBetween(lightDir, view, mode);
}

/// The cosine between the mirrored light and the view: the argument of Phong's highlight.
///
/// formula: r.v, r = 2 (n.l) n - l; at least 0 if Clamped
/// source: Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975
/// test: RdotV(float3(0, 0, 1), float3(0.6, 0, 0.8), float3(-0.6, 0, 0.8)) == 1
/// test: RdotV(float3(0, 0, 1), float3(0.6, 0, 0.8), float3(0, 0, 1)) == 0.8
/// test: RdotV(float3(0, 0, 1), float3(0.8, 0, 0.6), float3(0.8, 0, 0.6)) == 0
/// test: RdotV(float3(0, 0, 1), float3(0.8, 0, 0.6), float3(0.8, 0, 0.6), Absolute) == 0.28
/// test: RdotV(float3(0, 0, 1), float3(0.8, 0, 0.6), float3(0.8, 0, 0.6), Signed) == -0.28
[node("Lighting/Cosine/R.V")] [range(-1, 1)]
float RdotV(
    float3 normal = normalWS,           ///< unit normal
    float3 lightDir = light.direction,  ///< unit direction to the light
    float3 view = viewDirWS,            ///< unit direction to the viewer
    const CosineMode mode = Clamped      ///< how a viewer opposite to the mirrored light is treated
) {
    return CosineBetween(ReflectionVector(lightDir, normal), view, mode);
}

/// The cosine between normal and view, with the normal tilted to the viewer where it points away.
///
/// A normal map can turn the normal of a visible pixel away from the viewer. The tilt darkens such pixels smoothly; the
/// absolute cosine would make them bright again.
///
/// formula: n' = n - min(n.v, 0) v, with 0.00001 on top; n.v = saturate(n'.v)
/// source: Unity built-in shaders, BRDF1 with UNITY_HANDLE_CORRECTLY_NEGATIVE_NDOTV
/// test: NdotVShifted(float3(0, 0, 1), float3(0, 0.6, 0.8)) == 0.8
/// test: NdotVShifted(float3(0, 0, 1), float3(0, 0.8, -0.6)) == 0.00001 within 1e-2
/// test: NdotVShifted(float3(0, 0, 1), float3(0.6, 0, 0.8)).shiftedNormal == float3(0, 0, 1)
[node("Lighting/Cosine/N.V Shifted")] [range(0, 1)]
float NdotVShifted(
    float3 normal = normalWS,  ///< unit normal
    float3 view = viewDirWS,  ///< unit direction to the viewer
    out float3 shiftedNormal   ///< the tilted normal, for the other cosines; no longer quite unit length
) {
    float cosine = dot(normal, view);
    shiftedNormal = cosine < 0 ? normal + view * (1e-5 - cosine) : normal;
    return saturate(dot(shiftedNormal, view));
}

/// An orthonormal frame from an interpolated normal and tangent.
///
/// formula: n = normalize(normal), t = normalize(tangent - n dot(n, tangent)), b = cross(n, t) w
/// test: TangentFrame(float3(0, 0, 2), float4(3, 0, 3, 1)) == float3(1, 0, 0)
/// test: TangentFrame(float3(0, 0, 2), float4(3, 0, 3, 1)).bitangent == float3(0, 1, 0)
/// test: TangentFrame(float3(0, 0, 2), float4(3, 0, 3, -1)).bitangent == float3(0, -1, 0)
/// test: TangentFrame(float3(0, 0, 2), float4(3, 0, 3, 1)).unitNormal == float3(0, 0, 1)
[node("Lighting/Direction/Tangent Frame")] [range(-1, 1)]
float3 TangentFrame(
    float3 normal = geometryNormalWS,    ///< normal, of any length but zero
    float4 tangent = handedTangentWS,      ///< xyz: tangent, not along the normal; w: handedness, 1 or -1
    [range(-1, 1)] out float3 bitangent,   ///< unit bitangent
    [range(-1, 1)] out float3 unitNormal  ///< unit normal
) {
    unitNormal = normalize(normal);
    float3 along = tangent.xyz - unitNormal * dot(unitNormal, tangent.xyz);
    float3 unitTangent = along * rsqrt(max(dot(along, along), 1e-7));
    bitangent = cross(unitNormal, unitTangent) * tangent.w;
    return unitTangent;
}
