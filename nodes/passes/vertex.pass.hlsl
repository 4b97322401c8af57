// Vertex lit (Gouraud): the lighting graph runs at the vertices and its light is interpolated. Where `direct` is a colour
// that multiplies the diffuse one, plus the rest, the two are interpolated apart, and the diffuse colour of the pixel,
// with its texture, comes in last; so does the base colour, which some lighting graphs read in its place.
// source: Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on Computers 1971

/// `direct` for a diffuse colour of 1 but for what does not depend on it.
[slot] [part("direct", "surface.diffuseColor", "componentwise")]
[otherwise("a texture of the diffuse colour is seen only where there are vertices")]
float3 direct_by_diffuse(LightingSurface surface, [per_light] Light light);
[slot] [without("direct", "surface.diffuseColor")]
float3 direct_without_diffuse(LightingSurface surface, [per_light] Light light);
/// The same of what is left, and the base colour.
[slot] [part("direct_without_diffuse", "surface.baseColor", "componentwise")]
[otherwise("a texture of the base colour is seen only where there are vertices")]
float3 direct_by_base(LightingSurface surface, [per_light] Light light);
[slot] [without("direct_without_diffuse", "surface.baseColor")]
float3 direct_without_colors(LightingSurface surface, [per_light] Light light);

[slot] [part("indirect", "surface.diffuseColor", "componentwise")]
float3 indirect_by_diffuse(LightingSurface surface);
[slot] [without("indirect", "surface.diffuseColor")]
float3 indirect_without_diffuse(LightingSurface surface);
[slot] [part("indirect_without_diffuse", "surface.baseColor", "componentwise")]
float3 indirect_by_base(LightingSurface surface);
[slot] [without("indirect_without_diffuse", "surface.baseColor")]
float3 indirect_without_colors(LightingSurface surface);

[static("slot", "direct_by_diffuse")] bool splits_diffuse;
[static("slot", "direct_by_base")] bool splits_base;
[static("slot", "indirect_by_diffuse")] bool splits_indirect_diffuse;
[static("slot", "indirect_by_base")] bool splits_indirect_base;

/// The light in slot `index` at a vertex.
Light light_at_vertex(int index, float3 position, float2 uv) {
    Light light = light_at(index, position);
    if (shadow_mask) { light.shadow = masked_shadow(index, position, lightmap_shadows(uv)); }
    return light;
}

/// Light that a colour multiplies, for a colour of 1, and light that they do not change; what cannot be told apart is of
/// the last kind.
struct SplitLight {
    float3 by_diffuse;
    float3 by_base;
    float3 other;
};

[inline]
LightingSurface with_diffuse(LightingSurface surface, float3 color) {
    LightingSurface changed = surface;
    changed.diffuseColor = color;
    return changed;
}
[inline]
LightingSurface with_base(LightingSurface surface, float3 color) {
    LightingSurface changed = surface;
    changed.baseColor = color;
    return changed;
}

/// Direct light. One loop makes all kinds, so that each light is evaluated once. Worked out where it is read, which is
/// at the vertices.
[semantic("pixel")]
SplitLight split_light(float3 position = position_ws, float2 uv = uv1) {
    LightingSurface lit = as_lit(lighting_surface());
    float3 by_diffuse = float3(0);
    float3 by_base = float3(0);
    float3 other = float3(0);
    [light] for (int i = 0; i < min(light_count, MAX_LIGHTS); i++) {
        Light light = light_at_vertex(i, position, uv);
        if (splits_diffuse) { by_diffuse += direct_by_diffuse(with_diffuse(lit, float3(1)), light); }
        if (splits_base) {
            by_base += direct_by_base(with_base(lit, float3(1)), light);
            other += direct_without_colors(lit, light);
        }
        if (splits_diffuse && !splits_base) { other += direct_without_diffuse(lit, light); }
        if (!splits_diffuse && !splits_base) { other += direct(lit, light); }
    }
    SplitLight sum;
    sum.by_diffuse = by_diffuse;
    sum.by_base = by_base;
    sum.other = other;
    return sum;
}
[semantic("vertex")]
float3 light_by_diffuse(SplitLight sum = split_light) {
    return sum.by_diffuse;
}
[semantic("vertex")]
float3 light_by_base(SplitLight sum = split_light) {
    return sum.by_base;
}
[semantic("vertex")]
float3 other_light(SplitLight sum = split_light) {
    return sum.other;
}

/// The same of indirect light.
[semantic("vertex")]
float3 indirect_light_by_diffuse() {
    if (!splits_indirect_diffuse) { return float3(0); }
    return indirect_by_diffuse(with_diffuse(as_lit(lighting_surface()), float3(1)));
}
[semantic("vertex")]
float3 indirect_light_by_base() {
    if (!splits_indirect_base) { return float3(0); }
    return indirect_by_base(with_base(as_lit(lighting_surface()), float3(1)));
}
[semantic("vertex")]
float3 other_indirect() {
    LightingSurface lit = as_lit(lighting_surface());
    if (splits_indirect_base) { return indirect_without_colors(lit); }
    if (splits_indirect_diffuse) { return indirect_without_diffuse(lit); }
    return indirect(lit);
}

[pass("vertex")] [fragment] [lights("all")] [fallback("forward")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "src_alpha", "one_minus_src_alpha", "one", "one_minus_src_alpha")]
[blend("transparent", "one", "one_minus_src_alpha")] [blend("additive", "one", "one", "zero", "one")]
[blend("multiply", "dst_color", "zero", "zero", "one")]
float4 vertex_fragment(float3 position = position_ws, float3 by_diffuse = light_by_diffuse,
                       float3 by_base = light_by_base, float3 other = other_light,
                       float3 indirect_diffuse = indirect_light_by_diffuse,
                       float3 indirect_base = indirect_light_by_base, float3 indirect_other = other_indirect) {
    LightingSurface lit = as_lit(lighting_surface());
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    LightSum total;
    total.direct = other;
    if (splits_diffuse) { total.direct += lit.diffuseColor * by_diffuse; }
    if (splits_base) { total.direct += lit.baseColor * by_base; }
    total.indirect = indirect_other;
    if (splits_indirect_diffuse) { total.indirect += lit.diffuseColor * indirect_diffuse; }
    if (splits_indirect_base) { total.indirect += lit.baseColor * indirect_base; }
    if (lightmap) { total.indirect = indirect(lit); }  // a lightmap is finer than vertices are
    return blended_in_fog(final(lit, total), lit.alpha, position);
}
