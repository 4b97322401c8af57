[semantic("vertex")]
float2 slope(float2 uv = uv0) {
    return ddx(uv);
}

[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mine_fragment(float2 uv = slope) {
    return float4(uv, 0, 1);
}
