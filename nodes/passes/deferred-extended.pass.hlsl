// Deferred, with room for what a lighting graph reads beyond Unity's layout: up to twelve numbers more, of whatever
// members of the surface they are. Every lighting graph packs and unpacks its own.

/// Numbers that have no place of their own.
struct SurfaceExtras {
    float4 first;
    float4 second;
    float4 third;
};

[slot] [pack("direct", "added")] [holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion")]
SurfaceExtras pack_surface(LightingSurface surface);
[slot] [unpack("pack_surface")]
LightingSurface unpack_surface(LightingSurface surface, SurfaceExtras extras);

struct GBufferExtended {
    [target("gbuffer_diffuse", "rgba8")] float4 diffuse;
    [target("gbuffer_specular", "rgba8")] float4 specular;
    [target("gbuffer_normal", "rgb10a2")] float4 normal;
    [target("color", "rgba16f")] float4 light;
    [target("gbuffer_extra1", "rgba16f")] float4 extra1;
    [target("gbuffer_extra2", "rgba16f")] float4 extra2;
    [target("gbuffer_extra3", "rgba16f")] float4 extra3;
};

[reads("gbuffer_extra1")] Texture2D gbuffer_extra1_texture;
[reads("gbuffer_extra2")] Texture2D gbuffer_extra2_texture;
[reads("gbuffer_extra3")] Texture2D gbuffer_extra3_texture;

[inline]
LightingSurface told_in_full(float2 uv) {
    SurfaceExtras extras;
    extras.first = gbuffer_extra1_texture.SampleLevel(uv, 0);
    extras.second = gbuffer_extra2_texture.SampleLevel(uv, 0);
    extras.third = gbuffer_extra3_texture.SampleLevel(uv, 0);
    return unpack_surface(told(uv), extras);
}

[pass("gbuffer-extended")] [fragment] [lights("none")] [camera("perspective")] [needs("pack_surface")]
[excludes("subtractive", "shadow_mask")]
[fallback("forward")] [blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[stencil("always", "replace", "lighting")]
GBufferExtended gbuffer_extended_fragment(float3 position = position_ws) {
    LightingSurface lit = lighting_surface();
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    GBuffer plain = stored(lit, position);
    SurfaceExtras extras = pack_surface(lit);
    GBufferExtended made;
    made.diffuse = plain.diffuse;
    made.specular = plain.specular;
    made.normal = plain.normal;
    made.light = plain.light;
    made.extra1 = extras.first;
    made.extra2 = extras.second;
    made.extra3 = extras.third;
    return made;
}

[pass("extended-directional")] [fragment] [draws("fullscreen")] [each("light")] [lights("directional")]
[needs("added", "pack_surface")] [fallback("forward")]
[holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion", "pack_surface")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 extended_directional(float2 uv = screen_uv, float3 position = position_ws) {
    return float4(faded_by_fog(added_by_light(told_in_full(uv), position), position), 0);
}

[pass("extended-local")] [fragment] [draws("light-volumes")] [each("light")] [lights("local")]
[needs("added", "pack_surface")] [fallback("forward")]
[holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion", "pack_surface")]
[cull("front")] [depth("greaterEqual", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 extended_local(float2 uv = screen_uv, float3 position = position_ws) {
    return float4(faded_by_fog(added_by_light(told_in_full(uv), position), position), 0);
}

[pass("extended-reflections")] [fragment] [draws("fullscreen")] [lights("none")] [optional]
[needs("reflected", "added_indirect", "pack_surface")]
[holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion", "pack_surface")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 extended_reflections(float2 uv = screen_uv, float3 position = position_ws) {
    LightingSurface lit = told_in_full(uv);
    LightSum mirrored;
    mirrored.indirect = reflected(lit);
    return float4(faded_by_fog(added_indirect(lit, mirrored), position), 0);
}
