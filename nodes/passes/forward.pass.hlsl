// Forward: every light in one loop, ambient light once. What the lighting graph computes per light stays in the loop;
// the rest of it is computed once, before.

[pass("forward")] [pass("forward-base")] [pass("forward-add")] [pass("vertex")] [vertex]
float4 forward_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}

[pass("forward")] [fragment] [lights("all")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "src_alpha", "one_minus_src_alpha")] [blend("transparent", "one", "one_minus_src_alpha")]
[blend("additive", "one", "one")] [blend("multiply", "dst_color", "zero")]
float4 forward_fragment(float3 position = position_ws) {
    LightingSurface lit = as_lit(lighting_surface());
    float3 color = lit_by_all(lit, position);
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    return float4(in_fog(color, position), lit.alpha);
}
