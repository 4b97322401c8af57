// The textures of a specular workflow: diffuse colour, and the reflectance f0 with glossiness. Everything else is as in
// the path `bake`.
// source: Khronos Group, KHR_materials_pbrSpecularGlossiness

/// The diffuse colour before the share that is reflected is taken away, as the specular workflow states it.
[inline]
float3 diffuseBeforeReflection(LightingSurface surface) {
    return surface.diffuseColor / max(1 - max(max(surface.f0.r, surface.f0.g), surface.f0.b), 1e-4);
}

[pass("bake-specular")] [fragment] [lights("all")] [blend("one", "zero")] [depth("always", "keep")]
[stencil("always", "keep")] [lacks("fragCoord", "screenSize", "color", "depth")]
[lacks("time", "fixedTime")] [lacks("Camera", "fixedView")]
[lacks("Lights", "Shadows", "Ambient", "environmentMap", "lightCookie", "fixedLight")]
BakedSurface bakeSpecularFragment(float3 tangent = tangentWS, float3 bitangent = bitangentWS,
                                  float3 up = geometryNormalWS) {
    LightingSurface lit = lightingSurface();
    BakedSurface baked = bakedSurface(lit, normalInFrame(lit.normalWS, tangent, bitangent, up));
    baked.color = float4(diffuseBeforeReflection(lit), bakedAlpha(lit));
    baked.reflection = float4(lit.f0, 1 - lit.roughness);
    return baked;
}
