// Forward as Unity does it: the main light and everything that belongs to no pixel light in the base pass, then one pass
// for each further light, added to it.
// Lights that are not computed per pixel reach the lighting graph as ambient light, because a graph that is not linear
// in its light cannot be taken apart: up to four at the vertices, the others as spherical harmonics.

/// The second order of the ambient light is computed at the vertices, and the others in the pixel.
[switch] bool sh_per_vertex;

// The two halves of EvaluateSH9, which may be below zero each.
float3 sh_linear(float3 n, float3 sh0, float3 sh1, float3 sh2, float3 sh3) {
    return sh0 * SH_CONSTANT + (sh1 * n.y + sh2 * n.z + sh3 * n.x) * SH_LINEAR;
}
float3 sh_quadratic(float3 n, float3 sh4, float3 sh5, float3 sh6, float3 sh7, float3 sh8) {
    float3 sum = (sh4 * (n.x * n.y) + sh5 * (n.y * n.z) + sh7 * (n.x * n.z)) * SH_PRODUCT;
    sum += sh6 * (SH_POLAR * (3 * n.z * n.z - 1));
    return sum + sh8 * (SH_DIFFERENCE * (n.x * n.x - n.y * n.y));
}

const int MAX_VERTEX_LIGHTS = 4;

/// What the lights behind the main one send to a white Lambert surface.
[semantic("vertex")]
float3 vertex_lights(float3 position = position_ws, float3 normal = vertex_normal_ws) {
    float3 sum = float3(0);
    [light] for (int i = 0; i < min(vertex_light_count, MAX_VERTEX_LIGHTS); i++) {
        Light light = light_at(light_count + i, position);
        sum += light.radiance * saturate(dot(normal, light.direction));
    }
    if (sh_per_vertex && !lightmap) {
        sum += sh_quadratic(normal, ambient_sh[4].rgb, ambient_sh[5].rgb, ambient_sh[6].rgb, ambient_sh[7].rgb,
                            ambient_sh[8].rgb);
    }
    return sum;
}

[gives("AmbientIrradiance", "forward-base")]
float3 ambient_with_vertex_lights(float3 normal, float3 at_vertices = vertex_lights, float3 light = light_of_lightmap,
                                  float left = main_light_of_lightmap) {
    if (lightmap) { return baked_light(normal, light, left) + at_vertices; }
    if (sh_per_vertex) {
        float3 in_pixel = sh_linear(normal, ambient_sh[0].rgb, ambient_sh[1].rgb, ambient_sh[2].rgb, ambient_sh[3].rgb);
        return max(in_pixel + at_vertices, 0);
    }
    return AmbientIrradiance(normal) + at_vertices;
}

[pass("forward-base")] [fragment] [lights("main")] [needs("added")] [fallback("forward")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "src_alpha", "one_minus_src_alpha", "one", "one_minus_src_alpha")]
[blend("transparent", "one", "one_minus_src_alpha")] [blend("additive", "one", "one", "zero", "one")]
[blend("multiply", "dst_color", "zero", "zero", "one")]
float4 forward_base_fragment(float3 position = position_ws) {
    LightingSurface lit = as_lit(lighting_surface());
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    return blended_in_fog(lit_by_all(lit, position), lit.alpha, position);
}

[pass("forward-add")] [fragment] [each("light")] [lights("further")] [needs("added")]
[depth("lessEqual", "keep")]
[blend("opaque", "one", "one", "zero", "one")] [blend("cutout", "one", "one", "zero", "one")]
[blend("fade", "src_alpha", "one", "zero", "one")] [blend("transparent", "one", "one", "zero", "one")]
float4 forward_add_fragment(float3 position = position_ws) {
    LightingSurface lit = as_lit(lighting_surface());
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    float3 color = added_by_light(lit, position);
    return float4(faded_by_fog(color, position), fades ? lit.alpha : 0);
}
