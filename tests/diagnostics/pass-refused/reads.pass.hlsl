// Reads a target that nobody draws, and a value of an object where the screen is drawn.
[pass("reads-objects")] [vertex]
float4 objectsVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("reads-objects")] [fragment] [lights("none")]
float4 objectsFragment(float2 uv = screenUV) {
    return gbufferDiffuseTexture.SampleLevel(uv, 0);
}

[pass("reads-screen")] [vertex]
float4 screenCorner(float3 position = positionOS) {
    return float4(position.xy, 0, 1);
}
[pass("reads-screen")] [fragment] [draws("fullscreen")] [lights("none")] [depth("always", "keep")]
float4 screenFragment(float2 uv = screenUV, float3 center = objectPositionWS) {
    return float4(center, 1) * colorTexture.SampleLevel(uv, 0);
}
