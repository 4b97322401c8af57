// Members that nothing has, and that are near to what is there.
[slot] [part("final", "sum.dirct")]
float3 added_twice(LightingSurface surface, LightSum sum);
[slot] [part("final", "total.direct")]
float3 added_thrice(LightingSurface surface, LightSum sum);
[slot] [part("indirect", "EnvironmentRadiants")]
float3 mirrored(LightingSurface surface);

[pass("members")] [vertex]
float4 members_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("members")] [fragment] [lights("none")]
float4 members_fragment() {
    return float4(lighting_surface().diffuseColor, 1);
}
