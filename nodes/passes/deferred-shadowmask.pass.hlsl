// Deferred, with a fifth render target for baked shadows: each channel of RT4 holds the shadow of one light, 1 lit and
// 0 in shadow. Objects without a shadow mask are lit in all channels.
// source: Unity's built-in shaders, UnityStandardCore (RT4, SV_Target4)

struct GBufferShadowmask {
    [target("gbufferDiffuse", "rgba8")] float4 diffuse;
    [target("gbufferSpecular", "rgba8")] float4 specular;
    [target("gbufferNormal", "rgb10a2")] float4 normal;
    [target("color", "rgba16f")] float4 light;
    [target("gbufferShadowMask", "rgba8")] float4 shadows;
};

[reads("gbufferShadowMask")] [with("deferred-shadowmask")] Texture2D gbufferShadowMaskTexture;

[gives("shadow", "shadowmask-directional", "shadowmask-local")] [fragment]
float shadowWithGbuffer(int index, float3 position, float2 uv = screenUV) {
    return maskedShadow(index, position, gbufferShadowMaskTexture.SampleLevel(uv, 0));
}

[pass("gbuffer-shadowmask")] [fragment] [lights("none")] [camera("perspective")] [fallback("forward")]
[excludes("subtractive")] [blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[stencil("always", "replace", "lighting")]
GBufferShadowmask gbufferShadowMaskFragment(float3 position = positionWS, float4 shadows = shadowsOfLightmap) {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
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
[needs("added", "direct")] [holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion")] [fallback("forward")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 shadowMaskDirectional(float2 uv = screenUV, float3 position = positionWS) {
    return float4(fadedByFog(addedByLight(told(uv), position), position), 0);
}

[pass("shadowmask-local")] [fragment] [draws("light-volumes")] [each("light")] [lights("local")]
[needs("added", "direct")] [holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion")] [fallback("forward")]
[cull("front")] [depth("greaterEqual", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 shadowMaskLocal(float2 uv = screenUV, float3 position = positionWS) {
    return float4(fadedByFog(addedByLight(told(uv), position), position), 0);
}

[pass("shadowmask-reflections")] [fragment] [draws("fullscreen")] [lights("none")] [optional]
[excludes("reflectionProbes")]
[needs("reflected", "addedIndirect")] [holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 shadowMaskReflections(float2 uv = screenUV, float3 position = positionWS) {
    LightingSurface lit = told(uv);
    LightSum mirrored;
    mirrored.indirect = reflected(lit);
    return float4(fadedByFog(addedIndirect(lit, mirrored), position), 0);
}
