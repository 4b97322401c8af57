// Deferred, with room for the members of the surface that a lighting graph reads and Unity's layout lacks: up to twelve
// more numbers. Every lighting graph packs and unpacks its own.

/// Additional numbers of the surface, packed by the lighting graph.
struct SurfaceExtras {
    float4 first;
    float4 second;
    float4 third;
};

[slot] [pack("direct", "added")] [holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion")]
SurfaceExtras packSurface(LightingSurface surface);
[slot] [unpack("packSurface")]
LightingSurface unpackSurface(LightingSurface surface, SurfaceExtras extras);

struct GBufferExtended {
    [target("gbufferDiffuse", "rgba8")] float4 diffuse;
    [target("gbufferSpecular", "rgba8")] float4 specular;
    [target("gbufferNormal", "rgb10a2")] float4 normal;
    [target("color", "rgba16f")] float4 light;
    [target("gbufferExtra1", "rgba16f")] [optional] float4 extra1;
    [target("gbufferExtra2", "rgba16f")] [optional] float4 extra2;
    [target("gbufferExtra3", "rgba16f")] [optional] float4 extra3;
};

[reads("gbufferExtra1")] Texture2D gbufferExtra1Texture;
[reads("gbufferExtra2")] Texture2D gbufferExtra2Texture;
[reads("gbufferExtra3")] Texture2D gbufferExtra3Texture;

[inline]
LightingSurface toldInFull(float2 uv) {
    SurfaceExtras extras;
    extras.first = gbufferExtra1Texture.SampleLevel(uv, 0);
    extras.second = gbufferExtra2Texture.SampleLevel(uv, 0);
    extras.third = gbufferExtra3Texture.SampleLevel(uv, 0);
    return unpackSurface(told(uv), extras);
}

[pass("gbuffer-extended")] [fragment] [lights("none")] [camera("perspective")] [needs("packSurface")]
[excludes("subtractive", "shadowMask")]
[fallback("forward")] [blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[stencil("always", "replace", "lighting")]
GBufferExtended gbufferExtendedFragment(float3 position = positionWS) {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
    }
    GBuffer plain = stored(lit, position);
    SurfaceExtras extras = packSurface(lit);
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
[needs("added", "direct", "packSurface")] [fallback("forward")]
[holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion", "packSurface")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 extendedDirectional(float2 uv = screenUV, float3 position = positionWS) {
    return float4(fadedByFog(addedByLight(toldInFull(uv), position), position), 0);
}

[pass("extended-local")] [fragment] [draws("light-volumes")] [each("light")] [lights("local")]
[needs("added", "direct", "packSurface")] [fallback("forward")]
[holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion", "packSurface")]
[cull("front")] [depth("greaterEqual", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 extendedLocal(float2 uv = screenUV, float3 position = positionWS) {
    return float4(fadedByFog(addedByLight(toldInFull(uv), position), position), 0);
}

[pass("extended-reflections")] [fragment] [draws("fullscreen")] [lights("none")] [optional]
[excludes("reflectionProbes")]
[needs("reflected", "addedIndirect", "packSurface")]
[holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion", "packSurface")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 extendedReflections(float2 uv = screenUV, float3 position = positionWS) {
    LightingSurface lit = toldInFull(uv);
    LightSum mirrored;
    mirrored.indirect = reflected(lit);
    return float4(fadedByFog(addedIndirect(lit, mirrored), position), 0);
}
