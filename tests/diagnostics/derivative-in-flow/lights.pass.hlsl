[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mine_fragment(float3 position = position_ws) {
    float3 sum = float3(0);
    [light] for (int i = 0; i < min(light_count, MAX_LIGHTS); i++) {
        sum += ddx(light_at(i, position).radiance);
    }
    return float4(sum, 1);
}
