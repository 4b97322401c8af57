// Backdrop: what is around, as the camera sees it, behind all objects. It reads no material. The runtime draws it
// before everything else, so that surfaces that let light through show it.

/// The surroundings are out of focus.
[switch] bool blurredBackground;

/// What is seen behind everything, as sharp as it is known; one level.
/// unit: linear radiance
/// space: world
[extern] TextureCube backdropMap;

const float BACKGROUND_ROUGHNESS = 0.45;  // the surroundings are blurred as a surface of this roughness reflects them
// All rays of an orthographic camera are parallel, so it would show a single colour. It shows what a perspective camera
// with a vertical field of view of 30 degrees would see: the tangent of half of it.
const float ORTHOGRAPHIC_TANGENT = 0.2679491924;

/// The direction in which the camera looks through a place of the screen.
[inline]
float3 directionBehind(float2 uv) {
    float4 x = mul(worldToClip, float4(1, 0, 0, 0));
    float4 y = mul(worldToClip, float4(0, 1, 0, 0));
    float4 z = mul(worldToClip, float4(0, 0, 1, 0));
    float3 right = float3(x.x, y.x, z.x);
    float3 up = float3(x.y, y.y, z.y);
    float2 scale = float2(length(right), length(up));
    float2 tangents = lerp(1 / scale, ORTHOGRAPHIC_TANGENT * scale.y / scale, viewIsOrthographic);
    float2 at = (uv * 2 - 1) * float2(1, -1) * tangents / scale;
    return normalize(cameraForwardWS + right * at.x + up * at.y);
}

[pass("backdrop")] [vertex]
float4 backgroundVertex(float3 position = positionOS) {
    return float4(position.xy, 0, 1);
}

[pass("backdrop")] [fragment] [draws("fullscreen")] [lights("none")] [cull("off")] [depth("always", "keep")]
[blend("one", "zero")]
float4 backgroundFragment(float2 uv = screenUV) {
    float3 direction = directionBehind(uv);
    if (blurredBackground) { return float4(EnvironmentRadiance(direction, BACKGROUND_ROUGHNESS), 1); }
    return float4(backdropMap.SampleLevel(direction, 0).rgb, 1);
}
