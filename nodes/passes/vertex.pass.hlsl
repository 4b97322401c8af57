// Vertex lit (Gouraud): the lighting graph runs at the vertices and its light is interpolated. If `direct` is the
// diffuse colour times a factor, plus a rest, both are interpolated separately, and the pixel multiplies the factor by
// its diffuse colour, with the texture. The base colour, which some lighting graphs read, is treated alike.
// source: Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on Computers 1971

/// The part of `direct` that depends on the diffuse colour, for a diffuse colour of 1.
[slot] [part("direct", "surface.diffuseColor", "componentwise")]
[otherwise("a texture of the diffuse colour is sampled only at the vertices")]
float3 directByDiffuse(LightingSurface surface, [perLight] Light light);
[slot] [without("direct", "surface.diffuseColor")]
float3 directWithoutDiffuse(LightingSurface surface, [perLight] Light light);
/// The same for the remaining part and the base colour.
[slot] [part("directWithoutDiffuse", "surface.baseColor", "componentwise")]
[otherwise("a texture of the base colour is sampled only at the vertices")]
float3 directByBase(LightingSurface surface, [perLight] Light light);
[slot] [without("directWithoutDiffuse", "surface.baseColor")]
float3 directWithoutColors(LightingSurface surface, [perLight] Light light);

[slot] [part("indirect", "surface.diffuseColor", "componentwise")]
float3 indirectByDiffuse(LightingSurface surface);
[slot] [without("indirect", "surface.diffuseColor")]
float3 indirectWithoutDiffuse(LightingSurface surface);
[slot] [part("indirectWithoutDiffuse", "surface.baseColor", "componentwise")]
float3 indirectByBase(LightingSurface surface);
[slot] [without("indirectWithoutDiffuse", "surface.baseColor")]
float3 indirectWithoutColors(LightingSurface surface);

[static("slot", "directByDiffuse")] bool splitsDiffuse;
[static("slot", "directByBase")] bool splitsBase;
[static("slot", "indirectByDiffuse")] bool splitsIndirectDiffuse;
[static("slot", "indirectByBase")] bool splitsIndirectBase;

/// A light at a vertex.
Light lightAtVertex(int index, float3 position, float2 uv) {
    Light light = lightAt(index, position);
    if (shadowMask) { light.shadow = maskedShadow(index, position, lightmapShadows(uv)); }
    return light;
}

/// Light that the diffuse or base colour multiplies, for a colour of 1, and all other light. Light that cannot be split
/// counts as other.
struct SplitLight {
    float3 byDiffuse;
    float3 byBase;
    float3 other;
};

[inline]
LightingSurface withDiffuse(LightingSurface surface, float3 color) {
    LightingSurface changed = surface;
    changed.diffuseColor = color;
    return changed;
}
[inline]
LightingSurface withBase(LightingSurface surface, float3 color) {
    LightingSurface changed = surface;
    changed.baseColor = color;
    return changed;
}

/// The light that one light adds.
[inline]
SplitLight splitOfOne(LightingSurface lit, Light light) {
    SplitLight one;
    if (splitsDiffuse) { one.byDiffuse = directByDiffuse(withDiffuse(lit, float3(1)), light); }
    if (splitsBase) {
        one.byBase = directByBase(withBase(lit, float3(1)), light);
        one.other = directWithoutColors(lit, light);
    }
    if (splitsDiffuse && !splitsBase) { one.other = directWithoutDiffuse(lit, light); }
    if (!splitsDiffuse && !splitsBase) { one.other = direct(lit, light); }
    return one;
}

/// Direct light. One loop computes all parts, so that each light is evaluated once. It is computed where it is read:
/// at the vertices.
[semantic("pixel")]
SplitLight splitLight(float3 position = positionWS, float2 uv = uv1) {
    LightingSurface lit = asLit(lightingSurface());
    float3 byDiffuse = float3(0);
    float3 byBase = float3(0);
    float3 other = float3(0);
    [light] for (int i = 0; i < min(lightCount, MAX_LIGHTS); i++) {
        SplitLight one = splitOfOne(lit, lightAtVertex(i, position, uv));
        byDiffuse += one.byDiffuse;
        byBase += one.byBase;
        other += one.other;
    }
    SplitLight sum;
    sum.byDiffuse = byDiffuse;
    sum.byBase = byBase;
    sum.other = other;
    return sum;
}
[semantic("vertex")]
float3 lightByDiffuse(SplitLight sum = splitLight) {
    return sum.byDiffuse;
}
[semantic("vertex")]
float3 lightByBase(SplitLight sum = splitLight) {
    return sum.byBase;
}
[semantic("vertex")]
float3 otherLight(SplitLight sum = splitLight) {
    return sum.other;
}

/// The same for indirect light.
[semantic("vertex")]
float3 indirectLightByDiffuse() {
    if (!splitsIndirectDiffuse) { return float3(0); }
    return indirectByDiffuse(withDiffuse(asLit(lightingSurface()), float3(1)));
}
[semantic("vertex")]
float3 indirectLightByBase() {
    if (!splitsIndirectBase) { return float3(0); }
    return indirectByBase(withBase(asLit(lightingSurface()), float3(1)));
}
[semantic("vertex")]
float3 otherIndirect() {
    LightingSurface lit = asLit(lightingSurface());
    if (splitsIndirectBase) { return indirectWithoutColors(lit); }
    if (splitsIndirectDiffuse) { return indirectWithoutDiffuse(lit); }
    return indirect(lit);
}

/// The direct light at a pixel, of what the vertices have computed.
[inline]
float3 directOfVertices(LightingSurface lit, float3 byDiffuse, float3 byBase, float3 other) {
    float3 sum = other;
    if (splitsDiffuse) { sum += lit.diffuseColor * byDiffuse; }
    if (splitsBase) { sum += lit.baseColor * byBase; }
    return sum;
}

[pass("vertex")] [fragment] [lights("all")] [fallback("forward")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "srcAlpha", "oneMinusSrcAlpha", "one", "oneMinusSrcAlpha")]
[blend("transparent", "one", "oneMinusSrcAlpha")] [blend("additive", "one", "one", "zero", "one")]
[blend("multiply", "dstColor", "zero", "zero", "one")]
float4 vertexFragment(float3 position = positionWS, float3 byDiffuse = lightByDiffuse,
                       float3 byBase = lightByBase, float3 other = otherLight,
                       float3 indirectDiffuse = indirectLightByDiffuse,
                       float3 indirectBase = indirectLightByBase, float3 indirectOther = otherIndirect) {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
    }
    lit = asLit(lit);
    LightSum total;
    total.direct = directOfVertices(lit, byDiffuse, byBase, other);
    total.indirect = indirectOther;
    if (splitsIndirectDiffuse) { total.indirect += lit.diffuseColor * indirectDiffuse; }
    if (splitsIndirectBase) { total.indirect += lit.baseColor * indirectBase; }
    if (lightmap) { total.indirect = indirect(lit); }  // a lightmap is finer than the vertices
    return blendedInFog(final(lit, total), lit.alpha, position);
}
