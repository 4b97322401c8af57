// The depth that a light sees, with alpha clipping. The camera is the light's.
// source: Williams, "Casting Curved Shadows on Curved Surfaces", SIGGRAPH 1978; the two biases in the vertex stage as in
// source: Unity's built-in shaders, UnityClipSpaceShadowCasterPos
//
// The slope bias is twice the 3 texels that SampleShadowTent5x5 reaches along each axis. Depths of a plane at two places
// that far apart differ by at most 3 |dz/dx| + 3 |dz/dy|, and the rasteriser uses the larger: no plane shadows itself.

[pass("shadow-caster")] [vertex]
float4 casterVertex(float3 position = positionWS, float3 normal = vertexNormalWS) {
    float3 toLight = viewDirWS(position);
    float w = max(mul(worldToClip, float4(position, 1)).w, 0);  // a spot's texels grow with it
    float3 inside = ShadowNormalBias(position, normal, toLight, shadowNormalBias * w);
    return mul(worldToClip, float4(inside - toLight * shadowBias, 1));
}

[pass("shadow-caster")] [fragment] [each("light")] [lights("shadowed")] [depthTarget("shadowMap")]
[depth("lessEqual", "write")] [depthBias(1, 6)] [blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
void casterFragment() {
    if (alphaClip) {
        LightingSurface lit = lightingSurface();
        discardIf(lit.alpha < lit.alphaClip);
    }
}
