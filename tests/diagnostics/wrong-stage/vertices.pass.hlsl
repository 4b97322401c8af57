[semantic("vertex")]
float2 slope(float2 uv = uv0) {
    return ddx(uv);
}

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float2 uv = slope) {
    return float4(uv, 0, 1);
}
