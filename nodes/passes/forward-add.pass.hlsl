// Forward as in Unity: the base pass draws the main light and all light that is not computed per pixel; then one pass
// adds each further light.
// Lights that are not computed per pixel reach the lighting graph as ambient light, because a graph that is not linear
// in its light cannot be split: up to four at the vertices, the others as spherical harmonics.

/// The second order of the ambient light is computed at the vertices, and the other orders in the pixel.
[switch] bool shPerVertex;

// The two halves of EvaluateSH9. Each may be below zero.
float3 shLinear(float3 n, float3 sh0, float3 sh1, float3 sh2, float3 sh3) {
    return sh0 * SH_CONSTANT + (sh1 * n.y + sh2 * n.z + sh3 * n.x) * SH_LINEAR;
}
float3 shQuadratic(float3 n, float3 sh4, float3 sh5, float3 sh6, float3 sh7, float3 sh8) {
    float3 sum = (sh4 * (n.x * n.y) + sh5 * (n.y * n.z) + sh7 * (n.x * n.z)) * SH_PRODUCT;
    sum += sh6 * (SH_POLAR * (3 * n.z * n.z - 1));
    return sum + sh8 * (SH_DIFFERENCE * (n.x * n.x - n.y * n.y));
}

const int MAX_VERTEX_LIGHTS = 4;

/// The light that a white Lambert surface reflects from the lights computed per vertex.
[semantic("vertex")]
float3 vertexLights(float3 position = positionWS, float3 normal = vertexNormalWS) {
    float3 sum = float3(0);
    [light] for (int i = 0; i < min(vertexLightCount, MAX_VERTEX_LIGHTS); i++) {
        Light light = lightAt(lightCount + i, position);
        sum += light.radiance * saturate(dot(normal, light.direction));
    }
    if (shPerVertex && !lightmap) {
        sum += shQuadratic(normal, ambientSH[4].rgb, ambientSH[5].rgb, ambientSH[6].rgb, ambientSH[7].rgb,
                            ambientSH[8].rgb);
    }
    return sum;
}

[gives("AmbientIrradiance", "forward-base")] [fragment]
float3 ambientWithVertexLights(float3 normal, float3 atVertices = vertexLights, float3 light = lightOfLightmap,
                                  float left = mainLightOfLightmap) {
    if (lightmap) { return bakedLight(normal, light, left) + atVertices; }
    if (shPerVertex) {
        float3 inPixel = shLinear(normal, ambientSH[0].rgb, ambientSH[1].rgb, ambientSH[2].rgb, ambientSH[3].rgb);
        return max(inPixel + atVertices, 0);
    }
    return AmbientIrradiance(normal) + atVertices;
}

[pass("forward-base")] [fragment] [lights("main")] [needs("added")] [fallback("forward")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "srcAlpha", "oneMinusSrcAlpha", "one", "oneMinusSrcAlpha")]
[blend("transparent", "one", "oneMinusSrcAlpha")] [blend("additive", "one", "one", "zero", "one")]
[blend("multiply", "dstColor", "zero", "zero", "one")]
float4 forwardBaseFragment(float3 position = positionWS) {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
    }
    lit = asLit(lit);
    return blendedInFog(litByAll(lit, position), lit.alpha, position);
}

[pass("forward-add")] [fragment] [each("light")] [lights("further")] [needs("added", "direct")]
[depth("lessEqual", "keep")]
[blend("opaque", "one", "one", "zero", "one")] [blend("cutout", "one", "one", "zero", "one")]
[blend("fade", "srcAlpha", "one", "zero", "one")] [blend("transparent", "one", "one", "zero", "one")]
float4 forwardAddFragment(float3 position = positionWS) {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
    }
    lit = asLit(lit);
    float3 color = addedByLight(lit, position);
    return float4(fadedByFog(color, position), fades ? lit.alpha : 0);
}
