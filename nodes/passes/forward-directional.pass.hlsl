// The base and additive passes for objects that take no light at their vertices and none from spherical harmonics: what
// Unity calls OnlyDirectional.

[pass("directional-base")] [pass("directional-add")] [vertex]
float4 directional_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}

[pass("directional-base")] [fragment] [lights("main-only")] [needs("added")] [fallback("forward")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "src_alpha", "one_minus_src_alpha", "one", "one_minus_src_alpha")]
[blend("transparent", "one", "one_minus_src_alpha")] [blend("additive", "one", "one", "zero", "one")]
[blend("multiply", "dst_color", "zero", "zero", "one")]
float4 directional_base_fragment(float3 position = position_ws) {
    LightingSurface lit = as_lit(lighting_surface());
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    return blended_in_fog(lit_by_all(lit, position), lit.alpha, position);
}

[pass("directional-add")] [fragment] [each("light")] [lights("further")] [needs("added")]
[depth("lessEqual", "keep")]
[blend("opaque", "one", "one", "zero", "one")] [blend("cutout", "one", "one", "zero", "one")]
[blend("fade", "src_alpha", "one", "zero", "one")] [blend("transparent", "one", "one", "zero", "one")]
float4 directional_add_fragment(float3 position = position_ws) {
    LightingSurface lit = as_lit(lighting_surface());
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    float3 color = added_by_light(lit, position);
    return float4(faded_by_fog(color, position), fades ? lit.alpha : 0);
}
