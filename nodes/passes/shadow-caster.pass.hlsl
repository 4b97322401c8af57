// What a light sees: depth, and nothing else but what alpha clipping asks for. The camera is the light's.
// source: Williams, "Casting Curved Shadows on Curved Surfaces", SIGGRAPH 1978; the two biases in the vertex stage as in
// source: Unity's built-in shaders, UnityClipSpaceShadowCasterPos
//
// The slope bias is twice the 3 texels that SampleShadowTent5x5 reaches along each axis: depths of a plane at two places so
// far apart differ by at most 3 |dz/dx| + 3 |dz/dy|, the rasteriser knows the larger of both, and so no plane shadows itself.

[pass("shadow-caster")] [vertex]
float4 caster_vertex(float3 position = position_ws, float3 normal = vertex_normal_ws) {
    float3 to_light = view_dir_ws(position);
    float w = max(mul(world_to_clip, float4(position, 1)).w, 0);  // a spot's texels grow with it
    float3 inside = ShadowNormalBias(position, normal, to_light, shadow_normal_bias * w);
    return mul(world_to_clip, float4(inside - to_light * shadow_bias, 1));
}

[pass("shadow-caster")] [fragment] [each("light")] [lights("shadowed")] [depth_target("shadow_map")]
[depth("lessEqual", "write")] [depth_bias(1, 6)] [blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
void caster_fragment() {
    if (alpha_clip) {
        LightingSurface lit = lighting_surface();
        discard_if(lit.alpha < lit.alphaClip);
    }
}
