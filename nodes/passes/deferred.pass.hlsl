// Deferred: objects write their surface to a G-buffer, then each light is added to the pixels that it reaches. Every
// lighting graph of the scene lights its own pixels, which the stencil marks. Surfaces that a G-buffer cannot hold use
// the forward path.
// The layout is that of Unity's shaders:
//   RT0  8 bits each    diffuse colour, occlusion
//   RT1  8 bits each    f0, smoothness
//   RT2  10:10:10:2     normal in the world
//   RT3  half float     emission and ambient light; the picture itself
// source: Saito and Takahashi, "Comprehensible Rendering of 3-D Shapes", SIGGRAPH 1990 (the G-buffer)

struct GBuffer {
    [target("gbufferDiffuse", "rgba8")] float4 diffuse;
    [target("gbufferSpecular", "rgba8")] float4 specular;
    [target("gbufferNormal", "rgb10a2")] float4 normal;
    [target("color", "rgba16f")] float4 light;
};

[reads("gbufferDiffuse")] Texture2D gbufferDiffuseTexture;
[reads("gbufferSpecular")] Texture2D gbufferSpecularTexture;
[reads("gbufferNormal")] Texture2D gbufferNormalTexture;

/// The part of `indirect` that reflects the environment, and the rest.
[slot] [part("indirect", "EnvironmentRadiance")]
float3 reflected(LightingSurface surface);
[slot] [without("indirect", "EnvironmentRadiance")]
float3 notReflected(LightingSurface surface);
/// The part of `final` that is linear in sum.indirect.
[slot] [part("final", "sum.indirect")]
float3 addedIndirect(LightingSurface surface, LightSum sum);

[static("pass", "deferred-reflections", "extended-reflections", "shadowmask-reflections")] bool reflectsLater;

/// Emission and ambient light: `final` before any light is added.
[inline]
float3 unlitColor(LightingSurface lit) {
    LightSum start;
    if (reflectsLater) { start.indirect = notReflected(lit); }
    else { start.indirect = indirect(lit); }
    return final(lit, start);
}

[inline]
GBuffer stored(LightingSurface lit, float3 position) {
    GBuffer made;
    made.diffuse = float4(lit.diffuseColor, lit.occlusion);
    made.specular = float4(lit.f0, lit.smoothness);
    made.normal = float4(EncodeGBufferNormal(lit.normalWS), 1);
    made.light = float4(inFog(unlitColor(lit), position), 1);
    return made;
}

[inline]
LightingSurface told(float2 uv) {
    float4 diffuse = gbufferDiffuseTexture.SampleLevel(uv, 0);
    float4 specular = gbufferSpecularTexture.SampleLevel(uv, 0);
    LightingSurface lit;
    lit.diffuseColor = diffuse.rgb;
    lit.occlusion = diffuse.a;
    lit.f0 = specular.rgb;
    lit.roughness = 1 - specular.a;
    lit.normalWS = DecodeGBufferNormal(gbufferNormalTexture.SampleLevel(uv, 0).rgb);
    return lit;
}

[gives("positionWS", "deferred-directional", "deferred-local", "deferred-reflections", "extended-directional",
       "extended-local", "extended-reflections", "ldr-directional", "ldr-local", "shadowmask-directional",
       "shadowmask-local", "shadowmask-reflections")] [fragment]
float3 positionBehind(float2 uv = screenUV) {
    return WorldFromDepth(uv, depthTexture.SampleLevel(uv, 0).r, clipToWorld);
}

[gives("AmbientIrradiance", "gbuffer", "gbuffer-extended", "gbuffer-ldr", "gbuffer-shadowmask")]
[fragment]
float3 ambientOfGbuffer(float3 normal, float3 light = lightOfLightmap) {
    if (lightmap) { return light; }
    return AmbientIrradiance(normal);
}

[pass("deferred-directional")] [pass("deferred-reflections")] [pass("extended-directional")]
[pass("extended-reflections")] [pass("ldr-directional")] [pass("ldr-resolve")] [pass("shadowmask-directional")]
[pass("shadowmask-reflections")] [vertex]
float4 screenVertex(float3 position = positionOS) {
    return float4(position.xy, 0, 1);
}

[pass("gbuffer")] [fragment] [lights("none")] [camera("perspective")] [fallback("forward")]
[excludes("subtractive", "shadowMask")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")] [stencil("always", "replace", "lighting")]
GBuffer gbufferFragment(float3 position = positionWS) {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
    }
    return stored(lit, position);
}

[pass("deferred-directional")] [fragment] [draws("fullscreen")] [each("light")] [lights("directional")]
[needs("added", "direct")] [holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion")] [fallback("forward")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 deferredDirectional(float2 uv = screenUV, float3 position = positionWS) {
    return float4(fadedByFog(addedByLight(told(uv), position), position), 0);
}

// Draws the back faces of a light's volume that lie behind the visible surface. This works with the camera inside, too.
[pass("deferred-local")] [fragment] [draws("light-volumes")] [each("light")] [lights("local")]
[needs("added", "direct")] [holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion")] [fallback("forward")]
[cull("front")] [depth("greaterEqual", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 deferredLocal(float2 uv = screenUV, float3 position = positionWS) {
    return float4(fadedByFog(addedByLight(told(uv), position), position), 0);
}

// Reflections of probes, which belong to objects, are in the G-buffer.
[pass("deferred-reflections")] [fragment] [draws("fullscreen")] [lights("none")] [optional]
[excludes("reflectionProbes")]
[needs("reflected", "addedIndirect")] [holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion")]
[cull("off")] [depth("always", "keep")] [stencil("equal", "keep", "lighting")] [blend("one", "one")]
float4 deferredReflections(float2 uv = screenUV, float3 position = positionWS) {
    LightingSurface lit = told(uv);
    LightSum mirrored;
    mirrored.indirect = reflected(lit);
    return float4(fadedByFog(addedIndirect(lit, mirrored), position), 0);
}
