// Members of the lighting surface: "ink" may be another lighting model's, "roughnes" is nobody's. A part that no pass
// goes without has to be there.
[slot] [part("direct", "surface.difuseColor")]
float3 by_diffuse(LightingSurface surface, [per_light] Light light);
[slot] [part("direct", "surface.thickness_of_the_rind")]
float3 by_rind(LightingSurface surface, [per_light] Light light);
[slot] [part("direct", "surface.warmth_of_the_core")]
float3 by_core(LightingSurface surface, [per_light] Light light);
[static("slot", "by_core")] bool has_core;

[pass("surface-members")] [vertex]
float4 members_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("surface-members")] [fragment] [lights("none")] [holds("f0", "roughnes", "thickness_of_the_rind", "pack_surface")]
float4 members_fragment() {
    return float4(lighting_surface().diffuseColor, 1);
}
