// Vertex lit (Gouraud): the lighting graph runs at the vertices and its light is interpolated. Where `direct` is a colour
// that multiplies the diffuse one, plus the rest, the two are interpolated apart, and the diffuse colour of the pixel,
// with its texture, comes in last.
// source: Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on Computers 1971

/// `direct` for a diffuse colour of 1 but for what does not depend on it.
[slot] [part("direct", "surface.diffuseColor", "componentwise")]
[otherwise("the diffuse texture is seen only where there are vertices")]
float3 direct_by_diffuse(LightingSurface surface, [per_light] Light light);
[slot] [without("direct", "surface.diffuseColor")]
float3 direct_without_diffuse(LightingSurface surface, [per_light] Light light);
[slot] [part("indirect", "surface.diffuseColor", "componentwise")]
float3 indirect_by_diffuse(LightingSurface surface);
[slot] [without("indirect", "surface.diffuseColor")]
float3 indirect_without_diffuse(LightingSurface surface);

[static("slot", "direct_by_diffuse")] bool splits_direct;
[static("slot", "indirect_by_diffuse")] bool splits_indirect;

/// The light in slot `index` at a vertex.
Light light_at_vertex(int index, float3 position, float2 uv) {
    Light light = light_at(index, position);
    if (shadow_mask) { light.shadow = masked_shadow(index, position, lightmap_shadows(uv)); }
    return light;
}

/// Light that the diffuse colour multiplies, for a diffuse colour of 1, and light that it does not change; where they
/// cannot be told apart, all is of the second kind.
struct SplitLight {
    float3 by_diffuse;
    float3 other;
};

/// Direct light. One loop makes both kinds, so that each light is evaluated once. Worked out where it is read, which is
/// at the vertices.
[semantic("pixel")]
SplitLight split_light(float3 position = position_ws, float2 uv = uv1) {
    LightingSurface lit = as_lit(lighting_surface());
    LightingSurface white = lit;
    white.diffuseColor = float3(1);
    float3 by_diffuse = float3(0);
    float3 other = float3(0);
    [light] for (int i = 0; i < min(light_count, MAX_LIGHTS); i++) {
        Light light = light_at_vertex(i, position, uv);
        if (splits_direct) {
            by_diffuse += direct_by_diffuse(white, light);
            other += direct_without_diffuse(lit, light);
        }
        if (!splits_direct) { other += direct(lit, light); }
    }
    SplitLight sum;
    sum.by_diffuse = by_diffuse;
    sum.other = other;
    return sum;
}
[semantic("vertex")]
float3 diffuse_light(SplitLight sum = split_light) {
    return sum.by_diffuse;
}
[semantic("vertex")]
float3 other_light(SplitLight sum = split_light) {
    return sum.other;
}

/// The same of indirect light.
[semantic("vertex")]
float3 diffuse_indirect() {
    LightingSurface white = as_lit(lighting_surface());
    white.diffuseColor = float3(1);
    if (splits_indirect) { return indirect_by_diffuse(white); }
    return float3(0);
}
[semantic("vertex")]
float3 other_indirect() {
    LightingSurface lit = as_lit(lighting_surface());
    if (splits_indirect) { return indirect_without_diffuse(lit); }
    return indirect(lit);
}

[pass("vertex")] [fragment] [lights("all")] [fallback("forward")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "src_alpha", "one_minus_src_alpha", "one", "one_minus_src_alpha")]
[blend("transparent", "one", "one_minus_src_alpha")] [blend("additive", "one", "one", "zero", "one")]
[blend("multiply", "dst_color", "zero", "zero", "one")]
float4 vertex_fragment(float3 position = position_ws, float3 by_diffuse = diffuse_light, float3 other = other_light,
                       float3 ambient_by_diffuse = diffuse_indirect, float3 other_ambient = other_indirect) {
    LightingSurface lit = as_lit(lighting_surface());
    LightSum total;
    total.direct = other;
    if (splits_direct) { total.direct += lit.diffuseColor * by_diffuse; }
    total.indirect = other_ambient;
    if (splits_indirect) { total.indirect += lit.diffuseColor * ambient_by_diffuse; }
    if (lightmap) { total.indirect = indirect(lit); }  // a lightmap is finer than vertices are
    float3 color = final(lit, total);
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    return blended_in_fog(color, lit.alpha, position);
}
