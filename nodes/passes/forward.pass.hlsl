// Forward: every light in one loop, ambient light once. What the lighting graph computes per light stays in the loop;
// the rest of it is computed once, before.

[pass("forward")] [vertex]
float4 forward_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}

[pass("forward")] [fragment]
float4 forward_fragment(float3 position = position_ws) {
    LightingSurface lit = lighting_surface();
    float3 direct_sum = float3(0);
    [light] for (int i = 0; i < min(light_count, MAX_LIGHTS); i++) {
        direct_sum += direct(lit, light_at(i, position));
    }
    LightSum total;
    total.direct = direct_sum;
    total.indirect = indirect(lit);
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    return float4(final(lit, total), lit.alpha);
}
