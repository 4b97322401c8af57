// Deferred: objects leave their surface in a G-buffer, then each light is added to the pixels that it reaches. Every
// lighting graph of the scene lights its own pixels, which the stencil knows. Surfaces that a G-buffer cannot hold go
// the forward path.
// The layout is Unity's, as its shaders have it:
//   RT0  8 bits each    diffuse colour, occlusion
//   RT1  8 bits each    f0, smoothness
//   RT2  10:10:10:2     normal in the world
//   RT3  half float     emission and ambient light; the picture itself
// source: Saito and Takahashi, "Comprehensible Rendering of 3-D Shapes", SIGGRAPH 1990 (the G-buffer)

struct GBuffer {
    [target("gbuffer_diffuse", "rgba8")] float4 diffuse;
    [target("gbuffer_specular", "rgba8")] float4 specular;
    [target("gbuffer_normal", "rgb10a2")] float4 normal;
    [target("color", "rgba16f")] float4 light;
};

[reads("gbuffer_diffuse")] Texture2D gbuffer_diffuse_texture;
[reads("gbuffer_specular")] Texture2D gbuffer_specular_texture;
[reads("gbuffer_normal")] Texture2D gbuffer_normal_texture;

/// The part of `indirect` that mirrors the surroundings, and the rest.
[slot] [part("indirect", "EnvironmentRadiance")]
float3 reflected(LightingSurface surface);
[slot] [without("indirect", "EnvironmentRadiance")]
float3 not_reflected(LightingSurface surface);
/// The part of `final` that is linear in sum.indirect.
[slot] [part("final", "sum.indirect")]
float3 added_indirect(LightingSurface surface, LightSum sum);

[static("pass", "deferred-reflections", "extended-reflections", "shadowmask-reflections")] bool reflects_later;

/// Emission and ambient light: `final`, before there is any light.
[inline]
float3 unlit_color(LightingSurface lit) {
    LightSum start;
    if (reflects_later) { start.indirect = not_reflected(lit); }
    else { start.indirect = indirect(lit); }
    return final(lit, start);
}

[inline]
GBuffer stored(LightingSurface lit, float3 position) {
    GBuffer made;
    made.diffuse = float4(lit.diffuseColor, lit.occlusion);
    made.specular = float4(lit.f0, lit.smoothness);
    made.normal = float4(EncodeGBufferNormal(lit.normal_ws), 1);
    made.light = float4(in_fog(unlit_color(lit), position), 1);
    return made;
}

[inline]
LightingSurface told(float2 uv) {
    float4 diffuse = gbuffer_diffuse_texture.SampleLevel(uv, 0);
    float4 specular = gbuffer_specular_texture.SampleLevel(uv, 0);
    LightingSurface lit;
    lit.diffuseColor = diffuse.rgb;
    lit.occlusion = diffuse.a;
    lit.f0 = specular.rgb;
    lit.roughness = 1 - specular.a;
    lit.normal_ws = DecodeGBufferNormal(gbuffer_normal_texture.SampleLevel(uv, 0).rgb);
    return lit;
}

[gives("position_ws", "deferred-directional", "deferred-local", "deferred-reflections", "extended-directional",
       "extended-local", "extended-reflections", "ldr-directional", "ldr-local", "shadowmask-directional",
       "shadowmask-local", "shadowmask-reflections")]
float3 position_behind(float2 uv = screen_uv) {
    return WorldFromDepth(uv, depth_texture.SampleLevel(uv, 0).r, clip_to_world);
}

[gives("AmbientIrradiance", "gbuffer", "gbuffer-extended", "gbuffer-ldr", "gbuffer-shadowmask")]
float3 ambient_of_gbuffer(float3 normal, float3 light = light_of_lightmap) {
    if (lightmap) { return light; }
    return AmbientIrradiance(normal);
}

[pass("gbuffer")] [pass("gbuffer-extended")] [pass("gbuffer-ldr")] [pass("gbuffer-shadowmask")] [vertex]
float4 gbuffer_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}

[pass("deferred-directional")] [pass("deferred-reflections")] [pass("extended-directional")]
[pass("extended-reflections")] [pass("ldr-directional")] [pass("ldr-resolve")] [pass("shadowmask-directional")]
[pass("shadowmask-reflections")] [vertex]
float4 screen_vertex(float3 position = position_os) {
    return float4(position.xy, 0, 1);
}

[pass("deferred-local")] [pass("extended-local")] [pass("ldr-local")] [pass("shadowmask-local")] [vertex]
float4 volume_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}

[pass("gbuffer")] [fragment] [lights("none")] [camera("perspective")] [fallback("forward")]
[excludes("subtractive", "shadow_mask")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")] [stencil("always", "replace", "lighting")]
GBuffer gbuffer_fragment(float3 position = position_ws) {
    LightingSurface lit = lighting_surface();
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    return stored(lit, position);
}

[pass("deferred-directional")] [fragment] [draws("fullscreen")] [each("light")] [lights("directional")]
[needs("added")] [holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion")] [fallback("forward")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 deferred_directional(float2 uv = screen_uv, float3 position = position_ws) {
    return float4(faded_by_fog(added_by_light(told(uv), position), position), 0);
}

// The back of a light's volume, where it is behind what is seen: the light may reach it, also with the camera inside.
[pass("deferred-local")] [fragment] [draws("light-volumes")] [each("light")] [lights("local")]
[needs("added")] [holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion")] [fallback("forward")]
[cull("front")] [depth("greaterEqual", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 deferred_local(float2 uv = screen_uv, float3 position = position_ws) {
    return float4(faded_by_fog(added_by_light(told(uv), position), position), 0);
}

[pass("deferred-reflections")] [fragment] [draws("fullscreen")] [lights("none")] [optional]
[needs("reflected", "added_indirect")] [holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 deferred_reflections(float2 uv = screen_uv, float3 position = position_ws) {
    LightingSurface lit = told(uv);
    LightSum mirrored;
    mirrored.indirect = reflected(lit);
    return float4(faded_by_fog(added_indirect(lit, mirrored), position), 0);
}
