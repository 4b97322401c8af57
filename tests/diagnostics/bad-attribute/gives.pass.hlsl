[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mine_fragment(float3 position = position_ws) {
    return float4(lit_by_all(lighting_surface(), position), 1);
}

[gives("positon_ws", "mine")]
float3 misspelt() {
    return float3(0);
}
[gives("position_ws")]
float3 to_nobody() {
    return float3(0);
}
[gives("time", "mine")]
float no_semantic() {
    return 0;
}
[gives("uv0", "mine")]
float2 first() {
    return float2(0);
}
[gives("uv0", "mine")]
float2 second() {
    return float2(1);
}
