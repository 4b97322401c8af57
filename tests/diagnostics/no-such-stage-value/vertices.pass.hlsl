[semantic("vertex")]
float2 pixel(float4 at = frag_coord) {
    return at.xy;
}

[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mine_fragment(float2 at = pixel) {
    return float4(at, 0, 1);
}
