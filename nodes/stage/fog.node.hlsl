// Fog: part of the engine's interface. An engine may replace the [extern] function.

/// Distant surfaces fade into fog.
[switch] bool fog;
/// The colour that distant surfaces fade into: red, green and blue.
/// unit: linear radiance
[extern("Frame")] [with("fog")] float4 fogColor;
/// x: the kind of fog: 0 none, 1 linear, 2 exponential, 3 exponential squared; y: its density; z and w: the distances at
/// which linear fog starts and ends.
/// unit: 1/m (y), m (z, w)
[extern("Frame")] [with("fog")] float4 fogSettings;

/// The visible fraction of a surface in fog: 1 is fully visible. Distance is measured along the camera's axis.
[extern]
float fogVisibility(float3 position) {
    if (!fog) { return 1; }
    return FogFactor(dot(position - cameraPositionWS, cameraForwardWS), fogSettings);
}

/// The colour of a surface in fog.
[inline]
float3 inFog(float3 color, float3 position) {
    if (!fog) { return color; }
    return lerp(fogColor.rgb, color, fogVisibility(position));
}

/// Applies fog to light that is added to a surface whose colour already includes fog.
[inline]
float3 fadedByFog(float3 color, float3 position) {
    if (!fog) { return color; }
    return color * fogVisibility(position);
}

/// A pixel in fog, ready for the blend mode of its surface: fog covers as much as the surface does, dims additive
/// surfaces, and weakens multiplying ones. If the surface is transparent, `color` is multiplied by its coverage.
[inline]
float4 blendedInFog(float3 color, float alpha, float3 position) {
    float covered = 1;
    if (fades || premultiplied) { covered = alpha; }
    if (fog && premultiplied) { return float4(lerp(fogColor.rgb * alpha, color, fogVisibility(position)), covered); }
    if (fog && adds) { return float4(fadedByFog(color, position), covered); }
    if (fog && multiplies) { return float4(lerp(float3(1), color, fogVisibility(position)), covered); }
    return float4(inFog(color, position), covered);
}

/// The fog at a point: its colour, and how much of it covers a surface there. Without fog, both are zero.
///
/// The passes add fog by themselves: this node is for materials that do more with it.
[node("Input/Scene/Fog")] [also("FogColor", "FogDensity")]
float3 Fog(
    [unit("m")] float3 position = positionWS,  ///< the point, in world space
    out float density                          ///< the share of fog: 0 none, 1 nothing else is seen
) {
    density = 0;
    if (!fog) { return float3(0); }
    density = 1 - fogVisibility(position);
    return fogColor.rgb;
}
