[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mine_fragment(float3 position = position_ws) {
    return float4(1;
}
