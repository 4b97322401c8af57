// The base and additive passes for objects without lights at their vertices and without spherical harmonics: Unity's
// OnlyDirectional.

[pass("directional-base")] [fragment] [lights("main-only")] [needs("added")] [fallback("forward")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "srcAlpha", "oneMinusSrcAlpha", "one", "oneMinusSrcAlpha")]
[blend("transparent", "one", "oneMinusSrcAlpha")] [blend("additive", "one", "one", "zero", "one")]
[blend("multiply", "dstColor", "zero", "zero", "one")]
float4 directionalBaseFragment(float3 position = positionWS) {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
    }
    lit = asLit(lit);
    return blendedInFog(litByAll(lit, position), lit.alpha, position);
}

[pass("directional-add")] [fragment] [each("light")] [lights("further")] [needs("added", "direct")]
[depth("lessEqual", "keep")]
[blend("opaque", "one", "one", "zero", "one")] [blend("cutout", "one", "one", "zero", "one")]
[blend("fade", "srcAlpha", "one", "zero", "one")] [blend("transparent", "one", "one", "zero", "one")]
float4 directionalAddFragment(float3 position = positionWS) {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
    }
    lit = asLit(lit);
    float3 color = addedByLight(lit, position);
    return float4(fadedByFog(color, position), fades ? lit.alpha : 0);
}
