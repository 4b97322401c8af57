// Forward: every light in one loop, ambient light once. The loop holds only the computations that depend on the light;
// the others are done once, before the loop.

/// The vertex in world space, with the 1 that objectToWorld keeps in w.
[semantic("vertex")]
float4 wholePositionWS(float3 position = positionOS) {
    return mul(objectToWorld, float4(position, 1));
}

// The vertex of every pass that draws meshes for the camera. There is one expression for the place on the screen, so that
// a pass that tests for equal depth finds what another pass has written.
[pass("forward")] [pass("forward-base")] [pass("forward-add")] [pass("directional-base")] [pass("directional-add")]
[pass("vertex")] [pass("depth-only")] [pass("depth-normals")] [pass("gbuffer")] [pass("gbuffer-extended")]
[pass("gbuffer-ldr")] [pass("gbuffer-shadowmask")] [pass("deferred-local")] [pass("extended-local")]
[pass("ldr-local")] [pass("shadowmask-local")] [vertex]
float4 meshVertex(float4 position = wholePositionWS) {
    return mul(worldToClip, position);
}

/// Index of the drawn instance. It selects the properties and matrices of the instance (compiler/lower/instances.h).
[builtin("instanceIndex")] int instanceIndex;
/// Index of the vertex that the vertex stage computes.
[builtin("vertexIndex")] int vertexIndex;

/// The baked light of this point: light of the lightmap, the remaining share of the main light, and shadows.
[semantic("pixel")]
float3 lightOfLightmap(float2 uv = uv1) {
    return lightmapLight(uv);
}
[semantic("pixel")]
float mainLightOfLightmap(float3 position = positionWS) {
    return mainLightLeft(position);
}
[semantic("pixel")]
float4 shadowsOfLightmap(float2 uv = uv1) {
    return lightmapShadows(uv);
}

[gives("AmbientIrradiance", "forward", "directional-base", "vertex")] [fragment]
float3 ambientOrBaked(float3 normal, float3 light = lightOfLightmap, float left = mainLightOfLightmap) {
    if (lightmap) { return bakedLight(normal, light, left); }
    return AmbientIrradiance(normal);
}

[gives("EnvironmentRadiance", "forward", "forward-base", "directional-base", "vertex", "gbuffer", "gbuffer-extended",
       "gbuffer-ldr", "gbuffer-shadowmask")]
float3 radianceNearby(float3 direction, float roughness, float3 position = positionWS) {
    if (reflectionProbes) { return radianceOfProbes(direction, roughness, position); }
    return EnvironmentRadiance(direction, roughness);
}

[gives("shadow", "forward", "forward-base", "forward-add", "directional-base", "directional-add")]
[fragment]
float shadowWithMask(int index, float3 position, float4 mask = shadowsOfLightmap) {
    if (shadowMask) { return maskedShadow(index, position, mask); }
    return shadow(index, position);
}

[pass("forward")] [fragment] [lights("all")] [extra]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "srcAlpha", "oneMinusSrcAlpha", "one", "oneMinusSrcAlpha")]
[blend("transparent", "one", "oneMinusSrcAlpha")] [blend("additive", "one", "one", "zero", "one")]
[blend("multiply", "dstColor", "zero", "zero", "one")]
float4 forwardFragment(float3 position = positionWS) {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
    }
    lit = asLit(lit);
    return blendedInFog(litByAll(lit, position), lit.alpha, position);
}
