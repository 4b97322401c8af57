// A forward path that shades what a G-buffer would remember of a surface: every member is rounded to the bits of Unity's
// layout and decoded again. A user's pass file as any other; deferred is held to it.

/// A number a thousandth of a step beside the border between two steps may go to either: all go up, or all down.
[switch] bool upwards;
[switch] bool downwards;
/// What mirrors the surroundings is part of the ambient light.
[switch] bool mirrorsAtOnce;
/// The device makes 16 bits of a number first, and leaves the last six of them out.
[switch] bool cutsToTenBits;

/// Steps that a number is moved by.
float nudge() {
    if (upwards) { return 0.001; }
    if (downwards) { return -0.001; }
    return 0;
}

/// The nearest of so many equal steps from 0 to 1: what a target of unsigned numbers holds.
float3 stepped(float3 value, float steps) {
    return saturate(round(saturate(value) * steps + nudge()) / steps);
}
float3 inBytes(float3 value) {
    return stepped(value, 255);
}

float3 inTenBits(float3 value) {
    if (cutsToTenBits) {
        return saturate(floor(round(saturate(value) * 65535 + 64 * nudge()) / 64) / 1023);
    }
    return stepped(value, 1023);
}

LightingSurface remembered(LightingSurface lit) {
    LightingSurface kept;
    kept.diffuseColor = inBytes(lit.diffuseColor);
    kept.occlusion = inBytes(float3(lit.occlusion)).x;
    kept.f0 = inBytes(lit.f0);
    kept.roughness = 1 - inBytes(float3(lit.smoothness)).x;
    kept.normalWS = DecodeGBufferNormal(inTenBits(EncodeGBufferNormal(lit.normalWS)));
    return kept;
}

/// The shadow mask as RT4 holds it.
[gives("shadow", "quantised-lights")]
float shadowWithQuantisedMask(int index, float3 position, float4 mask = shadowsOfLightmap) {
    if (shadowMask) {
        return maskedShadow(index, position, float4(inBytes(mask.rgb), inBytes(float3(mask.a)).x));
    }
    return shadow(index, position);
}

[static("pass", "quantised-reflections")] bool reflectsInTheEnd;

[pass("quantised-base")] [pass("quantised-lights")] [pass("quantised-reflections")] [vertex]
float4 quantisedVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}

/// Emission and ambient light, of the surface as it is.
[pass("quantised-base")] [fragment] [lights("none")] [camera("perspective")] [fallback("forward")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
float4 quantisedBase(float3 position = positionWS) {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
    }
    LightSum start;
    if (reflectsInTheEnd && !mirrorsAtOnce) { start.indirect = notReflected(lit); }
    else { start.indirect = indirect(lit); }
    return float4(inFog(final(lit, start), position), 1);
}

[pass("quantised-lights")] [fragment] [lights("all")] [needs("added")] [fallback("forward")]
[holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion")] [depth("equal", "keep")]
[blend("opaque", "one", "one")] [blend("cutout", "one", "one")]
float4 quantisedLights(float3 position = positionWS) {
    LightingSurface kept = remembered(lightingSurface());
    LightSum total;
    total.direct = float3(0);
    [light] for (int i = 0; i < min(lightCount, MAX_LIGHTS); i++) {
        total.direct += direct(kept, lightAt(i, position));
    }
    return float4(fadedByFog(added(kept, total), position), 0);
}

[pass("quantised-reflections")] [fragment] [lights("none")] [optional] [needs("reflected", "addedIndirect")]
[holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion")] [depth("equal", "keep")]
[blend("opaque", "one", "one")] [blend("cutout", "one", "one")]
float4 quantisedReflections(float3 position = positionWS) {
    LightingSurface kept = remembered(lightingSurface());
    LightSum mirrored;
    if (mirrorsAtOnce) { mirrored.indirect = float3(0); }
    else { mirrored.indirect = reflected(kept); }
    return float4(fadedByFog(addedIndirect(kept, mirrored), position), 0);
}
