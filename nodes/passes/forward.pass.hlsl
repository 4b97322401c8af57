// Forward: every light in one loop, ambient light once. The loop holds only the computations that depend on the light;
// the others are done once, before the loop.

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
