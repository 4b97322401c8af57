// Fog: the engine seam. An engine may replace the [extern] function.

/// What is far fades into fog.
[switch] bool fog;
[extern("Frame")] [with("fog")] float4 fogColor;     // rgb, linear
[extern("Frame")] [with("fog")] float4 fogSettings;  // x: 0 none, 1 linear, 2 exponential, 3 exponential squared; y:
                                                      // density per metre; z, w: where linear fog starts and ends, metres

/// How much of a surface fog leaves to be seen: 1 all of it. Distance counts along the camera's axis.
[extern]
float fogVisibility(float3 position) {
    if (!fog) { return 1; }
    return FogFactor(dot(position - cameraPositionWS, cameraForwardWS), fogSettings);
}

/// A surface's colour in the fog.
[inline]
float3 inFog(float3 color, float3 position) {
    if (!fog) { return color; }
    return lerp(fogColor.rgb, color, fogVisibility(position));
}

/// What is added to a surface's colour that has been put into the fog already.
[inline]
float3 fadedByFog(float3 color, float3 position) {
    if (!fog) { return color; }
    return color * fogVisibility(position);
}

/// A pixel, ready to be blended as its kind of surface is: fog covers as much as the surface does, dims what is only
/// added, and takes away from what the picture is multiplied by. `color`: of a transparent surface, times its coverage.
[inline]
float4 blendedInFog(float3 color, float alpha, float3 position) {
    float covered = 1;
    if (fades || premultiplied) { covered = alpha; }
    if (fog && premultiplied) { return float4(lerp(fogColor.rgb * alpha, color, fogVisibility(position)), covered); }
    if (fog && adds) { return float4(fadedByFog(color, position), covered); }
    if (fog && multiplies) { return float4(lerp(float3(1), color, fogVisibility(position)), covered); }
    return float4(inFog(color, position), covered);
}
