[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment] [needs("aded")]
float4 mine_fragment(float3 position = position_ws) {
    return float4(lit_by_all(lighting_surface(), position), 1);
}

[static("slot", "aded")] bool has_added;
[slot] [part("finl", "sum.direct")]
float3 half_of_it(LightingSurface surface, LightSum sum);
[slot] [unpack("pack_surfaces")]
LightingSurface unpacked(LightingSurface surface, SurfaceExtras extras);
