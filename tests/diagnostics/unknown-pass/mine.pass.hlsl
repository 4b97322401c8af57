[switch("shadow-castr")] bool casts;
[static("pass", "gbufer")] bool has_surfaces;

[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mine_fragment(float3 position = position_ws) {
    return float4(lit_by_all(lighting_surface(), position), 1);
}

[gives("position_ws", "mien")]
float3 origin() {
    return float3(0);
}
