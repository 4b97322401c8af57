// Deferred without high dynamic range: RT3 holds 2^-light in 10:10:10:2, each light multiplies it, and a last pass
// converts it to the picture, up to a light of 11 (DecodeLightLdr). The G-buffer's light includes reflections.

struct GBufferLdr {
    [target("gbufferDiffuse", "rgba8")] float4 diffuse;
    [target("gbufferSpecular", "rgba8")] float4 specular;
    [target("gbufferNormal", "rgb10a2")] float4 normal;
    [target("gbufferLight", "rgb10a2")] float4 light;
};

[reads("gbufferLight")] Texture2D gbufferLightTexture;

[pass("gbuffer-ldr")] [fragment] [lights("none")] [camera("perspective")] [fallback("forward")]
[excludes("subtractive", "shadowMask")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")] [stencil("always", "replace", "lighting")]
GBufferLdr gbufferLdrFragment(float3 position = positionWS) {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
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
[needs("added", "direct")] [holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion")] [fallback("forward")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("dstColor", "zero")]
[target("gbufferLight", "rgb10a2")]
float4 ldrDirectional(float2 uv = screenUV, float3 position = positionWS) {
    return float4(EncodeLightLdr(fadedByFog(addedByLight(told(uv), position), position)), 1);
}

[pass("ldr-local")] [fragment] [draws("light-volumes")] [each("light")] [lights("local")]
[needs("added", "direct")] [holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion")] [fallback("forward")]
[cull("front")] [depth("greaterEqual", "keep")] [stencil("equal", "keep", "lighting")] [blend("dstColor", "zero")]
[target("gbufferLight", "rgb10a2")]
float4 ldrLocal(float2 uv = screenUV, float3 position = positionWS) {
    return float4(EncodeLightLdr(fadedByFog(addedByLight(told(uv), position), position)), 1);
}

[pass("ldr-resolve")] [fragment] [draws("fullscreen")] [lights("none")] [cull("off")] [depth("always", "keep")]
[stencil("equal", "keep", "lighting")] [blend("one", "zero")]
float4 ldrResolve(float2 uv = screenUV) {
    return float4(DecodeLightLdr(gbufferLightTexture.SampleLevel(uv, 0).rgb), 1);
}
