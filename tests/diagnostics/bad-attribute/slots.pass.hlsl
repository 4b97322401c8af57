struct Thin {
    float2 first;
};

[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mine_fragment(float3 position = position_ws) {
    return float4(lit_by_all(lighting_surface(), position), 1);
}

[slot]
float3 filled_by_nobody(LightingSurface surface);
[slot] [part("final")]
float3 of_what(LightingSurface surface, LightSum sum);
[slot] [part("final", "sum.direct")]
float3 unlike_final(LightingSurface surface);
[slot] [pack("direct")] [holds("f0")]
Thin packed(LightingSurface surface);
[slot] [pack]
SurfaceExtras packed_of_nothing(LightingSurface surface);
[slot] [unpack("direct")]
LightingSurface unpacked(LightingSurface surface, SurfaceExtras extras);
[slot] [unpack("pack_surface")]
LightingSurface unpacked_of_nothing(LightingSurface surface);
