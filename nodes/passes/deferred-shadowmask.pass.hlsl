// Deferred, with a fifth target for baked shadows: each channel of RT4 holds those of one light, 1 lit and 0 in shadow.
// Objects without a shadow mask are lit in all of them.
// source: Unity's built-in shaders, UnityStandardCore (RT4, SV_Target4)

struct GBufferShadowmask {
    [target("gbuffer_diffuse", "rgba8")] float4 diffuse;
    [target("gbuffer_specular", "rgba8")] float4 specular;
    [target("gbuffer_normal", "rgb10a2")] float4 normal;
    [target("color", "rgba16f")] float4 light;
    [target("gbuffer_shadowmask", "rgba8")] float4 shadows;
};

[reads("gbuffer_shadowmask")] [with("deferred-shadowmask")] Texture2D gbuffer_shadowmask_texture;

[gives("shadow", "shadowmask-directional", "shadowmask-local")]
float shadow_with_gbuffer(int index, float3 position, float2 uv = screen_uv) {
    return masked_shadow(index, position, gbuffer_shadowmask_texture.SampleLevel(uv, 0));
}

[pass("gbuffer-shadowmask")] [fragment] [lights("none")] [camera("perspective")] [fallback("forward")]
[excludes("subtractive")] [blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[stencil("always", "replace", "lighting")]
GBufferShadowmask gbuffer_shadowmask_fragment(float3 position = position_ws, float4 shadows = shadows_of_lightmap) {
    LightingSurface lit = lighting_surface();
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    GBuffer plain = stored(lit, position);
    GBufferShadowmask made;
    made.diffuse = plain.diffuse;
    made.specular = plain.specular;
    made.normal = plain.normal;
    made.light = plain.light;
    made.shadows = shadows;
    return made;
}

[pass("shadowmask-directional")] [fragment] [draws("fullscreen")] [each("light")] [lights("directional")]
[needs("added")] [holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion")] [fallback("forward")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 shadowmask_directional(float2 uv = screen_uv, float3 position = position_ws) {
    return float4(faded_by_fog(added_by_light(told(uv), position), position), 0);
}

[pass("shadowmask-local")] [fragment] [draws("light-volumes")] [each("light")] [lights("local")]
[needs("added")] [holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion")] [fallback("forward")]
[cull("front")] [depth("greaterEqual", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 shadowmask_local(float2 uv = screen_uv, float3 position = position_ws) {
    return float4(faded_by_fog(added_by_light(told(uv), position), position), 0);
}

[pass("shadowmask-reflections")] [fragment] [draws("fullscreen")] [lights("none")] [optional]
[needs("reflected", "added_indirect")] [holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 shadowmask_reflections(float2 uv = screen_uv, float3 position = position_ws) {
    LightingSurface lit = told(uv);
    LightSum mirrored;
    mirrored.indirect = reflected(lit);
    return float4(faded_by_fog(added_indirect(lit, mirrored), position), 0);
}
