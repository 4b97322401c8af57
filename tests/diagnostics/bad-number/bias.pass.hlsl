[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment] [depth_bias(1e39, -1.5)]
float4 mine_fragment(float3 position = position_ws) {
    return float4(lit_by_all(lighting_surface(), position), 1);
}
