[semantic("pixel")]
float3 first(float3 value = second) {
    return value;
}
[semantic("vertex")]
float3 second(float3 value = first) {
    return value;
}
[semantic("pixel")]
float4 own(float4 value = own) {
    return value;
}

[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mine_fragment(float3 position = first) {
    return float4(lit_by_all(lighting_surface(), position), 1);
}
