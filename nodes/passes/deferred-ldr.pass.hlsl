// Deferred for a picture without high dynamic range: RT3 holds 2^-light in 10:10:10:2, which lights multiply, and a last
// pass turns it into the picture, up to a light of 11 (DecodeLightLdr). Reflections are part of the G-buffer's light.

struct GBufferLdr {
    [target("gbuffer_diffuse", "rgba8")] float4 diffuse;
    [target("gbuffer_specular", "rgba8")] float4 specular;
    [target("gbuffer_normal", "rgb10a2")] float4 normal;
    [target("gbuffer_light", "rgb10a2")] float4 light;
};

[reads("gbuffer_light")] Texture2D gbuffer_light_texture;

[pass("gbuffer-ldr")] [fragment] [lights("none")] [camera("perspective")] [fallback("forward")]
[excludes("subtractive", "shadow_mask")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")] [stencil("always", "replace", "lighting")]
GBufferLdr gbuffer_ldr_fragment(float3 position = position_ws) {
    LightingSurface lit = lighting_surface();
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    GBuffer plain = stored(lit, position);
    GBufferLdr made;
    made.diffuse = plain.diffuse;
    made.specular = plain.specular;
    made.normal = plain.normal;
    made.light = float4(EncodeLightLdr(plain.light.rgb), 1);
    return made;
}

[pass("ldr-directional")] [fragment] [draws("fullscreen")] [each("light")] [lights("directional")]
[needs("added")] [holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion")] [fallback("forward")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("dst_color", "zero")]
[target("gbuffer_light", "rgb10a2")]
float4 ldr_directional(float2 uv = screen_uv, float3 position = position_ws) {
    return float4(EncodeLightLdr(faded_by_fog(added_by_light(told(uv), position), position)), 1);
}

[pass("ldr-local")] [fragment] [draws("light-volumes")] [each("light")] [lights("local")]
[needs("added")] [holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion")] [fallback("forward")]
[cull("front")] [depth("greaterEqual", "keep")] [stencil("equal", "keep", "lighting")] [blend("dst_color", "zero")]
[target("gbuffer_light", "rgb10a2")]
float4 ldr_local(float2 uv = screen_uv, float3 position = position_ws) {
    return float4(EncodeLightLdr(faded_by_fog(added_by_light(told(uv), position), position)), 1);
}

[pass("ldr-resolve")] [fragment] [draws("fullscreen")] [lights("none")] [cull("off")] [depth("always", "keep")]
[stencil("equal", "keep", "lighting")] [blend("one", "zero")]
float4 ldr_resolve(float2 uv = screen_uv) {
    return float4(DecodeLightLdr(gbuffer_light_texture.SampleLevel(uv, 0).rgb), 1);
}
