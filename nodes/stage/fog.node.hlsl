// Fog: the engine seam. An engine may replace the [extern] function.

/// What is far fades into fog.
[switch] bool fog;
[extern("Frame")] [with("fog")] float4 fog_color;     // rgb, linear
[extern("Frame")] [with("fog")] float4 fog_settings;  // x: 0 none, 1 linear, 2 exponential, 3 exponential squared; y:
                                                      // density per metre; z, w: where linear fog starts and ends, metres

/// How much of a surface fog leaves to be seen: 1 all of it. Distance counts along the camera's axis.
[extern]
float fog_visibility(float3 position) {
    if (!fog) { return 1; }
    return FogFactor(dot(position - camera_position_ws, camera_forward_ws), fog_settings);
}

/// A surface's colour in the fog.
[inline]
float3 in_fog(float3 color, float3 position) {
    if (!fog) { return color; }
    return lerp(fog_color.rgb, color, fog_visibility(position));
}

/// What is added to a surface's colour that has been put into the fog already.
[inline]
float3 faded_by_fog(float3 color, float3 position) {
    if (!fog) { return color; }
    return color * fog_visibility(position);
}

/// A pixel, ready to be blended as its kind of surface is: fog covers as much as the surface does, dims what is only
/// added, and takes away from what the picture is multiplied by. `color`: of a transparent surface, times its coverage.
[inline]
float4 blended_in_fog(float3 color, float alpha, float3 position) {
    float covered = 1;
    if (fades || premultiplied) { covered = alpha; }
    if (fog && premultiplied) { return float4(lerp(fog_color.rgb * alpha, color, fog_visibility(position)), covered); }
    if (fog && adds) { return float4(faded_by_fog(color, position), covered); }
    if (fog && multiplies) { return float4(lerp(float3(1), color, fog_visibility(position)), covered); }
    return float4(in_fog(color, position), covered);
}
