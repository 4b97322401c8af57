// A forward path that shades what a G-buffer would remember of a surface: every member is rounded to the bits of Unity's
// layout and decoded again. A user's pass file as any other; deferred is held to it.

/// A number a thousandth of a step beside the border between two steps may go to either: all go up, or all down.
[switch] bool upwards;
[switch] bool downwards;
/// What mirrors the surroundings is part of the ambient light.
[switch] bool mirrors_at_once;
/// The device makes 16 bits of a number first, and leaves the last six of them out.
[switch] bool cuts_to_ten_bits;

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
float3 in_bytes(float3 value) {
    return stepped(value, 255);
}

float3 in_ten_bits(float3 value) {
    if (cuts_to_ten_bits) {
        return saturate(floor(round(saturate(value) * 65535 + 64 * nudge()) / 64) / 1023);
    }
    return stepped(value, 1023);
}

LightingSurface remembered(LightingSurface lit) {
    LightingSurface kept;
    kept.diffuseColor = in_bytes(lit.diffuseColor);
    kept.occlusion = in_bytes(float3(lit.occlusion)).x;
    kept.f0 = in_bytes(lit.f0);
    kept.roughness = 1 - in_bytes(float3(lit.smoothness)).x;
    kept.normal_ws = DecodeGBufferNormal(in_ten_bits(EncodeGBufferNormal(lit.normal_ws)));
    return kept;
}

/// The shadow mask as RT4 holds it.
[gives("shadow", "quantised-lights")]
float shadow_with_quantised_mask(int index, float3 position, float4 mask = shadows_of_lightmap) {
    if (shadow_mask) {
        return masked_shadow(index, position, float4(in_bytes(mask.rgb), in_bytes(float3(mask.a)).x));
    }
    return shadow(index, position);
}

[static("pass", "quantised-reflections")] bool reflects_in_the_end;

[pass("quantised-base")] [pass("quantised-lights")] [pass("quantised-reflections")] [vertex]
float4 quantised_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}

/// Emission and ambient light, of the surface as it is.
[pass("quantised-base")] [fragment] [lights("none")] [camera("perspective")] [fallback("forward")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
float4 quantised_base(float3 position = position_ws) {
    LightingSurface lit = lighting_surface();
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    LightSum start;
    if (reflects_in_the_end && !mirrors_at_once) { start.indirect = not_reflected(lit); }
    else { start.indirect = indirect(lit); }
    return float4(in_fog(final(lit, start), position), 1);
}

[pass("quantised-lights")] [fragment] [lights("all")] [needs("added")] [fallback("forward")]
[holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion")] [depth("equal", "keep")]
[blend("opaque", "one", "one")] [blend("cutout", "one", "one")]
float4 quantised_lights(float3 position = position_ws) {
    LightingSurface kept = remembered(lighting_surface());
    LightSum total;
    total.direct = float3(0);
    [light] for (int i = 0; i < min(light_count, MAX_LIGHTS); i++) {
        total.direct += direct(kept, light_at(i, position));
    }
    return float4(faded_by_fog(added(kept, total), position), 0);
}

[pass("quantised-reflections")] [fragment] [lights("none")] [optional] [needs("reflected", "added_indirect")]
[holds("diffuseColor", "f0", "roughness", "normal_ws", "occlusion")] [depth("equal", "keep")]
[blend("opaque", "one", "one")] [blend("cutout", "one", "one")]
float4 quantised_reflections(float3 position = position_ws) {
    LightingSurface kept = remembered(lighting_surface());
    LightSum mirrored;
    if (mirrors_at_once) { mirrored.indirect = float3(0); }
    else { mirrored.indirect = reflected(kept); }
    return float4(faded_by_fog(added_indirect(kept, mirrored), position), 0);
}
