[semantic("vertex")]
float2 pixel(float4 at = fragCoord) {
    return at.xy;
}

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float2 at = pixel) {
    return float4(at, 0, 1);
}
