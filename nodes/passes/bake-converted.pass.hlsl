// The textures of a glTF material for a surface that states its diffuse colour and f0: the nearest base colour and
// metallic. Everything else is as in the path `bake`.
// source: Khronos Group, KHR_materials_pbrSpecularGlossiness, appendix

[pass("bake-converted")] [fragment] [lights("all")] [blend("one", "zero")] [depth("always", "keep")]
[stencil("always", "keep")] [lacks("fragCoord", "screenSize", "color", "depth")]
[lacks("time", "fixedTime")] [lacks("Camera", "fixedView")]
[lacks("Lights", "Shadows", "Ambient", "environmentMap", "lightCookie", "fixedLight")]
BakedSurface bakeConvertedFragment(float3 tangent = tangentWS, float3 bitangent = bitangentWS,
                                   float3 up = geometryNormalWS) {
    LightingSurface lit = lightingSurface();
    BakedSurface baked = bakedSurface(lit, normalInFrame(lit.normalWS, tangent, bitangent, up));
    // The node converts to Unity's set-up, in which a dielectric scatters 0.96 of its base colour. In glTF it scatters
    // all that Fresnel leaves.
    float3 diffuse = 0.96 * diffuseBeforeReflection(lit);
    float3 baseColor = MetallicFromSpecular(diffuse, lit.f0, 1 - lit.roughness).baseColor;
    float metallic = MetallicFromSpecular(diffuse, lit.f0, 1 - lit.roughness).metallic;
    float error = MetallicFromSpecular(diffuse, lit.f0, 1 - lit.roughness).error;
    baked.color = float4(baseColor, bakedAlpha(lit));
    baked.reflection = float4(lit.occlusion, lit.roughness, metallic, error);
    return baked;
}
