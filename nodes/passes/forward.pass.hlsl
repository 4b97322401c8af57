// Forward: every light in one loop, ambient light once. What the lighting graph computes per light stays in the loop;
// the rest of it is computed once, before.

[pass("forward")] [pass("forward-base")] [pass("forward-add")] [pass("vertex")] [vertex]
float4 forward_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}

/// Which instance of an object is drawn. Properties and matrices of instances are read by it (compiler/lower/instances.h).
[builtin("instance_index")] int instance_index;

/// What is baked for this point: light of the lightmap, what is left of the main light in it, and shadows.
[semantic("pixel")]
float3 light_of_lightmap(float2 uv = uv1) {
    return lightmap_light(uv);
}
[semantic("pixel")]
float main_light_of_lightmap(float3 position = position_ws) {
    return main_light_left(position);
}
[semantic("pixel")]
float4 shadows_of_lightmap(float2 uv = uv1) {
    return lightmap_shadows(uv);
}

[gives("AmbientIrradiance", "forward", "directional-base", "vertex")]
float3 ambient_or_baked(float3 normal, float3 light = light_of_lightmap, float left = main_light_of_lightmap) {
    if (lightmap) { return baked_light(normal, light, left); }
    return AmbientIrradiance(normal);
}

[gives("shadow", "forward", "forward-base", "forward-add", "directional-base", "directional-add")]
float shadow_with_mask(int index, float3 position, float4 mask = shadows_of_lightmap) {
    if (shadow_mask) { return masked_shadow(index, position, mask); }
    return shadow(index, position);
}

[pass("forward")] [fragment] [lights("all")] [extra]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "src_alpha", "one_minus_src_alpha", "one", "one_minus_src_alpha")]
[blend("transparent", "one", "one_minus_src_alpha")] [blend("additive", "one", "one", "zero", "one")]
[blend("multiply", "dst_color", "zero", "zero", "one")]
float4 forward_fragment(float3 position = position_ws) {
    LightingSurface lit = as_lit(lighting_surface());
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    return blended_in_fog(lit_by_all(lit, position), lit.alpha, position);
}
